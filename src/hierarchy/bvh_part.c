/* SPDX-License-Identifier: MIT */
/* From the root down: a range of slots is parted where the surface area heuristic expects the least
 * work, by the middles of the boxes sorted into bins along an axis. A range's node is known by the
 * place where it is parted, which no other node has; so threads need no order among themselves, and
 * the tree is the same for any number of them. */
#include "bvh_part.h"

#include "../support/openmp.h"

#include <stdbool.h>

#define BINS 16
#define LEAF_MOST 8
/* Larger ranges are binned along all axes, others along that where middles are farthest apart: so
 * trees are no worse, and made in three quarters of the time. */
#define ONE_AXIS_MOST 1024
/* What a node's four boxes cost, in objects. */
#define NODE_COST 1.0

typedef struct {
    extent box;
    uint32_t count;
} bin;

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
    const extent *box = &all.whole;
    double longest = fmax(edge(box, 0), fmax(edge(box, 1), edge(box, 2)));
    double per_length = 1 / longest, across = area(box, per_length);
    choice best = {.cost = INFINITY};
    if (depth > 0 && per_length > 0 && isfinite(per_length))
        best = choose(b, begin, end, &all.middles, per_length);
    bool costs_less = best.cost + NODE_COST * across < across * count;
    if (count <= LEAF_MOST && !costs_less)
        return 0;
    return isfinite(best.cost) ? part(b, begin, end, &best) : begin + count / 2;
}

uint32_t bvh_part_all(const build *b, uint32_t begin, uint32_t end, int depth)
{
    uint32_t place = place_to_part(b, begin, end, depth);
    if (place == 0)
        return 0;
    uint32_t left = 0, right = 0;
    OPENMP(omp task shared(left) if (end - begin > TASK_LEAST))
    left = bvh_part_all(b, begin, place, depth - 1);
    right = bvh_part_all(b, place, end, depth - 1);
    OPENMP(omp taskwait)
    b->partings[place] = (parting){left, right};
    return place;
}
