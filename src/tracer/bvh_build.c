/* First a binary tree, from the root down: a range of slots is parted where the surface area
 * heuristic expects the least work, by the middles of the boxes sorted into bins along each axis. A
 * range's node is known by the place where it is parted, which no other node has; so threads need
 * no order among themselves, and the tree is the same for any number of them. Then every two levels
 * become one of four children. */
#include "bvh_build.h"

#include "openmp.h"

#include <math.h>
#include <stdlib.h>

#define BINS 16
#define LEAF_MOST 8
/* What a node's four boxes cost, in objects. */
#define NODE_COST 1.0
/* Smaller ranges are not worth a task, nor the first of threads. */
#define TASK_LEAST 2048

/* A range that is parted in two, by the index of the place; ends of 0 are leaves. */
typedef struct {
    uint32_t left, right; /* where the halves are parted; 0: a leaf */
} parting;

typedef struct {
    const sure_object *objects;
    sure_box *boxes; /* one an object; unset for planes */
    uint32_t *slots;
    parting *partings; /* by place */
} build;

typedef struct {
    sure_box box;
    uint32_t count;
} bin;

static const sure_box empty = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static void extend(sure_box *box, const sure_box *by)
{
    for (int i = 0; i < 3; i++) {
        box->low[i] = by->low[i] < box->low[i] ? by->low[i] : box->low[i];
        box->high[i] = by->high[i] > box->high[i] ? by->high[i] : box->high[i];
    }
}

/* Twice the middle. */
static double middle(const sure_box *box, int axis)
{
    return box->low[axis] + box->high[axis];
}

/* Half of it, as a share of the largest box's: `size` is that one's longest edge. */
static double area(const sure_box *box, double size)
{
    double x = (box->high[0] - box->low[0]) / size;
    double y = (box->high[1] - box->low[1]) / size;
    double z = (box->high[2] - box->low[2]) / size;
    return x * y + y * z + z * x;
}

static double longest(const sure_box *box)
{
    double size = 0;
    for (int i = 0; i < 3; i++)
        size = fmax(size, box->high[i] - box->low[i]);
    return size;
}

static sure_box box_of(const build *b, uint32_t begin, uint32_t end)
{
    sure_box all = empty;
    for (uint32_t i = begin; i < end; i++)
        extend(&all, &b->boxes[b->slots[i]]);
    return all;
}

/* Where along an axis the middles of a range lie. */
typedef struct {
    double low, per_bin; /* per_bin 0: all in one place, or too far apart to tell */
    int bins;            /* no more than there are boxes */
} scale;

static scale scale_of(const build *b, uint32_t begin, uint32_t end, int axis)
{
    double low = INFINITY, high = -INFINITY;
    for (uint32_t i = begin; i < end; i++) {
        double m = middle(&b->boxes[b->slots[i]], axis);
        low = m < low ? m : low;
        high = m > high ? m : high;
    }
    int bins = end - begin < BINS ? (int)(end - begin) : BINS;
    double per_bin = bins / (high - low);
    return (scale){low, isfinite(low) && isfinite(high) && isfinite(per_bin) ? per_bin : 0, bins};
}

static int bin_of(scale along, double m)
{
    int number = (int)((m - along.low) * along.per_bin);
    return number < along.bins ? number : along.bins - 1;
}

/* A way to part a range: by the bins. */
typedef struct {
    double cost;
    scale along;
    int axis, first_right;
} choice;

static void fill_bins(const build *b, uint32_t begin, uint32_t end, int axis, scale along,
                      bin bins[BINS])
{
    for (int k = 0; k < along.bins; k++)
        bins[k] = (bin){empty, 0};
    for (uint32_t i = begin; i < end; i++) {
        const sure_box *box = &b->boxes[b->slots[i]];
        bin *of = &bins[bin_of(along, middle(box, axis))];
        extend(&of->box, box);
        of->count++;
    }
}

