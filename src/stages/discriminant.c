/* SPDX-License-Identifier: MIT */
#include "../numbers/environment.h"
#include "../numbers/mod128_value.h"
#include "close.h"
#include "hits/surface.h"

#include <assert.h>
#include <math.h>

/* More than what underflows in a square of D. */
#define DISCRIMINANT_FLOOR 0x1p-900

typedef struct {
    dd value;
    double terms; /* the sum of both */
} estimate;

static NOT_INLINED estimate by_dd(const shape_row *row, const sure_ray *ray, const void *shape)
{
    two_terms_dd terms = close_of(row)->discriminant(ray, shape);
    return (estimate){difference_dd(NULL, terms), terms.more.head + terms.less.head};
}

static NOT_INLINED ddb value_of(mod128 whole)
{
    return mod128_value(whole);
}

/* The whole of a D of at most that magnitude, by its low bits; and do both of its terms vanish, of
 * which none is more than that? */
static bool by_mod128(const shape_row *row, const sure_ray *ray, const void *shape, double most,
                      double most_of_terms, ddb *value, bool *vanishes)
{
    two_terms_mod128 terms = row->discriminant_mod128(ray, shape);
    mod128 whole = difference_mod128(NULL, terms);
    if (!mod128_is_whole(most, whole))
        return false;
    *vanishes = mod128_is_zero(terms.more) && mod128_is_zero(terms.less) &&
                mod128_is_whole(most_of_terms, whole);
    TO_NEAREST(*value, value_of(whole));
    return mod128_is_zero(whole) || (whole.exponent >= -1022 && whole.exponent <= 800);
}

bool discriminant_of(const shape_row *row, const sure_ray *ray, const void *shape, double measure,
                     double bound, known_discriminant *found)
{
    estimate nearly;
    double share = bound * DD_SHARE;
    TO_NEAREST(nearly, by_dd(row, ray, shape));
    double value = nearly.value.head, rest = nearly.value.tail;
    double error_square = share * share * nearly.terms * measure + DISCRIMINANT_FLOOR;
    double error = sqrt(error_square) * (1 + 0x1p-40);
    if (value * value > error_square) {
        *found = (known_discriminant){
            .value = value, .rest = rest, .error = error, .stage = SURE_STAGE_DOUBLE_DOUBLE};
        return true;
    }
    /* Where the sign is not certain the terms may be off by more than they are. */
    error += share * share * measure;
    double most = (fabs(value) + fabs(rest) + error) * (1 + 0x1p-40);
    ddb whole;
    bool vanishes;
    if (!by_mod128(row, ray, shape, most, nearly.terms + error, &whole, &vanishes))
        return false;
    *found = (known_discriminant){.value = whole.hi,
                                  .rest = whole.lo,
                                  .error = whole.error,
                                  .vanishes = vanishes,
                                  .stage = SURE_STAGE_MOD128};
    return true;
}

NOT_INLINED bool tangent_polish(const shape_row *row, const sure_ray *ray, const void *shape,
                                double t, double *rounded)
{
    assert(environment_is_nearest());
    ddb_context c = {false};
    part_slope at = surface_slope(&c, row, ray, shape, ddb_of(&c, t));
    ddb step = ddb_div(&c, at.half_slope, difference_ddb(&c, at.bend));
    return ddb_rounds_to(ddb_sub(&c, ddb_of(&c, t), step), rounded) && !c.uncertain;
}

/* As doubles have a slope it is off by less than this times what its terms come to, each of which
 * passes through fewer roundings than 2^6; and more than what underflows. */
#define SLOPE_SHARE 0x1p-46
#define SLOPE_FLOOR 0x1p-600

static NOT_INLINED bool slope_sign(const shape_row *row, const sure_ray *ray, const void *shape,
                                   double x, int *sign)
{
    ddb_context c = {false};
    *sign = ddb_sign(&c, surface_slope(&c, row, ray, shape, ddb_of(&c, x)).half_slope);
    return !c.uncertain;
}

/* t* - x = -s/a: the sign of the slope at x, which mostly vanishes there or next to it: so by its
 * low bits, then by double-doubles. */
NOT_INLINED bool tangent_order(const shape_row *row, const sure_ray *ray, const void *shape,
                               double x, int *sign)
{
    assert(environment_is_nearest());
    const surface_row *of = row->surface;
    double nearly = fabs(of->slope_f64(ray, shape, x));
    double error = SLOPE_SHARE * of->slope_most(ray, shape, x) + SLOPE_FLOOR;
    bool known = mod128_sign(nearly + error, of->slope_mod128(ray, shape, x), sign) ||
                 slope_sign(row, ray, shape, x, sign);
    *sign = -*sign;
    return known;
}
