/* SPDX-License-Identifier: MIT */
/* A candidate whose cylinders and cones are infinite walls, right but for what SUREHIT_WRONG
 * names; its spheres are as all. */
#include "wrong.h"
#include "../../../src/geometry/coordinate.h"

#include <surehit/cone_wall.h>
#include <surehit/cylinder_wall.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;
const char sure_candidate_entry[] = "wall";

/* In the apex' plane ends what a single nappe has. */
static int is_beyond_apex(const sure_ray *ray, const sure_cone *cone, double t)
{
    double depth = 0;
    for (int i = 0; i < 3; i++) {
        const double apex = coordinate(cone->apex, i);
        const double at = coordinate(ray->origin, i) + t * coordinate(ray->direction, i);
        depth += (coordinate(cone->base, i) - apex) * (at - apex);
    }
    return depth < 0;
}

static sure_status answer(const sure_ray *ray, const sure_object *object, sure_hit *hit)
{
    if (object->shape == SURE_SHAPE_SPHERE || is_wrong("capped"))
        return sure_object_hit(ray, object, SURE_TIER_EXACT, hit);
    if (object->shape == SURE_SHAPE_CYLINDER)
        return sure_cylinder_wall_hit_exact(ray, &object->as.cylinder, hit);
    sure_status status = sure_cone_wall_hit_exact(ray, &object->as.cone, hit);
    return status == SURE_HIT && is_wrong("one nappe") &&
                   is_beyond_apex(ray, &object->as.cone, hit->t)
               ? SURE_MISS
               : status;
}

static int give(sure_shape shape, const double *from, const double *numbers, sure_candidate_hit *to)
{
    const sure_ray ray = {vector(from), vector(from + 3), from[6], from[7]};
    sure_object object = object_of(shape, numbers);
    sure_hit hit;
    sure_status status = answer(&ray, &object, &hit);
    if (is_now(from, 8) && is_wrong("false miss"))
        return SURE_CANDIDATE_MISS;
    if (status == SURE_HIT)
        to->t = is_now(from, 8) && is_wrong("3 ulps")
                    ? nextafter(nextafter(nextafter(hit.t, 0), 0), 0)
                    : hit.t;
    if (status == SURE_HIT && is_wrong("part"))
        to->part = SURE_PART_BASE;
    return (int)status;
}

#define ASKED(shape, SHAPE)                                                                        \
    int sure_candidate_##shape(const double *ray, const double *shape, sure_candidate_hit *hit)    \
    {                                                                                              \
        return give(SURE_SHAPE_##SHAPE, ray, shape, hit);                                          \
    }
ASKED(sphere, SPHERE)
ASKED(cylinder, CYLINDER)
ASKED(cone, CONE)
