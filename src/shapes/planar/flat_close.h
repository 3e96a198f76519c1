/* SPDX-License-Identifier: MIT */
/* The second stage of the flat shapes, closer but no wider than needed: N.d and N.m in twice the
 * precision, and whether they are exactly 0. docs/proofs/flat_close.md proves it. Round to nearest
 * is required throughout, but not that subnormals are kept. */
#pragma once

#include "../../stages/stages.h"
#include "../plane/plane_filter.h"

/* Kept apart from the filter, but not from speed as what is rare. */
#ifdef __GNUC__
#define FLAT_APART __attribute__((noinline, hot))
#else
#define FLAT_APART
#endif

/* x[0] + ... + x[3], what the additions leave out put by. */
static INLINED double sum_of_four(const double x[4], double left_out[3])
{
    dd low = two_sum(x[0], x[1]), high = two_sum(x[2], x[3]);
    dd all = two_sum(low.head, high.head);
    left_out[0] = low.tail;
    left_out[1] = high.tail;
    left_out[2] = all.tail;
    return all.head;
}

/* Is the sum of four products, head + tail, 0? True is certain: nothing is left out in the end.
 * Entry: products none of which has underflowed. */
static INLINED bool sum_vanishes(const double heads[4], const double tails[4])
{
    double rest[4], left_out[6];
    rest[3] = sum_of_four(heads, rest);
    double of_tails = sum_of_four(tails, left_out), of_rest = sum_of_four(rest, left_out + 3);
    return of_tails == -of_rest &&
           sum_of_magnitudes(left_out[0], left_out[1], left_out[2]) +
                   sum_of_magnitudes(left_out[3], left_out[4], left_out[5]) ==
               0;
}

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

/* Is v.w exactly 0? False where that is not certain. Entry: coarse, or w made of what is. */
static INLINED bool dot_vanishes(const sure_vec3 *v, const vector_dd *w)
{
    dd x = two_product(v->x, w->x.head);
    dd y = two_product(v->y, w->y.head);
    dd z = two_product(v->z, w->z.head);
    const double heads[] = {x.head, y.head, z.head, 0}, tails[] = {x.tail, y.tail, z.tail, 0};
    return sum_of_magnitudes(w->x.tail, w->y.tail, w->z.tail) == 0 && sum_vanishes(heads, tails);
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

/* How a line lies to a plane: it crosses it at t, is beside it or within it. */
typedef enum { FLAT_UNCERTAIN, FLAT_CROSSES, FLAT_BESIDE, FLAT_WITHIN } flat_place;

typedef struct {
    flat_place place;
    double t, error;
    double e, e_error; /* of N.d */
    double reach, stride, normal;
} flat_line;

static inline flat_line flat_line_of(const sure_ray *ray, const sure_vec3 *place,
                                     const sure_vec3 *normal)
{
    vector_dd d = vector_of_dd(NULL, ray->direction),
              m = vector_between_dd(NULL, *place, ray->origin);
    flat_line l = {
        .place = FLAT_UNCERTAIN,
        .reach = sum_of_magnitudes(m.x.head, m.y.head, m.z.head),
        .stride = sum_of_magnitudes(d.x.head, d.y.head, d.z.head),
        .normal = sum_of_magnitudes(normal->x, normal->y, normal->z),
    };
    dd slope = flat_dot(normal, &d);
    dd height = flat_dot(normal, &m);
    double h = height.head + height.tail;
    double h_error = SURE_CROSSING_RESIDUAL_BOUND * l.normal * l.reach;
    l.e = slope.head + slope.tail;
    l.e_error = SURE_CROSSING_RESIDUAL_BOUND * l.normal * l.stride;
    if (!filter_scales(l.reach, l.stride, l.normal))
        return l;
    if (fabs(l.e) > 0x1p20 * l.e_error) {
        l.place = FLAT_CROSSES;
        l.t = -h / l.e;
        l.error = SURE_FLAT_T_BOUND * fabs(l.t) + (h_error + fabs(l.t) * l.e_error) / fabs(l.e);
        return l;
    }
    if (!(vector_is_coarse(normal) && vector_is_coarse(&ray->direction) &&
          dot_vanishes(normal, &d)))
        return l;
    if (fabs(h) > 2 * h_error)
        l.place = FLAT_BESIDE;
    else if (vector_is_coarse(place) && vector_is_coarse(&ray->origin) && dot_vanishes(normal, &m))
        l.place = FLAT_WITHIN;
    return l;
}

/* From t, near the crossing, to it: plane_filter.h's step by this better slope. p is the point at
 * t. */
static inline polish_step flat_step(const flat_line *l, const polish_point *p,
                                    const sure_vec3 *normal)
{
    vector_dd x = polish_vector(p);
    dd residual = flat_dot(normal, &x);
    double step = -(residual.head + residual.tail) / l->e, way = fabs(step);
    double off = SURE_CROSSING_RESIDUAL_BOUND * l->normal * p->most + l->e_error * way;
    return (polish_step){step, SURE_FLAT_T_BOUND * way + off / fabs(l->e),
                         filter_scales(l->normal, p->most, fabs(l->e))};
}

/* Does the line cross the plane exactly at t? p is the point there. True is certain. */
static inline bool flat_crosses_at(const sure_ray *ray, const sure_vec3 *place,
                                   const sure_vec3 *normal, double t, const polish_point *p)
{
    vector_dd x = polish_vector(p);
    return vector_is_coarse(normal) && point_is_whole(ray, place, t) && dot_vanishes(normal, &x);
}

static inline bool flat_line_keeps_limit(const flat_line *l, double error, double size)
{
    return error * l->stride < FLAT_LIMIT * (l->reach + size);
}

/* A hit as the line crosses, its t as wanted; `way` leads there from l's t. size: the object's. */
static inline filter_verdict flat_answer(const flat_line *l, double size, const polish_step *way,
                                         t_wanted wanted, sure_hit *hit)
{
    *hit = (sure_hit){l->t, l->error, SURE_PART_SURFACE, 0};
    if (wanted != T_EXACT)
        return flat_line_keeps_limit(l, l->error, size) ? FILTER_INTERVAL : FILTER_UNCERTAIN;
    bool rounded = polish_round(l->t, *way, &hit->t);
    hit->t_error = half_ulp(hit->t);
    return rounded ? FILTER_INTERVAL : FILTER_UNCERTAIN;
}

/* A chord within the boundary that holds t_min: the ray hits where it starts. */
static inline filter_verdict flat_start(const sure_ray *ray, sure_hit *hit)
{
    *hit = (sure_hit){ray->t_min, 0, SURE_PART_SURFACE, 0};
    return filter_range(ray) ? FILTER_INTERVAL : FILTER_UNCERTAIN;
}

/* A t that is exact. Bounds of the range that are subnormal are told by their bits. */
static inline filter_verdict flat_exactly(const sure_ray *ray, double t, t_wanted wanted,
                                          sure_hit *hit)
{
    double plain = t == 0 ? 0 : t;
    *hit = (sure_hit){plain, wanted == T_EXACT ? half_ulp(plain) : 0, SURE_PART_SURFACE, 0};
    if (!filter_range(ray))
        return FILTER_UNCERTAIN;
    bool within = !is_negative_bits(plain) && bits_of(plain) >= bits_of(ray->t_min) &&
                  bits_of(plain) <= bits_of(ray->t_max);
    return within ? FILTER_INTERVAL : FILTER_MISS;
}
