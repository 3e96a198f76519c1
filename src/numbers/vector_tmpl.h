/* SPDX-License-Identifier: MIT */
/* Differences and vectors of NUMBERs (number.h). */
#include "number.h"

#include <surehit/vector.h>

#ifndef NUMBER_HAS_SUB
NUMBER_INLINE number number_sub(number_context *c, number x, number y)
{
    return number_add(c, x, number_negate(c, y));
}
#endif

typedef struct {
    number x, y, z;
} vector;

NUMBER_INLINE vector vector_of(number_context *c, sure_vec3 v)
{
    return (vector){number_of(c, v.x), number_of(c, v.y), number_of(c, v.z)};
}

NUMBER_INLINE vector vector_add(number_context *c, vector v, vector w)
{
    return (vector){number_add(c, v.x, w.x), number_add(c, v.y, w.y), number_add(c, v.z, w.z)};
}

NUMBER_INLINE vector vector_sub(number_context *c, vector v, vector w)
{
    return (vector){number_sub(c, v.x, w.x), number_sub(c, v.y, w.y), number_sub(c, v.z, w.z)};
}

NUMBER_INLINE vector vector_negate(number_context *c, vector v)
{
    return (vector){number_negate(c, v.x), number_negate(c, v.y), number_negate(c, v.z)};
}

/* to - from */
NUMBER_INLINE vector vector_between(number_context *c, sure_vec3 from, sure_vec3 to)
{
    return (vector){number_difference_of(c, to.x, from.x), number_difference_of(c, to.y, from.y),
                    number_difference_of(c, to.z, from.z)};
}

NUMBER_INLINE vector vector_scale(number_context *c, number k, vector v)
{
    return (vector){number_mul(c, k, v.x), number_mul(c, k, v.y), number_mul(c, k, v.z)};
}

NUMBER_INLINE number vector_dot(number_context *c, vector v, vector w)
{
    number xy = number_add(c, number_mul(c, v.x, w.x), number_mul(c, v.y, w.y));
    return number_add(c, xy, number_mul(c, v.z, w.z));
}

NUMBER_INLINE number vector_square(number_context *c, vector v)
{
    number xy = number_add(c, number_square(c, v.x), number_square(c, v.y));
    return number_add(c, xy, number_square(c, v.z));
}

/* p s - q r */
NUMBER_INLINE number number_minor(number_context *c, number p, number q, number r, number s)
{
    return number_sub(c, number_mul(c, p, s), number_mul(c, q, r));
}

NUMBER_INLINE vector vector_cross(number_context *c, vector v, vector w)
{
    return (vector){number_minor(c, v.y, v.z, w.y, w.z), number_minor(c, v.z, v.x, w.z, w.x),
                    number_minor(c, v.x, v.y, w.x, w.y)};
}

/* A difference that is not yet taken: of terms that are near each other little would be left. */
typedef struct {
    number more, less;
} OVER(two_terms);

NUMBER_INLINE number OVER(difference)(number_context *c, OVER(two_terms) terms)
{
    return number_sub(c, terms.more, terms.less);
}

#undef NUMBER
