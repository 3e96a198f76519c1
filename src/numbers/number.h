/* One source, several stages: what decides a chord is compiled over double-doubles (SURE_NEAR),
 * over double-doubles with a residue (SURE_RESIDUE) and over exact numbers (SURE_EXACT). A sign
 * that a number can't tell marks the context as uncertain; whatever is computed from there on means
 * nothing and is dropped by the caller, who goes on to the next stage. A polynomial alone is also
 * compiled over pairs (SURE_PAIR) and modulo 2^128 (SURE_MODULAR), which have no sign. */
#ifndef NUMBERS_NUMBER_H
#define NUMBERS_NUMBER_H

#include "ieee.h"

#include <surehit/vector.h>

#if defined SURE_NEAR
#include "near.h"
#define STAGE(name) name##_near
#define NUMBER(operation) near##operation
#elif defined SURE_RESIDUE
#include "residue.h"
#define STAGE(name) name##_residue
#define NUMBER(operation) residue##operation
#elif defined SURE_PAIR
#include "pair.h"
#define STAGE(name) name##_pair
#define NUMBER(operation) pair##operation
#elif defined SURE_MODULAR
#include "modular.h"
#define STAGE(name) name##_modular
#define NUMBER(operation) modular##operation
#else
#include "exact.h"
#define STAGE(name) name##_exact
#define NUMBER(operation) exact##operation
#endif

/* Rounded numbers have a range; what lies outside is compared with its limits. */
#if defined SURE_NEAR || defined SURE_RESIDUE
#define NUMBER_RANGE 0x1p60
#ifdef SURE_RESIDUE
#define number_value residue_value
#else
#define number_value(x) (x)
#endif
#endif

/* Small numbers stay in registers when nothing is called. */
#if !defined SURE_EXACT && defined __GNUC__
#define NUMBER_INLINE static inline __attribute__((always_inline))
#else
#define NUMBER_INLINE static inline
#endif

typedef NUMBER() number;
typedef NUMBER(_context) context;
#define number_of NUMBER(_of)
#define number_add NUMBER(_add)
#define number_sub NUMBER(_sub)
#define number_mul NUMBER(_mul)
#define number_square NUMBER(_square)
#define number_difference_of NUMBER(_difference_of)
#define number_negate NUMBER(_negate)
#define number_sign NUMBER(_sign)

typedef struct {
    number x, y, z;
} vector;

NUMBER_INLINE vector vector_of(context *c, sure_vec3 v)
{
    return (vector){number_of(c, v.x), number_of(c, v.y), number_of(c, v.z)};
}

NUMBER_INLINE vector vector_add(context *c, vector v, vector w)
{
    return (vector){number_add(c, v.x, w.x), number_add(c, v.y, w.y), number_add(c, v.z, w.z)};
}

NUMBER_INLINE vector vector_sub(context *c, vector v, vector w)
{
    return (vector){number_sub(c, v.x, w.x), number_sub(c, v.y, w.y), number_sub(c, v.z, w.z)};
}

/* to - from */
NUMBER_INLINE vector vector_between(context *c, sure_vec3 from, sure_vec3 to)
{
    return (vector){number_difference_of(c, to.x, from.x), number_difference_of(c, to.y, from.y),
                    number_difference_of(c, to.z, from.z)};
}

NUMBER_INLINE vector vector_scale(context *c, number k, vector v)
{
    return (vector){number_mul(c, k, v.x), number_mul(c, k, v.y), number_mul(c, k, v.z)};
}

NUMBER_INLINE number vector_dot(context *c, vector v, vector w)
{
    number xy = number_add(c, number_mul(c, v.x, w.x), number_mul(c, v.y, w.y));
    return number_add(c, xy, number_mul(c, v.z, w.z));
}

NUMBER_INLINE number vector_square(context *c, vector v)
{
    number xy = number_add(c, number_square(c, v.x), number_square(c, v.y));
    return number_add(c, xy, number_square(c, v.z));
}

NUMBER_INLINE number number_minor(context *c, number p, number q, number r, number s)
{
    return number_sub(c, number_mul(c, p, s), number_mul(c, q, r));
}

NUMBER_INLINE vector vector_cross(context *c, vector v, vector w)
{
    return (vector){number_minor(c, v.y, v.z, w.y, w.z), number_minor(c, v.z, v.x, w.z, w.x),
                    number_minor(c, v.x, v.y, w.x, w.y)};
}

#endif
