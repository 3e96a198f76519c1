/* SPDX-License-Identifier: MIT */
/* The first stages' own headers, over a number that a test is asked about: every operation that
 * they do in doubles calls `computed`, which is the test's. */
#ifndef PROOFS_NUMBER_HPP
#define PROOFS_NUMBER_HPP

#include "numbers/bits.h"
#include "numbers/places.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

enum operation { GIVEN, NEGATION, MAGNITUDE, ROOT, SIGNED, SUM, DIFFERENCE, PRODUCT, QUOTIENT };

struct scalar {
    double value;
    int step; /* which of the computation's; 0: a constant */
    scalar() = default;
    scalar(double x, int at = 0) : value(x), step(at)
    {
    }
};

/* The number for what is `exact` in doubles. */
scalar computed(operation what, scalar x, scalar y, double exact);

/* Told of each comparison: that x > y was asked. */
void compared(scalar x, scalar y);

inline scalar operator-(scalar x)
{
    return computed(NEGATION, x, 0, -x.value);
}
inline scalar operator+(scalar x, scalar y)
{
    return computed(SUM, x, y, x.value + y.value);
}
inline scalar operator-(scalar x, scalar y)
{
    return computed(DIFFERENCE, x, y, x.value - y.value);
}
inline scalar operator*(scalar x, scalar y)
{
    return computed(PRODUCT, x, y, x.value * y.value);
}
inline scalar operator/(scalar x, scalar y)
{
    return computed(QUOTIENT, x, y, x.value / y.value);
}
inline scalar &operator+=(scalar &x, scalar y)
{
    return x = x + y;
}
inline scalar sqrt(scalar x)
{
    return computed(ROOT, x, 0, sqrt(x.value));
}
inline scalar fabs(scalar x)
{
    return computed(MAGNITUDE, x, 0, fabs(x.value));
}
inline scalar copysign(scalar x, scalar y)
{
    return computed(SIGNED, x, y, copysign(x.value, y.value));
}
inline scalar fma(scalar x, scalar y, scalar z)
{
    return computed(SUM, x * y, z, fma(x.value, y.value, z.value));
}
inline bool operator>(scalar x, scalar y)
{
    return compared(x, y), x.value > y.value;
}
inline bool operator<(scalar x, scalar y)
{
    return y > x;
}
inline bool operator<=(scalar x, scalar y)
{
    return x.value <= y.value;
}
inline bool operator>=(scalar x, scalar y)
{
    return x.value >= y.value;
}
inline bool operator==(scalar x, scalar y)
{
    return x.value == y.value;
}
inline bool isunordered(scalar x, scalar y)
{
    return isnan(x.value) || isnan(y.value);
}
#define OF_VALUE(type, asked)                                                                      \
    inline type asked(scalar x)                                                                    \
    {                                                                                              \
        return asked(x.value);                                                                     \
    }
OF_VALUE(uint64_t, bits_of)
OF_VALUE(bool, is_finite_bits)
OF_VALUE(bool, is_negative_bits)
OF_VALUE(bool, is_subnormal_bits)
OF_VALUE(bool, is_zero_bits)

#define double scalar
#include "numbers/error_free.h"

/* Two sums and products that are error-free are not recorded by their steps: who asks for
 * double-doubles says how they are. */
#ifdef WITH_PAIRS
double_pair exact_sum(scalar x, scalar y);
double_pair exact_product(scalar x, scalar y);
#else
inline double_pair no_pair(scalar, scalar)
{
    abort();
}
#define exact_sum no_pair
#define exact_product no_pair
#endif
#define two_sum exact_sum
#define two_product exact_product
#include "every_filter.h"
#include "shapes/capped/height_filter.h"
#undef two_sum
#undef two_product
#undef double

#include <surehit/object.h>

/* From a shape's data: has it a field of that kind, or of that name? */
inline bool shape_has(sure_shape shape, sure_kind kind)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    for (int i = 0; i < info->field_count; i++)
        if (info->fields[i].kind == kind)
            return true;
    return false;
}

inline bool shape_tapers(sure_shape shape)
{
    return sure_shape_info_of(shape)->fields[1].name == SURE_FIELD_APEX;
}

/* A query's numbers: o, d, up to seven of the object's, as its header has them, t_min, t_max. */
enum { OBJECT = 6, T_MIN = 13, T_MAX, INPUTS };
struct query {
    sure_ray ray;
    sure_object object;
};

inline query query_of(sure_shape shape, const scalar inputs[INPUTS])
{
    query q;
    q.ray = sure_ray{{inputs[0], inputs[1], inputs[2]},
                     {inputs[3], inputs[4], inputs[5]},
                     inputs[T_MIN],
                     inputs[T_MAX]};
    q.object.shape = shape;
    memcpy(&q.object.as, inputs + OBJECT, sizeof q.object.as);
    return q;
}

inline filter_verdict filtered(const query &q, filter_interval *found)
{
    switch (q.object.shape) {
#define FILTER(shape, SHAPE)                                                                       \
    case SURE_SHAPE_##SHAPE: return shape##_filter(&q.ray, &q.object.as.shape, found);
        SURE_EACH_SHAPE(FILTER)
#undef FILTER
    }
    return FILTER_UNCERTAIN;
}

#endif
