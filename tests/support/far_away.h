/* SPDX-License-Identifier: MIT */
/* Walls that are seen from so far away that A x p or A.p cancels to less than the tails of its
 * terms (docs/proofs/axial_polish.md). */
#pragma once

#include "../../src/cases/case.h"
#include "../../src/cases/rng.h"
#include "../../src/numbers/bits.h"
#include "../../src/numbers/sums.h"

static inline sure_vec3 far_small_vector(rng *g)
{
    return (sure_vec3){rng_integer(g, 1, 7), rng_integer(g, -7, 7), rng_integer(g, -7, 7)};
}

static inline sure_vec3 far_scaled(double by, sure_vec3 v)
{
    return (sure_vec3){by * v.x, by * v.y, by * v.z};
}

static inline double far_power(rng *g, int low, int high)
{
    return times_two_to(1, rng_integer(g, low, high));
}

/* A cylinder or cone whose axis goes through 0, as does the ray: across it, almost along it, or in
 * any other way. One of both begins far away. */
static inline sure_case case_far_away(sure_shape shape, uint64_t seed, uint64_t i)
{
    rng g = rng_of(seed, (uint64_t)shape, 0, i);
    const sure_vec3 a = far_small_vector(&g), b = far_small_vector(&g);
    const double small = far_power(&g, -60, 0), radius = rng_whole(&g, 30) * far_power(&g, -80, 0);
    const double way = rng_whole(&g, 44), along = far_power(&g, 0, 40);
    const sure_vec3 nearly = {b.x + along * a.x, b.y + along * a.y, b.z + along * a.z};
    const int which = rng_integer(&g, 0, 3);
    const sure_vec3 d = which == 0 && way < 0x1p12 ? nearly : which == 1 ? b : cross_of(a, b);
    const bool base_is_far = which == 3;
    return (sure_case){.ray = {far_scaled(base_is_far ? -small : -way, d), d, 0, HUGE_VAL},
                       .object = {shape,
                                  {.cone = {far_scaled(base_is_far ? -way : -small, a),
                                            far_scaled(small, a), radius}}}};
}
