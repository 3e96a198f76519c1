/* SPDX-License-Identifier: MIT */
/* The function whose zeros are the surface at a hit, at the point of its t and around: that of the
 * part that is hit as <shape>_tmpl.h has it, in twice the precision, with its gradient and how it
 * may change; and how far the solid's other functions are from 0. docs/proofs/spawn.md counts the
 * bounds, which take 2^-53 for an operation: round to nearest. Vectors are measured by their
 * components' magnitudes, summed. */
#pragma once

#include "../filter.h"
#include "../../numbers/sums.h"

/* n, n.v, A.p and H are off by less than this times their terms, besides what is said of them, and
 * candidates from P by this times |p|. */
#define QUICK_SPAWN_SHARE 0x1p-50
/* The normal that spawn.c takes is off by less than this times its terms. */
#define QUICK_SPAWN_OUTWARD 0x1p-48

/* |v|, here as in the filters the sum of magnitudes. */
static inline double measure_of(sure_vec3 v)
{
    return sum_of_magnitudes(v.x, v.y, v.z);
}

/* 0 where 2^-64 <= x < 2^64. */
static inline uint64_t beyond(double x)
{
    return (bits_of(x) - bits_of(0x1p-64)) >> 59;
}

/* o + t d */
typedef struct {
    dd x, y, z;
    double most; /* |o| + |t d| */
} line_point;

static inline dd line_coordinate(double o, double d, double t, double *most)
{
    dd way = two_product(t, d), x = two_sum(o, way.head);
    *most += fabs(o) + fabs(way.head);
    return (dd){x.head, x.tail + way.tail};
}

static inline line_point line_point_of(const sure_ray *ray, double t)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    line_point at = {.most = 0};
    at.x = line_coordinate(o->x, d->x, t, &at.most);
    at.y = line_coordinate(o->y, d->y, t, &at.most);
    at.z = line_coordinate(o->z, d->z, t, &at.most);
    return at;
}

static inline dd seen_coordinate(dd at, double from)
{
    dd x = two_sum(at.head, -from);
    return (dd){x.head, x.tail + at.tail};
}

/* As well known as filter.h says, with a `most` of its own. */
static inline polish_point seen_from(const sure_vec3 *from, const line_point *at)
{
    dd x = seen_coordinate(at->x, from->x), y = seen_coordinate(at->y, from->y);
    dd z = seen_coordinate(at->z, from->z);
    return (polish_point){x, y, z, sum_of_magnitudes(x.head, y.head, z.head) + at->most};
}

static inline sure_vec3 heads_of(const polish_point *p)
{
    return (sure_vec3){p->x.head, p->y.head, p->z.head};
}

/* Of a plane across a coordinate axis all points have that coordinate, exactly. */
typedef struct {
    int axis; /* 0, 1, 2; -1 for no such plane */
    double at, up;
} level;

/* x, y, z: is that component of the normal n other than 0? */
static inline level level_of(bool x, bool y, bool z, sure_vec3 n, const sure_vec3 *at)
{
    if (x + y + z != 1)
        return (level){.axis = -1};
    return x ? (level){0, at->x, n.x} : y ? (level){1, at->y, n.y} : (level){2, at->z, n.z};
}

/* F at the point of the hit's t, and around. */
typedef struct {
    double f, f_error;
    sure_vec3 n;          /* its gradient there, */
    double grain, bend;   /* off by grain at most, and by bend for each 1 that one goes */
    double outward_error; /* what spawn.c's normal is off by, when as long as n */
    double room, steep;   /* the other functions are -room at most, and rise by steep */
    uint64_t beyond;      /* 0: all is in range */
    level level;
} surface;

/* x + y where they all but cancel, so that the sum of their heads is as good as exact. */
static inline double remainder_of(dd x, dd y)
{
    return (x.head + y.head) + (x.tail + y.tail);
}
