/* The cylinder for stable, certain and exact: what it gives to the stages, and what is public. */
#include "../bounds.h"
#include "../shapes.h"
#include "../stable.h"
#include "../../stages/discriminant.h"
#include "../capped/capped_stages.h"
#include "cylinder_exact.h"
#include "cylinder_filter.h"
#include "cylinder_guess.h"
#include "cylinder_spawn.h"

#define NUMBER dd
#include "cylinder_tmpl.h"
#undef NUMBER
#ifdef MOD128_EXISTS
#define NUMBER mod128
#include "cylinder_tmpl.h"
#undef NUMBER
#endif
#define NUMBER_SIGNED
#define NUMBER ddb
#include "cylinder_tmpl.h"
#undef NUMBER

STAGES_INLINE filter_verdict filter(const sure_ray *ray, const void *shape, filter_interval *found)
{
    return cylinder_filter(ray, shape, found);
}

/* The filter once more in double-doubles, where an end of the wall is too near a rim for doubles,
 * or its t not near enough. Entry: round to nearest; what the filter's range takes; a D that is
 * known and not below 0. */
static NOT_INLINED filter_verdict closely(const sure_ray *ray, const sure_cylinder *s,
                                          const cylinder_terms *of, const known_discriminant *known,
                                          filter_interval *found)
{
    vector_dd axis = vector_between_dd(NULL, s->base, s->top);
    vector_dd m = vector_between_dd(NULL, s->base, ray->origin);
    vector_dd d = vector_of_dd(NULL, ray->direction);
    dd height = vector_square_dd(NULL, axis);
    dd a = vector_square_dd(NULL, vector_cross_dd(NULL, axis, d));
    dd e = capped_tilted(vector_dot_dd(NULL, axis, d)), f = vector_dot_dd(NULL, axis, m);
    dd b = cylinder_form_dd(NULL, height, vector_dot_dd(NULL, m, d), f, e);
    dd root = capped_root(dd_mul(NULL, height, (dd){known->value, known->rest}));
    double reach = of->height * of->size;
    capped_ends at = {.less = dd_div(NULL, dd_negate(NULL, dd_add(NULL, b, root)), a),
                      .more = dd_div(NULL, dd_sub(NULL, root, b), a),
                      .base = dd_div(NULL, dd_negate(NULL, f), e),
                      .top = dd_div(NULL, dd_sub(NULL, height, f), e)};
    axial_line line = {
        .less_at = END_LESS,
        .more_at = END_MORE,
        .e = e.head,
        .wall_error =
            DD_SHARE * SURE_CYLINDER_WALL_BOUND * sqrt(of->height * of->d_d * reach) / fabs(a.head),
        .plane_error = DD_SHARE * SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e.head),
        .leading = true,
    };
    capped_known(known, of->height / fabs(a.head) / root.head, &line);
    return capped_decide(&at, &line, of->d_d, of->size, ray, found);
}

/* Where the filter is uncertain: with a better discriminant, then with more digits of all. */
static filter_verdict refine(const sure_ray *ray, const void *shape, bool both_ends,
                             filter_interval *found, sure_stage *stage)
{
    static const discriminant_forms forms = DISCRIMINANT_FORMS(cylinder_discriminant_of);
    const sure_cylinder *s = shape;
    const cylinder_terms of = cylinder_terms_of(ray, s);
    known_discriminant known;
    if (!cylinder_fits(s, &of) ||
        !discriminant_of(ray, s, &forms, of.measure, SURE_CYLINDER_DISCRIMINANT_BOUND, &known))
        return FILTER_UNCERTAIN;
    axial_plane plane = axial_plane_of(ray, s->base, s->top, of.axis, of.m, of.d, of.size);
    known.coplanar = plane != AXIAL_PLANE_UNKNOWN;
    *stage = known.coplanar ? SURE_STAGE_MOD128 : known.stage;
    filter_verdict verdict = cylinder_filter_given(ray, s, &of, &known, found);
    if (known.coplanar)
        return axial_plane_chord(verdict,
                                 plane == AXIAL_PLANE_FROM ? SURE_PART_BASE : SURE_PART_TOP, ray,
                                 both_ends, found);
    if (verdict == FILTER_UNCERTAIN && known.value >= 0)
        TO_NEAREST(verdict, closely(ray, s, &of, &known, found));
    if (verdict == FILTER_INTERVAL &&
        axial_starts(ray, s->base, s->top, of.axis, of.m, of.size, END_BASE, END_TOP, found))
        *stage = SURE_STAGE_MOD128;
    return verdict;
}

