/* SPDX-License-Identifier: MIT */
/* The cone for certain and exact: what it gives to the stages. */
#include "../../numbers/valid.h"
#include "../../stages/close.h"
#include "../capped/capped_stages.h"
#include "cone_filter.h"

#define NUMBER mod128
#include "cone_tmpl.h"

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

/* A touch, as if the nappe had no end; then where it is. */
static filter_verdict touch(const sure_ray *ray, const sure_cone *s, const axial_terms *of,
                            const known_discriminant *known, filter_interval *found)
{
    static const capped_touching how = {
        cone_touch_of_f64, cone_touch_of_mod128, {SURE_PART_WALL, SURE_PART_BASE}};
    const double error = CAPPED_TOUCH_SHARE * of->size * of->d_d;
    const double errors[2] = {error, 2 * error * of->height};
    known_discriminant level = *known;
    level.coplanar = true;
    return cone_filter_given(ray, s, of, &level, found) == FILTER_INTERVAL &&
                   found->enter.end.at == END_TANGENT
               ? capped_touch(&how, ray, s, errors, found)
               : FILTER_UNCERTAIN;
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
    if (verdict == FILTER_UNCERTAIN && known.value == 0)
        verdict = touch(ray, s, &of, &known, found);
    if (verdict == FILTER_UNCERTAIN && known.value >= 0)
        TO_NEAREST(verdict, close_of(&cone_row)->filter(ray, s, &of, &known, found));
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
    .shape = SURE_SHAPE_CONE,
    .filter = cone_filter,
    .refine = refine,
    .steps = 2,
    .discriminant_mod128 = cone_discriminant_of_mod128,
    .exact_interval = cone_exact_interval,
    .round_normal = cone_round_normal,
    .surface = &cone_surface_row,
};

CAPPED_HIT(cone)

STAGES_QUESTIONS(cone)
