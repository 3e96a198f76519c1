/* Numbers of an answer, rounded correctly to nearest, ties to even; subnormals are kept, beyond the
 * greatest double comes infinity, zeros are +0. t* is that of one of the line's points. */
#ifndef STAGES_ROUNDING_H
#define STAGES_ROUNDING_H

#include "line.h"

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

#endif
