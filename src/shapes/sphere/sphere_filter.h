/* SPDX-License-Identifier: MIT */
/* The first stage of the sphere; docs/proofs/sphere_filter.md proves it. With m = o - C:
 *
 *     a = d.d,  b = m.d,  c = m.m - r^2,  D = b^2 - a c
 *     t = (-b -+ sqrt(D)) / a
 *
 * D is measured by M = d.d (m.m + r^2), which is all of its terms made positive. */
#pragma once

#include "../../stages/filter.h"
#ifndef LANES
#include "../../stages/decision.h"
#endif

#define NUMBER f64
#include "sphere_tmpl.h"

/* What is decided on: D and its measure. */
typedef struct {
    vector_f64 m, d;
    double a, b, size, discriminant;
} sphere_terms;

static inline sphere_terms sphere_terms_of(const sure_ray *ray, const sure_sphere *sphere)
{
    vector_f64 m = vector_between_f64(NULL, sphere->centre, ray->origin);
    vector_f64 d = vector_of_f64(NULL, ray->direction);
    double a = vector_dot_f64(NULL, d, d), b = vector_dot_f64(NULL, m, d);
    double m2 = vector_dot_f64(NULL, m, m), r2 = sphere->radius * sphere->radius;
    return (sphere_terms){m, d, a, b, m2 + r2, b * b - a * (m2 - r2)};
}

/* Are the numbers in the filter's range, and so valid but for t_min and t_max? */
static inline bool sphere_fits(const sure_sphere *sphere, const sphere_terms *of)
{
    return filter_scales(of->a, of->size, sphere->radius);
}

/* Does the line certainly cross the sphere, with an error within the limit? Does it miss? */
static inline bool sphere_crosses(const sphere_terms *of)
{
    return of->discriminant > SURE_SPHERE_CERTAIN * (of->a * of->size);
}

static inline bool sphere_misses(const sphere_terms *of)
{
    return of->discriminant < -SURE_SPHERE_DISCRIMINANT_BOUND * (of->a * of->size);
}

/* Of t where it crosses; root: that of D. */
static inline double sphere_error(const sphere_terms *of, double root)
{
    return SURE_SPHERE_T_BOUND * of->size * filter_reciprocal_above(root);
}

static inline filter_interval sphere_ends(const sphere_terms *of, double root, double minus_per_a,
                                          double error)
{
    tagged_end less = {END_LESS, SURE_PART_SURFACE}, more = {END_MORE, SURE_PART_SURFACE};
    double enter = (of->b + root) * minus_per_a, leave = (of->b - root) * minus_per_a;
    return (filter_interval){.enter = {.t = enter, .error = error, .end = less},
                             .leave = {.t = leave, .error = error, .end = more}};
}

/* D by its second form, whose terms are near each other only when the ray grazes. */
typedef struct {
    double discriminant, sum, all; /* r^2 a + |d x m|^2, sqrt(M) */
} sphere_close_terms;

static inline sphere_close_terms sphere_close_terms_of(const sphere_terms *of, double radius)
{
    two_terms_f64 terms = sphere_discriminant_f64(NULL, of->a, of->d, of->m, radius);
    return (sphere_close_terms){terms.more - terms.less, terms.more + terms.less,
                                sqrt(of->a * of->size)};
}

static inline double sphere_close_off(const sphere_close_terms *close)
{
    return SURE_SPHERE_CLOSE_BOUND * sqrt(close->sum) * close->all;
}

/* Of t where it crosses; root: that of D. */
static inline double sphere_close_error(const sphere_terms *of, const sphere_close_terms *close,
                                        double off, double root)
{
    return (SURE_SPHERE_CLOSE_T_BOUND * close->all + off / root) / of->a;
}

#ifndef LANES /* From here on of one ray alone, with branches. */

static inline filter_verdict sphere_found(const sphere_terms *of, double root, double error,
                                          filter_interval *found)
{
    *found = sphere_ends(of, root, -1 / of->a, error);
    return FILTER_INTERVAL;
}

