/* Twice the digits of double, for stable refraction where the digits of double cancel. A product is
 * off by some 2^-102 of itself, a sum by 2^-104 of its terms. */
#ifndef NUMBERS_TWICE_H
#define NUMBERS_TWICE_H

#include "error_free.h"
#include "scale.h"

/* head + tail, |tail| <= 2^-53 |head| */
typedef double_pair twice;

typedef struct {
    twice x, y, z;
} twice_vec3;

static inline twice twice_sum(twice x, twice y)
{
    double_pair heads = two_sum(x.head, y.head);
    double_pair tails = two_sum(x.tail, y.tail);
    double_pair sum = fast_two_sum(heads.head, heads.tail + tails.head);
    return fast_two_sum(sum.head, sum.tail + tails.tail);
}

static inline twice twice_difference(twice x, twice y)
{
    return twice_sum(x, (twice){-y.head, -y.tail});
}

static inline twice twice_product(twice x, twice y)
{
    double_pair product = two_product(x.head, y.head);
    return fast_two_sum(product.head, product.tail + (x.head * y.tail + x.tail * y.head));
}

static inline vec3 twice_head(const twice_vec3 *v)
{
    return (vec3){v->x.head, v->y.head, v->z.head};
}

static inline twice twice_dot(const twice_vec3 *a, const twice_vec3 *b)
{
    twice xy = twice_sum(twice_product(a->x, b->x), twice_product(a->y, b->y));
    return twice_sum(xy, twice_product(a->z, b->z));
}

static inline twice twice_minor(twice p, twice q, twice r, twice s)
{
    return twice_difference(twice_product(p, s), twice_product(q, r));
}

static inline twice_vec3 twice_cross(const twice_vec3 *a, const twice_vec3 *b)
{
    return (twice_vec3){twice_minor(a->y, a->z, b->y, b->z), twice_minor(a->z, a->x, b->z, b->x),
                        twice_minor(a->x, a->y, b->x, b->y)};
}

#endif
