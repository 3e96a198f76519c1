/* SPDX-License-Identifier: MIT */
/* Rotations about the axes and by a matrix: their laws in every tier, and the turned vector against
 * the reference. */
#include "fuzz.h"
#include "rotation_laws.h"
#include "tiers.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "reference.h"
#endif

#include <float.h>

FUZZ_TARGET("rotation", fuzz_mutate_doubles)

enum { AXES = 3 };

static sure_vec3 (*const apply[TIERS])(const sure_mat3 *,
                                       sure_vec3) = OF_TIERS(sure_rotation_apply);

typedef struct {
    int axis; /* for the reference; the laws hold for all */
    double angle;
    sure_vec3 v;
} question;

#ifndef FUZZ_WITHOUT_REFERENCE
/* Nothing is published: cosine and sine are the C library's. GNU's manual gives them 1 ulp, 2 u at
 * most. With u each for a product, the sum and the reference's own rounding a component is off by
 * at most 5 u (|cos p| + |sin q|) <= 5 sqrt(2) u times the larger of |p| and |q|, which is less
 * than: */
#define ROTATION_ROUNDINGS 8

static bool near(sure_tier tier, double x, double truth, double p, double q)
{
    long double larger = fmax(fabs(p), fabs(q));
    long double most = ROTATION_ROUNDINGS * unit(tier) * larger + 2 * least(tier);
    return fabsl((long double)x - truth) <= most;
}

/* Is no sum of two products beyond the largest number? */
static bool far_from_overflow(sure_tier tier, sure_vec3 v)
{
    double most = tier == SURE_TIER_FLOAT32 ? FLT_MAX / 4 : DBL_MAX / 4;
    return fabs(v.x) <= most && fabs(v.y) <= most && fabs(v.z) <= most;
}

static void check_reference(const question *q, sure_tier tier)
{
    const int axis = q->axis;
    sure_vec3 v = rounded_vector(tier, q->v);
    double angle = rounded(tier, q->angle);
    if (!isfinite(angle) || !far_from_overflow(tier, v))
        return;
    fuzz_by(tier);
    sure_vec3 given = turn_of(axis, tier)(q->angle, q->v), right = reference_rotate(axis, angle, v);
    bool x =
        axis == 0 || near(tier, given.x, right.x, axis == 1 ? v.z : v.x, axis == 1 ? v.x : v.y);
    bool y = axis == 1 || near(tier, given.y, right.y, v.y, axis == 0 ? v.z : v.x);
    bool z = axis == 2 || near(tier, given.z, right.z, v.z, axis == 0 ? v.y : v.x);
    expect(x && y && z, "too far from the true rotation");
}
#endif

/* A product and two sums, 3 u of the products' magnitudes and a little; long double has 11 bits
 * more. What underflows is one least number a product, and as much of a component that stable
 * quarters. */
static bool near_dot(sure_tier tier, sure_vec3 row, sure_vec3 v, double given, double largest)
{
    long double x = (long double)row.x * v.x, y = (long double)row.y * v.y;
    long double z = (long double)row.z * v.z, sum = x + y + z;
    long double terms = fabsl(x) + fabsl(y) + fabsl(z);
    long double entries = fabsl(row.x) + fabsl(row.y) + fabsl(row.z);
    long double most = 4 * unit(tier) * terms + 4 * least(tier) * (1 + entries);
    return terms > largest / 2 || fabsl(given - sum) <= most;
}

/* Stable overflows only where the sum does, the entries being a rotation's, 1 at most. */
static bool overflows_late(sure_vec3 row, sure_vec3 v, double given)
{
    long double x = (long double)row.x * v.x, y = (long double)row.y * v.y;
    long double sum = x + y + (long double)row.z * v.z;
    bool small = fabs(row.x) <= 1 && fabs(row.y) <= 1 && fabs(row.z) <= 1;
    return !small || fabsl(sum) > DBL_MAX / 2 || isfinite(given);
}

static void check_apply(const question *q, const sure_mat3 *matrix, sure_tier tier)
{
    sure_vec3 v = rounded_vector(tier, q->v), given = apply[tier](matrix, q->v);
    const double parts[AXES] = {given.x, given.y, given.z};
    for (int i = 0; i < AXES; i++) {
        sure_vec3 row = rounded_vector(tier, matrix->row[i]);
        if (!all_finite(v) || !all_finite(row))
            return;
        expect(near_dot(tier, row, v, parts[i], tier == SURE_TIER_FLOAT32 ? FLT_MAX : DBL_MAX),
               "a matrix gives another vector");
        if (tier == SURE_TIER_STABLE)
            expect(overflows_late(row, v, parts[i]), "a product overflows too early");
    }
}

/* Decoding. */

/* As a rotation has them. */
static double read_entry(fuzz_bytes *bytes)
{
    return (int8_t)fuzz_byte(bytes) / 128.0;
}

/* Nearly as large as doubles come: sums of two products overflow. */
static sure_vec3 enlarged(sure_vec3 v, int below)
{
    int exponent;
    (void)frexp(fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z))), &exponent);
    return times_two_to(v, DBL_MAX_EXP - exponent - below);
}

/* Any, or some steps from a multiple of a quarter of pi. */
static double read_angle(fuzz_bytes *bytes, uint8_t how)
{
    const double quarter = 0.78539816339744830962;
    if (how % 4 == 0)
        return fuzz_double(bytes);
    if (how % 4 == 1)
        return fuzz_shaped_double(bytes);
    double times = (int8_t)fuzz_byte(bytes);
    return fuzz_ulps(times * quarter, (int8_t)fuzz_byte(bytes));
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t how = fuzz_byte(&bytes);
    question q = {.axis = fuzz_byte(&bytes) % AXES};
    q.angle = read_angle(&bytes, how);
    sure_mat3 matrix;
    q.v = fuzz_vector(&bytes, how & 4 ? fuzz_double : fuzz_shaped_double);
    if (how & 8)
        q.v = enlarged(q.v, fuzz_byte(&bytes) % 8);
    if (!isfinite(q.angle) || !all_finite(q.v))
        return false;
    for (int i = 0; i < AXES; i++)
        matrix.row[i] = fuzz_vector(&bytes, how & 4 ? fuzz_shaped_double : read_entry);
    fuzz_ask("angle %a v %a %a %a", q.angle, q.v.x, q.v.y, q.v.z);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        fuzz_promised(tier, turn_law_broken(tier, q.angle, q.v));
        check_apply(&q, &matrix, tier);
    }
#ifndef FUZZ_WITHOUT_REFERENCE
    unsigned asked = how / 16 % 8; /* it takes longer than all the rest */
    if (asked < TIERS)
        check_reference(&q, (sure_tier)asked);
#endif
    return true;
}
