#include "truth.h"

#include <surehit/object.h>

#include <math.h>
#include <string.h>

/* Where the line through o along share d meets the object, in multiples of d, if it does for t >= 0
 * of that. */
static sure_status one_way(const double *inputs, double share, int shape, struct truth *truth)
{
    sure_object object = {.shape = (sure_shape)shape};
    sure_vec3 d = {share * inputs[3], share * inputs[4], share * inputs[5]};
    sure_ray ray = {{inputs[0], inputs[1], inputs[2]}, d, 0, HUGE_VAL};
    sure_interval interval;
    memcpy(&object.as, inputs + 6, sizeof object.as);
    sure_status status = sure_object_interval(&ray, &object, SURE_TIER_EXACT, &interval);
    int first = share < 0;
    if (status == SURE_HIT) {
        truth->t[first] = share * interval.t_enter;
        truth->t[!first] = share * interval.t_leave;
        truth->part[first] = interval.enter_part;
        truth->part[!first] = interval.leave_part;
    }
    return status;
}

bool truth_of(const double *inputs, int shape, struct truth *truth)
{
    sure_status ahead = one_way(inputs, 1, shape, truth);
    truth->ahead = ahead == SURE_HIT;
    truth->meets = truth->ahead || one_way(inputs, -1, shape, truth) == SURE_HIT;
    return ahead != SURE_INVALID;
}
