/* The reduced discriminant D for a filter that is certain of everything else: what makes grazing
 * and tangent rays hard is this number alone. docs/proofs/discriminant.md proves the bound. */
#ifndef STAGES_DISCRIMINANT_H
#define STAGES_DISCRIMINANT_H

#include "../numbers/dd.h"
#include "shape.h"

/* A shape's D as a difference (<shape>_tmpl.h). Not inlined, since they are called in another
 * floating-point environment. */
typedef struct {
    two_terms_dd (*by_dd)(const sure_ray *, const void *shape);
#ifdef MOD128_EXISTS
    two_terms_mod128 (*by_mod128)(const sure_ray *, const void *shape);
#endif
} discriminant_forms;

#ifdef MOD128_EXISTS
#define DISCRIMINANT_FORMS(name)                                                                   \
    {                                                                                              \
        name##_dd, name##_mod128                                                                   \
    }
#else
#define DISCRIMINANT_FORMS(name)                                                                   \
    {                                                                                              \
        name##_dd                                                                                  \
    }
#endif

/* By double-doubles, then by the low bits; false where neither can tell. `measure` is G of the
 * filter's proof and `bound` the filter's bound for it. Entry: what the filter's range takes. Any
 * environment. */
bool discriminant_of(const sure_ray *ray, const void *shape, const discriminant_forms *forms,
                     double measure, double bound, known_discriminant *found);

/* Where D = 0 both roots are the vertex t* = -b/a, a > 0. From any t it is at t - s/a, with
 * s = a t + b half the body's slope at t: no root, and no residual that vanishes twice.
 * docs/proofs/tangent.md. */

/* t* correctly rounded, from the end's t; false where it can't be told. Entry for both: round to
 * nearest. */
bool tangent_polish(const shape_row *row, const sure_ray *ray, const void *shape, double t,
                    double *rounded);

/* The sign of t* - x; false where it can't be told. */
bool tangent_order(const shape_row *row, const sure_ray *ray, const void *shape, double x,
                   int *sign);

#endif
