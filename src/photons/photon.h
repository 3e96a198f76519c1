/* SPDX-License-Identifier: MIT */
/* What a light has to give, by which photons choose one; and a photon on its way, as the forward
 * tracer and the mixed one follow it. */
#pragma once

#include "../numbers/sums.h"
#include "../support/random.h"
#include "../tracer/meeting.h"
#include "../tracer/visible.h"

#include <surehit/backward.h>

static inline double mean(sure_vec3 color)
{
    return (color.x + color.y + color.z) / 3;
}

static inline double power_of(const sure_light *light)
{
    return light->brightness * mean(light->color);
}

/* Of all lights. */
static inline double total_power(const sure_scene *scene)
{
    double sum = 0;
    for (size_t i = 0; i < scene->light_count; i++)
        sum += power_of(&scene->lights[i]);
    return sum;
}

typedef struct {
    tracing t;
    random_stream random;
    sure_vec3 weight;
    double length;           /* of its way */
    sure_ray ray;            /* to the next surface, ... */
    sure_surface_point from; /* ... from this one, ... */
    bool at_light;           /* ... or from the light itself */
    int chain_left;          /* mirrors and clear surfaces that it may follow */
    /* of the forward tracer: */
    bool scattered;    /* by a matte surface */
    int surfaces_left; /* matte ones that it may light */
} photon;

static inline void photon_head_for(photon *p, sure_vec3 origin, sure_vec3 direction)
{
    p->ray = (sure_ray){origin, direction, p->at_light ? in_front(p->t.tier) : 0, INFINITY};
}

static inline bool photon_nearest(const photon *p, sure_nearest *nearest)
{
    const sure_surface_point *leaving = p->at_light ? NULL : &p->from;
    return sure_backward_nearest(p->t.scene, p->t.tier, &p->ray, leaving, nearest) == SURE_HIT;
}

/* Goes there. */
static inline meeting photon_meet(photon *p, const sure_nearest *nearest)
{
    p->length += nearest->hit.t * sqrt(dot(p->ray.direction, p->ray.direction));
    meeting at;
    meeting_of(&p->t, &p->ray, p->at_light ? NULL : &p->from, nearest, &at);
    return at;
}

/* As the surface sends it on; false where it may not follow, or has no place to leave from. */
static inline bool photon_follow(photon *p, const meeting *at, sure_side side, sure_vec3 direction)
{
    if (p->chain_left <= 0 || !meeting_leave(&p->t, at, side, &p->from))
        return false;
    p->chain_left--;
    p->at_light = false;
    photon_head_for(p, p->from.point, direction);
    return true;
}

static inline bool photon_reflect(photon *p, const meeting *at)
{
    return photon_follow(p, at, at->side, meeting_reflect(at));
}

/* One of the two ways on, by chance: reflected as it is, or through in the surface's colour. */
static inline bool photon_pass_clear(photon *p, const meeting *at)
{
    parting into = meeting_part(at);
    if (random_fraction(&p->random) < into.share)
        return photon_reflect(p, at);
    p->weight = product(at->material->color, p->weight);
    return photon_follow(p, at, meeting_beyond(at), into.direction);
}
