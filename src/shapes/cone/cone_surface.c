/* The surface of the cone for certain and exact: what is asked of a hit. */
#include "../../stages/hits/normal.h"
#include "../bounds.h"
#include "../capped/capped_side.h"
#include "cone_exact.h"
#include "cone_spawn.h"

#define NUMBER_SIGNED
#define NUMBER ddb
#include "cone_tmpl.h"
#undef NUMBER

static bool part_of_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_cone *s = shape;
    *plane = (part_plane){s->apex, s->base, s->base};
    return part != SURE_PART_WALL;
}

static sure_vec3 anchor(const void *shape)
{
    return ((const sure_cone *)shape)->apex;
}

static part_slope slope(ddb_context *c, const void *shape, vector_ddb p, vector_ddb d)
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
static vector_ddb unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    const sure_cone *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->apex, s->base);
    ddb height = vector_square_ddb(c, axis), r = ddb_of(c, s->radius);
    ddb slant = ddb_add(c, height, ddb_square(c, r)), depth = vector_dot_ddb(c, axis, p);
    vector_ddb outward = cone_gradient_ddb(c, axis, height, slant, p, depth);
    ddb length = ddb_mul(c, ddb_mul(c, depth, r), ddb_sqrt(c, ddb_mul(c, slant, height)));
    return vector_over_ddb(c, outward, length);
}

static bool has_inside(const void *shape)
{
    return !is_zero_bits(((const sure_cone *)shape)->radius);
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    const sure_cone *s = shape;
    sure_vec3 axis = spawn_difference(s->base, s->apex), m = spawn_difference(p, s->apex);
    double height = dot_of(axis, axis), slope = 1 + s->radius * s->radius / height;
    return part == SURE_PART_BASE ? axis : capped_less(m, slope * dot_of(axis, m) / height, axis);
}

static SPAWN_IN_ONE_PIECE spawn_on_wall(const sure_ray *ray, const sure_cone *s,
                                        const sure_hit *hit, double side, sure_vec3 *origin,
                                        sure_hit *nearer)
{
    line_point line = line_point_of(ray, hit->t);
    return spawn_by_surface(ray, hit, side, &line, cone_surface(&line, s), origin, nearer);
}

static bool spawn_quick(const sure_ray *ray, const void *shape, const sure_hit *hit, double side,
                        sure_vec3 *origin, sure_hit *nearer)
{
    const sure_cone *s = shape;
    if (hit->part == SURE_PART_WALL)
        return spawn_on_wall(ray, s, hit, side, origin, nearer);
    return spawn_on_cap(ray, hit, side, &s->apex, &s->base, s->radius, origin, nearer);
}

static void bounds(const void *shape, double low[3], double high[3])
{
    const sure_cone *cone = shape;
    const double none[3] = {0, 0, 0};
    double reach[3];
    bounds_reach_of_cap(cone->apex, cone->base, cone->radius, reach);
    bounds_include(cone->base, reach, low, high);
    bounds_include(cone->apex, none, low, high);
}

const surface_row cone_surface_row = {
    .plane = part_of_plane,
    .anchor = anchor,
    .slope = slope,
    .unit_normal = unit_normal,
    .side_ddb = cone_side_ddb,
    .side_exact = cone_side_of,
    .has_inside = has_inside,
    .outward = outward,
    .spawn_quick = spawn_quick,
    .bounds = bounds,
};

/* In doubles, from the hit's t, where that is good enough. The slope's two shares: with u the unit
 * vector from the axis to the point, h = |A|, the normal is (h u - r A / h) / sqrt(h^2 + r^2). */
static inline bool cone_quick_normal(const sure_ray *ray, const sure_cone *cone,
                                     const sure_hit *hit, sure_vec3 *normal)
{
    quick_vector axis = quick_between(cone->apex, cone->base), p;
    if (hit->part == SURE_PART_BASE)
        return quick_unit(axis, 1, normal);
    double error, height_square = quick_dot(axis, axis), r = cone->radius;
    if (!quick_point(ray, hit, cone->apex, &p, &error) || !quick_in_range(height_square) ||
        !quick_in_range(r))
        return false;
    quick_vector radial = quick_radial(p, axis, height_square);
    double distance = sqrt(quick_dot(radial, radial)), height = sqrt(height_square);
    double slant = sqrt(height_square + r * r), share = height / (slant * distance);
    quick_vector outward = {radial.x * share, radial.y * share, radial.z * share};
    outward = quick_plus(outward, -r / (slant * height), axis);
    *normal = (sure_vec3){outward.x, outward.y, outward.z};
    return quick_in_range(distance) && error <= QUICK_POINT_SHARE * distance;
}

SURFACE_NORMALS(cone)
