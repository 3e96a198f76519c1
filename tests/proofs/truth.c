/* SPDX-License-Identifier: MIT */
#include "truth.h"

#include <surehit/object.h>

#include <math.h>
#include <string.h>

/* Where the line through o along share d meets the object, in multiples of d, if it does for t >= 0
 * of that. */
static bool one_way(sure_ray ray, double share, const sure_object *object, struct truth *truth)
{
    sure_interval interval;
    int first = share < 0;
    ray.direction.x *= share;
    ray.direction.y *= share;
    ray.direction.z *= share;
    ray.t_min = 0;
    ray.t_max = HUGE_VAL;
    if (sure_object_interval(&ray, object, SURE_TIER_EXACT, &interval) != SURE_HIT)
        return false;
    truth->t[first] = share * interval.t_enter;
    truth->t[!first] = share * interval.t_leave;
    truth->part[first] = (int)interval.enter_part;
    truth->part[!first] = (int)interval.leave_part;
    return true;
}

bool truth_of(const double *inputs, int shape, struct truth *truth)
{
    sure_object object = {.shape = (sure_shape)shape};
    sure_ray ray = {{inputs[0], inputs[1], inputs[2]},
                    {inputs[3], inputs[4], inputs[5]},
                    inputs[13],
                    inputs[14]};
    sure_hit hit;
    memcpy(&object.as, inputs + 6, sizeof object.as);
    if (sure_object_check(&ray, &object) != SURE_FIELD_NONE)
        return false;
    truth->meets = one_way(ray, 1, &object, truth) || one_way(ray, -1, &object, truth);
    truth->hits = sure_object_hit(&ray, &object, SURE_TIER_EXACT, &hit) == SURE_HIT;
    if (truth->hits) {
        truth->hit_t = hit.t;
        truth->hit_part = (int)hit.part;
    }
    ray.t_max = HUGE_VAL;
    truth->ahead = sure_object_occluded(&ray, &object, SURE_TIER_EXACT) == SURE_HIT;
    return true;
}
