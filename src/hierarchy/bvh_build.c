/* SPDX-License-Identifier: MIT */
/* First a binary tree (bvh_part.c). Then every two levels become one of four children. */
#include "bvh_build.h"

#include "../support/openmp.h"
#include "bvh_part.h"

#include <stdlib.h>

/* A range of slots that becomes a child. */
typedef struct {
    uint32_t begin, end, place; /* 0: a leaf */
} range;

/* Parts ranges, the largest first, until there are four or only leaves. */
static int open_ranges(const build *b, range ranges[SURE_BVH_WIDTH])
{
    int count = 1;
    while (count < SURE_BVH_WIDTH) {
        int widest = -1;
        for (int k = 0; k < count; k++) {
            if (ranges[k].place != 0 &&
                (widest < 0 ||
                 ranges[k].end - ranges[k].begin > ranges[widest].end - ranges[widest].begin))
                widest = k;
        }
        if (widest < 0)
            break;
        range whole = ranges[widest];
        parting into = b->partings[whole.place];
        ranges[widest] = (range){whole.begin, whole.place, into.left};
        ranges[count++] = (range){whole.place, whole.end, into.right};
    }
    return count;
}

/* Objects lie anywhere: fetched some slots before they are asked for. */
static void fetch_ahead(const build *b, uint32_t slot)
{
#ifdef __GNUC__
    const uint32_t ahead = 12;
    if (slot + ahead < b->end) {
        const char *object = (const char *)&b->objects[b->slots[slot + ahead]];
        __builtin_prefetch(object);
        __builtin_prefetch(object + sizeof(sure_object) - 1);
    }
#else
    (void)b, (void)slot;
#endif
}

/* Made anew: the boxes have given their room to the nodes. */
static extent leaf_box(const build *b, uint32_t begin, uint32_t end)
{
    extent all = empty;
    for (uint32_t i = begin; i < end; i++) {
        fetch_ahead(b, i);
        extent box = box_of(&b->objects[b->slots[i]]);
        extend(&all, &box);
    }
    return all;
}

static void set_box(sure_bvh_node *node, int child, const extent *box)
{
    for (int i = 0; i < 3; i++) {
        node->bound[2 * i][child] = box->least[i];
        node->bound[2 * i + 1][child] = -box->least[3 + i];
    }
}

/* How many nodes a range makes. */
static uint32_t count_nodes(const build *b, range whole)
{
    range ranges[SURE_BVH_WIDTH] = {whole};
    uint32_t nodes = 1;
    int count = open_ranges(b, ranges);
    for (int k = 0; k < count; k++)
        nodes += ranges[k].place != 0 ? count_nodes(b, ranges[k]) : 0;
    return nodes;
}

/* Makes a range's nodes, from `index` on: where the next are to go, and the box of all. */
static uint32_t widen(const build *b, sure_bvh_node *nodes, range whole, uint32_t index,
                      extent *box)
{
    range ranges[SURE_BVH_WIDTH] = {whole};
    extent of[SURE_BVH_WIDTH] = {empty, empty, empty, empty};
    sure_bvh_node *node = &nodes[index++];
    int count = open_ranges(b, ranges);
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        range child = k < count ? ranges[k] : (range){0, 0, 0};
        uint32_t size = child.end - child.begin, first = child.place ? index : child.begin;
        node->first[k] = first;
        node->count[k] = child.place ? SURE_BVH_INNER : (uint8_t)size;
        if (child.place == 0) {
            of[k] = leaf_box(b, child.begin, child.end);
        } else if (size <= TASK_LEAST) {
            index = widen(b, nodes, child, first, &of[k]);
        } else {
            index += count_nodes(b, child);
            OPENMP(omp task shared(of))
            (void)widen(b, nodes, child, first, &of[k]);
        }
    }
    OPENMP(omp taskwait)
    *box = empty;
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        set_box(node, k, &of[k]);
        extend(box, &of[k]);
    }
    return index;
}

static bool is_bounded(const sure_object *object)
{
    return sure_shape_info_of(object->shape)->bounded;
}

size_t bvh_bounded(const sure_object *objects, size_t count)
{
    size_t bounded = 0;
    for (size_t i = 0; i < count; i++)
        bounded += is_bounded(&objects[i]);
    return bounded;
}

/* The slots of objects without a box in front, so many. */
static void fill(build *b, size_t unbounded, int threads)
{
    size_t front = 0, back = unbounded;
    for (uint32_t i = 0; i < b->end; i++)
        b->slots[is_bounded(&b->objects[i]) ? back++ : front++] = i;
    OPENMP(omp parallel for num_threads(openmp_threads(threads)) if (b->end > TASK_LEAST))
    for (size_t i = unbounded; i < b->end; i++)
        b->boxes[i] = box_of(&b->objects[b->slots[i]]);
}

/* From boxes, which are freed, and slots; NULL when there is no memory. */
static sure_bvh_node *make_nodes(build *b, uint32_t begin)
{
    extent box;
    range whole = {begin, b->end, bvh_part_all(b, begin, b->end, SURE_BVH_DEPTH / 2)};
    free(b->boxes);
    b->boxes = NULL;
    size_t room = (size_t)count_nodes(b, whole) * sizeof(sure_bvh_node);
    sure_bvh_node *nodes = aligned_alloc(64, (room + 63) / 64 * 64);
    if (nodes)
        (void)widen(b, nodes, whole, 0, &box);
    return nodes;
}

bool bvh_build(const sure_object *objects, size_t count, int threads, sure_bvh *bvh)
{
    build b = {.objects = objects, .end = (uint32_t)count};
    const size_t room = count > 0 ? count : 1, unbounded = count - bvh_bounded(objects, count);
    sure_bvh_node *nodes = NULL;
    b.boxes = malloc(room * sizeof *b.boxes);
    b.slots = malloc(room * sizeof *b.slots);
    b.partings = malloc(room * sizeof *b.partings);
    bool ok = b.boxes && b.slots && b.partings;
    if (ok)
        fill(&b, unbounded, threads);
    if (ok && unbounded < count) {
        OPENMP(omp parallel num_threads(openmp_threads(threads)) if (count > TASK_LEAST))
        OPENMP(omp single)
        nodes = make_nodes(&b, (uint32_t)unbounded);
        ok = nodes != NULL;
    }
    free(b.boxes);
    free(b.partings);
    if (!ok)
        free(b.slots);
    else
        *bvh = (sure_bvh){.nodes = nodes, .slots = b.slots, .unbounded = unbounded};
    return ok;
}

/* The last node is the last child's last one, and so on. */
size_t bvh_bytes(const sure_bvh *bvh, size_t objects)
{
    uint32_t last = 0;
    for (int k = bvh->nodes ? SURE_BVH_WIDTH - 1 : -1; k >= 0; k--) {
        if (bvh->nodes[last].count[k] != SURE_BVH_INNER)
            continue;
        last = bvh->nodes[last].first[k];
        k = SURE_BVH_WIDTH;
    }
    return (bvh->nodes ? (last + 1) * sizeof *bvh->nodes : 0) + objects * sizeof *bvh->slots;
}

void bvh_free(sure_bvh *bvh)
{
    free((void *)bvh->nodes);
    free((void *)bvh->slots);
    *bvh = (sure_bvh){0};
}
