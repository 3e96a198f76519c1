/* SPDX-License-Identifier: MIT */
#include "campaign_check.h"

#include "../support/long_vector.h"

static sure_status hit_of(const sure_ray *ray, const sure_object *object, double *t,
                          sure_part *part, sure_vec3 *normal)
{
    sure_hit hit;
    sure_status status = sure_object_hit(ray, object, SURE_TIER_EXACT, &hit);
    if (status != SURE_HIT)
        return status;
    *t = hit.t;
    *part = hit.part;
    if (normal)
        *normal = sure_object_normal(ray, object, SURE_TIER_EXACT, &hit);
    return status;
}

static sure_status interval(const sure_ray *ray, const sure_object *object, sure_interval *ends)
{
    return sure_object_interval(ray, object, SURE_TIER_EXACT, ends);
}

/* Of a real number only the nearest double is known, which is up to `half` a step from there: what
 * is certainly farther off than the error is refused. */
static bool may_be_within(double x, double rounded, double half, double error)
{
    return fabsl((long double)x - rounded) <= ((long double)error + half) * (1 + LONG_SLACK);
}

static bool hit_within(const sure_ray *ray, const sure_object *object, double t, double error)
{
    sure_hit hit;
    sure_object_hit(ray, object, SURE_TIER_EXACT, &hit);
    return may_be_within(t, hit.t, hit.t_error, error);
}

static bool normal_within(const sure_ray *ray, const sure_object *object, sure_vec3 normal,
                          double error)
{
    sure_hit hit;
    sure_object_hit(ray, object, SURE_TIER_EXACT, &hit);
    sure_vec3 rounded = sure_object_normal(ray, object, SURE_TIER_EXACT, &hit);
    return may_be_within(normal.x, rounded.x, 0x1p-54, error) &&
           may_be_within(normal.y, rounded.y, 0x1p-54, error) &&
           may_be_within(normal.z, rounded.z, 0x1p-54, error);
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
