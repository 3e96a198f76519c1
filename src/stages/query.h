/* SPDX-License-Identifier: MIT */
/* A query made fit for the stages of bounded range: where its numbers are very large or small,
 * lengths and directions are scaled by powers of two, which no decision notices. */
#pragma once

#include "shape.h"

typedef struct {
    const sure_ray *asked; /* as it was */
    const sure_ray *ray;   /* as it is to be taken: asked and the asked shape, or these: */
    const void *shape;
    sure_ray scaled_ray;
    double scaled_shape[SURE_SHAPE_NUMBERS];
    int t_exponent, length_exponent; /* a true t is the query's times 2^t_exponent, ... */
} query;

/* Where lengths, directions and normals are 0 or between 2^-30 and 2^30, they are taken as they
 * are; otherwise each of these three is scaled so that its largest is near 1. Where others are then
 * less than 2^-QUERY_SPREAD but not 0 nothing is scaled, and the answer is false. t_min and t_max
 * may lie beyond what a stage tells apart, but stay on their side of it. Entry: valid input that
 * outlives the query. */
#define QUERY_SPREAD 100
bool query_of(const sure_ray *ray, const shape_row *row, const void *shape, query *q);

/* The query as it is asked. */
static inline void query_unscaled(const sure_ray *ray, const void *shape, query *q)
{
    q->asked = q->ray = ray;
    q->shape = shape;
    q->t_exponent = q->length_exponent = 0;
}

/* x 2^exponent; false when that might be rounded. */
static inline bool query_shift(double x, int exponent, double *shifted)
{
    int result = exponent_of(x) + exponent;
    *shifted = double_of(bits_of(x) + ((uint64_t)exponent << 52));
    return result > -900 && result < 1000 && exponent_of(x) > -1000 && is_finite_bits(x);
}

/* A t of the query as one of the asked ray. */
static inline bool query_unscale(const query *q, double t, double *asked)
{
    return query_shift(t, q->t_exponent, asked);
}

/* On which side a point is (surface.h), by double-doubles, then by low bits, which set *stage.
 * False where these don't tell either. Entry: round to nearest. */
bool query_side(const shape_row *row, const void *shape, sure_vec3 p, int *side, sure_stage *stage);
/* Exactly. */
int query_side_exact(const shape_row *row, const void *shape, sure_vec3 p);

/* The first end of a solid's chord in [t_min, t_max], where a bound of these is next to an end: by
 * a step from the bound to the end, or by the side on which the ray's point is, where that is a
 * double's. An end that is found to be at t_min is put there: t exactly, no error; likewise a
 * touch at t_max. *stage: which told. */
filter_verdict query_first(const shape_row *row, const query *q, filter_interval *found,
                           filter_end *first, sure_stage *stage);
