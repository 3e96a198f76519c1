/* SPDX-License-Identifier: MIT */
/* What a packet asks of one object: the shape's first stage side by side, and a ray alone where
 * that is uncertain or where it comes from that very object. A mask has a bit a ray. */
#pragma once

#include "../stages/hits/block.h"
#include "packet.h"
#include "pixel_ray.h"
#include "visible.h"

#include <surehit/backward.h>
#include <surehit/hit_order.h>

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

_Static_assert(sizeof(((packet *)0)->origin) == 3 * PACKET * sizeof(double), "columns of a block");

typedef struct {
    double farthest[PACKET]; /* as far as the nearest so far */
    double t[PACKET], t_error[PACKET];
    uint8_t status[PACKET], part[PACKET], leaves[PACKET];
    block asked; /* of the rays, answered into these */
    const block_stage *stages;
    const sure_scene *scene;
    const packet *rays;
    sure_nearest *nearest; /* NULL: any will do, and who has met one is not asked any more */
    unsigned open, found;  /* who asks, who has met one */
} PACKET_ALIGNED packet_search;

static inline unsigned packet_lowest(unsigned mask)
{
    return (unsigned)__builtin_ctz(mask);
}

static bool packet_at_light(const packet_search *s, unsigned i, size_t object)
{
    const sure_ray ray = packet_ray(s->rays, i);
    return visible_is_at_light(s->scene, SURE_TIER_CERTAIN, &ray, s->rays->leaving[i],
                               s->rays->light, object);
}

static inline void packet_keep(packet_search *s, unsigned i, size_t object, const sure_hit *hit)
{
    const unsigned bit = 1U << i;
    if (!s->nearest) {
        if (visible_may_be_at_light(s->rays->light, SURE_TIER_CERTAIN, hit) &&
            packet_at_light(s, i, object))
            return;
        s->open &= ~bit;
    } else {
        const sure_ray ray = packet_ray(s->rays, i);
        if ((s->found & bit) &&
            !visible_is_nearer(s->scene, SURE_TIER_CERTAIN, &ray, object, hit, &s->nearest[i]))
            return;
        s->nearest[i] = (sure_nearest){object, *hit};
        s->farthest[i] = visible_as_far_as(SURE_TIER_CERTAIN, hit, s->farthest[i]);
    }
    s->found |= bit;
}

static inline void packet_ask_alone(packet_search *s, unsigned i, size_t object)
{
    const sure_ray ray = packet_ray(s->rays, i);
    sure_hit hit;
    if (visible_meets(s->scene, SURE_TIER_CERTAIN, &ray, s->rays->leaving[i], object, &hit))
        packet_keep(s, i, object, &hit);
}

static inline unsigned packet_from(const packet_search *s, size_t object)
{
    unsigned from = 0;
    for (unsigned i = 0; i < PACKET; i++) {
        const sure_surface_point *leaving = s->rays->leaving[i];
        from |= (unsigned)(leaving && leaving->object == object) << i;
    }
    return from;
}

static inline unsigned packet_whose(const uint8_t status[PACKET], uint8_t is)
{
    unsigned whose = 0;
    for (unsigned i = 0; i < PACKET; i++)
        whose |= (unsigned)(status[i] == is) << i;
    return whose;
}

static inline void packet_ask_together(packet_search *s, size_t object, unsigned mask)
{
    const sure_object *asked = &s->scene->objects[object];
    const double *numbers = (const double *)&asked->as;
    for (int k = 0; k < OBJECT_NUMBERS; k++)
        s->asked.object[k] = numbers + k;
    s->stages[asked->shape].first(&s->asked);
    unsigned uncertain = packet_whose(s->status, BLOCK_UNCERTAIN) & mask;
    unsigned hits = packet_whose(s->status, SURE_HIT) & mask;
    for (; hits; hits &= hits - 1) {
        const unsigned i = packet_lowest(hits);
        const sure_hit hit = {s->t[i], s->t_error[i], (sure_part)s->part[i], s->leaves[i]};
        packet_keep(s, i, object, &hit);
    }
    for (; uncertain; uncertain &= uncertain - 1)
        packet_ask_alone(s, packet_lowest(uncertain), object);
}

