/* SPDX-License-Identifier: MIT */
/* What the peers have in common: the routines of others, to be judged (docs/judge.md). Each file
 * is one shared library; it says what it stands for and where its formulas are published. The
 * formulas are followed, the code is our own. A peer checks no input where its model checks none.
 */
#ifndef PEERS_PEER_H
#define PEERS_PEER_H

#include "precision.h"

typedef struct {
    real x, y, z;
} vec3;

typedef struct {
    vec3 o, d;
    real t_min, t_max;
} peer_ray;

static inline vec3 vector(const real *from)
{
    return (vec3){from[0], from[1], from[2]};
}

static inline peer_ray ray_of(const real *from)
{
    return (peer_ray){vector(from), vector(from + 3), from[6], from[7]};
}

static inline vec3 sub(vec3 a, vec3 b)
{
    return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vec3 scaled(real s, vec3 a)
{
    return (vec3){s * a.x, s * a.y, s * a.z};
}

static inline real dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 cross(vec3 a, vec3 b)
{
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* p + t d */
static inline vec3 along(vec3 p, real t, vec3 d)
{
    return (vec3){p.x + t * d.x, p.y + t * d.y, p.z + t * d.z};
}

static inline int is_in_range(const peer_ray *ray, real t)
{
    return t >= ray->t_min && t <= ray->t_max;
}

static inline int found(peer_hit *hit, real t, int part)
{
    hit->t = t;
    hit->part = part;
    return SURE_CANDIDATE_HIT;
}

/* The first of two roots, near <= far, that is in the range. */
static inline int found_first(const peer_ray *ray, real near, real far, peer_hit *hit)
{
    if (is_in_range(ray, near))
        return found(hit, near, SURE_CANDIDATE_SURFACE);
    if (is_in_range(ray, far))
        return found(hit, far, SURE_CANDIDATE_SURFACE);
    return SURE_CANDIDATE_MISS;
}

#endif