static inline filter_verdict sphere_filter_closely(const sure_ray *ray, const sure_sphere *sphere,
                                                   const sphere_terms *of, filter_interval *found)
{
    sphere_close_terms close = sphere_close_terms_of(of, sphere->radius);
    double discriminant = close.discriminant, off = sphere_close_off(&close);
    if (!(discriminant > off))
        return filter_miss_if(-discriminant > off, ray);
    double root = sqrt(discriminant);
    return sphere_found(of, root, sphere_close_error(of, &close, off, root), found);
}

static INLINED filter_verdict sphere_filter(const sure_ray *ray, const void *shape,
                                            filter_interval *found)
{
    const sure_sphere *sphere = (const sure_sphere *)shape;
    sphere_terms of = sphere_terms_of(ray, sphere);
    if (!sphere_fits(sphere, &of))
        return FILTER_UNCERTAIN;
    if (sphere_misses(&of))
        return filter_miss_if(true, ray);
    if (!sphere_crosses(&of))
        return sphere_filter_closely(ray, sphere, &of, found);
    double root = sqrt(of.discriminant);
    return sphere_found(&of, root, sphere_error(&of, root), found);
}

/* Without a branch but for the range, which can be foreseen: whether the line crosses the sphere
 * can't. Where it does not the root is that of another number, and nothing is made of it. */
static INLINED decided sphere_decide(const sure_ray *ray, const sure_sphere *sphere)
{
    const sphere_terms of = sphere_terms_of(ray, sphere);
    double size = fabs(of.discriminant), root = sqrt(size), error = sphere_error(&of, root);
    if (!sphere_fits(sphere, &of))
        return (decided){.certain = false};
    double minus_per_a = -1 / of.a;
    const decision_end at =
        decision_end_of((of.b + root) * minus_per_a, (of.b - root) * minus_per_a, ray);
    return decision_of(&at, of.discriminant, size > SURE_SPHERE_CERTAIN * (of.a * of.size), true,
                       error, error, SURE_PART_SURFACE, ray);
}

/* |p|^2 - r^2 for a point near the sphere, in twice the precision: off by at most 64 2^-106 times
 * the product of magnitudes. */
static inline double sphere_residual(const polish_point *p, double radius)
{
    dd x = dd_square(NULL, p->x), y = dd_square(NULL, p->y), z = dd_square(NULL, p->z);
    dd rr = two_product(radius, radius);
    dd xy = two_sum(x.head, y.head), xyz = two_sum(xy.head, z.head);
    dd all = two_sum(xyz.head, -rr.head);
    double tails = (x.tail + y.tail) + (z.tail + xy.tail) + (xyz.tail - rr.tail);
    return all.head + (all.tail + tails);
}

/* From t on, with q = |p|^2 - r^2 and s = p.d, the equation is a step^2 + 2 s step + q = 0. Its
 * root next to t is the lesser where s is certainly negative, the greater where it is positive. */
static inline polish_step sphere_step(const sure_ray *ray, const void *shape, tagged_end end,
                                      double t)
{
    const sure_sphere *sphere = (const sure_sphere *)shape;
    const sure_vec3 *d = &ray->direction;
    polish_point p = polish_point_of(ray, &sphere->centre, t);
    double p_most = sum_of_magnitudes(p.x.head, p.y.head, p.z.head) + 0x1p-50 * p.most;
    double a = d->x * d->x + d->y * d->y + d->z * d->z;
    double s = p.x.head * d->x + p.y.head * d->y + p.z.head * d->z;
    double slope = end.at == END_LESS ? -s : s;
    double slope_most = p.most * sum_of_magnitudes(d->x, d->y, d->z);
    double step = -sphere_residual(&p, sphere->radius) * (0.5 / s), way = fabs(step);
    double error = (0.5 / slope) * (way * (1.5 * a * way + SURE_SPHERE_STEP_BOUND * slope_most) +
                                    SURE_SPHERE_RESIDUAL_BOUND * p_most * p.most);
    bool certain = slope > SURE_SPHERE_SLOPE_CERTAIN * slope_most &&
                   a * way < POLISH_BEND * slope && filter_scales(a, slope, p_most * p.most);
    return (polish_step){step, error, certain};
}

#endif
