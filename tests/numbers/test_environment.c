/* SPDX-License-Identifier: MIT */
/* The caller's rounding mode is seen, changed and given back; compiled with and without the
 * optimiser, which must not undo what is volatile. */
#include "../support/suite.h"
#include "../support/surroundings.h"

#include "../../src/numbers/flushing.h"

static volatile double one = 1, five = 5, least = 0x1p-1022, half = 0x1p-1023, two = 2;

/* Where the compiler can't look; what a wide stage would do. */
typedef struct {
    double fifth, minus_fifth, half_least, least;
} sample;

static sample take(void)
{
    return (sample){one / five, -one / five, least / two, half * two};
}

static sample (*volatile look)(void) = take;

static bool same(sample x, sample y)
{
    return memcmp(&x, &y, sizeof x) == 0;
}

/* Rounding modes, and flushing with any of them, are off inside and on again after. */
LOOP_TEST(test_enter_and_leave, SURROUNDINGS_ALL)
{
    const sample usual = {0x1.999999999999ap-3, -0x1.999999999999ap-3, 0x1p-1023, 0x1p-1022};
    environment saved;
    surroundings_set(_i);
    volatile bool nearest_before = environment_is_nearest();
    volatile bool default_before = environment_is_default();
    sample before = look();
    environment_enter(&saved);
    volatile bool nearest = environment_is_nearest();
    sample inside = look();
    environment_leave(&saved);
    int mode = fegetround();
    sample after = look();
    surroundings_set(0);
    ck_assert_int_eq(nearest_before, _i % SURROUNDINGS_MODES == 0);
    ck_assert_int_eq(default_before, _i == 0);
    ck_assert(nearest && same(inside, usual));
    ck_assert(same(after, before) && same(before, usual) == (_i == 0));
    ck_assert_int_eq(mode == FE_TONEAREST, _i % SURROUNDINGS_MODES == 0);
    ck_assert(environment_is_nearest());
}

/* Inside, to nearest nothing but subnormals is other than it was, and in another mode nothing; then
 * nothing is. */
LOOP_TEST(test_flush_and_leave, SURROUNDINGS_ALL)
{
    environment saved;
    surroundings_enter(_i);
    sample before = look();
    environment_flush(&saved);
    sample inside = look();
    environment_leave(&saved);
    sample after = look();
    volatile bool kept = surroundings_kept(_i);
    surroundings_set(0);
#ifdef ENVIRONMENT_IS_MXCSR
    if (_i % SURROUNDINGS_MODES == 0)
        before.half_least = before.least = 0;
#endif
    ck_assert(same(inside, before));
    ck_assert(kept && after.fifth == before.fifth && after.minus_fifth == before.minus_fifth);
}

/* Flags raised inside are not the caller's; his own are kept. */
TEST(test_flags)
{
    feclearexcept(FE_ALL_EXCEPT);
    feraiseexcept(FE_DIVBYZERO);
    environment saved;
    environment_enter(&saved);
    (void)look();
    environment_leave(&saved);
    ck_assert(fetestexcept(FE_DIVBYZERO) != 0);
    ck_assert(fetestexcept(FE_INEXACT) == 0);
}

SUITE("environment")
