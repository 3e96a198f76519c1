/* SPDX-License-Identifier: MIT */
/* Numbers of the plain tiers. */
#pragma once

#include <math.h>
#include <stdbool.h>

#include <surehit/tier.h>
#include <surehit/vector.h>

enum { TIERS = SURE_TIER_STABLE + 1 };

/* A function of each. */
#define OF_TIERS(function)                                                                         \
    {                                                                                              \
        function##_float32, function##_textbook, function##_stable                                 \
    }

static inline double rounded(sure_tier tier, double x)
{
    return tier == SURE_TIER_FLOAT32 ? (double)(float)x : x;
}

static inline sure_vec3 rounded_vector(sure_tier tier, sure_vec3 v)
{
    return (sure_vec3){rounded(tier, v.x), rounded(tier, v.y), rounded(tier, v.z)};
}

/* u, and the least number. */
static inline long double unit(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1p-24L : 0x1p-53L;
}

static inline long double least(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1p-149L : 0x1p-1074L;
}

/* By value; not a number is itself. */
static inline bool same(double x, double y)
{
    return x == y || (isnan(x) && isnan(y));
}

static inline bool all_finite(sure_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static inline bool is_direction(sure_vec3 v)
{
    return all_finite(v) && (v.x != 0 || v.y != 0 || v.z != 0);
}

static inline sure_vec3 times_two_to(sure_vec3 v, int k)
{
    return (sure_vec3){ldexp(v.x, k), ldexp(v.y, k), ldexp(v.z, k)};
}

static inline bool same_vector(sure_vec3 a, sure_vec3 b)
{
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
