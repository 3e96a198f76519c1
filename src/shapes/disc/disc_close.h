/* SPDX-License-Identifier: MIT */
/* The second stage of the disc; docs/proofs/flat_close.md proves it. From t, near where the line
 * crosses the disc's plane or, within it, is nearest to the centre, the point p and
 *
 *     q = |p|^2 - r^2
 *
 * are known in twice the precision. A step s to the crossing itself makes q + 2 s p.d + s^2 d.d of
 * it. Within the plane the circle is met at the roots of a s^2 + 2 b s + q with a = d.d and
 * b = p.d, as a sphere would be. */
#pragma once

#include "disc_filter.h"
#include "../planar/flat_close.h"
#include "../sphere/sphere_filter.h"

/* |p|^2 - r^2 at t, off by at most SURE_DISC_RIM_BOUND times size, and of itself by 2^-53. */
typedef struct {
    double t;
    polish_point p;
    double p_most, q, size;
} disc_place;

static inline disc_place disc_place_of(double t, const polish_point *p, double r)
{
    double p_most = sum_of_magnitudes(p->x.head, p->y.head, p->z.head) + 0x1p-50 * p->most;
    return (disc_place){t, *p, p_most, sphere_residual(p, r), p_most * p->most + r * r};
}

static inline bool disc_in_range(const flat_line *l, double radius)
{
    double reach = l->reach * l->reach;
    return filter_scales(l->stride * l->stride, reach, reach + radius * radius);
}

/* A number whose sign decides: |value - it| <= error. */
typedef struct {
    double value, error;
} disc_sign;

/* 1, -1, or 0 where it is not certain. */
static inline int disc_sign_of(const disc_sign *of)
{
    return of->value > of->error ? 1 : -of->value > of->error ? -1 : 0;
}

/* |p|^2 - r^2 a step from the place, at the crossing. Entry: the step is certain. */
static inline disc_sign disc_rim_sign(const sure_ray *ray, const flat_line *l, const disc_place *at,
                                      const polish_step *way)
{
    const sure_vec3 *d = &ray->direction;
    double s = way->step, there = fabs(s) * l->stride, off = way->error * l->stride;
    double slope = at->p.x.head * d->x + at->p.y.head * d->y + at->p.z.head * d->z;
    double a = d->x * d->x + d->y * d->y + d->z * d->z;
    double of_step = off * (at->p_most + there + off);
    double of_terms = SURE_DISC_TERMS_BOUND * (there * (at->p.most + there) + fabs(at->q));
    return (disc_sign){at->q + (2 * s * slope + s * s * a),
                       SURE_DISC_RIM_BOUND * at->size + 2.125 * (of_step + of_terms)};
}

/* Within the plane: where the line is nearest to the centre, or nearly there. */
typedef struct {
    disc_place at;
    double a, slope, slope_error; /* d.d, p.d */
    disc_sign quarter;            /* of the discriminant: b^2 - a q */
} disc_foot;

/* Where that is by double alone. */
static inline double disc_foot_guess(const sure_ray *ray, const sure_disc *disc, double a)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction, *c = &disc->centre;
    return -((o->x - c->x) * d->x + (o->y - c->y) * d->y + (o->z - c->z) * d->z) / a;
}

static inline disc_sign disc_edge_sign(const disc_foot *foot)
{
    double b = fabs(foot->slope), of_b = (2 * b + foot->slope_error) * foot->slope_error;
    double square = b * b, product = foot->a * foot->at.q;
    double of_q = SURE_DISC_RIM_BOUND * foot->a * foot->at.size;
    return (disc_sign){square - product,
                       1.0625 * (of_q + of_b) + SURE_DISC_TERMS_BOUND * (square + fabs(product))};
}

