/* SPDX-License-Identifier: MIT */
/* How far is the k-th nearest photon? Leaves are met in the order of a tree, the nearer side of a
 * parting first, and of their photons the squares of the least distances are held: what is farther
 * than the k-th of them is passed by.
 *
 * The distance of a photon p from the point q is squared as ((p - q) + ...) in one way everywhere,
 * and that to a parting by the same operations: rounding is monotone, in any mode, so what is said
 * of a side is true of each photon's rounded distance. */
#include "../../numbers/sums.h"
#include "../../numbers/valid.h"
#include "../../hierarchy/bvh_walk.h"

#include <surehit/photon_map.h>

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#define HELD (2 * SURE_PHOTON_NEAREST + SURE_PHOTON_LEAF)
/* So few are ranked by comparing each with each. */
#define FEW 16
/* A range of 2^32 leaves is parted as often. */
#define DEPTH 33

typedef struct {
    const sure_photon_map *map;
    const sure_photon_group *group;
    double at[3];
} query;

static INLINED void squares_of(const query *q, const sure_photon_leaf *leaf,
                               double square[SURE_PHOTON_LEAF])
{
    BVH_LANES
    for (int i = 0; i < SURE_PHOTON_LEAF; i++) {
        double x = leaf->x[i] - q->at[0], y = leaf->y[i] - q->at[1], z = leaf->z[i] - q->at[2];
        square[i] = x * x + y * y + z * z;
    }
}

/* The tree. */

/* Leaves, and how far their photons are at least along each axis. */
typedef struct {
    double x, y, z;
    uint32_t begin, end;
} range;

/* Those that are still to be asked. */
typedef struct {
    int height;
    range ranges[DEPTH];
} pending;

static INLINED double nearest_in(const range *r)
{
    return r->x * r->x + r->y * r->y + r->z * r->z;
}

static INLINED double way_out(const query *q, int axis)
{
    double out =
        bvh_later(q->group->box.low[axis] - q->at[axis], q->at[axis] - q->group->box.high[axis]);
    return bvh_later(out, 0);
}

static INLINED void put_all(const query *q, pending *all)
{
    all->ranges[0] =
        (range){way_out(q, 0), way_out(q, 1), way_out(q, 2), q->group->begin, q->group->end};
    all->height = 1;
}

/* A part of it, which is as far as that along an axis, or farther. */
static INLINED range part_of(range r, uint32_t axis, double way, uint32_t begin, uint32_t end)
{
    r.x = axis == 0 ? bvh_later(way, r.x) : r.x;
    r.y = axis == 1 ? bvh_later(way, r.y) : r.y;
    r.z = axis == 2 ? bvh_later(way, r.z) : r.z;
    r.begin = begin;
    r.end = end;
    return r;
}

/* The next leaf with anything nearer than `high`; false when there is no more. */
static INLINED bool next_leaf(const query *q, pending *left, double high, uint32_t *leaf)
{
    while (left->height > 0) {
        range r = left->ranges[--left->height];
        if (!(nearest_in(&r) < high))
            continue;
        while (r.end - r.begin > 1) {
            const uint32_t place = r.begin + (r.end - r.begin) / 2;
            const sure_photon_node *node = &q->map->nodes[place];
            const uint32_t axis = node->axis;
            const double over = q->at[axis] - node->low, under = node->high - q->at[axis];
            const bool lower = over < under;
            const range other = part_of(r, axis, lower ? under : over, lower ? place : r.begin,
                                        lower ? r.end : place);
            r = part_of(r, axis, lower ? over : under, lower ? r.begin : place,
                        lower ? place : r.end);
            left->ranges[left->height] = other;
            left->height += nearest_in(&other) < high;
        }
        *leaf = r.begin;
        if (nearest_in(&r) < high)
            return true;
    }
    return false;
}

/* Photons whose squares are below `high`: as many as are sought, the least. A photon's number
 * counts the places of all leaves. */
typedef struct {
    double high;
    int sought, count;
    double square[HELD];
    size_t number[HELD];
} search;

/* Those below the pivot first: how many. */
static INLINED int part_squares(double *square, int count, double pivot)
{
    int less = 0;
    for (int i = 0; i < count; i++) {
        double x = square[i];
        square[i] = square[less];
        square[less] = x;
        less += x < pivot;
    }
    return less;
}

/* The n-th least of the first few, from 1 on: the least with so many that are no greater. What
 * stands behind them is. */
