/* What plane and disc share in the stages after the first. */
#ifndef SHAPES_PLANAR_STAGES_H
#define SHAPES_PLANAR_STAGES_H

#include "../../stages/hits/normal_quick.h"
#include "../../stages/last/rounding.h"
#include "../../stages/stages.h"

#define NUMBER_SIGNED
#define NUMBER ddb
#include "planar_tmpl.h"
#undef NUMBER
#define NUMBER exact
#include "planar_tmpl.h"
#undef NUMBER
#undef NUMBER_SIGNED

/* The ray's line seen from a point of the plane, and h = N.m; e is the line's speed. */
typedef struct {
    vector_exact m, d;
    exact h;
} planar_line;

static inline planar_line planar_line_of(exact_context *c, const sure_ray *ray, sure_vec3 point,
                                         sure_vec3 normal, line_coefficients *l)
{
    planar_line at = {.m = vector_between_exact(c, point, ray->origin),
                      .d = vector_of_exact(c, ray->direction)};
    vector_exact n = vector_of_exact(c, normal);
    at.h = vector_dot_exact(c, n, at.m);
    l->speed = vector_dot_exact(c, n, at.d);
    l->base = exact_negate(c, at.h);
    return at;
}

/* Its other side. */
static inline bool planar_has_inside(const void *shape)
{
    (void)shape;
    return true;
}

#endif