static void choose_along(const build *b, uint32_t begin, uint32_t end, int axis, double size,
                         choice *best)
{
    scale along = scale_of(b, begin, end, axis);
    bin bins[BINS];
    double above[BINS]; /* the cost of what is in this bin and those above */
    if (along.per_bin == 0)
        return;
    fill_bins(b, begin, end, axis, along, bins);
    bin sum = {empty, 0};
    for (int k = along.bins - 1; k > 0; k--) {
        extend(&sum.box, &bins[k].box);
        sum.count += bins[k].count;
        above[k] = sum.count > 0 ? area(&sum.box, size) * sum.count : 0;
    }
    sum = (bin){empty, 0};
    for (int k = 1; k < along.bins; k++) {
        extend(&sum.box, &bins[k - 1].box);
        sum.count += bins[k - 1].count;
        bool parts = sum.count > 0 && sum.count < end - begin;
        double cost = parts ? area(&sum.box, size) * sum.count + above[k] : INFINITY;
        if (cost < best->cost)
            *best = (choice){cost, along, axis, k};
    }
}

/* Those of the left first, each half in its order. */
static uint32_t part(const build *b, uint32_t begin, uint32_t end, const choice *by)
{
    uint32_t left = begin, right = end;
    while (left < right) {
        uint32_t slot = b->slots[left];
        if (bin_of(by->along, middle(&b->boxes[slot], by->axis)) < by->first_right) {
            left++;
        } else {
            b->slots[left] = b->slots[--right];
            b->slots[right] = slot;
        }
    }
    return left;
}

/* Where to part the range; 0 to leave it whole. Behind `depth` levels that the heuristic chose, and
 * where it knows nothing, in halves. */
static uint32_t place_to_part(const build *b, uint32_t begin, uint32_t end, int depth)
{
    uint32_t count = end - begin;
    sure_box whole = box_of(b, begin, end);
    double size = longest(&whole);
    choice best = {.cost = INFINITY};
    if (count < 2)
        return 0;
    for (int axis = 0; axis < 3 && depth > 0 && size > 0 && isfinite(size); axis++)
        choose_along(b, begin, end, axis, size, &best);
    bool costs_less = best.cost + NODE_COST * area(&whole, size) < area(&whole, size) * count;
    if (count <= LEAF_MOST && !costs_less)
        return 0;
    return isfinite(best.cost) ? part(b, begin, end, &best) : begin + count / 2;
}

/* Parts a range and what comes of it: where, or 0. */
static uint32_t part_all(const build *b, uint32_t begin, uint32_t end, int depth)
{
    uint32_t place = place_to_part(b, begin, end, depth);
    if (place == 0)
        return 0;
    uint32_t left = 0, right = 0;
    OPENMP(omp task shared(left) if (end - begin > TASK_LEAST))
    left = part_all(b, begin, place, depth - 1);
    right = part_all(b, place, end, depth - 1);
    OPENMP(omp taskwait)
    b->partings[place] = (parting){left, right};
    return place;
}

/* A range of slots that becomes a child. */
typedef struct {
    uint32_t begin, end, place; /* 0: a leaf */
} range;

typedef struct {
    const build *from;
    sure_bvh_node *nodes;
    uint32_t used;
} widening;

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

/* Made anew: the boxes have given their room to the nodes. */
static sure_box leaf_box(const build *b, uint32_t begin, uint32_t end)
{
    sure_box all = empty, box = empty;
    for (uint32_t i = begin; i < end; i++) {
        (void)sure_bvh_box(&b->objects[b->slots[i]], &box);
        extend(&all, &box);
    }
    return all;
}

static void set_box(sure_bvh_node *node, int child, const sure_box *box)
{
    for (int i = 0; i < 3; i++) {
        node->bound[2 * i][child] = box->low[i];
        node->bound[2 * i + 1][child] = box->high[i];
    }
}

