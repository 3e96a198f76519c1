/* How far is the k-th nearest photon? Of those that are met, nearest boxes first, the squares of
 * the k least distances are held, and what is farther than the k-th of them is passed by. No more
 * can be held than there is room for: then that many are found, and counted, and the next ones
 * sought beyond. When the distance is known the weights of all that are nearer are added up, where
 * a whole box is at once, by sums made beforehand.
 *
 * The distance of a photon p from the point q is squared as ((p - q) + ...) in one way everywhere,
 * and every bound of a box by the same operations: rounding is monotone, in any mode, so what is
 * said of a box is true of each photon's rounded distance. */
#include "../../numbers/bits.h"

#include <surehit/photon_map.h>

#include <math.h>
#include <stdbool.h>

/* Photons that are sought at a time. */
#define SOUGHT 512

static const double pi = 3.14159265358979323846;

typedef struct {
    const sure_photon_map *map;
    const sure_photon_group *group;
    double x, y, z;
} query;

static void squares_of(const query *q, const sure_photon_leaf *leaf,
                       double square[SURE_PHOTON_LEAF])
{
    for (int i = 0; i < SURE_PHOTON_LEAF; i++) {
        double x = leaf->x[i] - q->x, y = leaf->y[i] - q->y, z = leaf->z[i] - q->z;
        square[i] = x * x + y * y + z * z;
    }
}

/* The least and the greatest |p - q| along an axis. */
static double least(double low, double high)
{
    double beyond = low > 0 ? low : 0;
    return -high > beyond ? -high : beyond;
}

static double greatest(double low, double high)
{
    return -low > high ? -low : high;
}

/* Squares of distances: none in the box is less or more. */
typedef struct {
    double near, far;
} span;

static span span_of(const query *q, const sure_bounds *box)
{
    double low_x = box->low[0] - q->x, high_x = box->high[0] - q->x;
    double low_y = box->low[1] - q->y, high_y = box->high[1] - q->y;
    double low_z = box->low[2] - q->z, high_z = box->high[2] - q->z;
    double x = least(low_x, high_x), y = least(low_y, high_y), z = least(low_z, high_z);
    double u = greatest(low_x, high_x), v = greatest(low_y, high_y), w = greatest(low_z, high_z);
    return (span){x * x + y * y + z * z, u * u + v * v + w * w};
}

typedef struct {
    uint32_t begin, end;
} range;

static range all_of(const query *q)
{
    return (range){q->group->begin, q->group->end};
}

static uint64_t count_of(const sure_photon_map *map, range leaves)
{
    return map->before[leaves.end].count - map->before[leaves.begin].count;
}

/* How the halves of a range lie to the point. */
typedef struct {
    range range[2];
    span span[2];
} halves;

static halves part(const query *q, range whole)
{
    uint32_t place = whole.begin + (whole.end - whole.begin) / 2;
    const sure_photon_node *node = &q->map->nodes[place];
    return (halves){{{whole.begin, place}, {place, whole.end}},
                    {span_of(q, &node->half[0]), span_of(q, &node->half[1])}};
}

/* Photons whose squares are from `low` on and below `high`: as many as are sought, the least. */
typedef struct {
    double low, high;
    uint64_t sought; /* at most SOUGHT */
    int count;
    double held[2 * SOUGHT + SURE_PHOTON_LEAF];
} search;

/* Those below the pivot first: how many. */
static int part_held(double *held, int count, double pivot)
{
    int less = 0;
    for (int i = 0; i < count; i++) {
        double x = held[i];
        held[i] = held[less];
        held[less] = x;
        less += x < pivot;
    }
    return less;
}

/* The n-th least, from 1 on, by exchanges until it is in its place: those before it are no greater
 * then. */
static double select_held(double *held, int count, int n)
{
    int begin = 0, end = count;
    while (end - begin > 1) {
        double pivot = held[begin + (end - begin) / 2];
        int less = begin + part_held(held + begin, end - begin, pivot);
        int most = less + part_held(held + less, end - less, next_away(pivot));
        if (n > less && n <= most)
            return pivot;
        begin = n <= less ? begin : most;
        end = n <= less ? less : end;
    }
    return held[begin];
}

/* What does not come before these is of no interest. */
static void drop_farther(search *s)
{
    s->high = select_held(s->held, s->count, (int)s->sought);
    s->count = (int)s->sought;
}

static void search_leaf(const query *q, search *s, const sure_photon_leaf *leaf)
{
    double square[SURE_PHOTON_LEAF];
    squares_of(q, leaf, square);
    for (int i = 0; i < SURE_PHOTON_LEAF; i++) {
        s->held[s->count] = square[i];
        s->count += square[i] >= s->low && square[i] < s->high;
    }
    if (s->count >= 2 * (int)s->sought)
        drop_farther(s);
}