static inline void packet_ask(packet_search *s, size_t object, unsigned mask)
{
    unsigned from = packet_from(s, object) & mask;
    if (mask & ~from)
        packet_ask_together(s, object, mask & ~from);
    for (; from; from &= from - 1)
        packet_ask_alone(s, packet_lowest(from), object);
}

/* What is unused is as the first ray. */
static inline void packet_begin(packet_search *s, const sure_scene *scene, packet *rays,
                                sure_nearest *nearest, const block_stage *stages)
{
    double *columns = (double *)(void *)rays;
    assert(rays->count > 0 && rays->count <= PACKET);
    for (size_t k = 0; k < RAY_NUMBERS; k++) {
        for (size_t i = rays->count; i < PACKET; i++)
            columns[k * PACKET + i] = columns[k * PACKET];
        s->asked.ray[k] = columns + k * PACKET;
    }
    for (size_t i = rays->count; i < PACKET; i++)
        rays->leaving[i] = NULL;
    memcpy(s->farthest, rays->t_max, sizeof s->farthest);
    s->asked.count = PACKET;
    s->asked.one_object = true;
    s->asked.status = s->status;
    s->asked.part = s->part;
    s->asked.leaves = s->leaves;
    s->asked.t = s->t;
    s->asked.t_error = s->t_error;
    s->stages = stages;
    s->scene = scene;
    s->rays = rays;
    s->nearest = nearest;
    s->open = (1U << rays->count) - 1;
    s->found = 0;
}

/* Rays that go alone. */
static inline void packet_rest(packet_search *s, unsigned alone)
{
    for (; alone; alone &= alone - 1) {
        const unsigned i = packet_lowest(alone);
        const sure_ray ray = packet_ray(s->rays, i);
        const sure_surface_point *leaving = s->rays->leaving[i];
        size_t unused;
        sure_status met =
            s->nearest
                ? sure_backward_nearest(s->scene, SURE_TIER_CERTAIN, &ray, leaving, &s->nearest[i])
                : visible_any(s->scene, SURE_TIER_CERTAIN, &ray, leaving, s->rays->light, &unused);
        s->found |= (unsigned)(met == SURE_HIT) << i;
    }
}

/* A child that waits. */
typedef struct {
    double enter[PACKET];
    uint32_t first;
    uint8_t count, mask;
} PACKET_ALIGNED packet_pending;

/* The last one goes where it belongs, the nearest on top, each as its lowest ray has it. */
static inline void packet_sort(packet_pending *bottom, packet_pending *last)
{
    const double enter = last->enter[packet_lowest(last->mask)];
    packet_pending *to = last;
    while (to > bottom && to[-1].enter[packet_lowest(to[-1].mask)] < enter)
        to--;
    if (to == last)
        return;
    const packet_pending moved = *last;
    for (; last > to; last--)
        *last = last[-1];
    *to = moved;
}

/* What pixels' rays are made of. */
typedef struct {
    double extent[2], twice[2], ahead;
    const sure_mat3 *turn;
} packet_view;

/* The rays but for their directions, of which there is what PIXEL_OFFSET calls odd. */
static inline packet_view packet_begin_pixels(const sure_scene *scene, size_t count,
                                              const int *column, const int *row, packet *rays)
{
    const sure_camera *camera = &scene->camera;
    rays->count = 0;
    rays->light = NULL;
    assert(count > 0 && count <= PACKET && pixel_scales_ok(camera));
    for (size_t i = 0; i < PACKET; i++) {
        const int64_t x = column[i < count ? i : 0], y = row[i < count ? i : 0];
        assert(0 <= x && x < scene->width && 0 <= y && y < scene->height);
        const sure_vec3 odd = {(double)(2 * x + 1 - scene->width),
                               (double)(2 * y + 1 - scene->height), 0};
        packet_add(rays, &camera->position, &odd, 0, HUGE_VAL, NULL);
    }
    rays->count = count;
    return (packet_view){
        {camera->viewport_width, camera->viewport_height},
        {(double)(2 * (int64_t)scene->width), (double)(2 * (int64_t)scene->height)},
        -camera->focal_length,
        &scene->turn};
}