static INLINED double least_of_few(const double square[FEW], int count, int n)
{
    double least = INFINITY;
    for (int i = 0; i < count; i++) {
        int64_t up_to = 0;
        BVH_LANES
        for (int k = 0; k < FEW; k++)
            up_to += square[k] <= square[i];
        least = up_to >= n ? bvh_earlier(square[i], least) : least;
    }
    return least;
}

/* And of many: all but few are left aside, by comparison with one. */
static INLINED double least_held(const search *s)
{
    double copy[HELD + FEW], *square = copy;
    int count = s->count, n = s->sought;
    memcpy(copy, s->square, (size_t)count * sizeof *copy);
    for (int i = 0; i < FEW; i++)
        copy[count + i] = INFINITY;
    while (count > FEW) {
        double pivot = square[count / 2];
        int less = part_squares(square, count, pivot);
        if (less == 0) {
            less = part_squares(square, count, next_away(pivot));
            if (n <= less)
                return pivot;
        }
        square += n <= less ? 0 : less;
        count = n <= less ? less : count - less;
        n -= n <= less ? 0 : less;
    }
    return least_of_few(square, count, n);
}

/* What does not come before these is of no interest. Of those as far as the last any will do. */
static INLINED void drop_farther(search *s)
{
    const int count = s->count;
    s->high = least_held(s);
    s->count = 0;
    for (int i = 0; i < count; i++) {
        s->square[s->count] = s->square[i];
        s->number[s->count] = s->number[i];
        s->count += s->square[i] < s->high;
    }
    while (s->count < s->sought)
        s->square[s->count++] = s->high;
}

static INLINED void search_leaf(const query *q, search *s, size_t leaf)
{
    double square[SURE_PHOTON_LEAF];
    int64_t taken[SURE_PHOTON_LEAF];
    const double high = s->high;
    int count = s->count;
    squares_of(q, &q->map->leaves[leaf], square);
    BVH_LANES
    for (int i = 0; i < SURE_PHOTON_LEAF; i++)
        taken[i] = square[i] < high;
    for (int i = 0; i < SURE_PHOTON_LEAF; i++) {
        s->square[count] = square[i];
        s->number[count] = SURE_PHOTON_LEAF * leaf + (size_t)i;
        count += (int)taken[i];
    }
    s->count = count;
    if (s->count >= 2 * s->sought)
        drop_farther(s);
}

/* The square of the last that is sought; that of the reach where fewer are within it. */
static INLINED double search_all(const query *q, search *s)
{
    const double reach = q->group->reach;
    pending left;
    uint32_t leaf;
    put_all(q, &left);
    s->count = 0;
    s->sought = (int)q->map->nearest;
    s->high = reach;
    while (next_leaf(q, &left, s->high, &leaf))
        search_leaf(q, s, leaf);
    return s->count < s->sought ? reach : least_held(s);
}

/* How many photons, and the sums of their digits. */
typedef struct {
    uint64_t count, digit[6];
} photon_sum;

/* Of those held that are nearer. */
static INLINED photon_sum sum_held(const query *q, const search *s, double square)
{
    photon_sum sum = {0};
    for (int i = 0; i < s->count; i++) {
        const size_t number = s->number[i], place = number % SURE_PHOTON_LEAF;
        const sure_photon_leaf *leaf = &q->map->leaves[number / SURE_PHOTON_LEAF];
        if (!(s->square[i] < square))
            continue;
        sum.count++;
        for (int digit = 0; digit < 6; digit++)
            sum.digit[digit] += leaf->digit[digit][place];
    }
    return sum;
}

static double channel(const query *q, const photon_sum *sum, int i, double square)
{
    double weight = (double)sum->digit[i] * 0x1p-31 + (double)sum->digit[3 + i] * 0x1p-62;
    double light = weight / (pi * square) * q->group->unit;
    return q->map->spreads ? light * q->map->scale * q->map->scale : light;
}

BVH_WIDE sure_vec3 sure_photon_map_gather(const sure_photon_map *map, const sure_photon_face *face,
                                          sure_vec3 point)
{
    assert(map->nearest >= 1 && map->nearest <= SURE_PHOTON_NEAREST && all_finite(point));
    uint32_t group = map->group_of[sure_photon_face_index(face)];
    if (group == 0)
        return (sure_vec3){0, 0, 0};
    const query q = {map,
                     &map->groups[group - 1],
                     {map->scale * point.x, map->scale * point.y, map->scale * point.z}};
    search s;
    double square = search_all(&q, &s);
    photon_sum sum = sum_held(&q, &s, square);
    if (sum.count == 0)
        return (sure_vec3){0, 0, 0};
    return (sure_vec3){channel(&q, &sum, 0, square), channel(&q, &sum, 1, square),
                       channel(&q, &sum, 2, square)};
}
