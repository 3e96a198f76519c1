/* SPDX-License-Identifier: MIT */
/* The true hit point P is on the surface F = 0, and so, with n the gradient of F, a point q next to
 * it has
 *
 *     F(q) = n.(q - P) + curvature
 *
 * whose sign needs doubles only, once P is known as head + tail: by a step of Newton's method from
 * the hit's t. What spawn.c tries first is tried here, in its order; what is not certain is left to
 * it. docs/proofs/spawn.md counts the bounds. */
#pragma once

#include "../../numbers/places.h"
#include "spawn_surface.h"

/* A shape's spawn_quick in one piece, which lets the numbers stay in registers. True and *origin
 * when the answer is certain, and then it is what the rest of sure_spawn would find. False: then
 * *nearer is the hit with its t known better, where that helps. side: as surface.h counts. Entry:
 * as of sure_spawn, round to nearest, subnormals kept or flushed. */
#ifdef __GNUC__
#define SPAWN_IN_ONE_PIECE __attribute__((flatten)) bool
#else
#define SPAWN_IN_ONE_PIECE bool
#endif

/* P is off by less than this times |o| + |t d|, besides what the step is. */
#define QUICK_SPAWN_POINT 0x1p-103

/* P, and what is certain around it. */
typedef struct {
    dd x, y, z;
    double step;          /* from the hit's t to t* */
    double error;         /* of each coordinate */
    double doubt;         /* of n.(q - P) as F(q), q a candidate */
    double outward_error; /* of n as the normal that spawn.c takes */
    bool certain;
} true_place;

/* F(o + t d) = (t - t*) slope, with a slope of between here and P; |t - t*| <= t_error. */
static inline true_place true_place_of(const sure_ray *ray, const sure_hit *hit,
                                       const line_point *line, const surface *s)
{
    const sure_vec3 *d = &ray->direction;
    double slope = dot(s->n, *d), per_slope = 1 / slope, step = -s->f * per_slope;
    double d_most = measure_of(*d), n_most = measure_of(s->n), way = d_most * fabs(step);
    double stray = 1.25 * (d_most * hit->t_error); /* |o + t d - P| or more */
    double reach = QUICK_SPAWN_SHARE * (line->most + stray);
    double haze = QUICK_SPAWN_SHARE * n_most + s->grain, bent = haze; /* what n is off by: here, */
    if (s->bend > 0) {
        bent += s->bend * way;
        haze += s->bend * (stray + reach); /* and all around */
    }
    double error = 1.5 * (d_most * fabs(per_slope) * (s->f_error + way * bent));
    error += QUICK_SPAWN_POINT * line->most;
    return (true_place){.x = {line->x.head, line->x.tail + step * d->x},
                        .y = {line->y.head, line->y.tail + step * d->y},
                        .z = {line->z.head, line->z.tail + step * d->z},
                        .step = step,
                        .error = error,
                        .doubt = n_most * error + reach * haze,
                        .outward_error = s->bend > 0 ? haze + s->outward_error : 0,
                        .certain = ((s->beyond | beyond(d_most) | beyond(line->most)) == 0) &
                                   (8 * (haze * d_most) < fabs(slope)) &
                                   (s->steep > 0 ? (stray + reach) * s->steep < s->room : 1)};
}

static inline double nearest(dd x)
{
    return x.head + x.tail;
}

/* 0 where all that is within the error is rounded to one double: rounding is monotone. */
static inline double spread(dd x, double error)
{
    return (x.head + (x.tail + error)) - (x.head + (x.tail - error));
}

/* Is P certainly rounded to p, and far from 0 in all coordinates? */
static INLINED bool rounds_to(const true_place *at, sure_vec3 p)
{
    double all = spread(at->x, at->error) + spread(at->y, at->error) + spread(at->z, at->error);
    return (all == 0) & (filter_lesser(filter_lesser(fabs(p.x), fabs(p.y)), fabs(p.z)) >= 0x1p-64);
}

static inline double next_towards(double x, double up)
{
    if (is_zero_bits(x))
        return next_away(copysign(0.0, up));
    return is_negative_bits(x) == is_negative_bits(up) ? next_away(x) : next_towards_zero(x);
}

/* Is P's coordinate rounded to q for certain, and far from 0? */
static inline bool is_told(dd x, double error, double q)
{
    return (spread(x, error) == 0) & (fabs(q) >= 0x1p-64);
}

