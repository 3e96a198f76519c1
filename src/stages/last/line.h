/* SPDX-License-Identifier: MIT */
/* A ray's line against one shape in exact numbers: the chord's ends by name, the coefficients that
 * say where they are, and numbers of them, correctly rounded. */
#pragma once

#include "../../numbers/exact.h"
#include "../filter.h"

/* The body is a t^2 + 2 b t + c <= 0, with b^2 - a c = factor * quarter and factor > 0; the end
 * planes are crossed at base / speed and top / speed. What the object or the chord does not need is
 * not set. */
typedef struct {
    exact a, b, c, factor, quarter;
    exact speed, base, top;
} line_coefficients;

/* t = n/d of the vertex and of the end planes' crossings. */
void line_rational(exact_context *, const line_coefficients *, end_kind at, exact *n, exact *d);

/* Sign of t - n/d for the point's t. Entry: d is not zero, the point is none of the ray's own. */
int line_compare(exact_context *, const line_coefficients *, end_kind at, exact n, exact d);

/* Sign of root - x, from the sign of the body at x times a's (negative between the roots) and that
 * of x - vertex, the middle -b/a of the roots, which tells the sides and the roots apart. */
static inline int root_from_signs(end_kind at, int outside, int side)
{
    if (outside < 0)
        return at == END_LESS ? -1 : 1;
    if (outside > 0)
        return -side;
    if (side == 0)
        return 0;
    if (side < 0)
        return at == END_LESS ? 0 : 1;
    return at == END_LESS ? -1 : 0;
}

/* The status of one query and, on a hit, the first boundary point, and whether the ray leaves a
 * solid there. */
struct shape_row;
sure_status line_hit(exact_context *, const sure_ray *, const struct shape_row *, const void *shape,
                     line_coefficients *, tagged_end *first, bool *leaves);

/* The same for the chord: have it and [t_min, t_max] a point in common? */
sure_status line_interval(exact_context *, const sure_ray *, const struct shape_row *,
                          const void *shape, line_coefficients *, tagged_interval *ends);

/* Numbers of an answer, rounded to nearest, ties to even; subnormals are kept, beyond the greatest
 * double comes infinity, zeros are +0. t* is that of one of the line's points. */

/* Is t* a root, and not rational? */
static inline bool is_root(end_kind at)
{
    return at == END_LESS || at == END_MORE;
}

/* t* = n/d of a point that is no root. */
void rational_t(exact_context *c, const sure_ray *ray, const line_coefficients *l, end_kind at,
                exact *n, exact *d);

/* Entry for both: t* is a root. Sign of alpha + beta t*, and of p t*^2 + 2 q t* + s. */
int sign_of_linear(exact_context *c, const line_coefficients *l, end_kind at, exact alpha,
                   exact beta);
int sign_of_quadratic(exact_context *c, const line_coefficients *l, end_kind at, exact p, exact q,
                      exact s);

/* t*, and (alpha + beta t*) / rho, rho > 0 */
double round_t(exact_context *c, const sure_ray *ray, const line_coefficients *l, end_kind at);
double round_linear(exact_context *c, const sure_ray *ray, const line_coefficients *l, end_kind at,
                    exact alpha, exact beta, exact rho);
sure_vec3 round_linear_vector(exact_context *c, const sure_ray *ray, const line_coefficients *l,
                              end_kind at, vector_exact alpha, vector_exact beta, exact rho);

/* v/|v|, v not zero. */
sure_vec3 round_unit(exact_context *c, vector_exact v);

/* (alpha + beta t*) / ((gamma + delta t*) sqrt(rho)), a unit vector. Entry: t* is a root, the
 * divisor > 0. */
sure_vec3 round_over_root(exact_context *c, const line_coefficients *l, end_kind at,
                          vector_exact alpha, vector_exact beta, exact gamma, exact delta,
                          exact rho);
