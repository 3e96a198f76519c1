/* SPDX-License-Identifier: MIT */
/* The cylinder for certain and exact: what it gives to the stages. */
#include "../../stages/close.h"
#include "../../stages/hits/surface.h"
#include "../capped/capped_stages.h"
#include "cylinder_filter.h"

#define NUMBER mod128
#include "cylinder_tmpl.h"

/* A touch, as if the solid had no ends; then where it is. */
static filter_verdict touch(const sure_ray *ray, const sure_cylinder *s, const axial_terms *of,
                            const known_discriminant *known, filter_interval *found)
{
    static const capped_touching how = {
        cylinder_touch_of_f64, cylinder_touch_of_mod128, {SURE_PART_BASE, SURE_PART_TOP}};
    const double error = CAPPED_TOUCH_SHARE * of->size * of->d_d, errors[2] = {error, error};
    known_discriminant level = *known;
    level.coplanar = true;
    return cylinder_filter_given(ray, s, of, &level, found) == FILTER_INTERVAL
               ? capped_touch(&how, ray, s, errors, found)
               : FILTER_UNCERTAIN;
}

/* On which side of the wall's body the ray starts: -1 within. False where that can't be told. */
static NOT_INLINED bool wall_side(const sure_ray *ray, const sure_cylinder *s, int *side)
{
    ddb_context c = {false};
    *side = ddb_sign(&c, surface_slope(&c, &cylinder_row, ray, s, ddb_of(&c, 0)).f);
    return !c.uncertain;
}

/* A line along the axis is within the wall all along, or outside; on it is left to the last stage.
 * The wall's ends, of which there are none, are put out of sight. */
static filter_verdict along_axis(const sure_ray *ray, const sure_cylinder *s, const axial_terms *of,
                                 filter_interval *found)
{
    axial_line line = cylinder_ends_of(of, 1, 1).line;
    int side;
    bool known;
    TO_NEAREST(known, wall_side(ray, s, &side));
    if (!known || side >= 0)
        return filter_miss_if(known && side > 0, ray);
    line.less = -0x1p600;
    line.more = 0x1p600;
    line.wall_error = 0;
    return axial_chord(&line, of->d_d, of->size, ray, found);
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
    *stage = known.stage;
    if (known.vanishes)
        return along_axis(ray, s, &of, found);
    axial_plane plane = axial_plane_of(ray, s->base, s->top, &of);
    known.coplanar = plane != AXIAL_PLANE_UNKNOWN;
    if (known.coplanar)
        *stage = SURE_STAGE_MOD128;
    filter_verdict verdict = cylinder_filter_given(ray, s, &of, &known, found);
    if (known.coplanar)
        return axial_plane_chord(verdict,
                                 plane == AXIAL_PLANE_FROM ? SURE_PART_BASE : SURE_PART_TOP, ray,
                                 both_ends, found);
    if (verdict == FILTER_UNCERTAIN && known.value == 0)
        verdict = touch(ray, s, &of, &known, found);
    if (verdict == FILTER_UNCERTAIN && known.value >= 0)
        TO_NEAREST(verdict, close_of(&cylinder_row)->filter(ray, s, &of, &known, found));
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
    .shape = SURE_SHAPE_CYLINDER,
    .filter = cylinder_filter,
    .refine = refine,
    .steps = 2,
    .discriminant_mod128 = cylinder_discriminant_of_mod128,
    .exact_interval = cylinder_exact_interval,
    .round_normal = cylinder_round_normal,
    .surface = &cylinder_surface_row,
};

CAPPED_HIT(cylinder)

STAGES_QUESTIONS(cylinder)
