/* The cone for stable, certain and exact: what it gives to the stages, and what is public. */
#include "../bounds.h"
#include "../shapes.h"
#include "../stable.h"
#include "../../stages/discriminant.h"
#include "../capped/capped_stages.h"
#include "cone_exact.h"
#include "cone_filter.h"
#include "cone_guess.h"
#include "cone_spawn.h"

#define NUMBER dd
#include "cone_tmpl.h"
#undef NUMBER
#ifdef MOD128_EXISTS
#define NUMBER mod128
#include "cone_tmpl.h"
#undef NUMBER
#endif
#define NUMBER_SIGNED
#define NUMBER ddb
#include "cone_tmpl.h"
#undef NUMBER

STAGES_INLINE filter_verdict filter(const sure_ray *ray, const void *shape, filter_interval *found)
{
    return cone_filter(ray, shape, found);
}

/* The filter once more in double-doubles, where an end of the wall is too near a rim for doubles,
 * or its t not near enough. Entry: round to nearest; what the filter's range takes; a D that is
 * known and not below 0. */
static NOT_INLINED filter_verdict closely(const sure_ray *ray, const sure_cone *s,
                                          const cone_terms *of, const known_discriminant *known,
                                          filter_interval *found)
{
    vector_dd axis = vector_between_dd(NULL, s->apex, s->base);
    vector_dd m = vector_between_dd(NULL, s->apex, ray->origin);
    vector_dd d = vector_of_dd(NULL, ray->direction);
    dd height = vector_square_dd(NULL, axis);
    dd slant = dd_add(NULL, height, dd_square(NULL, dd_of(NULL, s->radius)));
    dd e = capped_tilted(vector_dot_dd(NULL, axis, d)), f = vector_dot_dd(NULL, axis, m);
    dd a = difference_dd(NULL, cone_form_dd(NULL, height, slant, vector_square_dd(NULL, d), e, e));
    dd b = difference_dd(NULL, cone_form_dd(NULL, height, slant, vector_dot_dd(NULL, m, d), f, e));
    dd root = dd_mul(NULL, height, capped_root((dd){known->value, known->rest}));
    double all = of->height * of->height * of->d_d + of->slant * (e.head * e.head);
    double reach = of->height * of->size, a_bound = DD_SHARE * SURE_CONE_LEADING_BOUND;
    bool steep = a.head < 0;
    const dd out_of_sight = {0x1p600, 0};
    capped_ends at = {.less = dd_div(NULL, dd_negate(NULL, dd_add(NULL, b, root)), a),
                      .more = dd_div(NULL, dd_sub(NULL, root, b), a),
                      .base = dd_div(NULL, dd_sub(NULL, height, f), e),
                      .top = dd_div(NULL, dd_negate(NULL, f), e)};
    if (steep && e.head > 0)
        at.more = out_of_sight;
    if (steep && e.head < 0)
        at.less = dd_negate(NULL, out_of_sight);
    axial_line line = {
        .less_at = steep ? END_MORE : END_LESS,
        .more_at = steep ? END_LESS : END_MORE,
        .e = -e.head,
        .wall_error =
            DD_SHARE * SURE_CONE_WALL_BOUND * sqrt(all * (of->slant * reach)) / fabs(a.head),
        .plane_error = DD_SHARE * SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e.head),
        .leading = a.head * a.head > a_bound * a_bound * all * (of->slant * of->height * of->d_d),
    };
    if (known->value > 0 || !steep)
        capped_known(known, of->height * of->height / fabs(a.head) / root.head, &line);
    return capped_decide(&at, &line, of->d_d, of->size, ray, found);
}

/* -m.d/d.d is off by at most this times |m| / |d|. */
#define APEX_SHARE 0x1p-48

/* m is along d, so the line passes through the apex, at t = -m.d/d.d. There it touches the cone, or
 * it goes on to the base. */
static filter_verdict through_apex(const cone_terms *terms, filter_interval *found)
{
    const double bound = SURE_CONE_LEADING_BOUND * SURE_CONE_LEADING_BOUND;
    cone_terms of = *terms;
    double e = vector_dot_f64(NULL, of.axis, of.d), f = vector_dot_f64(NULL, of.axis, of.m);
    two_terms_f64 form = cone_form_f64(NULL, of.height, of.slant, of.d_d, e, e);
    double a = form.more - form.less, all = form.more + form.less;
    double far = fabs(of.m.x) + fabs(of.m.y) + fabs(of.m.z), reach = of.height * of.size;
    filter_end apex = {-vector_dot_f64(NULL, of.m, of.d) / of.d_d,
                       APEX_SHARE * far / sqrt(of.d_d) + 0x1p-500,
                       {END_TANGENT, SURE_PART_WALL}};
    filter_end base = {(of.height - f) / e,
                       SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e),
                       {END_BASE, SURE_PART_BASE}};
    if (!(a * a > bound * all * (of.slant * (of.height * of.d_d))))
        return FILTER_UNCERTAIN;
    if (a > 0)
        base = apex;
    else if (!(base.error * base.error * of.d_d < AXIAL_LIMIT * AXIAL_LIMIT * of.size))
        return FILTER_UNCERTAIN;
    *found = e > 0 ? (filter_interval){apex, base} : (filter_interval){base, apex};
    return FILTER_INTERVAL;
}

