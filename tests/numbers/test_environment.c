/* The caller's rounding mode is seen, changed and given back; compiled with and without the
 * optimiser, which must not undo what is volatile. */
#include "../support/suite.h"

#include "../../src/numbers/environment.h"

#include <fenv.h>

static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
enum { MODES = sizeof modes / sizeof *modes };

static volatile double one = 1, five = 5, least = 0x1p-1022, two = 2;

/* Where the compiler can't look; what a wide stage would do. */
typedef struct {
    double fifth, minus_fifth, half_least;
} sample;

static sample take(void)
{
    return (sample){one / five, -one / five, least / two};
}

static sample (*volatile look)(void) = take;

static bool is_default(sample x)
{
    return x.fifth == 0x1.999999999999ap-3 && x.minus_fifth == -0x1.999999999999ap-3 &&
           x.half_least != 0;
}

LOOP_TEST(test_is_nearest, MODES)
{
    ck_assert_int_eq(fesetround(modes[_i]), 0);
    volatile bool nearest = environment_is_nearest();
    fesetround(FE_TONEAREST);
    ck_assert_int_eq(nearest, modes[_i] == FE_TONEAREST);
    ck_assert(environment_is_nearest());
}

LOOP_TEST(test_enter_and_leave, MODES)
{
    ck_assert_int_eq(fesetround(modes[_i]), 0);
    environment saved;
    environment_enter(&saved);
    volatile bool nearest = environment_is_nearest();
    sample inside = look();
    environment_leave(&saved);
    int after_mode = fegetround();
    sample after = look();
    fesetround(FE_TONEAREST);
    ck_assert(nearest);
    ck_assert(is_default(inside));
    ck_assert_int_eq(after_mode, modes[_i]);
    ck_assert_int_eq(is_default(after), modes[_i] == FE_TONEAREST);
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

#ifdef __SSE2_MATH__
/* Flushing, and any mode besides, is off inside and on again after. */
LOOP_TEST(test_flushing, MODES)
{
    unsigned before = _mm_getcsr();
    fesetround(modes[_i]);
    _mm_setcsr(_mm_getcsr() | 0x8040);
    volatile bool nearest = environment_is_nearest();
    environment saved;
    environment_enter(&saved);
    sample inside = look();
    environment_leave(&saved);
    sample after = look();
    unsigned flags = _mm_getcsr();
    _mm_setcsr(before);
    ck_assert_int_eq(nearest, modes[_i] == FE_TONEAREST);
    ck_assert(is_default(inside));
    ck_assert(after.half_least == 0);
    ck_assert_uint_eq(flags & 0x8040, 0x8040);
    fesetround(FE_TONEAREST);
}
#endif

SUITE("environment")
