/* SPDX-License-Identifier: MIT */
#include "../numbers/valid.h"
#include "../numbers/error_free.h"
#include "../numbers/scale.h"

#include <surehit/refract.h>

#include <assert.h>

/* Snell: n1 sin i = n2 sin t. The part of D along the surface is D_s = (N x D) x N / N.N, of length
 * |D| sin i; it is shortened by eta = n1/n2, and along -N goes what the length |D| leaves:
 *
 *     T = eta D_s - |D| cos(t) N/|N|
 *     cos^2(t) = 1 - eta^2 sin^2(i) = cos^2(i) + (1 - eta)(1 + eta) sin^2(i)
 *
 * with |N||D| cos(i) = |N.D| and |N||D| sin(i) = |N x D|. Terms of opposite sign are left for eta >
 * 1 alone: they cancel at the critical angle.
 *
 * Lengths here are in |N||D|.
 */
typedef struct {
    vec3 turn;      /* N x D */
    real sine2;     /* sin^2(i) */
    real cosine;    /* cos(i) */
    real bend;      /* 1 - eta^2 */
    real refracted; /* cos^2(t), on total reflection below 0 */
} incidence;

#ifndef SURE_STABLE
/* |N|^2, (|N||D|)^2 and |D|/|N| */
static inline bool lengths_are_in_range(real square, real product)
{
    return scale_is_in_range(square) && scale_is_in_range(product) &&
           scale_is_in_range(REAL(sqrt)(product) / square);
}

static incidence incidence_of(vec3 d, vec3 n, real ratio)
{
    vec3 turn = vec3_cross(n, d);
    real sine2 = vec3_dot(turn, turn), cosine = REAL(fabs)(vec3_dot(n, d));
    assert(lengths_are_in_range(vec3_dot(n, n), sine2 + cosine * cosine));
    real bend = (1 - ratio) * (1 + ratio);
    return (incidence){turn, sine2, cosine, bend, cosine * cosine + bend * sine2};
}
#else
/* Twice the digits of double: a product is off by some 2^-102 of itself, a sum by 2^-104 of its
 * terms. */

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

static inline twice twice_product(twice x, twice y)
{
    double_pair product = two_product(x.head, y.head);
    return fast_two_sum(product.head, product.tail + (x.head * y.tail + x.tail * y.head));
}

static inline twice twice_dot(const twice_vec3 *a, const twice_vec3 *b)
{
    twice xy = twice_sum(twice_product(a->x, b->x), twice_product(a->y, b->y));
    return twice_sum(xy, twice_product(a->z, b->z));
}

static inline twice twice_minor(twice p, twice q, twice r, twice s)
{
    twice less = twice_product(q, r);
    return twice_sum(twice_product(p, s), (twice){-less.head, -less.tail});
}

static inline twice_vec3 twice_cross(const twice_vec3 *a, const twice_vec3 *b)
{
    return (twice_vec3){twice_minor(a->y, a->z, b->y, b->z), twice_minor(a->z, a->x, b->z, b->x),
                        twice_minor(a->x, a->y, b->x, b->y)};
}

static twice_vec3 twice_from(vec3 v)
{
    return (twice_vec3){{v.x, 0}, {v.y, 0}, {v.z, 0}};
}

/* Stable: all of it with twice the digits, since N.D cancels at grazing incidence, N x D along the
 * normal, and cos^2(t) at the critical angle. */
static incidence incidence_of(vec3 d, vec3 n, real ratio)
{
    assert(ratio >= 0x1p-100 && ratio <= 0x1p100);
    twice_vec3 twice_d = twice_from(d), twice_n = twice_from(n);
    twice_vec3 turn = twice_cross(&twice_n, &twice_d);
    twice sine2 = twice_dot(&turn, &turn), cosine = twice_dot(&twice_n, &twice_d);
    twice bend = twice_product(two_sum(1, -ratio), two_sum(1, ratio));
    twice refracted = twice_sum(twice_product(cosine, cosine), twice_product(bend, sine2));
    vec3 heads = {turn.x.head, turn.y.head, turn.z.head};
    return (incidence){heads, sine2.head, fabs(cosine.head), bend.head, refracted.head};
}
#endif

