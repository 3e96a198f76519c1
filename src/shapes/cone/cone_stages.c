/* SPDX-License-Identifier: MIT */
/* The cone for certain and exact: what it gives to the stages. */
#include "../../numbers/valid.h"
#include "../capped/capped_stages.h"
#include "cone_filter.h"

#include <assert.h>

#define NUMBER mod128
#include "cone_tmpl.h"

/* The filter once more in double-doubles, where an end of the wall is too near a rim for doubles,
 * or its t not near enough. Entry: round to nearest; what the filter's range takes; a D that is
 * known and not below 0. */
static NOT_INLINED filter_verdict closely(const sure_ray *ray, const sure_cone *s,
                                          const axial_terms *of, const known_discriminant *known,
                                          filter_interval *found)
{
    assert(environment_is_nearest() && known->value >= 0);
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
        axial_known(known, known->error, of->height * of->height / fabs(a.head) / root.head, &line);
    return capped_decide(&at, &line, of->d_d, of->size, ray, found);
}

/* -m.d/d.d is off by at most this times |m| / |d|. */
#define APEX_SHARE 0x1p-48

/* m is along d, so the line passes through the apex, at t = -m.d/d.d, or at 0 where the ray starts
 * there. It touches the cone, or it goes on to the base. */
static filter_verdict through_apex(const axial_terms *terms, bool starts, filter_interval *found)
{
    const double bound = SURE_CONE_LEADING_BOUND * SURE_CONE_LEADING_BOUND;
    axial_terms of = *terms;
    double e = vector_dot_f64(NULL, of.axis, of.d), f = vector_dot_f64(NULL, of.axis, of.m);
    two_terms_f64 form = cone_form_f64(NULL, of.height, of.slant, of.d_d, e, e);
    double a = form.more - form.less, all = form.more + form.less;
    double far = fabs(of.m.x) + fabs(of.m.y) + fabs(of.m.z), reach = of.height * of.size;
    filter_end apex = {.t = starts ? 0 : -vector_dot_f64(NULL, of.m, of.d) / of.d_d,
                       .error = starts ? 0 : APEX_SHARE * far / sqrt(of.d_d) + 0x1p-500,
                       .end = {END_TANGENT, SURE_PART_WALL}};
    filter_end base = {.t = (of.height - f) / e,
                       .error = SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e),
                       .end = {END_BASE, SURE_PART_BASE}};
    if (!(a * a > bound * all * (of.slant * (of.height * of.d_d))))
        return FILTER_UNCERTAIN;
    if (a > 0)
        base = apex;
    else if (!(base.error * base.error * of.d_d < AXIAL_LIMIT * AXIAL_LIMIT * of.size))
        return FILTER_UNCERTAIN;
    *found = e > 0 ? (filter_interval){apex, base} : (filter_interval){base, apex};
    return FILTER_INTERVAL;
}

/* Where the filter is uncertain. In this order: a start at the apex; a better discriminant; a line
 * through the apex; a line in the base's plane; the filter with the better discriminant; all in
 * double-doubles; a start in the base's plane. */
static filter_verdict refine(const sure_ray *ray, const void *shape, bool both_ends,
                             filter_interval *found, sure_stage *stage)
{
    const sure_cone *s = shape;
    const axial_terms of = cone_terms_of(ray, s);
    known_discriminant known;
    *stage = SURE_STAGE_DOUBLE_DOUBLE;
    if (!axial_fits(&of, s->radius))
        return FILTER_UNCERTAIN;
    if (!both_ends && is_zero_bits(ray->t_min) && same_point(ray->origin, s->apex))
        return through_apex(&of, true, found);
    if (!discriminant_of(&cone_row, ray, s, of.measure, SURE_CONE_DISCRIMINANT_BOUND, &known))
        return FILTER_UNCERTAIN;
    *stage = known.stage;
    if (known.vanishes)
        return through_apex(&of, false, found);
    known.coplanar = axial_plane_of(ray, s->apex, s->base, &of) == AXIAL_PLANE_TO;
    *stage = known.coplanar ? SURE_STAGE_MOD128 : known.stage;
    filter_verdict verdict = cone_filter_given(ray, s, &of, &known, found);
    if (known.coplanar)
        return axial_plane_chord(verdict, SURE_PART_BASE, ray, both_ends, found);
    if (verdict == FILTER_UNCERTAIN && known.value >= 0)
        TO_NEAREST(verdict, closely(ray, s, &of, &known, found));
    if (verdict == FILTER_INTERVAL &&
        axial_starts(ray, s->apex, s->base, &of, END_TOP, END_BASE, found))
        *stage = SURE_STAGE_MOD128;
    return verdict;
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
    .filter = cone_filter,
    .refine = refine,
    .step = cone_step,
    .steps = 2,
    SHAPE_BODY(cone),
    .exact_interval = cone_exact_interval,
    .round_normal = cone_round_normal,
    .surface = &cone_surface_row,
};

CAPPED_HIT(cone)

STAGES_QUESTIONS(cone)
