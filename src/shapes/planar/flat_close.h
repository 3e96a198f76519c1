/* SPDX-License-Identifier: MIT */
/* The second stage of the flat shapes, closer but no wider than needed: N.d and N.m in twice the
 * precision, and whether they are exactly 0. docs/proofs/flat_close.md proves it. Round to nearest
 * is required throughout, but not that subnormals are kept. */
#pragma once

#include "../../stages/stages.h"
#include "../../stages/whole_point.h"
#include "../plane/plane_filter.h"

/* Of three or four: what the additions leave out is put by. */
static INLINED double sum_of_some(int count, const double *x, double left_out[3])
{
    dd low = two_sum(x[0], x[1]), high = count > 3 ? two_sum(x[2], x[3]) : (dd){x[2], 0};
    dd all = two_sum(low.head, high.head);
    left_out[0] = low.tail;
    left_out[1] = all.tail;
    left_out[2] = high.tail;
    return all.head;
}

/* Is the sum of three or four products, head + tail, 0? True is certain: nothing is left out in the
 * end. Entry: none has underflowed. */
static INLINED bool sum_vanishes(int count, const double *heads, const double *tails)
{
    double rest[4], left_out[6], head = sum_of_some(count, heads, rest);
    rest[count - 1] = head;
    double of_tails = sum_of_some(count, tails, left_out);
    double of_rest = sum_of_some(count, rest, left_out + 3);
    return of_tails == -of_rest &&
           sum_of_magnitudes(left_out[0], left_out[1], left_out[2]) +
                   sum_of_magnitudes(left_out[3], left_out[4], left_out[5]) ==
               0;
}

/* Is v.w exactly 0? False where that is not certain. Entry: coarse, or w made of what is. */
static INLINED bool dot_vanishes(const sure_vec3 *v, const vector_dd *w)
{
    dd x = two_product(v->x, w->x.head);
    dd y = two_product(v->y, w->y.head);
    dd z = two_product(v->z, w->z.head);
    const double heads[] = {x.head, y.head, z.head}, tails[] = {x.tail, y.tail, z.tail};
    return sum_of_magnitudes(w->x.tail, w->y.tail, w->z.tail) == 0 && sum_vanishes(3, heads, tails);
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
