/* SPDX-License-Identifier: MIT */
#include "campaign_check.h"

#include "../oracles/part_check.h"
#include "../support/hard_points.h"
#include "../support/long_vector.h"

#include "reference.h"

static bool hit_within(const sure_ray *ray, const sure_object *object, double t, double error)
{
    int within = 0;
    reference_hit_within(ray, object, t, error, &within);
    return within;
}

static bool normal_within(const sure_ray *ray, const sure_object *object, sure_vec3 normal,
                          double error)
{
    int within = 0;
    reference_normal_within(ray, object, normal, error, &within);
    return within;
}

/* And the projections of the notes' derivations. */
static void parts(const sure_case *question, uint64_t draw, const char *broken[CAMPAIGN_PARTS])
{
    const sure_object *solid = &question->object;
    const sure_ray *ray = &question->ray;
    part_unrounded unused = {0};
    if (!has_parts(solid->shape))
        return;
    sure_vec3 p = hard_point(solid, draw);
    broken[0] = height_broken(solid, p, &unused);
    broken[1] = wall_hit_broken(ray, solid, &unused);
    broken[2] = wall_normal_broken(solid, p, &unused);
    broken[3] = end_points_broken(
        solid->shape, ray->origin, ray->direction, solid->as.cylinder.radius,
        (double)long_length(long_between(solid->as.cylinder.base, solid->as.cylinder.top)),
        &unused);
    broken[4] = vectors_broken(p, ray->direction, &unused);
}

static const char *bracket(const sure_case *question)
{
    unsigned long unused = 0;
    return bracket_broken(&question->ray, &question->object, &unused);
}

const campaign_truth truth_by_reference = {.name = "reference",
                                           .first = SURE_TIER_FLOAT32,
                                           .check = reference_check,
                                           .hit = reference_hit,
                                           .interval = reference_interval,
                                           .hit_within = hit_within,
                                           .normal_within = normal_within,
                                           .where = reference_where,
                                           .parts = parts,
                                           .bracket = bracket};