/* At a tangent point, with p seen from the base: s = [p, d], a = [d, d]. */
static bool polish_tangent(const sure_ray *ray, const sure_cylinder *s, const filter_end *end,
                           double *t)
{
    ddb_context c = {false};
    vector_ddb axis = vector_between_ddb(&c, s->base, s->top);
    vector_ddb d = vector_of_ddb(&c, ray->direction), p = tangent_point(&c, ray, s->base, end->t);
    ddb height = vector_square_ddb(&c, axis), e = vector_dot_ddb(&c, axis, d);
    ddb slope =
        cylinder_form_ddb(&c, height, vector_dot_ddb(&c, p, d), vector_dot_ddb(&c, axis, p), e);
    double all = height.hi * vector_square_ddb(&c, d).hi;
    return tangent_round(end->t, slope, all - e.hi * e.hi, all, t);
}

static bool tangent_order(const sure_ray *ray, const void *shape, double x, int *sign)
{
#ifdef MOD128_EXISTS
    const sure_cylinder *s = shape;
    vector_f64 axis = vector_between_f64(NULL, s->base, s->top);
    double height = vector_square_f64(NULL, axis);
    return tangent_order_of(ray, s->base, x, cylinder_slope_at_f64(ray, s, x), 2 * height,
                            cylinder_slope_at_mod128(ray, s, x), sign);
#else
    (void)ray, (void)shape, (void)x, (void)sign;
    return false;
#endif
}

STAGES_INLINE bool polish(const sure_ray *ray, const void *shape, const filter_end *end, double *t)
{
    return end->end.at == END_TANGENT ? polish_tangent(ray, shape, end, t)
                                      : cylinder_polish(ray, shape, end, t);
}

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
    two_terms_ddb body =
        cylinder_body_ddb(c, arm, vector_square_ddb(c, axis), ddb_of(c, s->radius));
    return (part_slope){difference_ddb(c, body), vector_dot_ddb(c, arm, across),
                        vector_square_ddb(c, across)};
}

/* (p - (A.p / H) A) / r */
static vector_ddb unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    const sure_cylinder *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->base, s->top);
    ddb share = ddb_div(c, vector_dot_ddb(c, axis, p), vector_square_ddb(c, axis));
    return vector_over_ddb(c, vector_sub_ddb(c, p, vector_scale_ddb(c, share, axis)),
                           ddb_of(c, s->radius));
}

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

static bool has_inside(const void *shape)
{
    return !is_zero_bits(((const sure_cylinder *)shape)->radius);
}

static void bounds(const void *shape, double low[3], double high[3])
{
    const sure_cylinder *cylinder = shape;
    double reach[3];
    bounds_reach_of_cap(cylinder->base, cylinder->top, cylinder->radius, reach);
    bounds_include(cylinder->base, reach, low, high);
    bounds_include(cylinder->top, reach, low, high);
}

