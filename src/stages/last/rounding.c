/* SPDX-License-Identifier: MIT */
/* A point's t* is rational (n/d) or a root of a t^2 + 2 b t + c, and that is never computed. A
 * number of an answer that its guess leaves open is rounded by asking on which side of it lie the
 * midpoints of neighbouring doubles, and each of these questions becomes one about t*:
 *
 *     (alpha + beta t*) / rho > m       t* against (m rho - alpha) / beta
 *     a quadratic's sign at t*          reduced by the point's own quadratic it is linear
 *     t* > another quadratic's root     that quadratic's sign at t*, and which side of its vertex
 */
#include "guess.h"

#include "../../numbers/places.h"

#include <assert.h>

#define NUMBER exact

/* What a number to be rounded is asked: the sign of (it - x). */
typedef struct number_to_round number_to_round;
struct number_to_round {
    int (*compare)(number_context *, const number_to_round *, exact x);
    const line_coefficients *l;
    end_kind at;
    exact alpha, beta;  /* the number is (alpha + beta t*) / rho, rho > 0, ... */
    exact gamma, delta; /* ... or (alpha + beta t*) / ((gamma + delta t*) sqrt(rho)) */
    exact rho;
};

/* Infinity rounds as 2^1024 would. */
static exact exact_at_place(number_context *c, int64_t place)
{
    double x = at_place(place);
    return is_finite_bits(x) ? exact_of(c, x) : exact_scaled(c, place < 0 ? -1 : 1, 1024);
}

/* Sign of the number - the midpoint between a place and the next one. */
static int above_middle(number_context *c, const number_to_round *z, int64_t place)
{
    size_t mark = exact_mark(c);
    exact both = exact_add(c, exact_at_place(c, place), exact_at_place(c, place + 1));
    int sign = z->compare(c, z, exact_mul(c, both, exact_scaled(c, 1, -1)));
    exact_release(c, mark);
    return sign;
}

/* From the place that is nearest to the number, the lower one of two. */
static int64_t to_even(number_context *c, const number_to_round *z, int64_t place)
{
    const bool tie = place % 2 != 0 && above_middle(c, z, place) == 0;
    return tie ? place + 1 : place;
}

static int64_t to_odd(number_context *c, const number_to_round *z, int64_t place)
{
    if (place % 2 != 0)
        return place;
    size_t mark = exact_mark(c);
    int64_t odd = place + z->compare(c, z, exact_at_place(c, place));
    exact_release(c, mark);
    return odd > (int64_t)BITS_INFINITY || -odd > (int64_t)BITS_INFINITY ? place : odd;
}

/* Between low and high; their distance may exceed the integers' range. */
static int64_t between(int64_t low, int64_t high)
{
    return low + (int64_t)(((uint64_t)high - (uint64_t)low) / 2);
}

/* The place that the number rounds to is the least one whose upper middle is not below it: from one
 * near by in doubling steps to both sides of that, then by halves. */
static double round_from(number_context *c, const number_to_round *z, double near)
{
    const int64_t last = (int64_t)BITS_INFINITY, stride = last / 4;
    int64_t high = place_of(near), low = high, step = 1;
    if (above_middle(c, z, high) > 0) {
        do {
            low = high + 1;
            high = high > last - step ? last : high + step;
            step = step < stride ? 2 * step : step;
        } while (high < last && above_middle(c, z, high) > 0);
    } else {
        low = high - 1;
        while (low >= -last && above_middle(c, z, low) <= 0) {
            high = low;
            low = low < -last + step ? -last - 1 : low - step;
            step = step < stride ? 2 * step : step;
        }
        low++;
    }
    while (low < high) {
        int64_t middle = between(low, high);
        if (above_middle(c, z, middle) > 0)
            low = middle + 1;
        else
            high = middle;
    }
    high = c->to_odd ? to_odd(c, z, high) : to_even(c, z, high);
    return high == 0 ? 0 : at_place(high);
}

static double round_number(number_context *c, const number_to_round *z, wide guess)
{
    double n;
    return wide_rounds(c, guess, &n) ? n : round_from(c, z, n);
}

/* Sign of alpha + beta t*, t* a root. */
int sign_of_linear(number_context *c, const line_coefficients *l, end_kind at, exact alpha,
                   exact beta)
{
    assert(is_root(at));
    int rising = exact_sign(c, beta);
    if (rising == 0)
        return exact_sign(c, alpha);
    return rising * line_compare(c, l, at, exact_negate(c, alpha), beta);
}

/* Sign of p t*^2 + 2 q t* + s: less p/a times the point's own quadratic it is linear. */
int sign_of_quadratic(number_context *c, const line_coefficients *l, end_kind at, exact p, exact q,
                      exact s)
{
    assert(is_root(at));
    int leading = exact_sign(c, l->a);
    if (leading == 0) { /* t* = n/d = -c / 2b */
        exact n = exact_negate(c, l->c), d = exact_add(c, l->b, l->b);
        exact mixed = exact_mul(c, exact_mul(c, exact_add(c, q, q), n), d);
        return exact_sign(c, exact_add(c, exact_add(c, exact_mul(c, p, number_square(c, n)), mixed),
                                       exact_mul(c, s, number_square(c, d))));
    }
    exact half = number_minor(c, q, p, l->b, l->a); /* q a - p b */
    exact constant = number_minor(c, s, p, l->c, l->a);
    return leading * sign_of_linear(c, l, at, constant, exact_add(c, half, half));
}