/* p is in the plane, and one step from there on the side; what else spawn.c tries is p. */
static inline bool answer_level(const true_place *at, level plane, double side, sure_vec3 *origin)
{
    bool x = plane.axis == 0, y = plane.axis == 1, z = plane.axis == 2;
    sure_vec3 q = {nearest(at->x), nearest(at->y), nearest(at->z)};
    double step = next_towards(plane.at, side * plane.up);
    if (!(at->certain & (is_zero_bits(plane.at) | (beyond(fabs(plane.at)) == 0)) &
          (x | is_told(at->x, at->error, q.x)) & (y | is_told(at->y, at->error, q.y)) &
          (z | is_told(at->z, at->error, q.z))))
        return false;
    origin->x = x ? step : q.x;
    origin->y = y ? step : q.y;
    origin->z = z ? step : q.z;
    return true;
}

/* n.(q - P) */
static inline double ahead(const true_place *at, sure_vec3 n, sure_vec3 q)
{
    double x = (q.x - at->x.head) - at->x.tail, y = (q.y - at->y.head) - at->y.tail;
    double z = (q.z - at->z.head) - at->z.tail;
    return n.x * x + n.y * y + n.z * z;
}

/* A step to a neighbour, as what is added to each coordinate's bits. */
typedef struct {
    uint64_t x, y, z;
} neighbour;

static inline sure_vec3 moved(sure_vec3 p, neighbour by, uint64_t times)
{
    return (sure_vec3){double_of(bits_of(p.x) + times * by.x),
                       double_of(bits_of(p.y) + times * by.y),
                       double_of(bits_of(p.z) + times * by.z)};
}

/* 1 or -1 for a step from x in the direction of n. */
static inline uint64_t step_along(double x, double n)
{
    return 1 - 2 * ((bits_of(x) ^ bits_of(n)) >> 63);
}

/* 2^e <= |x| */
static inline double unit_of(double x)
{
    return double_of(bits_of(x) & BITS_INFINITY);
}

/* As spawn.c's directions: one step in the coordinate with the greatest |n_i| 2^(exponent of p_i),
 * the first of equals. True when an n that is off by `error` leaves no other. Which one it is is as
 * good as random, so that is no branch. */
static inline bool best_step(sure_vec3 p, sure_vec3 n, double error, neighbour *best)
{
    sure_vec3 unit = {unit_of(p.x), unit_of(p.y), unit_of(p.z)};
    double x = fabs(n.x) * unit.x, y = fabs(n.y) * unit.y, z = fabs(n.z) * unit.z;
    double more = filter_greater(y, x);
    uint64_t second = y > x, third = z > more;
    *best =
        (neighbour){step_along(p.x, n.x) & (second - 1) & (third - 1),
                    step_along(p.y, n.y) & -second & (third - 1), step_along(p.z, n.z) & -third};
    double rest = filter_greater(z, more) - error * (unit.x + unit.y + unit.z);
    return (x > rest) + (y > rest) + (z > rest) <= 1;
}

/* The same hit where it is certain, its t known better. */
static inline void come_nearer(const sure_ray *ray, const sure_hit *hit, const true_place *at,
                               sure_hit *nearer)
{
    double t = hit->t + at->step;
    double t_error = at->error / measure_of(ray->direction) + 0x1p-52 * fabs(t);
    if (at->certain)
        *nearer = (sure_hit){t, t_error, hit->part, hit->leaves};
}

/* p, or the best neighbour, or the one behind it. Which of the first two it is is as good as
 * random. */
static inline bool spawn_by_surface(const sure_ray *ray, const sure_hit *hit, double side,
                                    const line_point *line, surface s, sure_vec3 *origin,
                                    sure_hit *nearer)
{
    true_place at = true_place_of(ray, hit, line, &s);
    if (s.level.axis >= 0)
        return answer_level(&at, s.level, side, origin);
    sure_vec3 p = {nearest(at.x), nearest(at.y), nearest(at.z)};
    if (!(at.certain & rounds_to(&at, p))) {
        come_nearer(ray, hit, &at, nearer);
        return false;
    }
    neighbour best;
    sure_vec3 n = {side * s.n.x, side * s.n.y, side * s.n.z};
    bool told = best_step(p, n, at.outward_error, &best);
    double first = ahead(&at, n, p);
    sure_vec3 q = moved(p, best, first < 0);
    double last = ahead(&at, n, q);
    if (last < -at.doubt) {
        q = moved(p, best, 2);
        last = ahead(&at, n, q);
    }
    if (!((fabs(first) > at.doubt) & ((first > 0) | told) & (last > at.doubt)))
        return false;
    *origin = q;
    return true;
}

/* Such a stage from a surface, which is made of `line` and what else it is handed. */
#define SPAWN_QUICK(name, surface)                                                                 \
    static inline SPAWN_IN_ONE_PIECE name(const sure_ray *ray, const void *shape,                  \
                                          const sure_hit *hit, double side, sure_vec3 *origin,     \
                                          sure_hit *nearer)                                        \
    {                                                                                              \
        line_point line = line_point_of(ray, hit->t);                                              \
        return spawn_by_surface(ray, hit, side, &line, surface, origin, nearer);                   \
    }
