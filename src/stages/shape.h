/* SPDX-License-Identifier: MIT */
/* What the stages ask of a shape: one row a shape. src/shapes/shapes.c has the table; what a row
 * points to lives in the shape's folder. */
#pragma once

#include "../numbers/mod128.h"
#include "filter.h"
#include "last/line.h"

#include <surehit/shape.h>

#include <stddef.h>

/* t within t_error, or correctly rounded; or whether there is a hit, and no t. */
typedef enum { T_CERTAIN, T_EXACT, T_NONE } t_wanted;

/* The first stage, in doubles. */
typedef filter_verdict first_stage(const sure_ray *, const void *shape, filter_interval *);

typedef struct shape_row {
    sure_shape_info info;
    sure_shape shape;

    first_stage *filter;

    /* The second: the same with coefficients as double-doubles, then modulo 2^128. Asked for the
     * first boundary point of [t_min, t_max] alone, or for both ends of the interval. */
    filter_verdict (*refine)(const sure_ray *, const void *shape, bool both_ends, filter_interval *,
                             sure_stage *);

    int steps; /* t is polished by so many */

    /* Of a body D as a difference (<shape>_tmpl.h). */
    two_terms_mod128 (*discriminant_mod128)(const sure_ray *, const void *shape);

    /* The last stage: the interval in exact numbers, and the normal at its first end. */
    tagged_interval (*exact_interval)(exact_context *, const sure_ray *, const void *shape,
                                      line_coefficients *);
    sure_vec3 (*round_normal)(exact_context *, const sure_ray *, const void *shape,
                              const line_coefficients *, tagged_end);

    /* What is asked of a hit (hits/surface.h). */
    const struct surface_row *surface;
} shape_row;

/* The rows: each is defined in its shape's folder. */
#define DECLARE_ROW(shape, SHAPE)                                                                  \
    extern const shape_row shape##_row;                                                            \
    extern const struct surface_row shape##_surface_row;
SURE_EACH_SHAPE(DECLARE_ROW)

/* How many doubles stand before a field of a shape's struct. */
#define DOUBLES_BEFORE(type, field) ((int)(offsetof(type, field) / sizeof(double)))

/* The first invalid field of ray or shape, in the contract's order. */
sure_field shape_check(const shape_row *row, const sure_ray *ray, const void *shape);

/* The reduced discriminant D for a filter that is certain of everything else: what makes grazing
 * and tangent rays hard is this number alone. docs/proofs/discriminant.md proves the bound.
 *
 * By double-doubles, then by the low bits; false where neither can tell. `measure` is G of the
 * filter's proof and `bound` the filter's bound for it. Entry: what the filter's range takes. Any
 * environment. */
bool discriminant_of(const shape_row *row, const sure_ray *ray, const void *shape, double measure,
                     double bound, known_discriminant *found);

/* t of an end that is certain rounded correctly, by what the shape computes in double-doubles
 * (close.h); false where it can't be told, and in other environments. */
bool close_polish(const shape_row *row, const sure_ray *ray, const void *shape,
                  const filter_end *end, double *t);

/* A hit of a planar shape in double-doubles; uncertain of others, and in other environments. */
filter_verdict close_hit(const shape_row *row, const sure_ray *ray, const void *shape,
                         t_wanted wanted, sure_hit *hit);

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