/* Where as many as are sought, and from `low` on, lie in a box, none is sought beyond it. */
static void limit(const query *q, search *s, range photons, span within)
{
    if (within.near >= s->low && within.far < s->high && count_of(q->map, photons) >= s->sought)
        s->high = next_away(within.far);
}

/* The nearer half first. */
static void search_in(const query *q, search *s, range whole)
{
    if (whole.end - whole.begin == 1) {
        search_leaf(q, s, &q->map->leaves[whole.begin]);
        return;
    }
    halves in = part(q, whole);
    const span *s0 = &in.span[0], *s1 = &in.span[1];
    int first = !(s0->near < s1->near || (s0->near == s1->near && s0->far <= s1->far));
    for (int i = 0; i < 2; i++)
        limit(q, s, in.range[i], in.span[i]);
    for (int i = 0; i < 2; i++) {
        int half = i == 0 ? first : 1 - first;
        if (in.span[half].near < s->high && in.span[half].far >= s->low)
            search_in(q, s, in.range[half]);
    }
}

/* The square of the last that is sought; `high` where there are fewer. */
static double search_from(const query *q, search *s)
{
    const double beyond = s->high;
    s->count = 0;
    search_in(q, s, all_of(q));
    if (s->count < (int)s->sought)
        return beyond;
    return select_held(s->held, s->count, (int)s->sought);
}

/* Of photons that are nearer. */
typedef struct {
    double than;
    sure_photon_sum sum;
} nearer;

static void add_range(const query *q, nearer *n, range photons)
{
    const sure_photon_sum *from = &q->map->before[photons.begin];
    const sure_photon_sum *to = &q->map->before[photons.end];
    n->sum.count += to->count - from->count;
    for (int i = 0; i < 6; i++)
        n->sum.digit[i] += to->digit[i] - from->digit[i];
}

static void add_leaf(const query *q, nearer *n, const sure_photon_leaf *leaf)
{
    double square[SURE_PHOTON_LEAF];
    uint32_t mask[SURE_PHOTON_LEAF];
    squares_of(q, leaf, square);
    for (int i = 0; i < SURE_PHOTON_LEAF; i++)
        mask[i] = square[i] < n->than ? UINT32_MAX : 0;
    for (int i = 0; i < SURE_PHOTON_LEAF; i++)
        n->sum.count += mask[i] & 1;
    for (int digit = 0; digit < 6; digit++) {
        for (int i = 0; i < SURE_PHOTON_LEAF; i++)
            n->sum.digit[digit] += leaf->digit[digit][i] & mask[i];
    }
}

static void add_within(const query *q, nearer *n, range whole)
{
    if (whole.end - whole.begin == 1) {
        add_leaf(q, n, &q->map->leaves[whole.begin]);
        return;
    }
    halves in = part(q, whole);
    for (int i = 0; i < 2; i++) {
        if (in.span[i].far < n->than)
            add_range(q, n, in.range[i]);
        else if (in.span[i].near < n->than)
            add_within(q, n, in.range[i]);
    }
}

static sure_photon_sum sum_within(const query *q, double square)
{
    nearer n = {.than = square};
    add_within(q, &n, all_of(q));
    return n.sum;
}

/* The square of the k-th nearest's distance, or of the reach where fewer are within it. */
static double radius_of(const query *q)
{
    const double reach = q->group->reach;
    uint64_t left = q->map->nearest;
    search s = {.high = reach};
    if (count_of(q->map, all_of(q)) < left)
        return reach;
    for (;;) {
        s.sought = left < SOUGHT ? left : SOUGHT;
        double last = search_from(q, &s);
        if (left <= SOUGHT || last == reach)
            return last;
        s.low = next_away(last);
        s.high = reach;
        uint64_t found = sum_within(q, s.low).count;
        if (found >= q->map->nearest)
            return last;
        left = q->map->nearest - found;
    }
}

static double channel(const query *q, const sure_photon_sum *sum, int i, double square)
{
    double weight = (double)sum->digit[i] * 0x1p-31 + (double)sum->digit[3 + i] * 0x1p-62;
    double light = weight / (pi * square) * q->group->unit;
    return q->map->spreads ? light * q->map->scale * q->map->scale : light;
}

sure_vec3 sure_photon_map_gather(const sure_photon_map *map, const sure_photon_face *face,
                                 sure_vec3 point)
{
    uint32_t group = map->group_of[sure_photon_face_index(face)];
    if (group == 0)
        return (sure_vec3){0, 0, 0};
    const query q = {map, &map->groups[group - 1], map->scale * point.x, map->scale * point.y,
                     map->scale * point.z};
    double square = radius_of(&q);
    sure_photon_sum sum = sum_within(&q, square);
    if (sum.count == 0)
        return (sure_vec3){0, 0, 0};
    return (sure_vec3){channel(&q, &sum, 0, square), channel(&q, &sum, 1, square),
                       channel(&q, &sum, 2, square)};
}
