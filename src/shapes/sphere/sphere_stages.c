/* The sphere for stable, certain and exact: what it gives to the stages, and what is public. */
#include "../bounds.h"
#include "../shapes.h"
#include "../stable.h"
#include "../../stages/discriminant.h"
#include "../../stages/hits/normal_quick.h"
#include "../../stages/last/rounding.h"
#include "../../stages/stages.h"
#include "../../stages/tangent.h"
#include "sphere_filter.h"
#include "sphere_guess.h"
#include "sphere_spawn.h"

#define NUMBER dd
#include "sphere_tmpl.h"
#undef NUMBER
#ifdef MOD128_EXISTS
#define NUMBER mod128
#include "sphere_tmpl.h"
#undef NUMBER
#endif
#define NUMBER_SIGNED
#define NUMBER ddb
#include "sphere_tmpl.h"
#undef NUMBER
#define NUMBER exact
#include "sphere_tmpl.h"
#undef NUMBER

/* The filter takes a known D when error^2 is at most this share of |value| times the positive term
 * of what it is the difference of (docs/proofs/root.md). */
#define SPHERE_KNOWN_SHARE 0x1p-98

STAGES_INLINE filter_verdict filter(const sure_ray *ray, const void *shape, filter_interval *found)
{
    return sphere_filter(ray, shape, found);
}

/* Where the filter is uncertain, with a better discriminant: its root is then as good as any
 * product, which the bound allows for. */
static filter_verdict refine(const sure_ray *ray, const void *shape, bool both_ends,
                             filter_interval *found, sure_stage *stage)
{
    static const discriminant_forms forms = DISCRIMINANT_FORMS(sphere_discriminant_of);
    const sure_sphere *s = shape;
    const sphere_terms of = sphere_terms_of(ray, s);
    known_discriminant known;
    (void)both_ends;
    if (!sphere_fits(s, &of) ||
        !discriminant_of(ray, s, &forms, of.a * of.size, SURE_CYLINDER_DISCRIMINANT_BOUND, &known))
        return FILTER_UNCERTAIN;
    double off = known.error + fabs(known.rest), inner = of.a * (s->radius * s->radius);
    if (!(off * off <= SPHERE_KNOWN_SHARE * (fabs(known.value) * inner)))
        return FILTER_UNCERTAIN;
    *stage = known.stage;
    if (known.value < 0)
        return filter_miss_if(true, ray);
    double error = SURE_SPHERE_CLOSE_T_BOUND * sqrt(of.a * of.size) / of.a;
    (void)sphere_found(&of, sqrt(known.value), error, found);
    if (known.value == 0)
        found->enter.end.at = found->leave.end.at = END_TANGENT;
    return FILTER_INTERVAL;
}

/* At a tangent point s = p.d, a = d.d. */
static bool polish_tangent(const sure_ray *ray, const sure_sphere *s, const filter_end *end,
                           double *t)
{
    ddb_context c = {false};
    vector_ddb d = vector_of_ddb(&c, ray->direction);
    vector_ddb p = tangent_point(&c, ray, s->centre, end->t);
    double a = vector_square_ddb(&c, d).hi;
    return tangent_round(end->t, vector_dot_ddb(&c, p, d), a, a, t);
}

static bool tangent_order(const sure_ray *ray, const void *shape, double x, int *sign)
{
#ifdef MOD128_EXISTS
    const sure_sphere *s = shape;
    return tangent_order_of(ray, s->centre, x, sphere_slope_at_f64(ray, s, x), 1,
                            sphere_slope_at_mod128(ray, s, x), sign);
#else
    (void)ray, (void)shape, (void)x, (void)sign;
    return false;
#endif
}

STAGES_INLINE bool polish(const sure_ray *ray, const void *shape, const filter_end *end, double *t)
{
    return end->end.at == END_TANGENT ? polish_tangent(ray, shape, end, t)
                                      : sphere_polish(ray, shape, end, t);
}

static tagged_interval exact_interval(exact_context *c, const sure_ray *ray, const void *shape,
                                      line_coefficients *l)
{
    const sure_sphere *s = shape;
    vector_exact d = vector_of_exact(c, ray->direction);
    vector_exact m = vector_between_exact(c, s->centre, ray->origin);
    exact r = exact_of(c, s->radius);
    l->a = vector_square_exact(c, d);
    l->quarter = difference_exact(c, sphere_discriminant_exact(c, l->a, d, m, r));
    int crosses = exact_sign(c, l->quarter);
    if (crosses < 0)
        return interval_empty();
    l->b = vector_dot_exact(c, m, d);
    if (crosses == 0)
        return interval_point((tagged_end){END_TANGENT, SURE_PART_SURFACE});
    l->factor = exact_of(c, 1);
    l->c = difference_exact(c, sphere_body_exact(c, m, r));
    return interval_between((tagged_end){END_LESS, SURE_PART_SURFACE},
                            (tagged_end){END_MORE, SURE_PART_SURFACE});
}

/* (m + t d) / r */
static sure_vec3 round_normal(exact_context *c, const sure_ray *ray, const void *shape,
                              const line_coefficients *l, tagged_end at)
{
    const sure_sphere *s = shape;
    exact r = exact_of(c, s->radius);
    vector_exact d = vector_of_exact(c, ray->direction);
    if (r.sign == 0)
        return round_unit(c, vector_negate_exact(c, d));
    return round_linear_vector(c, ray, l, at.at, vector_between_exact(c, s->centre, ray->origin), d,
                               r);
}

static bool part_of_plane(const void *shape, sure_part part, part_plane *plane)
{
    (void)shape, (void)part, (void)plane;
    return false;
}

