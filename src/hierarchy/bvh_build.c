/* First a binary tree, from the root down: a range of slots is parted where the surface area
 * heuristic expects the least work, by the middles of the boxes sorted into bins along an axis. A
 * range's node is known by the place where it is parted, which no other node has; so threads need
 * no order among themselves, and the tree is the same for any number of them. Then every two levels
 * become one of four children. */
#include "bvh_build.h"

#include "../support/openmp.h"

#include <math.h>
#include <stdlib.h>

#define BINS 16
#define LEAF_MOST 8
/* Larger ranges are binned along all axes, others along that where middles are farthest apart: so
 * trees are no worse, and made in three quarters of the time. */
#define ONE_AXIS_MOST 1024
/* What a node's four boxes cost, in objects. */
#define NODE_COST 1.0
/* Smaller ranges are not worth a task, nor the first of threads. */
#define TASK_LEAST 2048

/* A range that is parted in two, by the index of the place; ends of 0 are leaves. */
typedef struct {
    uint32_t left, right; /* where the halves are parted; 0: a leaf */
} parting;

/* A box by what is least: its lows, and its highs negated; so that one loop does for all. */
typedef struct {
    double least[6];
} extent;

typedef struct {
    const sure_object *objects;
    uint32_t *slots, end;
    extent *boxes;     /* of what is in the slots, but for planes */
    parting *partings; /* by place */
} build;

typedef struct {
    extent box;
    uint32_t count;
} bin;

static const extent empty = {{INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY}};

static void extend(extent *box, const extent *by)
{
    for (int i = 0; i < 6; i++)
        box->least[i] = by->least[i] < box->least[i] ? by->least[i] : box->least[i];
}

static extent box_of(const sure_object *object)
{
    sure_box box = {{0}, {0}};
    (void)sure_bvh_box(object, &box);
    return (extent){{box.low[0], box.low[1], box.low[2], -box.high[0], -box.high[1], -box.high[2]}};
}

static double edge(const extent *box, int axis)
{
    return -box->least[3 + axis] - box->least[axis];
}

/* Twice the middle. */
static double middle(const extent *box, int axis)
{
    return box->least[axis] - box->least[3 + axis];
}

/* Half of it, with edges counted in a unit of which there are per_length in one. */
static double area(const extent *box, double per_length)
{
    double x = edge(box, 0) * per_length, y = edge(box, 1) * per_length;
    double z = edge(box, 2) * per_length;
    return x * y + y * z + z * x;
}

static double longest(const extent *box)
{
    return fmax(edge(box, 0), fmax(edge(box, 1), edge(box, 2)));
}

/* A range's box, and between what limits the middles of its boxes lie. */
typedef struct {
    extent whole, middles;
} survey;

static survey survey_of(const build *b, uint32_t begin, uint32_t end)
{
    survey all = {empty, empty};
    for (uint32_t i = begin; i < end; i++) {
        const extent *box = &b->boxes[i];
        double x = middle(box, 0), y = middle(box, 1), z = middle(box, 2);
        const extent at = {{x, y, z, -x, -y, -z}};
        extend(&all.whole, box);
        extend(&all.middles, &at);
    }
    return all;
}

/* How middles along an axis are sorted into bins. */
typedef struct {
    int axis;
    double low, per_bin; /* per_bin 0: all in one place, or too far apart to tell */
    int bins;            /* no more than there are boxes */
} scale;

static scale scale_along(const extent *middles, int axis, uint32_t count)
{
    double low = middles->least[axis], high = -middles->least[3 + axis];
    int bins = count < BINS ? (int)count : BINS;
    double per_bin = bins / (high - low);
    bool known = isfinite(low) && isfinite(high) && isfinite(per_bin);
    return (scale){axis, low, known ? per_bin : 0, bins};
}

/* Those along which to look for a way: none has per_bin 0. How many there are. */
static int scales_of(const extent *middles, uint32_t count, scale scales[3])
{
    int found = 0;
    for (int axis = 0; axis < 3; axis++) {
        scale along = scale_along(middles, axis, count);
        bool first = found == 0;
        if (along.per_bin == 0)
            continue;
        if (first || count > ONE_AXIS_MOST)
            scales[found++] = along;
        else if (along.per_bin < scales[0].per_bin)
            scales[0] = along;
    }
    return found;
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
    int first_right;
} choice;

