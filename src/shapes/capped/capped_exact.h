/* What cylinder and cone share in exact numbers. */
#ifndef SHAPES_CAPPED_EXACT_H
#define SHAPES_CAPPED_EXACT_H

#include "../../stages/last/line.h"

#define NUMBER_SIGNED
#define NUMBER exact
#include "../planar/planar_tmpl.h"
#undef NUMBER
#undef NUMBER_SIGNED

/* What a row gives to the last stage (stages/shape.h). */
#define CAPPED_EXACT(shape)                                                                        \
    tagged_interval shape##_exact_interval(exact_context *c, const sure_ray *ray,                  \
                                           const void *solid, line_coefficients *l);               \
    sure_vec3 shape##_round_normal(exact_context *c, const sure_ray *ray, const void *solid,       \
                                   const line_coefficients *l, tagged_end at);
CAPPED_EXACT(cone)
CAPPED_EXACT(cylinder)

/* A cap's plane is crossed inside, at or outside its rim: 1, 0, -1. m is seen from the cap's
 * centre, e = A.d, h = A.m. */
static inline int capped_within(exact_context *c, exact e, exact h, vector_exact m, vector_exact d,
                                exact r)
{
    return exact_sign(c, difference_exact(c, disc_rim_exact(c, e, h, m, d, r)));
}

/* What the normal is made of, seen from the axis's first end. */
typedef struct {
    vector_exact m, d, axis;
    exact radius, height; /* height = axis.axis */
} capped_point;

static inline capped_point capped_point_of(exact_context *c, const sure_ray *ray, sure_vec3 from,
                                           sure_vec3 to, double radius)
{
    vector_exact axis = vector_between_exact(c, from, to);
    return (capped_point){vector_between_exact(c, from, ray->origin),
                          vector_of_exact(c, ray->direction), axis, exact_of(c, radius),
                          vector_square_exact(c, axis)};
}

#endif
