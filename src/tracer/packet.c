/* SPDX-License-Identifier: MIT */
/* Compiled once for each width of shapes/lanes. */
#include "packet.h"

#include "../hierarchy/bvh_row.h"
#include "../stages/hits/block.h"
#include "visible.h"

#include <surehit/backward.h>
#include <surehit/hit_order.h>

#define double_alone double
enum { BVH_PACKET = PACKET };
#include <stdint.h>
#include <string.h>
#ifdef __SSE2__
#include <immintrin.h>
#endif

#define COLUMN __attribute__((aligned(64)))

#if defined(__AVX512F__)
#define WALKS packet_walks_8
#define STAGES block_stages_8
#elif defined(__AVX2__)
#define WALKS packet_walks_4
#define STAGES block_stages_4
#else
#define WALKS packet_walks_2
#define STAGES block_stages_2
#endif

typedef struct {
    double column[RAY_NUMBERS][PACKET] COLUMN;
    double farthest[PACKET] COLUMN;
    const sure_scene *scene;
    const packet *rays;
    sure_nearest *nearest; /* NULL: any will do */
    unsigned together, found;
    size_t leaving[PACKET] COLUMN;
    bool leaves;
} walk;

static inline unsigned lowest(unsigned mask)
{
    return (unsigned)__builtin_ctz(mask);
}

static inline bool is_nearer(const walk *w, unsigned i, size_t object, const sure_hit *hit)
{
    const sure_object *objects = w->scene->objects;
    const sure_nearest *than = &w->nearest[i];
    int order = sure_hit_order(&w->rays->ray[i], &objects[object], hit, &objects[than->object],
                               &than->hit);
    return order < 0 || (order == 0 && object < than->object);
}

static inline void keep(walk *w, unsigned i, size_t object, const sure_hit *hit)
{
    const unsigned bit = 1U << i;
    if (w->nearest && (w->found & bit) && !is_nearer(w, i, object, hit))
        return;
    w->found |= bit;
    if (!w->nearest)
        return;
    w->nearest[i] = (sure_nearest){object, *hit};
    double farthest = hit->t + hit->t_error;
    w->farthest[i] = farthest < w->farthest[i] ? farthest : w->farthest[i];
}

static void ask_alone(walk *w, unsigned i, size_t object)
{
    sure_hit hit;
    const sure_surface_point *leaving = w->rays->leaving[i];
    const sure_ray *ray = &w->rays->ray[i];
    bool met = leaving && leaving->object == object
                   ? sure_scene_meets_again(w->scene, SURE_TIER_CERTAIN, ray, leaving, &hit) == SURE_HIT
                   : sure_object_hit(ray, &w->scene->objects[object], SURE_TIER_CERTAIN, &hit) == SURE_HIT;
    if (met)
        keep(w, i, object, &hit);
}

static inline unsigned mask_of(const uint8_t status[PACKET], uint8_t of)
{
    unsigned mask = 0;
#ifdef __SSE2__
    __m128i x = _mm_loadl_epi64((const __m128i *)(const void *)status);
    mask = (unsigned)_mm_movemask_epi8(_mm_cmpeq_epi8(x, _mm_set1_epi8((char)of))) & 0xff;
#else
    for (unsigned i = 0; i < PACKET; i++)
        mask |= (unsigned)(status[i] == of) << i;
#endif
    return mask;
}

static void ask(walk *w, size_t index, unsigned mask)
{
    const sure_object *object = &w->scene->objects[index];
    unsigned alone = 0;
    if (w->leaves) {
        for (unsigned i = 0; i < PACKET; i++)
            alone |= (unsigned)(w->leaving[i] == index) << i;
        alone &= mask;
        for (unsigned rest = alone; rest; rest &= rest - 1)
            ask_alone(w, lowest(rest), index);
        mask &= ~alone;
    }
    if (!mask)
        return;
    double t[PACKET], error[PACKET];
    uint8_t status[PACKET], part[PACKET], leaves[PACKET];
    double numbers[OBJECT_NUMBERS][PACKET];
    const double *from = (const double *)&object->as;
    const int count = sure_shape_info_of(object->shape)->numbers;
    block b = {.count = PACKET, .one_object = true, .status = status, .part = part, .leaves = leaves, .t = t, .t_error = error};
    for (int k = 0; k < RAY_NUMBERS; k++)
        b.ray[k] = w->column[k];
    for (int k = 0; k < count; k++) {
        for (int i = 0; i < PACKET; i++)
            numbers[k][i] = from[k];
        b.object[k] = numbers[k];
    }
    STAGES[object->shape](&b);
    unsigned hits = mask_of(status, SURE_HIT) & mask;
    unsigned uncertain = mask_of(status, BLOCK_UNCERTAIN) & mask;
    for (; uncertain; uncertain &= uncertain - 1)
        ask_alone(w, lowest(uncertain), index);
    if (!w->nearest) {
        w->found |= hits;
        return;
    }
    for (; hits; hits &= hits - 1) {
        unsigned i = lowest(hits);
        sure_hit hit = {t[i], error[i], (sure_part)part[i], leaves[i]};
        keep(w, i, index, &hit);
    }
}