/* Makes the node of a range: its index, and its box. */
static uint32_t widen(widening *w, range whole, sure_box *box)
{
    range ranges[SURE_BVH_WIDTH] = {whole};
    uint32_t index = w->used++;
    int count = open_ranges(w->from, ranges);
    *box = empty;
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        sure_box of = empty;
        uint32_t first = 0;
        uint8_t slots = 0;
        if (k < count && ranges[k].place != 0) {
            first = widen(w, ranges[k], &of);
            slots = SURE_BVH_INNER;
        } else if (k < count) {
            of = leaf_box(w->from, ranges[k].begin, ranges[k].end);
            first = ranges[k].begin;
            slots = (uint8_t)(ranges[k].end - ranges[k].begin);
        }
        sure_bvh_node *node = &w->nodes[index];
        set_box(node, k, &of);
        node->first[k] = first;
        node->count[k] = slots;
        extend(box, &of);
    }
    return index;
}

size_t bvh_bounded(const sure_object *objects, size_t count)
{
    size_t bounded = 0;
    for (size_t i = 0; i < count; i++)
        bounded += objects[i].shape != SURE_SHAPE_PLANE;
    return bounded;
}

/* The slots of objects without a box in front. */
static size_t fill(build *b, size_t count, int threads)
{
    size_t unbounded = count - bvh_bounded(b->objects, count), front = 0, back = unbounded;
    OPENMP(omp parallel for num_threads(openmp_threads(threads)) if (count > TASK_LEAST))
    for (size_t i = 0; i < count; i++)
        (void)sure_bvh_box(&b->objects[i], &b->boxes[i]);
    for (size_t i = 0; i < count; i++) {
        bool bounded = b->objects[i].shape != SURE_SHAPE_PLANE;
        b->slots[bounded ? back++ : front++] = (uint32_t)i;
    }
    return unbounded;
}

static uint32_t part_in_parallel(const build *b, uint32_t begin, uint32_t end, int threads)
{
    uint32_t root = 0;
    OPENMP(omp parallel num_threads(openmp_threads(threads)) if (end - begin > TASK_LEAST))
    OPENMP(omp single)
    root = part_all(b, begin, end, SURE_BVH_DEPTH / 2);
    return root;
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

/* From boxes and slots; NULL when there is no memory. */
static sure_bvh_node *build_nodes(build *b, uint32_t begin, uint32_t end, int threads)
{
    b->partings = malloc((size_t)end * sizeof *b->partings);
    if (!b->partings)
        return NULL;
    range whole = {begin, end, part_in_parallel(b, begin, end, threads)};
    free(b->boxes);
    b->boxes = NULL;
    sure_box box;
    size_t room = (size_t)count_nodes(b, whole) * sizeof(sure_bvh_node);
    widening w = {.from = b, .nodes = aligned_alloc(64, (room + 63) / 64 * 64)};
    if (w.nodes)
        (void)widen(&w, whole, &box);
    free(b->partings);
    return w.nodes;
}

bool bvh_build(const sure_object *objects, size_t count, int threads, sure_bvh *bvh)
{
    build b = {.objects = objects};
    size_t room = count > 0 ? count : 1, unbounded = 0;
    sure_bvh_node *nodes = NULL;
    b.boxes = malloc(room * sizeof *b.boxes);
    b.slots = malloc(room * sizeof *b.slots);
    bool ok = b.boxes && b.slots;
    if (ok)
        unbounded = fill(&b, count, threads);
    if (ok && unbounded < count) {
        nodes = build_nodes(&b, (uint32_t)unbounded, (uint32_t)count, threads);
        ok = nodes != NULL;
    }
    free(b.boxes);
    if (!ok)
        free(b.slots);
    else
        *bvh = (sure_bvh){nodes, b.slots, unbounded};
    return ok;
}

void bvh_free(sure_bvh *bvh)
{
    free((void *)bvh->nodes);
    free((void *)bvh->slots);
    *bvh = (sure_bvh){0};
}
