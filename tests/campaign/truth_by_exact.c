/* SPDX-License-Identifier: MIT */
#include "campaign_check.h"

#include "../../src/stages/hits/beyond.h"
#include "../../src/stages/rows.h"
#include "../../src/stages/stages.h"
#include "../support/long_vector.h"

static sure_status hit_of(const sure_ray *ray, const sure_object *object, double *t,
                          sure_part *part, sure_vec3 *normal)
{
    const shape_row *row = row_of(object);
    sure_hit hit;
    if (shape_check(row, ray, &object->as) != SURE_FIELD_NONE)
        return SURE_INVALID;
    sure_status status = stages_last_hit(row, ray, &object->as, T_EXACT, &hit);
    if (status != SURE_HIT)
        return status;
    *t = hit.t;
    *part = hit.part;
    if (normal)
        *normal = rounded_normal(ray, row, &object->as);
    return status;
}

static sure_status interval(const sure_ray *ray, const sure_object *object, sure_interval *ends)
{
    const shape_row *row = row_of(object);
    if (shape_check(row, ray, &object->as) != SURE_FIELD_NONE)
        return SURE_INVALID;
    return stages_last_interval(row, ray, &object->as, ends);
}

/* Sign of the hit's t* - (t + more). */
static int beyond(exact_context *c, const line_coefficients *l, const sure_ray *ray, end_kind at,
                  double t, double more)
{
    exact x = exact_add(c, exact_of(c, t), exact_of(c, more));
    if (at == END_START)
        return exact_sign(c, exact_sub(c, exact_of(c, ray->t_min), x));
    return line_compare(c, l, at, x, exact_of(c, 1));
}

static bool hit_within(const sure_ray *ray, const sure_object *object, double t, double error)
{
    exact_arena room;
    exact_context c = exact_start(&room);
    line_coefficients l;
    tagged_end first;
    bool leaves;
    if (!isfinite(t) || !isfinite(error))
        return isinf(error);
    return line_hit(&c, ray, row_of(object), &object->as, &l, &first, &leaves) == SURE_HIT &&
           beyond(&c, &l, ray, first.at, t, error) <= 0 &&
           beyond(&c, &l, ray, first.at, t, -error) >= 0;
}

/* Of a real number only the nearest double is known, which is up to half a step from there: what
 * is certainly farther off than the error is refused. */
static bool may_be_within(double x, double rounded, double error)
{
    return fabsl((long double)x - rounded) <= ((long double)error + 0x1p-54) * (1 + LONG_SLACK);
}

static bool normal_within(const sure_ray *ray, const sure_object *object, sure_vec3 normal,
                          double error)
{
    sure_vec3 rounded = rounded_normal(ray, row_of(object), &object->as);
    return may_be_within(normal.x, rounded.x, error) && may_be_within(normal.y, rounded.y, error) &&
           may_be_within(normal.z, rounded.z, error);
}

const campaign_truth truth_of_floats = {.name = "floats",
                                        .first = SURE_TIER_CERTAIN,
                                        .floats = true,
                                        .check = sure_object_check,
                                        .hit = hit_of};

const campaign_truth truth_by_exact = {.name = "exact",
                                       .first = SURE_TIER_CERTAIN,
                                       .check = sure_object_check,
                                       .hit = hit_of,
                                       .interval = interval,
                                       .hit_within = hit_within,
                                       .normal_within = normal_within};
