/* SPDX-License-Identifier: MIT */
#include "line_signs.h"

#include "suite.h"
#include "true_hit.h"

/* v.v w.w = (v.w)^2? */
static bool parallel(mpfr_t vv, mpfr_t ww, mpfr_t vw)
{
    TRUE_NUMBERS(mpfr_get_prec(vv), difference);
    mpfr_fmms(difference, vv, ww, vw, vw, MPFR_RNDN);
    return mpfr_zero_p(difference) != 0;
}

/* Does the line meet the body's boundary in the plane A.(m + t d) = level, or lie in it and meet
 * the body? */
static bool meets_rim(true_line *line, mpfr_t level)
{
    TRUE_NUMBERS(line->bits, rise);
    mpfr_sub(rise, level, line->level, MPFR_RNDN);
    return mpfr_zero_p(line->slope) ? mpfr_zero_p(rise) && mpfr_sgn(line->discriminant) >= 0
                                    : true_side(line, rise, line->slope) == 0;
}

/* The axis of true_hit.h leads from a cone's apex to its base. */
static void set_line_signs(true_line *line, void *context)
{
    line_signs *signs = context;
    TRUE_NUMBERS(line->bits, zero);
    mpfr_set_zero(zero, 1);
    bool from_zero = meets_rim(line, zero);
    bool at_height = line->capped && meets_rim(line, line->height);
    *signs = (line_signs){
        .a = mpfr_sgn(line->a),
        .discriminant = mpfr_sgn(line->discriminant),
        .slope = line->tapers ? -mpfr_sgn(line->slope) : mpfr_sgn(line->slope),
        .along_axis = parallel(line->height, line->dd, line->slope),
        .meets_base_rim = line->tapers ? at_height : from_zero,
        .meets_end_rim = line->capped && (line->tapers ? from_zero : at_height),
        .meets_apex = line->tapers && parallel(line->mm, line->dd, line->md),
    };
}

line_signs line_signs_of(const sure_case *valid)
{
    line_signs signs;
    true_exactly(valid, set_line_signs, &signs);
    return signs;
}

typedef struct {
    int64_t m;
    int exponent;
    point_signs signs;
} place;

static void set_point_signs(true_line *line, void *context)
{
    place *at = context;
    TRUE_NUMBERS(line->bits, t, one, height, over);
    mpfr_set_ui(one, 1, MPFR_RNDN);
    mpfr_set_si_2exp(t, at->m, at->exponent, MPFR_RNDN);
    mpfr_fma(height, t, line->slope, line->level, MPFR_RNDN);
    mpfr_sub(over, height, line->height, MPFR_RNDN);
    bool tapers = line->tapers;
    at->signs = (point_signs){
        .round = true_side(line, t, one),
        .height = tapers ? -mpfr_sgn(over) : mpfr_sgn(height),
        .over_end = tapers ? -mpfr_sgn(height) : mpfr_sgn(over),
    };
}

point_signs point_signs_at(const sure_case *valid, int64_t m, int exponent)
{
    place at = {.m = m, .exponent = exponent};
    true_exactly(valid, set_point_signs, &at);
    return at.signs;
}
