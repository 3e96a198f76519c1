/* What every decision rests on: IEEE arithmetic as written. A compiler that was told otherwise is
 * refused here. */
#ifndef NUMBERS_IEEE_H
#define NUMBERS_IEEE_H

#include <float.h>

#if FLT_EVAL_METHOD != 0
#error "surehit needs FLT_EVAL_METHOD 0: each operation rounded to its own type"
#endif
#if FLT_RADIX != 2 || DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024 || FLT_MANT_DIG != 24
#error "surehit needs IEEE 754 binary32 and binary64"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "surehit cannot be compiled with -ffast-math or a part of it"
#endif

#endif