static sure_vec3 anchor(const void *shape)
{
    return ((const sure_sphere *)shape)->centre;
}

static part_slope slope(ddb_context *c, const void *shape, vector_ddb p, vector_ddb d)
{
    ddb r = ddb_of(c, ((const sure_sphere *)shape)->radius);
    return (part_slope){difference_ddb(c, sphere_body_ddb(c, p, r)), vector_dot_ddb(c, p, d),
                        vector_square_ddb(c, d)};
}

static vector_ddb unit_normal(ddb_context *c, const void *shape, vector_ddb p)
{
    return vector_over_ddb(c, p, ddb_of(c, ((const sure_sphere *)shape)->radius));
}

/* In doubles, from the hit's t, where that is good enough. */
static inline bool sphere_quick_normal(const sure_ray *ray, const sure_sphere *sphere,
                                       const sure_hit *hit, sure_vec3 *normal)
{
    quick_vector p;
    double error;
    return quick_point(ray, hit, sphere->centre, &p, &error) && quick_unit(p, 1, normal) &&
           error <= QUICK_POINT_SHARE * sphere->radius;
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    (void)part;
    return spawn_difference(p, anchor(shape));
}

static SPAWN_IN_ONE_PIECE spawn_quick(const sure_ray *ray, const void *shape, const sure_hit *hit,
                                      double side, sure_vec3 *origin, sure_hit *nearer)
{
    line_point line = line_point_of(ray, hit->t);
    return spawn_by_surface(ray, hit, side, &line, sphere_surface(&line, shape), origin, nearer);
}

static bool has_inside(const void *shape)
{
    return !is_zero_bits(((const sure_sphere *)shape)->radius);
}

static void bounds(const void *shape, double low[3], double high[3])
{
    const sure_sphere *sphere = shape;
    const double r = sphere->radius, reach[3] = {r, r, r};
    bounds_include(sphere->centre, reach, low, high);
}

const shape_row sphere_row = {
    .info = {.name = "sphere",
             .solid = 1,
             .bounded = 1,
             .numbers = 4,
             .field_count = 2,
             .part_count = 1,
             .fields = {{SURE_FIELD_CENTRE, SURE_KIND_POINT, DOUBLES_BEFORE(sure_sphere, centre)},
                        {SURE_FIELD_RADIUS, SURE_KIND_RADIUS, DOUBLES_BEFORE(sure_sphere, radius)}},
             .parts = {SURE_PART_SURFACE}},
    .filter = filter,
    .refine = refine,
    .tangent_order = tangent_order,
    .polish = polish,
    .exact_interval = exact_interval,
    .round_normal = round_normal,
    .surface = {part_of_plane, anchor, slope, unit_normal},
    .side_ddb = sphere_side_ddb,
    .side_exact = sphere_side_exact,
    .outward = outward,
    .spawn_quick = spawn_quick,
    .has_inside = has_inside,
    .bounds = bounds,
};

sure_field sure_sphere_check(const sure_ray *ray, const sure_sphere *sphere)
{
    return shape_check(&sphere_row, ray, sphere);
}

sure_status sure_sphere_hit_certain(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&sphere_row, ray, sphere, T_CERTAIN, hit, &unused);
}

sure_status sure_sphere_hit_exact(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&sphere_row, ray, sphere, T_EXACT, hit, &unused);
}

sure_status sure_sphere_interval_certain(const sure_ray *ray, const sure_sphere *sphere,
                                         sure_interval *interval)
{
    return stages_interval(&sphere_row, ray, sphere, T_CERTAIN, interval);
}

sure_status sure_sphere_interval_exact(const sure_ray *ray, const sure_sphere *sphere,
                                       sure_interval *interval)
{
    return stages_interval(&sphere_row, ray, sphere, T_EXACT, interval);
}

sure_status sure_sphere_occluded_certain(const sure_ray *ray, const sure_sphere *sphere)
{
    sure_hit unused;
    return sure_sphere_hit_certain(ray, sphere, &unused);
}

sure_status sure_sphere_occluded_exact(const sure_ray *ray, const sure_sphere *sphere)
{
    sure_hit unused;
    return sure_sphere_hit_certain(ray, sphere, &unused);
}

sure_vec3 sure_sphere_normal_certain(const sure_ray *ray, const sure_sphere *sphere,
                                     const sure_hit *hit)
{
    sure_vec3 normal;
    if (sphere_quick_normal(ray, sphere, hit, &normal))
        return normal;
    return stages_normal(&sphere_row, ray, sphere, hit, T_CERTAIN);
}

sure_vec3 sure_sphere_normal_exact(const sure_ray *ray, const sure_sphere *sphere,
                                   const sure_hit *hit)
{
    return stages_normal(&sphere_row, ray, sphere, hit, T_EXACT);
}

sure_status sure_sphere_hit_stable(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit)
{
    return stable_hit(&sphere_row, sphere_guess, ray, sphere, hit);
}

sure_status sure_sphere_interval_stable(const sure_ray *ray, const sure_sphere *sphere,
                                        sure_interval *interval)
{
    return stable_interval(&sphere_row, sphere_guess, ray, sphere, interval);
}

sure_status sure_sphere_occluded_stable(const sure_ray *ray, const sure_sphere *sphere)
{
    sure_hit unused;
    return sure_sphere_hit_stable(ray, sphere, &unused);
}

sure_vec3 sure_sphere_normal_stable(const sure_ray *ray, const sure_sphere *sphere,
                                    const sure_hit *hit)
{
    sure_vec3 normal;
    if (sphere_quick_normal(ray, sphere, hit, &normal))
        return normal;
    return sure_sphere_normal_textbook(ray, sphere, hit);
}