static vec3 direction(const incidence *at, vec3 n, real ratio)
{
    real square = vec3_dot(n, n);
    vec3 along_surface = vec3_scale(ratio / square, vec3_cross(at->turn, n));
    return vec3_sub(along_surface, vec3_scale(REAL(sqrt)(at->refracted) / square, n));
}

static real contrast(real x, real y)
{
    return (x - y) / (x + y);
}

/* The amplitudes across and in the plane of incidence:
 *
 *     r_s = (eta cos(i) - cos(t)) / (eta cos(i) + cos(t))
 *     r_p = (cos(i) - eta cos(t)) / (cos(i) + eta cos(t))
 */
#ifndef SURE_STABLE
static real fresnel(const incidence *at, real ratio)
{
    real cosine = at->cosine, refracted = REAL(sqrt)(at->refracted);
    real across = contrast(ratio * cosine, refracted), in = contrast(cosine, ratio * refracted);
    return (across * across + in * in) / 2;
}
#else
/* Stable: for eta near 1 both differences cancel, but not when multiplied by their sums:
 *
 *     r_s = -(1 - eta^2) / (eta cos(i) + cos(t))^2
 *     r_p = -r_s cos(i + t) / cos(i - t),  cos(i +- t) = cos(i) cos(t) -+ eta sin^2(i)
 *
 * and what cancels still is Brewster's angle, where r_p is 0. */
static real fresnel(const incidence *at, real ratio)
{
    real cosine = at->cosine, refracted = sqrt(at->refracted);
    real sum = ratio * cosine + refracted;
    real across = at->bend * (cosine * cosine + at->sine2) / (sum * sum);
    real turned = contrast(cosine * refracted, ratio * at->sine2);
    return fmin(1, across * across * (1 + turned * turned) / 2);
}
#endif

/* Stable takes powers of two out of lengths; |T| gets back those of |D|. */
static bool is_moderate(vec3 v)
{
#ifdef SURE_STABLE
    return scale_is_moderate(vec3_dot(v, v));
#else
    (void)v;
    return true;
#endif
}

static vec3 in_range(vec3 v)
{
    return is_moderate(v) ? v : vec3_near_one(v);
}

/* Stable: whatever the length of N, to the bit. */
static vec3 near_one(vec3 n)
{
#ifdef SURE_STABLE
    return vec3_near_one(n);
#else
    return n;
#endif
}

static vec3 as_long_as(vec3 d, vec3 t)
{
    return is_moderate(d) ? t : scale_vector(t, scale_exponent(scale_largest(d)));
}

/* Indices that are equal make no surface. */
sure_status TIER(sure_refract)(sure_vec3 incident, sure_vec3 normal, double index_ratio,
                               sure_vec3 *refracted)
{
    assert(direction_ok(incident) && direction_ok(normal));
    assert(is_finite_bits(index_ratio) && index_ratio > 0);
    real ratio = (real)index_ratio;
    vec3 d = vec3_from(incident), n = near_one(vec3_from(normal));
    if (ratio == 1) {
        *refracted = vec3_public(d);
        return SURE_HIT;
    }
    incidence at = incidence_of(in_range(d), n, ratio);
    if (!(at.refracted >= 0))
        return SURE_MISS;
    *refracted = vec3_public(as_long_as(d, direction(&at, n, ratio)));
    return SURE_HIT;
}

double TIER(sure_refract_fresnel)(sure_vec3 incident, sure_vec3 normal, double index_ratio)
{
    assert(direction_ok(incident) && direction_ok(normal));
    assert(is_finite_bits(index_ratio) && index_ratio > 0);
    real ratio = (real)index_ratio;
    if (ratio == 1)
        return 0;
    incidence at = incidence_of(in_range(vec3_from(incident)), near_one(vec3_from(normal)), ratio);
    return at.refracted >= 0 ? fresnel(&at, ratio) : 1;
}