/* (alpha + beta t*) / rho */
static int compare_linear(number_context *c, const number_to_round *z, exact x)
{
    exact rest = exact_sub(c, z->alpha, exact_mul(c, x, z->rho));
    return sign_of_linear(c, z->l, z->at, rest, z->beta);
}

/* u / (v sqrt(rho)) for u = alpha + beta t*, v = gamma + delta t* > 0: against x by signs, then by
 * squares, u^2 - x^2 rho v^2. */
static int compare_over_root(number_context *c, const number_to_round *z, exact x)
{
    int sign = sign_of_linear(c, z->l, z->at, z->alpha, z->beta);
    if (sign != x.sign || sign == 0)
        return sign > x.sign ? 1 : sign < x.sign ? -1 : 0;
    exact k = exact_mul(c, number_square(c, x), z->rho);
    exact kd = exact_mul(c, k, z->delta), kg = exact_mul(c, k, z->gamma);
    return sign * sign_of_quadratic(c, z->l, z->at, number_minor(c, z->beta, kd, z->delta, z->beta),
                                    number_minor(c, z->alpha, kg, z->delta, z->beta),
                                    number_minor(c, z->alpha, kg, z->gamma, z->alpha));
}

/* The same for rational u / sqrt(rho): gamma = 1, delta = 0, t* does not matter. */
static int compare_rational_over_root(number_context *c, const number_to_round *z, exact x)
{
    int sign = exact_sign(c, z->alpha);
    if (sign != x.sign || sign == 0)
        return sign > x.sign ? 1 : sign < x.sign ? -1 : 0;
    exact square = exact_mul(c, number_square(c, x), z->rho);
    return sign * exact_compare(c, number_square(c, z->alpha), square);
}

/* t* = n/d of a point that is no root. */
void rational_t(number_context *c, const sure_ray *ray, const line_coefficients *l, end_kind at,
                exact *n, exact *d)
{
    *n = exact_of(c, ray->t_min);
    *d = exact_of(c, 1);
    if (at != END_START)
        line_rational(c, l, at, n, d);
}

/* (alpha + beta t*) / rho rounded. */
double round_linear(number_context *c, const sure_ray *ray, const line_coefficients *l, end_kind at,
                    exact alpha, exact beta, exact rho)
{
    if (!is_root(at)) {
        exact n, d;
        rational_t(c, ray, l, at, &n, &d);
        exact top = exact_add(c, exact_mul(c, alpha, d), exact_mul(c, beta, n));
        return exact_quotient(c, top, exact_mul(c, rho, d));
    }
    number_to_round z = {
        .compare = compare_linear, .l = l, .at = at, .alpha = alpha, .beta = beta, .rho = rho};
    wide whole = guess_linear(c, l, at, alpha, beta);
    return round_number(c, &z, wide_div(whole, wide_of(rho)));
}

double round_t(number_context *c, const sure_ray *ray, const line_coefficients *l, end_kind at)
{
    if (at == END_START)
        return is_zero_bits(ray->t_min) ? 0 : ray->t_min;
    return round_linear(c, ray, l, at, exact_of(c, 0), exact_of(c, 1), exact_of(c, 1));
}

/* v/|v|, v not zero. */
sure_vec3 round_unit(number_context *c, vector v)
{
    exact square = vector_square(c, v);
    wide length = wide_sqrt(wide_of(square));
    const exact parts[3] = {v.x, v.y, v.z};
    double unit[3];
    for (int i = 0; i < 3; i++) {
        number_to_round z = {
            .compare = compare_rational_over_root, .alpha = parts[i], .rho = square};
        unit[i] = round_number(c, &z, wide_div(wide_of(parts[i]), length));
    }
    return (sure_vec3){unit[0], unit[1], unit[2]};
}

sure_vec3 round_linear_vector(number_context *c, const sure_ray *ray, const line_coefficients *l,
                              end_kind at, vector alpha, vector beta, exact rho)
{
    return (sure_vec3){round_linear(c, ray, l, at, alpha.x, beta.x, rho),
                       round_linear(c, ray, l, at, alpha.y, beta.y, rho),
                       round_linear(c, ray, l, at, alpha.z, beta.z, rho)};
}

sure_vec3 round_over_root(number_context *c, const line_coefficients *l, end_kind at, vector alpha,
                          vector beta, exact gamma, exact delta, exact rho)
{
    assert(is_root(at));
    const exact alphas[3] = {alpha.x, alpha.y, alpha.z}, betas[3] = {beta.x, beta.y, beta.z};
    wide length = wide_mul(guess_linear(c, l, at, gamma, delta), wide_sqrt(wide_of(rho)));
    double n[3];
    for (int i = 0; i < 3; i++) {
        number_to_round z = {.compare = compare_over_root,
                             .l = l,
                             .at = at,
                             .alpha = alphas[i],
                             .beta = betas[i],
                             .gamma = gamma,
                             .delta = delta,
                             .rho = rho};
        wide along = guess_linear(c, l, at, z.alpha, z.beta);
        n[i] = round_number(c, &z, wide_div(along, length));
    }
    return (sure_vec3){n[0], n[1], n[2]};
}