/* Along all of the axes in one go: what costs is to fetch the boxes. */
static void fill_bins(const build *b, uint32_t begin, uint32_t end, const scale scales[], int count,
                      bin bins[][BINS])
{
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < scales[i].bins; k++)
            bins[i][k] = (bin){empty, 0};
    }
    for (uint32_t slot = begin; slot < end; slot++) {
        const extent *box = &b->boxes[slot];
        for (int i = 0; i < count; i++) {
            bin *of = &bins[i][bin_of(scales[i], middle(box, scales[i].axis))];
            extend(&of->box, box);
            of->count++;
        }
    }
}

static void choose_along(const bin bins[BINS], scale along, double per_length, uint32_t count,
                         choice *best)
{
    double above[BINS]; /* the cost of what is in this bin and those above */
    bin sum = {empty, 0};
    for (int k = along.bins - 1; k > 0; k--) {
        extend(&sum.box, &bins[k].box);
        sum.count += bins[k].count;
        above[k] = sum.count > 0 ? area(&sum.box, per_length) * sum.count : 0;
    }
    sum = (bin){empty, 0};
    for (int k = 1; k < along.bins; k++) {
        extend(&sum.box, &bins[k - 1].box);
        sum.count += bins[k - 1].count;
        bool parts = sum.count > 0 && sum.count < count;
        double cost = parts ? area(&sum.box, per_length) * sum.count + above[k] : INFINITY;
        if (cost < best->cost)
            *best = (choice){cost, along, k};
    }
}

static choice choose(const build *b, uint32_t begin, uint32_t end, const extent *middles,
                     double per_length)
{
    choice best = {.cost = INFINITY};
    scale scales[3];
    bin bins[3][BINS];
    int count = scales_of(middles, end - begin, scales);
    fill_bins(b, begin, end, scales, count, bins);
    for (int i = 0; i < count; i++)
        choose_along(bins[i], scales[i], per_length, end - begin, &best);
    return best;
}

static void swap(const build *b, uint32_t i, uint32_t j)
{
    uint32_t slot = b->slots[i];
    extent box = b->boxes[i];
    b->slots[i] = b->slots[j];
    b->boxes[i] = b->boxes[j];
    b->slots[j] = slot;
    b->boxes[j] = box;
}

/* Those of the left first. */
static uint32_t part(const build *b, uint32_t begin, uint32_t end, const choice *by)
{
    uint32_t left = begin, right = end;
    while (left < right) {
        if (bin_of(by->along, middle(&b->boxes[left], by->along.axis)) < by->first_right)
            left++;
        else
            swap(b, left, --right);
    }
    return left;
}

/* Where to part the range; 0 to leave it whole. Behind `depth` levels that the heuristic chose, and
 * where it knows nothing, in halves. */
static uint32_t place_to_part(const build *b, uint32_t begin, uint32_t end, int depth)
{
    uint32_t count = end - begin;
    if (count < 2)
        return 0;
    survey all = survey_of(b, begin, end);
    double per_length = 1 / longest(&all.whole), across = area(&all.whole, per_length);
    choice best = {.cost = INFINITY};
    if (depth > 0 && per_length > 0 && isfinite(per_length))
        best = choose(b, begin, end, &all.middles, per_length);
    bool costs_less = best.cost + NODE_COST * across < across * count;
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

/* The slots of objects without a box in front. */
static size_t fill(build *b, size_t count, int threads)
{
    size_t unbounded = count - bvh_bounded(b->objects, count), front = 0, back = unbounded;
    for (size_t i = 0; i < count; i++) {
        b->slots[is_bounded(&b->objects[i]) ? back++ : front++] = (uint32_t)i;
    }
    OPENMP(omp parallel for num_threads(openmp_threads(threads)) if (count > TASK_LEAST))
    for (size_t i = unbounded; i < count; i++)
        b->boxes[i] = box_of(&b->objects[b->slots[i]]);
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

static void widen_in_parallel(const build *b, sure_bvh_node *nodes, range whole, int threads)
{
    extent box;
    uint32_t size = whole.end - whole.begin;
    OPENMP(omp parallel num_threads(openmp_threads(threads)) if (size > TASK_LEAST))
    OPENMP(omp single)
    (void)widen(b, nodes, whole, 0, &box);
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
    size_t room = (size_t)count_nodes(b, whole) * sizeof(sure_bvh_node);
    sure_bvh_node *nodes = aligned_alloc(64, (room + 63) / 64 * 64);
    if (nodes)
        widen_in_parallel(b, nodes, whole, threads);
    free(b->partings);
    return nodes;
}

bool bvh_build(const sure_object *objects, size_t count, int threads, sure_bvh *bvh)
{
    build b = {.objects = objects, .end = (uint32_t)count};
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
