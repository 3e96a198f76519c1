/* SPDX-License-Identifier: MIT */
/* All that a tier answers to a case, 0 where nothing is. It has no holes: bytes are compared. */
#pragma once

#include "../../src/cases/case.h"

#include <string.h>

#include <surehit/hit_order.h>
#include <surehit/spawn.h>

enum { SIDES = 2 };

typedef struct {
    sure_hit hit;
    sure_interval interval;
    sure_vec3 normal, origin[SIDES]; /* spawned outside and inside */
    int status, interval_status, occluded, found[SIDES];
    int order; /* of the hit and that on a plane across the ray, through the object's first point */
} answers;

/* Calls `asked` after each question unless it is NULL. */
static inline answers answers_of(const sure_case *question, sure_tier tier, void (*asked)(void))
{
    const sure_ray *ray = &question->ray;
    const sure_object *object = &question->object;
    sure_object across = {.shape = SURE_SHAPE_PLANE};
    answers a = {.order = 0};
    sure_hit hit, crossing;
    sure_interval interval;
#define ASKED (asked ? asked() : (void)0)
    a.status = (int)sure_object_hit(ray, object, tier, &hit);
    ASKED;
    if (a.status == SURE_HIT) {
        a.hit = hit;
        a.normal = sure_object_normal(ray, object, tier, &hit);
        ASKED;
        for (int side = 0; side < SIDES; side++) {
            a.found[side] = sure_spawn(ray, object, &hit, (sure_side)side, &a.origin[side]);
            ASKED;
        }
        memcpy(&across.as.plane.point, &object->as, sizeof across.as.plane.point);
        across.as.plane.normal = ray->direction;
        if (sure_object_hit(ray, &across, tier, &crossing) == SURE_HIT)
            a.order = 2 + sure_hit_order(ray, object, &hit, &across, &crossing);
        ASKED;
    }
    a.interval_status = (int)sure_object_interval(ray, object, tier, &interval);
    ASKED;
    if (a.interval_status == SURE_HIT)
        a.interval = interval;
    a.occluded = (int)sure_object_occluded(ray, object, tier);
    ASKED;
#undef ASKED
    return a;
}

static inline bool answers_same_decisions(const answers *a, const answers *b)
{
    return a->status == b->status && a->hit.part == b->hit.part && a->hit.leaves == b->hit.leaves &&
           a->interval_status == b->interval_status && a->occluded == b->occluded &&
           a->interval.enter_part == b->interval.enter_part &&
           a->interval.leave_part == b->interval.leave_part;
}

/* All but t_error? */
static inline bool answers_same(const answers *a, answers b)
{
    b.hit.t_error = a->hit.t_error;
    return memcmp(a, &b, sizeof b) == 0;
}
