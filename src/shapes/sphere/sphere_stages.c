/* SPDX-License-Identifier: MIT */
/* The sphere for certain and exact: what it gives to the stages. */
#include "../../stages/last/line.h"
#include "../../stages/stages.h"
#include "sphere_filter.h"

#define NUMBER mod128
#include "sphere_tmpl.h"
#define NUMBER exact
#include "sphere_tmpl.h"

/* The filter takes a known D when error^2 is at most this share of |value| times the positive term
 * of what it is the difference of (docs/proofs/root.md). */
#define SPHERE_KNOWN_SHARE 0x1p-98

/* Where the filter is uncertain, with a better discriminant: its root is then as good as any
 * product, which the bound allows for. */
static filter_verdict refine(const sure_ray *ray, const void *shape, bool both_ends,
                             filter_interval *found, sure_stage *stage)
{
    const sure_sphere *s = shape;
    const sphere_terms of = sphere_terms_of(ray, s);
    known_discriminant known;
    (void)both_ends;
    if (!sphere_fits(s, &of) || !discriminant_of(&sphere_row, ray, s, of.a * of.size,
                                                 SURE_CYLINDER_DISCRIMINANT_BOUND, &known))
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
    .shape = SURE_SHAPE_SPHERE,
    .filter = sphere_filter,
    .refine = refine,
    .steps = 2,
    .discriminant_mod128 = sphere_discriminant_of_mod128,
    .exact_interval = exact_interval,
    .round_normal = round_normal,
    .surface = &sphere_surface_row,
};

sure_status sure_sphere_hit_certain(const sure_ray *ray, const sure_sphere *sphere, sure_hit *hit)
{
    const decided said = sphere_decide(ray, sphere);
    return said.certain ? decision_tell(&said, hit)
                        : stages_certain_hit(ray, sphere, hit, &sphere_row);
}

STAGES_QUESTIONS(sphere)
