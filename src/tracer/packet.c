/* SPDX-License-Identifier: MIT */
/* A packet's way through the hierarchy. Compiled once for each width that block_lanes knows. */
#include "packet_ask.h"

#include "../hierarchy/bvh_row.h"
#include "../shapes/lanes/lanes.h"

enum { BVH_PACKET = PACKET };
#include "../hierarchy/bvh_packet.h"

#define NAME_OF(name, width) name##_##width
#define NAME(name, width) NAME_OF(name, width)

/* Puts the children that are met on the stack, in order where the nearest is asked for: its height.
 */
static INLINED int push_children(const packet_search *s, const bvh_packet *probe,
                                 const sure_bvh_node *node, unsigned mask, packet_pending *stack,
                                 int height)
{
    const int bottom = height;
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        packet_pending *at = &stack[height];
        const unsigned met = bvh_packet_meets(node, k, probe, s->farthest, at->enter) & mask;
        if (!met)
            continue;
        at->first = node->first[k];
        at->count = node->count[k];
        at->mask = (uint8_t)met;
        if (s->nearest)
            packet_sort(stack + bottom, at);
        height++;
    }
    return height;
}

/* slots NULL: the objects themselves. */
static inline void packet_slots(packet_search *s, const uint32_t *slots, size_t first, size_t count,
                                unsigned mask)
{
    for (size_t i = first; i < first + count && (mask & s->open); i++)
        packet_ask(s, slots ? slots[i] : i, mask & s->open);
}

static void packet_boxes(packet_search *s, const bvh_packet *probe)
{
    const sure_bvh *bvh = s->scene->bvh;
    packet_pending stack[(SURE_BVH_WIDTH - 1) * SURE_BVH_DEPTH + 2]; /* one that is not met */
    int height = 0;
    packet_slots(s, bvh->slots, 0, bvh->unbounded, s->open);
    if (bvh->nodes)
        height = push_children(s, probe, bvh->nodes, s->open, stack, 0);
    while (height > 0) {
        const packet_pending *next = &stack[--height];
        const unsigned mask =
            next->mask & s->open & bvh_packet_before(probe, next->enter, s->farthest);
        if (!mask)
            continue;
        if (next->count == SURE_BVH_INNER)
            height = push_children(s, probe, &bvh->nodes[next->first], mask, stack, height);
        else
            packet_slots(s, bvh->slots, next->first, next->count, mask);
    }
}

/* Those that see the same faces of boxes first as the first ray go together. */
static void ask_in_boxes(packet_search *s)
{
    bvh_packet probe;
    const unsigned together = bvh_packet_of(&probe, s->rays), alone = s->open & ~together;
    s->open &= together;
    packet_boxes(s, &probe);
    packet_rest(s, alone);
}

static unsigned search(const sure_scene *scene, packet *rays, sure_nearest *nearest)
{
    packet_search s;
    packet_begin(&s, scene, rays, nearest, NAME(block_stages, LANES));
    if (scene->bvh)
        ask_in_boxes(&s);
    else
        packet_slots(&s, NULL, 0, scene->object_count, s.open);
    return s.found;
}

static unsigned search_any(const sure_scene *scene, packet *rays)
{
    return search(scene, rays, NULL);
}

/* A number of the viewport in all lanes. */
#define ALL(number) lanes_all_at(&(number))

/* Along a column of the turn's matrix, since the camera is turned back. */
#define ALONG(axis)                                                                                \
    (ALL(turn->row[0].axis) * x + ALL(turn->row[1].axis) * y + ALL(turn->row[2].axis) * z)

static void pixels(const sure_scene *scene, size_t count, const int *column, const int *row,
                   packet *rays)
{
    const packet_view view = packet_begin_pixels(scene, count, column, row, rays);
    const sure_mat3 *turn = view.turn;
    for (size_t i = 0; i < PACKET; i += LANES) {
        const double x =
            PIXEL_OFFSET(ALL(view.extent[0]), lanes_at(&rays->direction[0][i]), ALL(view.twice[0]));
        const double y =
            PIXEL_OFFSET(ALL(view.extent[1]), lanes_at(&rays->direction[1][i]), ALL(view.twice[1]));
        const double z = ALL(view.ahead);
        lanes_to(&rays->direction[0][i], ALONG(x));
        lanes_to(&rays->direction[1][i], ALONG(y));
        lanes_to(&rays->direction[2][i], ALONG(z));
    }
}

const packet_walks NAME(packet_walks, LANES) = {pixels, search, search_any};