static inline void disc_foot_at(double t, const sure_ray *ray, const sure_disc *disc,
                                const flat_line *l, disc_foot *foot)
{
    polish_point p = polish_point_of(ray, &disc->centre, t);
    vector_dd x = polish_vector(&p);
    dd slope = flat_dot(&ray->direction, &x);
    foot->at = disc_place_of(t, &p, disc->radius);
    foot->slope = slope.head + slope.tail;
    foot->slope_error = SURE_CROSSING_RESIDUAL_BOUND * l->stride * p.most;
    foot->quarter = disc_edge_sign(foot);
}

/* What is uncertain from nearly there may be certain from as near as doubles are. */
static inline disc_foot disc_foot_of(const sure_ray *ray, const sure_disc *disc, const flat_line *l)
{
    const sure_vec3 *d = &ray->direction;
    disc_foot foot = {.a = d->x * d->x + d->y * d->y + d->z * d->z};
    double nearer = disc_foot_guess(ray, disc, foot.a), t;
    int steps = 0;
    do {
        t = nearer;
        disc_foot_at(t, ray, disc, l, &foot);
        nearer = t - foot.slope / foot.a;
    } while (disc_sign_of(&foot.quarter) == 0 && nearer != t && ++steps < 2);
    return foot;
}

/* Is a point that is whole exactly on the circle's sphere? True is certain. */
static INLINED bool disc_holds_on_rim(const sure_disc *disc, const polish_point *p)
{
    dd x = two_product(p->x.head, p->x.head), y = two_product(p->y.head, p->y.head);
    dd z = two_product(p->z.head, p->z.head);
    dd rr = two_product(disc->radius, disc->radius);
    const double heads[] = {x.head, y.head, z.head, -rr.head};
    const double tails[] = {x.tail, y.tail, z.tail, -rr.tail};
    const sure_vec3 radii = {disc->radius, disc->radius, disc->radius};
    return vector_is_coarse(&radii) && sum_vanishes(4, heads, tails);
}

/* Does the line touch the circle exactly at the foot: p.d = 0, q = 0? True is certain. */
static inline bool disc_touches(const sure_ray *ray, const sure_disc *disc, const disc_foot *foot)
{
    vector_dd p = polish_vector(&foot->at.p);
    return point_is_whole(ray, &disc->centre, foot->at.t) && dot_vanishes(&ray->direction, &p) &&
           disc_holds_on_rim(disc, &foot->at.p);
}

static inline void disc_edge_found(const disc_foot *foot, filter_interval *found)
{
    double root = sqrt(foot->quarter.value), per_a = 1 / foot->a, t = foot->at.t;
    double terms = SURE_DISC_TERMS_BOUND * (fabs(foot->slope) + root);
    double error = 1.0625 * (foot->quarter.error / root + foot->slope_error + terms) * per_a +
                   SURE_FLAT_T_BOUND * fabs(t);
    tagged_end less = {END_LESS, SURE_PART_SURFACE}, more = {END_MORE, SURE_PART_SURFACE};
    double enter = t + (-foot->slope - root) * per_a, leave = t + (root - foot->slope) * per_a;
    found->enter = (filter_end){.t = enter, .error = error, .end = less};
    found->leave = (filter_end){.t = leave, .error = error, .end = more};
}

/* The line's chord in the circle: FILTER_INTERVAL, both ends at the foot where it is tangent. */
static inline filter_verdict disc_edge_chord(const sure_ray *ray, const sure_disc *disc,
                                             const flat_line *l, filter_interval *found)
{
    disc_foot foot = disc_foot_of(ray, disc, l);
    tagged_end touch = {END_TANGENT, SURE_PART_SURFACE};
    switch (disc_sign_of(&foot.quarter)) {
    case 1: disc_edge_found(&foot, found); return FILTER_INTERVAL;
    case -1: return FILTER_MISS;
    default: break;
    }
    found->enter = found->leave = (filter_end){.t = foot.at.t, .end = touch};
    return disc_touches(ray, disc, &foot) ? FILTER_INTERVAL : FILTER_UNCERTAIN;
}

