/* SPDX-License-Identifier: MIT */
/* A point of a ray that doubles have exactly. docs/proofs/flat_close.md, "Exactly 0". Round to
 * nearest is required, but not that subnormals are kept. */
#pragma once

#include "filter.h"

/* The least magnitude of v's components that are not 0, less one step. */
static inline uint64_t vector_fineness(const sure_vec3 *v)
{
    uint64_t x = magnitude_bits(v->x) - 1, y = magnitude_bits(v->y) - 1;
    uint64_t z = magnitude_bits(v->z) - 1, xy = x < y ? x : y;
    return xy < z ? xy : z;
}

/* Are all components 0 or so large that what is made of them by a difference and a product, and
 * squared, is a multiple of 2^-1022? Of exact sums no part is then subnormal. */
static inline bool vector_is_coarse(const sure_vec3 *v)
{
    return vector_fineness(v) >= bits_of(0x1p-200) - 1;
}

/* 0 where the head of a polish_component is o + t d - from exactly. */
static INLINED double component_left_out(double o, double from, double t, double d)
{
    dd start = two_sum(o, -from), way = two_product(t, d);
    return sum_of_magnitudes(start.tail, way.tail, two_sum(start.head, way.head).tail);
}

/* Are the heads of the point at t exactly o + t d - from, and all of it coarse? */
static INLINED bool point_is_whole(const sure_ray *ray, const sure_vec3 *from, double t)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction, times = {t, t, t};
    double left_out = component_left_out(o->x, from->x, t, d->x) +
                      component_left_out(o->y, from->y, t, d->y) +
                      component_left_out(o->z, from->z, t, d->z);
    return left_out == 0 && vector_is_coarse(&times) && vector_is_coarse(o) &&
           vector_is_coarse(d) && vector_is_coarse(from);
}

/* o + t d, if that are doubles. */
static inline bool whole_point(const sure_ray *ray, double t, sure_vec3 *p)
{
    static const sure_vec3 none = {0, 0, 0};
    polish_point at = polish_point_of(ray, &none, t);
    *p = (sure_vec3){at.x.head, at.y.head, at.z.head};
    return point_is_whole(ray, &none, t);
}
