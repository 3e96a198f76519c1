/* SPDX-License-Identifier: MIT */
/* The surface of the sphere for certain and exact: what is asked of a hit. */
#include "../../stages/hits/normal.h"
#include "../bounds.h"

#define NUMBER f64
#include "sphere_tmpl.h"
#define NUMBER mod128
#include "sphere_tmpl.h"
#include "../../numbers/most.h" /* a type, where variables in headers have its name */
#define NUMBER most
#include "sphere_tmpl.h"
#define NUMBER ddb
#include "sphere_tmpl.h"
#define NUMBER exact
#include "sphere_tmpl.h"

static part_slope slope(ddb_context *c, const void *shape, vector_ddb p, vector_ddb d)
{
    ddb r = ddb_of(c, ((const sure_sphere *)shape)->radius);
    return (part_slope){difference_ddb(c, sphere_body_ddb(c, p, r)),
                        vector_dot_ddb(c, p, d),
                        {vector_square_ddb(c, d), ddb_of(c, 0)}};
}

static vector_ddb unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    return vector_over_ddb(c, p, ddb_of(c, ((const sure_sphere *)shape)->radius));
}

static bool has_inside(const void *shape)
{
    return !is_zero_bits(((const sure_sphere *)shape)->radius);
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    (void)part;
    return difference_of(p, ((const sure_sphere *)shape)->centre);
}

static void bounds(const void *shape, double low[3], double high[3])
{
    const sure_sphere *sphere = shape;
    const double r = sphere->radius, reach[3] = {r, r, r};
    bounds_include(sphere->centre, reach, low, high);
}

const surface_row sphere_surface_row = {
    .anchor = DOUBLES_BEFORE(sure_sphere, centre),
    .slope = slope,
    SURFACE_SLOPES(sphere),
    .unit_normal = unit_normal,
    SURFACE_SIDES(sphere),
    .has_inside = has_inside,
    .outward = outward,
    .bounds = bounds,
};

/* In doubles, from the hit's t, where that is good enough. */
static inline bool sphere_quick_normal(const sure_ray *ray, const sure_sphere *sphere,
                                       const sure_hit *hit, sure_vec3 *normal)
{
    sure_vec3 p;
    double error;
    return quick_point(ray, hit, sphere->centre, &p, &error) && quick_unit(p, 1, normal) &&
           error <= QUICK_POINT_SHARE * sphere->radius;
}

SURFACE_NORMALS(sphere)
