/* SPDX-License-Identifier: MIT */
#include "rotation_laws.h"

#include "tiers.h"

#include <stddef.h>

turn *turn_of(int axis, sure_tier tier)
{
    static turn *const turns[][TIERS] = {OF_TIERS(sure_rotate_x), OF_TIERS(sure_rotate_y),
                                         OF_TIERS(sure_rotate_z)};
    return turns[axis][tier];
}

static sure_vec3 components_moved_on(sure_vec3 v)
{
    return (sure_vec3){v.z, v.x, v.y};
}

static const char *law_2_broken(sure_tier tier, double angle)
{
    turn *about_x = turn_of(0, tier);
    sure_vec3 there = about_x(angle, (sure_vec3){0, 1, 0});
    if (!all_finite(there))
        return "a turned axis is none";
    sure_vec3 back = about_x(-angle, there);
    double cc = rounded(tier, there.y * there.y), ss = rounded(tier, there.z * there.z);
    if (back.x != 0 || back.y != rounded(tier, cc + ss) || back.z != 0)
        return "Law 2: there and back is not cos^2 + sin^2";
    return NULL;
}

/* R_x, R_y and R_z in turn, the coordinates moved on as they are. */
const char *turn_law_broken(sure_tier tier, double angle, sure_vec3 v)
{
    sure_vec3 given = v, kept = rounded_vector(tier, v), expected = turn_of(0, tier)(angle, v);
    if (!same(expected.x, kept.x))
        return "Law 1: the axis' own coordinate is changed";
    for (int axis = 0; axis < 3; axis++) {
        if (all_finite(kept) && !same_vector(turn_of(axis, tier)(0, v), kept))
            return "Law 1: an angle of 0 changes the vector";
        if (!same_vector(turn_of(axis, tier)(angle, given), expected))
            return "Law 3: another axis turns otherwise";
        given = components_moved_on(given);
        expected = components_moved_on(expected);
    }
    return isfinite(rounded(tier, angle)) ? law_2_broken(tier, angle) : NULL;
}
