/* The surface of the cylinder for certain and exact: what is asked of a hit. */
#include "../../stages/hits/normal.h"
#include "../bounds.h"
#include "../capped/capped_side.h"
#include "cylinder_exact.h"
#include "cylinder_spawn.h"

#define NUMBER_SIGNED
#define NUMBER ddb
#include "cylinder_tmpl.h"
#undef NUMBER

static bool part_of_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_cylinder *s = shape;
    *plane = part == SURE_PART_TOP ? (part_plane){s->base, s->top, s->top}
                                   : (part_plane){s->top, s->base, s->base};
    return part != SURE_PART_WALL;
}

static sure_vec3 anchor(const void *shape)
{
    return ((const sure_cylinder *)shape)->base;
}

static part_slope slope(ddb_context *c, const void *shape, vector_ddb p, vector_ddb d)
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

/* Half the gradient; on the wall its length is H r. */
static vector_ddb unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    const sure_cylinder *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->base, s->top);
    ddb height = vector_square_ddb(c, axis);
    vector_ddb outward = cylinder_gradient_ddb(c, axis, height, p, vector_dot_ddb(c, axis, p));
    return vector_over_ddb(c, outward, ddb_mul(c, height, ddb_of(c, s->radius)));
}

static bool has_inside(const void *shape)
{
    return !is_zero_bits(((const sure_cylinder *)shape)->radius);
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    const sure_cylinder *s = shape;
    sure_vec3 axis = spawn_difference(s->top, s->base), m = spawn_difference(p, s->base);
    if (part != SURE_PART_WALL)
        return part == SURE_PART_TOP ? axis : spawn_difference(s->base, s->top);
    return capped_less(m, dot_of(axis, m) / dot_of(axis, axis), axis);
}

static SPAWN_IN_ONE_PIECE spawn_on_wall(const sure_ray *ray, const sure_cylinder *s,
                                        const sure_hit *hit, double side, sure_vec3 *origin,
                                        sure_hit *nearer)
{
    line_point line = line_point_of(ray, hit->t);
    return spawn_by_surface(ray, hit, side, &line, cylinder_surface(&line, s), origin, nearer);
}

static bool spawn_quick(const sure_ray *ray, const void *shape, const sure_hit *hit, double side,
                        sure_vec3 *origin, sure_hit *nearer)
{
    const sure_cylinder *s = shape;
    bool top = hit->part == SURE_PART_TOP;
    if (hit->part == SURE_PART_WALL)
        return spawn_on_wall(ray, s, hit, side, origin, nearer);
    return spawn_on_cap(ray, hit, side, top ? &s->base : &s->top, top ? &s->top : &s->base,
                        s->radius, origin, nearer);
}

static void bounds(const void *shape, double low[3], double high[3])
{
    const sure_cylinder *cylinder = shape;
    double reach[3];
    bounds_reach_of_cap(cylinder->base, cylinder->top, cylinder->radius, reach);
    bounds_include(cylinder->base, reach, low, high);
    bounds_include(cylinder->top, reach, low, high);
}

const surface_row cylinder_surface_row = {
    .plane = part_of_plane,
    .anchor = anchor,
    .slope = slope,
    .unit_normal = unit_normal,
    .side_ddb = cylinder_side_ddb,
    .side_exact = cylinder_side_of,
    .has_inside = has_inside,
    .outward = outward,
    .spawn_quick = spawn_quick,
    .bounds = bounds,
};

/* In doubles, from the hit's t, where that is good enough. */
static inline bool cylinder_quick_normal(const sure_ray *ray, const sure_cylinder *cylinder,
                                         const sure_hit *hit, sure_vec3 *normal)
{
    quick_vector axis = quick_between(cylinder->base, cylinder->top), p;
    if (hit->part != SURE_PART_WALL)
        return quick_unit(axis, hit->part == SURE_PART_TOP ? 1 : -1, normal);
    double error, height_square = quick_dot(axis, axis);
    return quick_point(ray, hit, cylinder->base, &p, &error) && quick_in_range(height_square) &&
           quick_unit(quick_radial(p, axis, height_square), 1, normal) &&
           error <= QUICK_POINT_SHARE * cylinder->radius;
}

SURFACE_NORMALS(cylinder)