const shape_row cylinder_row = {
    .info = {.name = "cylinder",
             .solid = 1,
             .bounded = 1,
             .numbers = 7,
             .field_count = 3,
             .part_count = 3,
             .fields = {{SURE_FIELD_BASE, SURE_KIND_POINT, DOUBLES_BEFORE(sure_cylinder, base)},
                        {SURE_FIELD_TOP, SURE_KIND_OTHER_POINT, DOUBLES_BEFORE(sure_cylinder, top)},
                        {SURE_FIELD_RADIUS, SURE_KIND_RADIUS,
                         DOUBLES_BEFORE(sure_cylinder, radius)}},
             .parts = {SURE_PART_BASE, SURE_PART_TOP, SURE_PART_WALL}},
    .filter = filter,
    .refine = refine,
    .tangent_order = tangent_order,
    .polish = polish,
    .exact_interval = cylinder_exact_interval,
    .round_normal = cylinder_round_normal,
    .surface = {part_of_plane, anchor, slope, unit_normal},
    .side_ddb = cylinder_side_ddb,
    .side_exact = cylinder_side_of,
    .outward = outward,
    .spawn_quick = spawn_quick,
    .has_inside = has_inside,
    .bounds = bounds,
};

sure_field sure_cylinder_check(const sure_ray *ray, const sure_cylinder *cylinder)
{
    return shape_check(&cylinder_row, ray, cylinder);
}

sure_status sure_cylinder_hit_certain(const sure_ray *ray, const sure_cylinder *cylinder,
                                      sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&cylinder_row, ray, cylinder, T_CERTAIN, hit, &unused);
}

sure_status sure_cylinder_hit_exact(const sure_ray *ray, const sure_cylinder *cylinder,
                                    sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&cylinder_row, ray, cylinder, T_EXACT, hit, &unused);
}

sure_status sure_cylinder_interval_certain(const sure_ray *ray, const sure_cylinder *cylinder,
                                           sure_interval *interval)
{
    return stages_interval(&cylinder_row, ray, cylinder, T_CERTAIN, interval);
}

sure_status sure_cylinder_interval_exact(const sure_ray *ray, const sure_cylinder *cylinder,
                                         sure_interval *interval)
{
    return stages_interval(&cylinder_row, ray, cylinder, T_EXACT, interval);
}

sure_status sure_cylinder_occluded_certain(const sure_ray *ray, const sure_cylinder *cylinder)
{
    sure_hit unused;
    return sure_cylinder_hit_certain(ray, cylinder, &unused);
}

sure_status sure_cylinder_occluded_exact(const sure_ray *ray, const sure_cylinder *cylinder)
{
    sure_hit unused;
    return sure_cylinder_hit_certain(ray, cylinder, &unused);
}

sure_vec3 sure_cylinder_normal_certain(const sure_ray *ray, const sure_cylinder *cylinder,
                                       const sure_hit *hit)
{
    sure_vec3 normal;
    if (cylinder_quick_normal(ray, cylinder, hit, &normal))
        return normal;
    return stages_normal(&cylinder_row, ray, cylinder, hit, T_CERTAIN);
}

sure_vec3 sure_cylinder_normal_exact(const sure_ray *ray, const sure_cylinder *cylinder,
                                     const sure_hit *hit)
{
    return stages_normal(&cylinder_row, ray, cylinder, hit, T_EXACT);
}

sure_status sure_cylinder_hit_stable(const sure_ray *ray, const sure_cylinder *cylinder,
                                     sure_hit *hit)
{
    return stable_hit(&cylinder_row, cylinder_guess, ray, cylinder, hit);
}

sure_status sure_cylinder_interval_stable(const sure_ray *ray, const sure_cylinder *cylinder,
                                          sure_interval *interval)
{
    return stable_interval(&cylinder_row, cylinder_guess, ray, cylinder, interval);
}

sure_status sure_cylinder_occluded_stable(const sure_ray *ray, const sure_cylinder *cylinder)
{
    sure_hit unused;
    return sure_cylinder_hit_stable(ray, cylinder, &unused);
}

sure_vec3 sure_cylinder_normal_stable(const sure_ray *ray, const sure_cylinder *cylinder,
                                      const sure_hit *hit)
{
    sure_vec3 normal;
    if (cylinder_quick_normal(ray, cylinder, hit, &normal))
        return normal;
    return sure_cylinder_normal_textbook(ray, cylinder, hit);
}