/* A hit at an end of the chord, its t as wanted. */
static inline filter_verdict disc_edge_answer(const sure_ray *ray, const sure_disc *disc,
                                              const flat_line *l, const filter_end *end,
                                              t_wanted wanted, sure_hit *hit)
{
    sure_sphere around = {disc->centre, disc->radius};
    *hit = (sure_hit){end->t, end->error, SURE_PART_SURFACE, 0};
    if (wanted != T_EXACT)
        return flat_line_keeps_limit(l, end->error, disc->radius) ? FILTER_INTERVAL
                                                                  : FILTER_UNCERTAIN;
    bool rounded = polish(sphere_step, 2, ray, &around, end, &hit->t);
    hit->t_error = half_ulp(hit->t);
    return rounded ? FILTER_INTERVAL : FILTER_UNCERTAIN;
}

static NOT_INLINED filter_verdict disc_edge_closely(const sure_ray *ray, const sure_disc *disc,
                                                    const flat_line *l, t_wanted wanted,
                                                    sure_hit *hit)
{
    filter_interval found;
    filter_end first;
    filter_verdict verdict = disc_edge_chord(ray, disc, l, &found);
    if (verdict != FILTER_INTERVAL)
        return filter_miss_if(verdict == FILTER_MISS, ray);
    if (found.enter.end.at == END_TANGENT)
        return flat_exactly(ray, found.enter.t, wanted, hit);
    if (ray->t_min - found.enter.t > found.enter.error &&
        found.leave.t - ray->t_min > found.leave.error)
        return flat_start(ray, hit);
    verdict = filter_first(&found, ray, &first);
    return verdict == FILTER_INTERVAL ? disc_edge_answer(ray, disc, l, &first, wanted, hit)
                                      : verdict;
}

/* Where t or the rim can't be told, t may be exact. */
static inline filter_verdict disc_crossing_closely(const sure_ray *ray, const sure_disc *disc,
                                                   const flat_line *l, t_wanted wanted,
                                                   sure_hit *hit)
{
    filter_interval found;
    filter_end first;
    (void)flat_found(l->t, l->error, &found);
    filter_verdict in_range = filter_first(&found, ray, &first);
    if (in_range == FILTER_MISS)
        return in_range;
    polish_point p = polish_point_of(ray, &disc->centre, l->t);
    polish_step way = flat_step(l, &p, &disc->normal);
    disc_place at = disc_place_of(l->t, &p, disc->radius);
    disc_sign rim = disc_rim_sign(ray, l, &at, &way);
    int side = way.certain ? disc_sign_of(&rim) : 0;
    if (side > 0)
        return filter_miss_if(true, ray);
    if (side < 0 && in_range == FILTER_INTERVAL)
        return flat_answer(l, disc->radius, &way, wanted, hit);
    if (flat_crosses_at(ray, &disc->centre, &disc->normal, l->t, &p) &&
        (side < 0 || disc_holds_on_rim(disc, &p)))
        return flat_exactly(ray, l->t, wanted, hit);
    return FILTER_UNCERTAIN;
}

static inline filter_verdict disc_refine_hit(const sure_ray *ray, const void *shape,
                                             t_wanted wanted, sure_hit *hit)
{
    const sure_disc *disc = shape;
    flat_line l = flat_line_of(ray, &disc->centre, &disc->normal);
    if (is_negative_bits(disc->radius) || !disc_in_range(&l, disc->radius))
        return FILTER_UNCERTAIN;
    switch (l.place) {
    case FLAT_UNCERTAIN: break;
    case FLAT_BESIDE: return filter_miss_if(true, ray);
    case FLAT_WITHIN: return disc_edge_closely(ray, disc, &l, wanted, hit);
    case FLAT_CROSSES: return disc_crossing_closely(ray, disc, &l, wanted, hit);
    }
    return FILTER_UNCERTAIN;
}

#define DISC_CLOSE .refine_hit = disc_refine_hit, .step = disc_step, .spawn = planar_spawn_quick
