/* SPDX-License-Identifier: MIT */
/* One formula, many numbers. A source that is written over `number` and `vector` is compiled for
 * whatever NUMBER stands for where it is included or compiled:
 *
 *     #define NUMBER dd
 *     #include "cone_tmpl.h"
 *
 * makes cone_form_dd of what is called OVER(cone_form) there, and leaves no NUMBER. The numbers:
 *
 *     f64      a double, rounded at each operation (stages/filter.h)
 *     dd       a double-double
 *     ddb      a double-double with a bound of its error, computed along
 *     mod128   an integer modulo 2^128, times a power of two
 *     exact    an integer of any length, times a power of two
 *     most     a double: what the terms come to, added up in magnitude
 *
 * Of these ddb and exact have signs. A sign that a ddb can't tell marks the context as uncertain;
 * whatever is computed from there on means nothing, and the caller goes on to the next stage. */
#pragma once

#include "bits.h"

#define NUMBER_JOINED(a, b) a##_##b
#define NUMBER_JOIN(a, b) NUMBER_JOINED(a, b)

/* name_dd, ... */
#define OVER(name) NUMBER_JOIN(name, NUMBER)

#define number NUMBER
#define number_context NUMBER_JOIN(NUMBER, context)
#define number_of NUMBER_JOIN(NUMBER, of)
#define number_add NUMBER_JOIN(NUMBER, add)
#define number_sub NUMBER_JOIN(NUMBER, sub)
#define number_mul NUMBER_JOIN(NUMBER, mul)
#define number_square NUMBER_JOIN(NUMBER, square)
#define number_difference_of NUMBER_JOIN(NUMBER, difference_of)
#define number_negate NUMBER_JOIN(NUMBER, negate)
#define number_sign NUMBER_JOIN(NUMBER, sign)
#define number_minor NUMBER_JOIN(NUMBER, minor)

#define vector OVER(vector)
#define vector_of OVER(vector_of)
#define vector_add OVER(vector_add)
#define vector_sub OVER(vector_sub)
#define vector_between OVER(vector_between)
#define vector_scale OVER(vector_scale)
#define vector_dot OVER(vector_dot)
#define vector_square OVER(vector_square)
#define vector_cross OVER(vector_cross)
#define vector_negate OVER(vector_negate)

/* Small numbers stay in registers when nothing is called. Apart is what is called in another
 * floating-point environment (environment.h). Rare is compiled for size. */
#ifdef __GNUC__
#define NUMBER_INLINE static INLINED __attribute__((unused))
#define NUMBER_APART static __attribute__((noinline, unused))
#define NUMBER_RARE static __attribute__((noinline, cold, unused))
#else
#define NUMBER_INLINE static INLINED
#define NUMBER_APART static
#define NUMBER_RARE static
#endif

/* An operation of numbers of the type that is one expression; `context` is what it is handed. */
#define NUMBER_OPERATION(type, operation, value, ...)                                              \
    static inline type type##_##operation(type##_context *context, __VA_ARGS__)                    \
    {                                                                                              \
        (void)context;                                                                             \
        return value;                                                                              \
    }

/* What operations are handed; of most numbers they have no use for it. */
typedef struct {
    char unused;
} no_context;

/* The greater of the signs of two of a solid's functions: it is outside where any is positive. */
NUMBER_INLINE int number_side(int x, int y)
{
    return x > y ? x : y;
}
