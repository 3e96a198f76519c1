/* SPDX-License-Identifier: MIT */
/* The surface of the cylinder for certain and exact: what is asked of a hit. */
#define MOD128_APART
#include "../capped/capped_surface.h"
#include "cylinder_spawn.h"

#define NUMBER mod128
#include "cylinder_tmpl.h"
#include "../../numbers/most.h" /* a type, where variables in headers have its name */
#define NUMBER most
#include "cylinder_tmpl.h"
#define NUMBER ddb
#include "cylinder_tmpl.h"
#define NUMBER exact
#include "cylinder_tmpl.h"

static RARE part_slope cylinder_slope(ddb_context *c, const void *shape, vector_ddb p, vector_ddb d)
{
    const sure_cylinder *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->base, s->top);
    vector_ddb arm = vector_cross_ddb(c, axis, p), across = vector_cross_ddb(c, axis, d);
    two_terms_ddb body = cylinder_body_ddb(c, vector_square_ddb(c, arm), vector_square_ddb(c, axis),
                                           ddb_of(c, s->radius));
    return (part_slope){difference_ddb(c, body),
                        vector_dot_ddb(c, arm, across),
                        {vector_square_ddb(c, across), ddb_of(c, 0)}};
}

/* Half the gradient; on the wall its length is H r. Of the one coordinate in which the axis goes on
 * it has nothing, exactly. */
static vector_ddb cylinder_unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    const sure_cylinder *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->base, s->top);
    ddb height = vector_square_ddb(c, axis);
    vector_ddb outward = cylinder_gradient_ddb(c, axis, height, p, vector_dot_ddb(c, axis, p));
    ddb *along = surface_level(&outward, s->base, s->top);
    if (along)
        *along = ddb_of(c, 0);
    return vector_over_ddb(c, outward, ddb_mul(c, height, ddb_of(c, s->radius)));
}

static sure_vec3 cylinder_outward(const void *shape, sure_part part, sure_vec3 p)
{
    const sure_cylinder *s = shape;
    part_plane cap;
    if (capped_plane(shape, part, &cap))
        return difference_of(cap.to, cap.from);
    sure_vec3 axis = difference_of(s->top, s->base);
    return quick_radial(difference_of(p, s->base), axis, dot(axis, axis));
}

static void cylinder_bounds(const void *shape, double low[3], double high[3])
{
    const sure_cylinder *cylinder = shape;
    double reach[3];
    bounds_reach_of_disc(difference_of(cylinder->top, cylinder->base), cylinder->radius, reach);
    bounds_include(cylinder->base, reach, low, high);
    bounds_include(cylinder->top, reach, low, high);
}

const surface_row cylinder_surface_row = {CAPPED_SURFACE(cylinder),
                                          .anchor = DOUBLES_BEFORE(sure_cylinder, base)};

/* In doubles, from the hit's t, where that is good enough. */
static inline bool cylinder_quick_normal(const sure_ray *ray, const sure_cylinder *cylinder,
                                         const sure_hit *hit, sure_vec3 *normal)
{
    sure_vec3 axis = difference_of(cylinder->top, cylinder->base), p;
    if (hit->part != SURE_PART_WALL)
        return quick_unit(axis, hit->part == SURE_PART_TOP ? 1 : -1, normal);
    double error, height_square = dot(axis, axis);
    return quick_point(ray, hit, cylinder->base, &p, &error) && quick_in_range(height_square) &&
           quick_unit(quick_radial(p, axis, height_square), 1, normal) &&
           error <= QUICK_POINT_SHARE * cylinder->radius;
}

SURFACE_NORMALS(cylinder)