typedef struct {
    double enter[PACKET];
    uint32_t first;
    uint8_t count, mask;
} COLUMN pending;

/* Of those that meet: the nearest of the first's. */
static inline bool put_in_order(pending *stack, int bottom, int height)
{
    pending *at = &stack[height];
    const double enter = at->enter[lowest(at->mask)];
    int j = height;
    while (j > bottom && stack[j - 1].enter[lowest(stack[j - 1].mask)] < enter)
        j--;
    if (j == height)
        return true;
    pending moved = *at;
    for (int k = height; k > j; k--)
        stack[k] = stack[k - 1];
    stack[j] = moved;
    return true;
}

static inline unsigned open(const walk *w)
{
    return w->nearest ? w->together : w->together & ~w->found;
}

static inline void columns_of(walk *w)
{
    const packet *rays = w->rays;
    w->leaves = false;
    for (unsigned i = 0; i < PACKET; i++) {
        unsigned from = i < rays->count ? i : 0;
        const sure_ray *ray = &rays->ray[from];
        const double *numbers = (const double *)ray;
        for (int k = 0; k < RAY_NUMBERS; k++)
            w->column[k][i] = numbers[k];
        w->farthest[i] = ray->t_max;
        w->leaving[i] = rays->leaving[from] ? rays->leaving[from]->object : SIZE_MAX;
        w->leaves |= w->leaving[i] != SIZE_MAX;
    }
}

#include "../shapes/lanes/lanes.h"

#include "../hierarchy/bvh_packet.h"

static inline int push(const walk *w, const bvh_packet *probe, const sure_bvh_node *node, unsigned mask, pending *stack, int height)
{
    int bottom = height;
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        pending *at = &stack[height];
        unsigned met = bvh_packet_meets(node, k, probe, w->farthest, at->enter) & mask;
        if (!met)
            continue;
        at->first = node->first[k];
        at->count = node->count[k];
        at->mask = (uint8_t)met;
        if (w->nearest)
            put_in_order(stack, bottom, height);
        height++;
    }
    return height;
}

static void walk_on(walk *w, const bvh_packet *probe)
{
    const sure_bvh *bvh = w->scene->bvh;
    pending stack[(SURE_BVH_WIDTH - 1) * SURE_BVH_DEPTH + 2];
    int height = 0;
    for (size_t i = 0; i < bvh->unbounded && open(w); i++)
        ask(w, bvh->slots[i], open(w));
    if (!bvh->nodes)
        return;
    height = push(w, probe, bvh->nodes, open(w), stack, 0);
    while (height > 0) {
        const pending *next = &stack[--height];
        unsigned mask = next->mask & open(w);
        if (w->nearest)
            mask &= bvh_packet_before(probe, next->enter, w->farthest);
        if (!mask)
            continue;
        if (next->count == SURE_BVH_INNER) {
            height = push(w, probe, &bvh->nodes[next->first], mask, stack, height);
            continue;
        }
        for (uint32_t i = next->first, end = i + next->count; i < end; i++) {
            ask(w, bvh->slots[i], mask);
            mask &= open(w);
            if (!mask)
                break;
        }
        if (!w->nearest && !open(w))
            return;
    }
}

static unsigned run(const sure_scene *scene, const packet *rays, sure_nearest *nearest)
{
    walk w;
    bvh_packet probe;
    w.scene = scene;
    w.rays = rays;
    w.nearest = nearest;
    w.found = 0;
    columns_of(&w);
    unsigned all = (1U << rays->count) - 1;
    w.together = bvh_packet_of(&probe, w.column) & all;
    unsigned apart = all & ~w.together;
    walk_on(&w, &probe);
    for (; apart; apart &= apart - 1) {
        unsigned i = lowest(apart);
        size_t unused;
        sure_status met = nearest ? sure_backward_nearest(scene, SURE_TIER_CERTAIN, &rays->ray[i], rays->leaving[i], &nearest[i])
                                  : visible_any(scene, SURE_TIER_CERTAIN, &rays->ray[i], rays->leaving[i], &unused);
        if (met == SURE_HIT)
            w.found |= 1U << i;
    }
    return w.found;
}

static unsigned nearest_of(const sure_scene *scene, const packet *rays, sure_nearest nearest[PACKET])
{
    return run(scene, rays, nearest);
}

static unsigned any_of(const sure_scene *scene, const packet *rays)
{
    return run(scene, rays, NULL);
}

const packet_walks WALKS = {nearest_of, any_of};
