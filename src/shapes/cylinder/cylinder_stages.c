/* SPDX-License-Identifier: MIT */
/* The cylinder for certain and exact: what it gives to the stages. */
#include "../capped/capped_stages.h"
#include "cylinder_filter.h"

#include <assert.h>

#define NUMBER mod128
#include "cylinder_tmpl.h"

/* The filter once more in double-doubles, where an end of the wall is too near a rim for doubles,
 * or its t not near enough. Entry: round to nearest; what the filter's range takes; a D that is
 * known and not below 0. */
static NOT_INLINED filter_verdict closely(const sure_ray *ray, const sure_cylinder *s,
                                          const axial_terms *of, const known_discriminant *known,
                                          filter_interval *found)
{
    assert(environment_is_nearest() && known->value >= 0);
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
    axial_known(known, known->error, of->height / fabs(a.head) / root.head, &line);
    return capped_decide(&at, &line, of->d_d, of->size, ray, found);
}

/* Where the filter is uncertain: with a better discriminant, then with more digits of all. */
static filter_verdict refine(const sure_ray *ray, const void *shape, bool both_ends,
                             filter_interval *found, sure_stage *stage)
{
    const sure_cylinder *s = shape;
    const axial_terms of = cylinder_terms_of(ray, s);
    known_discriminant known;
    if (!axial_fits(&of, s->radius) || !discriminant_of(&cylinder_row, ray, s, of.measure,
                                                        SURE_CYLINDER_DISCRIMINANT_BOUND, &known))
        return FILTER_UNCERTAIN;
    axial_plane plane = axial_plane_of(ray, s->base, s->top, &of);
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
        axial_starts(ray, s->base, s->top, &of, END_BASE, END_TOP, found))
        *stage = SURE_STAGE_MOD128;
    return verdict;
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
    .filter = cylinder_filter,
    .refine = refine,
    .step = cylinder_step,
    .steps = 2,
    SHAPE_BODY(cylinder),
    .exact_interval = cylinder_exact_interval,
    .round_normal = cylinder_round_normal,
    .surface = &cylinder_surface_row,
};

CAPPED_HIT(cylinder)

STAGES_QUESTIONS(cylinder)
