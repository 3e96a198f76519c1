/* SPDX-License-Identifier: MIT */
/* The surface of the cone for certain and exact: what is asked of a hit. */
#define MOD128_APART
#include "../capped/capped_surface.h"
#include "cone_spawn.h"

#define NUMBER mod128
#include "cone_tmpl.h"
#include "../../numbers/most.h" /* a type, where variables in headers have its name */
#define NUMBER most
#include "cone_tmpl.h"
#define NUMBER ddb
#include "cone_tmpl.h"
#define NUMBER exact
#include "cone_tmpl.h"

static RARE part_slope cone_slope(ddb_context *c, const void *shape, vector_ddb p, vector_ddb d)
{
    const sure_cone *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->apex, s->base);
    vector_ddb arm = vector_cross_ddb(c, axis, p), across = vector_cross_ddb(c, axis, d);
    ddb height = vector_square_ddb(c, axis), r = ddb_of(c, s->radius);
    ddb depth = vector_dot_ddb(c, axis, p), e = vector_dot_ddb(c, axis, d);
    two_terms_ddb a = cone_body_ddb(c, height, r, vector_square_ddb(c, across), ddb_square(c, e));
    return (part_slope){
        difference_ddb(
            c, cone_body_ddb(c, height, r, vector_square_ddb(c, arm), ddb_square(c, depth))),
        difference_ddb(
            c, cone_body_ddb(c, height, r, vector_dot_ddb(c, arm, across), ddb_mul(c, depth, e))),
        a};
}

/* Half the gradient; on the wall, where H^2 p.p = K (A.p)^2, its length is
 * (A.p) r sqrt(K H). */
static vector_ddb cone_unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    const sure_cone *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->apex, s->base);
    ddb height = vector_square_ddb(c, axis), r = ddb_of(c, s->radius);
    ddb slant = ddb_add(c, height, ddb_square(c, r)), depth = vector_dot_ddb(c, axis, p);
    vector_ddb outward = cone_gradient_ddb(c, axis, height, slant, p, depth);
    ddb length = ddb_mul(c, ddb_mul(c, depth, r), ddb_sqrt(c, ddb_mul(c, slant, height)));
    return vector_over_ddb(c, outward, length);
}

static sure_vec3 cone_outward(const void *shape, sure_part part, sure_vec3 p)
{
    const sure_cone *s = shape;
    part_plane cap;
    if (capped_plane(shape, part, &cap))
        return difference_of(cap.to, cap.from);
    sure_vec3 axis = difference_of(s->base, s->apex), m = difference_of(p, s->apex);
    double height = dot(axis, axis), slope = 1 + s->radius * s->radius / height;
    return sum_of(m, -(slope * dot(axis, m) / height), axis);
}

static void cone_bounds(const void *shape, double low[3], double high[3])
{
    const sure_cone *cone = shape;
    const double none[3] = {0, 0, 0};
    double reach[3];
    bounds_reach_of_disc(difference_of(cone->base, cone->apex), cone->radius, reach);
    bounds_include(cone->base, reach, low, high);
    bounds_include(cone->apex, none, low, high);
}

const surface_row cone_surface_row = {CAPPED_SURFACE(cone),
                                      .anchor = DOUBLES_BEFORE(sure_cone, apex)};

/* In doubles, from the hit's t, where that is good enough. The slope's two shares: with u the unit
 * vector from the axis to the point, h = |A|, the normal is (h u - r A / h) / sqrt(h^2 + r^2). */
static inline bool cone_quick_normal(const sure_ray *ray, const sure_cone *cone,
                                     const sure_hit *hit, sure_vec3 *normal)
{
    sure_vec3 axis = difference_of(cone->base, cone->apex), p;
    if (hit->part == SURE_PART_BASE)
        return quick_unit(axis, 1, normal);
    double error, height_square = dot(axis, axis), r = cone->radius;
    if (!quick_point(ray, hit, cone->apex, &p, &error) || !quick_in_range(height_square) ||
        !quick_in_range(r))
        return false;
    sure_vec3 radial = quick_radial(p, axis, height_square);
    double distance = sqrt(dot(radial, radial)), height = sqrt(height_square);
    double slant = sqrt(height_square + r * r), share = height / (slant * distance);
    sure_vec3 across = {radial.x * share, radial.y * share, radial.z * share};
    *normal = sum_of(across, -r / (slant * height), axis);
    return quick_in_range(distance) && error <= QUICK_POINT_SHARE * distance;
}

SURFACE_NORMALS(cone)
