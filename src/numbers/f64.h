/* A double as one of the numbers of number.h. */
#ifndef NUMBERS_F64_H
#define NUMBERS_F64_H

#include "bits.h"

typedef double f64;

/* One that all numbers have (number.h); these have no use for it. */
typedef struct {
    char unused;
} f64_context;

static inline f64 f64_of(f64_context *context, double x)
{
    (void)context;
    return x;
}

static inline f64 f64_difference_of(f64_context *context, double x, double y)
{
    (void)context;
    return x - y;
}

static inline f64 f64_negate(f64_context *context, f64 x)
{
    (void)context;
    return -x;
}

static inline f64 f64_add(f64_context *context, f64 x, f64 y)
{
    (void)context;
    return x + y;
}

static inline f64 f64_sub(f64_context *context, f64 x, f64 y)
{
    (void)context;
    return x - y;
}

static inline f64 f64_mul(f64_context *context, f64 x, f64 y)
{
    (void)context;
    return x * y;
}

static inline f64 f64_square(f64_context *context, f64 x)
{
    (void)context;
    return x * x;
}

#define NUMBER f64
#include "vector_tmpl.h"
#undef NUMBER

#endif