/* A ray that starts where the cone does meets it at once. */
static bool starts_at_apex(const sure_ray *ray, const sure_cone *cone, filter_interval *found)
{
    const filter_end apex = {0, 0, {END_TANGENT, SURE_PART_WALL}};
    *found = (filter_interval){apex, apex};
    return is_zero_bits(ray->t_min) && same_point(ray->origin, cone->apex);
}

/* Where the filter is uncertain. In this order: a start at the apex; a better discriminant; a line
 * through the apex; a line in the base's plane; the filter with the better discriminant; all in
 * double-doubles; a start in the base's plane. */
static filter_verdict refine(const sure_ray *ray, const void *shape, bool both_ends,
                             filter_interval *found, sure_stage *stage)
{
    static const discriminant_forms forms = DISCRIMINANT_FORMS(cone_discriminant_of);
    const sure_cone *s = shape;
    const cone_terms of = cone_terms_of(ray, s);
    known_discriminant known;
    *stage = SURE_STAGE_DOUBLE_DOUBLE;
    if (!cone_fits(s, &of))
        return FILTER_UNCERTAIN;
    if (!both_ends && starts_at_apex(ray, s, found))
        return FILTER_INTERVAL;
    if (!discriminant_of(ray, s, &forms, of.measure, SURE_CONE_DISCRIMINANT_BOUND, &known))
        return FILTER_UNCERTAIN;
    *stage = known.stage;
    if (known.vanishes)
        return through_apex(&of, found);
    known.coplanar =
        axial_plane_of(ray, s->apex, s->base, of.axis, of.m, of.d, of.size) == AXIAL_PLANE_TO;
    *stage = known.coplanar ? SURE_STAGE_MOD128 : known.stage;
    filter_verdict verdict = cone_filter_given(ray, s, &of, &known, found);
    if (known.coplanar)
        return axial_plane_chord(verdict, SURE_PART_BASE, ray, both_ends, found);
    if (verdict == FILTER_UNCERTAIN && known.value >= 0)
        TO_NEAREST(verdict, closely(ray, s, &of, &known, found));
    if (verdict == FILTER_INTERVAL &&
        axial_starts(ray, s->apex, s->base, of.axis, of.m, of.size, END_TOP, END_BASE, found))
        *stage = SURE_STAGE_MOD128;
    return verdict;
}

/* At a tangent point, with p seen from the apex: s = [p, d], a = [d, d]. */
static bool polish_tangent(const sure_ray *ray, const sure_cone *cone, const filter_end *end,
                           double *t)
{
    ddb_context c = {false};
    vector_ddb axis = vector_between_ddb(&c, cone->apex, cone->base);
    vector_ddb d = vector_of_ddb(&c, ray->direction);
    vector_ddb p = tangent_point(&c, ray, cone->apex, end->t);
    ddb height = vector_square_ddb(&c, axis), e = vector_dot_ddb(&c, axis, d);
    ddb slant = ddb_add(&c, height, ddb_square(&c, ddb_of(&c, cone->radius)));
    two_terms_ddb form =
        cone_form_ddb(&c, height, slant, vector_dot_ddb(&c, p, d), vector_dot_ddb(&c, axis, p), e);
    double all = height.hi * vector_square_ddb(&c, d).hi;
    double a = height.hi * all - slant.hi * e.hi * e.hi;
    return tangent_round(end->t, difference_ddb(&c, form), a, (height.hi + slant.hi) * all, t);
}

static bool tangent_order(const sure_ray *ray, const void *shape, double x, int *sign)
{
#ifdef MOD128_EXISTS
    const sure_cone *s = shape;
    vector_f64 axis = vector_between_f64(NULL, s->apex, s->base);
    double height = vector_square_f64(NULL, axis);
    return tangent_order_of(ray, s->apex, x, cone_slope_at_f64(ray, s, x),
                            (height + (height + s->radius * s->radius)) * height,
                            cone_slope_at_mod128(ray, s, x), sign);
#else
    (void)ray, (void)shape, (void)x, (void)sign;
    return false;
#endif
}

STAGES_INLINE bool polish(const sure_ray *ray, const void *shape, const filter_end *end, double *t)
{
    return end->end.at == END_TANGENT ? polish_tangent(ray, shape, end, t)
                                      : cone_polish(ray, shape, end, t);
}

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
    two_terms_ddb a = cone_body_ddb(c, height, r, vector_square_ddb(c, across), e, e);
    return (part_slope){
        difference_ddb(c, cone_body_ddb(c, height, r, vector_square_ddb(c, arm), depth, depth)),
        difference_ddb(c, cone_body_ddb(c, height, r, vector_dot_ddb(c, arm, across), depth, e)),
        ddb_add(c, a.more, a.less)};
}

