/* SPDX-License-Identifier: MIT */
#include "line.h"

#include "../../numbers/bits.h"
#include "../shape.h"

#include <assert.h>

#define NUMBER exact

/* The root of 2 b t + c: 2 b n/d + c has the sign of b (n/d - t). */
static int compare_only_root(number_context *c, const line_coefficients *l, number n, number d)
{
    number twice = number_add(c, l->b, l->b);
    number value = number_add(c, number_mul(c, twice, n), number_mul(c, l->c, d));
    return -number_sign(c, value) * number_sign(c, d) * number_sign(c, l->b);
}

static int compare_root(number_context *c, const line_coefficients *l, end_kind at, number n,
                        number d)
{
    int leading = number_sign(c, l->a);
    if (leading == 0)
        return compare_only_root(c, l, n, d);
    /* d^2 times the body at n/d */
    number bd = number_mul(c, l->b, d), rising = number_add(c, number_mul(c, l->a, n), bd);
    number value = number_add(c, number_mul(c, number_add(c, rising, bd), n),
                              number_mul(c, l->c, number_square(c, d)));
    int outside = leading * number_sign(c, value);
    int side = outside < 0 ? 0 : leading * number_sign(c, rising) * number_sign(c, d);
    return root_from_signs(at, outside, side);
}

void line_rational(number_context *c, const line_coefficients *l, end_kind at, number *n, number *d)
{
    *n = at == END_TANGENT ? number_negate(c, l->b) : at == END_BASE ? l->base : l->top;
    *d = at == END_TANGENT ? l->a : l->speed;
}

int line_compare(number_context *c, const line_coefficients *l, end_kind at, number n, number d)
{
    assert(d.sign != 0);
    if (at == END_LESS || at == END_MORE)
        return compare_root(c, l, at, n, d);
    number own_n, own_d;
    line_rational(c, l, at, &own_n, &own_d);
    number ahead = number_sub(c, number_mul(c, own_n, d), number_mul(c, n, own_d));
    return number_sign(c, ahead) * number_sign(c, own_d) * number_sign(c, d);
}

/* The same for t - 0. */
static int compare_with_zero(number_context *c, const line_coefficients *l, end_kind at)
{
    if (at == END_LESS || at == END_MORE) {
        int leading = number_sign(c, l->a), sign = number_sign(c, l->c);
        int side = leading * sign < 0 ? 0 : number_sign(c, l->b);
        return leading == 0 ? -sign * side : root_from_signs(at, leading * sign, leading * side);
    }
    number n, d;
    line_rational(c, l, at, &n, &d);
    return number_sign(c, n) * number_sign(c, d);
}

static int compare_with(number_context *c, const line_coefficients *l, end_kind at, double x)
{
    return is_zero_bits(x) ? compare_with_zero(c, l, at)
                           : line_compare(c, l, at, number_of(c, x), number_of(c, 1));
}

/* Sign of the end's t - x for a bound x of the range, where `endless` stands for an end without
 * t. */
static int compare_end(number_context *c, const line_coefficients *l, tagged_end end, double x,
                       int endless)
{
    if (end.at == END_ENDLESS)
        return endless;
    if (!is_finite_bits(x))
        return -1;
    return compare_with(c, l, end.at, x);
}

sure_status line_hit(number_context *c, const sure_ray *ray, const shape_row *row,
                     const void *shape, line_coefficients *l, tagged_end *first, bool *leaves)
{
    tagged_interval ends = row->exact_interval(c, ray, shape, l);
    if (ends.empty)
        return SURE_MISS;
    *first = ends.enter;
    *leaves = false;
    if (compare_end(c, l, ends.enter, ray->t_min, -1) >= 0)
        return compare_end(c, l, *first, ray->t_max, -1) <= 0 ? SURE_HIT : SURE_MISS;
    int left = compare_end(c, l, ends.leave, ray->t_min, 1);
    if (ends.boundary && left > 0) {
        *first = (tagged_end){END_START, ends.inner_part};
        return SURE_HIT;
    }
    *first = ends.leave;
    *leaves = !ends.boundary;
    return left >= 0 && compare_end(c, l, *first, ray->t_max, 1) <= 0 ? SURE_HIT : SURE_MISS;
}

sure_status line_interval(number_context *c, const sure_ray *ray, const shape_row *row,
                          const void *shape, line_coefficients *l, tagged_interval *ends)
{
    *ends = row->exact_interval(c, ray, shape, l);
    if (ends->empty || compare_end(c, l, ends->enter, ray->t_max, -1) > 0 ||
        compare_end(c, l, ends->leave, ray->t_min, 1) < 0)
        return SURE_MISS;
    return SURE_HIT;
}