/* The gradient H^2 p - K (A.p) A; on the wall, where H^2 p.p = K (A.p)^2, its length is
 * (A.p) r sqrt(K H). */
static vector_ddb unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    const sure_cone *s = shape;
    vector_ddb axis = vector_between_ddb(c, s->apex, s->base);
    ddb height = vector_square_ddb(c, axis), r = ddb_of(c, s->radius);
    ddb slant = ddb_add(c, height, ddb_square(c, r)), depth = vector_dot_ddb(c, axis, p);
    vector_ddb inward = vector_scale_ddb(c, ddb_mul(c, slant, depth), axis);
    vector_ddb outward = vector_sub_ddb(c, vector_scale_ddb(c, ddb_square(c, height), p), inward);
    ddb length = ddb_mul(c, ddb_mul(c, depth, r), ddb_sqrt(c, ddb_mul(c, slant, height)));
    return vector_over_ddb(c, outward, length);
}

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

static bool has_inside(const void *shape)
{
    return !is_zero_bits(((const sure_cone *)shape)->radius);
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

const shape_row cone_row = {
    .info = {.name = "cone",
             .solid = 1,
             .bounded = 1,
             .numbers = 7,
             .field_count = 3,
             .part_count = 2,
             .fields = {{SURE_FIELD_BASE, SURE_KIND_POINT, DOUBLES_BEFORE(sure_cone, base)},
                        {SURE_FIELD_APEX, SURE_KIND_OTHER_POINT, DOUBLES_BEFORE(sure_cone, apex)},
                        {SURE_FIELD_RADIUS, SURE_KIND_RADIUS, DOUBLES_BEFORE(sure_cone, radius)}},
             .parts = {SURE_PART_BASE, SURE_PART_WALL}},
    .filter = filter,
    .refine = refine,
    .tangent_order = tangent_order,
    .polish = polish,
    .exact_interval = cone_exact_interval,
    .round_normal = cone_round_normal,
    .surface = {part_of_plane, anchor, slope, unit_normal},
    .side_ddb = cone_side_ddb,
    .side_exact = cone_side_of,
    .outward = outward,
    .spawn_quick = spawn_quick,
    .has_inside = has_inside,
    .bounds = bounds,
};

sure_field sure_cone_check(const sure_ray *ray, const sure_cone *cone)
{
    return shape_check(&cone_row, ray, cone);
}

sure_status sure_cone_hit_certain(const sure_ray *ray, const sure_cone *cone, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&cone_row, ray, cone, T_CERTAIN, hit, &unused);
}

sure_status sure_cone_hit_exact(const sure_ray *ray, const sure_cone *cone, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&cone_row, ray, cone, T_EXACT, hit, &unused);
}

sure_status sure_cone_interval_certain(const sure_ray *ray, const sure_cone *cone,
                                       sure_interval *interval)
{
    return stages_interval(&cone_row, ray, cone, T_CERTAIN, interval);
}

sure_status sure_cone_interval_exact(const sure_ray *ray, const sure_cone *cone,
                                     sure_interval *interval)
{
    return stages_interval(&cone_row, ray, cone, T_EXACT, interval);
}

sure_status sure_cone_occluded_certain(const sure_ray *ray, const sure_cone *cone)
{
    sure_hit unused;
    return sure_cone_hit_certain(ray, cone, &unused);
}

sure_status sure_cone_occluded_exact(const sure_ray *ray, const sure_cone *cone)
{
    sure_hit unused;
    return sure_cone_hit_certain(ray, cone, &unused);
}

sure_vec3 sure_cone_normal_certain(const sure_ray *ray, const sure_cone *cone, const sure_hit *hit)
{
    sure_vec3 normal;
    if (cone_quick_normal(ray, cone, hit, &normal))
        return normal;
    return stages_normal(&cone_row, ray, cone, hit, T_CERTAIN);
}

sure_vec3 sure_cone_normal_exact(const sure_ray *ray, const sure_cone *cone, const sure_hit *hit)
{
    return stages_normal(&cone_row, ray, cone, hit, T_EXACT);
}

sure_status sure_cone_hit_stable(const sure_ray *ray, const sure_cone *cone, sure_hit *hit)
{
    return stable_hit(&cone_row, cone_guess, ray, cone, hit);
}

sure_status sure_cone_interval_stable(const sure_ray *ray, const sure_cone *cone,
                                      sure_interval *interval)
{
    return stable_interval(&cone_row, cone_guess, ray, cone, interval);
}

sure_status sure_cone_occluded_stable(const sure_ray *ray, const sure_cone *cone)
{
    sure_hit unused;
    return sure_cone_hit_stable(ray, cone, &unused);
}

sure_vec3 sure_cone_normal_stable(const sure_ray *ray, const sure_cone *cone, const sure_hit *hit)
{
    sure_vec3 normal;
    if (cone_quick_normal(ray, cone, hit, &normal))
        return normal;
    return sure_cone_normal_textbook(ray, cone, hit);
}
