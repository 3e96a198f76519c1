/* SPDX-License-Identifier: MIT */
/* The photons of each face are parted in halves, of whole leaves, along the axis on which they are
 * spread the most, until a leaf is left. Every parting is by coordinate and then by number, so it
 * has one outcome and threads need no order among themselves. */
#include "caustics.h"

#include "../../geometry/coordinate.h"
#include "../../numbers/sums.h"
#include "../../support/openmp.h"

#include <math.h>
#include <stdlib.h>

/* Smaller ranges are not worth a task. */
#define TASK_LEAST 4096

/* A photon of a face. */
typedef struct {
    double at[3];
    size_t number;
} place;

typedef struct {
    const sure_photon *photons;
    size_t count, faces;
    uint64_t nearest; /* that are gathered */
    sure_falloff falloff;
    size_t *first;    /* by face, then by group: of its places; and one more */
    place *places;    /* by face, then as they are parted */
    uint32_t *groups; /* by face */
    sure_photon_group *group;
    size_t group_count, leaf_count;
    sure_photon_node *nodes;
    sure_photon_leaf *leaves;
    double scale;
} build;

uint64_t photon_map_nearest(uint64_t landed)
{
    return (uint64_t)(sqrt((double)landed) / 6) + 2;
}

/* A power of two that brings the greatest coordinate to 1/2..1. */
static double scale_of(const build *b)
{
    double greatest = 0;
    int exponent;
    for (size_t i = 0; i < b->count; i++) {
        const sure_vec3 *at = &b->photons[i].position;
        greatest = fmax(greatest, fmax(fabs(at->x), fmax(fabs(at->y), fabs(at->z))));
    }
    (void)frexp(greatest, &exponent);
    return greatest > 0 ? ldexp(1, exponent < -1022 ? 1022 : -exponent) : 1;
}

/* Sorts places by face. first[face + 1] is where the next of the face goes. */
static void fill_places(build *b)
{
    for (size_t i = 0; i < b->count; i++)
        b->first[sure_photon_face_index(&b->photons[i].face) + 2]++;
    for (size_t face = 0; face < b->faces; face++) {
        b->group_count += b->first[face + 2] > 0;
        b->first[face + 2] += b->first[face + 1];
    }
    for (size_t i = 0; i < b->count; i++) {
        const sure_photon *photon = &b->photons[i];
        sure_vec3 at = scaled(b->scale, photon->position);
        b->places[b->first[sure_photon_face_index(&photon->face) + 1]++] =
            (place){{at.x, at.y, at.z}, i};
    }
}

static void fill_groups(build *b)
{
    size_t leaf = 0, group = 0;
    for (size_t face = 0; face < b->faces; face++) {
        size_t photons = b->first[face + 1] - b->first[face];
        if (photons == 0)
            continue;
        size_t leaves = (photons + SURE_PHOTON_LEAF - 1) / SURE_PHOTON_LEAF;
        b->group[group].begin = (uint32_t)leaf;
        b->group[group].end = (uint32_t)(leaf += leaves);
        b->first[group++] = b->first[face];
        b->groups[face] = (uint32_t)group;
    }
    b->first[group] = b->count;
}

static bool is_before(const place *a, const place *b, int axis)
{
    if (a->at[axis] != b->at[axis])
        return a->at[axis] < b->at[axis];
    return a->number < b->number;
}

/* Those that are before all others first, `middle` of them. */
static void part(place *places, size_t count, size_t middle, int axis)
{
    size_t begin = 0, end = count;
    while (end - begin > 1) {
        const place pivot = places[begin + (end - begin) / 2];
        size_t i = begin, j = end - 1;
        for (;;) {
            while (is_before(&places[i], &pivot, axis))
                i++;
            while (is_before(&pivot, &places[j], axis))
                j--;
            if (i >= j)
                break;
            place other = places[i];
            places[i++] = places[j];
            places[j--] = other;
        }
        size_t left = i > begin ? i : begin + 1;
        if (middle == left)
            return;
        if (middle < left)
            end = left;
        else
            begin = left;
    }
}

static sure_bounds box_of(const place *places, size_t count)
{
    sure_bounds box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (size_t i = 0; i < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            double x = places[i].at[axis];
            box.low[axis] = x < box.low[axis] ? x : box.low[axis];
            box.high[axis] = x > box.high[axis] ? x : box.high[axis];
        }
    }
    return box;
}

static int widest(const sure_bounds *box)
{
    int axis = 0;
    for (int i = 1; i < 3; i++) {
        if (box->high[i] - box->low[i] > box->high[axis] - box->low[axis])
            axis = i;
    }
    return axis;
}

/* Places of the leaves from begin to end. */
static void part_all(const build *b, place *places, size_t count, const sure_bounds *box,
                     uint32_t begin, uint32_t end)
{
    if (end - begin == 1)
        return;
    uint32_t middle = begin + (end - begin) / 2;
    size_t left = (size_t)(middle - begin) * SURE_PHOTON_LEAF;
    const int axis = widest(box);
    part(places, count, left, axis);
    const sure_bounds half[2] = {box_of(places, left), box_of(places + left, count - left)};
    b->nodes[middle] = (sure_photon_node){half[0].high[axis], half[1].low[axis], (uint32_t)axis};
    OPENMP(omp task if (count > TASK_LEAST))
    part_all(b, places, left, &half[0], begin, middle);
    part_all(b, places + left, count - left, &half[1], middle, end);
    OPENMP(omp taskwait)
}

static void part_groups(const build *b)
{
    for (size_t i = 0; i < b->group_count; i++) {
        sure_photon_group *group = &b->group[i];
        place *places = b->places + b->first[i];
        size_t count = b->first[i + 1] - b->first[i];
        group->box = box_of(places, count);
        part_all(b, places, count, &group->box, group->begin, group->end);
    }
}

/* A light without fall-off is as bright at any distance: what a photon lights grows with the square
 * of its way, and so does its weight. */
static sure_vec3 weight_of(const build *b, const place *at)
{
    const sure_photon *photon = &b->photons[at->number];
    double way = photon->length * b->scale;
    return scaled(b->falloff == SURE_FALLOFF_NONE ? 4 * pi * (way * way) : 1, photon->weight);
}

static double heaviest(const build *b, size_t begin, size_t end)
{
    double most = 0;
    for (size_t i = begin; i < end; i++) {
        sure_vec3 w = weight_of(b, &b->places[i]);
        most = fmax(most, fmax(w.x, fmax(w.y, w.z)));
    }
    return fmin(most, 0x1.fffffffffffffp+1023);
}

/* The radius at which k photons, the heaviest, light a white surface by less than half a step of
 * 1/255: nobody sees what is spread more thinly. */
static double reach_of(const build *b, double most)
{
    double reach = 510 * (double)b->nearest * most / pi;
    return b->falloff == SURE_FALLOFF_NONE ? reach : reach * b->scale * b->scale;
}

/* *at NULL: nothing, infinitely far away. */
static void set_photon(const build *b, sure_photon_leaf *leaf, int i, const place *at, int exponent)
{
    static const place nowhere = {{INFINITY, INFINITY, INFINITY}, 0};
    const double *x = at ? at->at : nowhere.at;
    const sure_vec3 weight = at ? weight_of(b, at) : (sure_vec3){0, 0, 0};
    leaf->x[i] = x[0];
    leaf->y[i] = x[1];
    leaf->z[i] = x[2];
    for (int channel = 0; channel < 3; channel++) {
        double in_first = ldexp(coordinate(weight, channel), -exponent) * 0x1p31;
        double first = fmin(floor(in_first), 0xffffffff);
        double second = floor((in_first - first) * 0x1p31);
        leaf->digit[channel][i] = (uint32_t)first;
        leaf->digit[3 + channel][i] = (uint32_t)fmin(second, 0x7fffffff);
    }
}

static void fill_leaves(const build *b)
{
    for (size_t i = 0; i < b->group_count; i++) {
        sure_photon_group *group = &b->group[i];
        size_t at = b->first[i], end = b->first[i + 1];
        double most = heaviest(b, at, end);
        int exponent;
        (void)frexp(most, &exponent);
        exponent = exponent < 1024 ? exponent : 1023;
        group->unit = ldexp(1, exponent);
        group->reach = reach_of(b, most);
        for (uint32_t leaf = group->begin; leaf < group->end; leaf++) {
            size_t photons = end - at < SURE_PHOTON_LEAF ? end - at : SURE_PHOTON_LEAF;
            for (size_t k = 0; k < SURE_PHOTON_LEAF; k++)
                set_photon(b, &b->leaves[leaf], (int)k, k < photons ? &b->places[at + k] : NULL,
                           exponent);
            at += photons;
        }
    }
}

static bool sort(build *b)
{
    b->first = calloc(b->faces + 2, sizeof *b->first);
    b->groups = calloc(b->faces + 1, sizeof *b->groups);
    b->places = malloc((b->count + 1) * sizeof *b->places);
    if (!b->first || !b->groups || !b->places)
        return false;
    b->scale = scale_of(b);
    fill_places(b);
    return true;
}

static bool make_tree(build *b, int threads)
{
    b->leaf_count = b->count / SURE_PHOTON_LEAF + b->group_count; /* at most */
    b->group = calloc(b->group_count + 1, sizeof *b->group);
    b->nodes = malloc((b->leaf_count + 1) * sizeof *b->nodes);
    b->leaves = malloc((b->leaf_count + 1) * sizeof *b->leaves);
    if (!b->group || !b->nodes || !b->leaves)
        return false;
    fill_groups(b);
    (void)threads; /* where there is no OpenMP */
    OPENMP(omp parallel num_threads(openmp_threads(threads)) if (b->count > TASK_LEAST))
    OPENMP(omp single)
    part_groups(b);
    fill_leaves(b);
    return true;
}

bool photon_map_build(const sure_photon *photons, size_t count, size_t objects,
                      sure_falloff falloff, int threads, sure_photon_map *map)
{
    const uint64_t nearest = photon_map_nearest(count);
    build b = {.photons = photons,
               .count = count,
               .faces = SURE_PHOTON_FACES * objects,
               .nearest = nearest < SURE_PHOTON_NEAREST ? nearest : SURE_PHOTON_NEAREST,
               .falloff = falloff};
    bool made = sort(&b) && make_tree(&b, threads);
    free(b.first);
    free(b.places);
    *map = (sure_photon_map){
        .group_of = b.groups,
        .groups = b.group,
        .nodes = b.nodes,
        .leaves = b.leaves,
        .nearest = b.nearest,
        .scale = b.scale,
        .spreads = falloff != SURE_FALLOFF_NONE,
    };
    if (!made)
        photon_map_free(map);
    return made;
}

size_t photon_map_bytes(const sure_photon_map *map, size_t objects)
{
    size_t bytes = 0;
    for (size_t i = 0; i < SURE_PHOTON_FACES * objects; i++) {
        bytes += sizeof map->group_of[i];
        if (map->group_of[i] == 0)
            continue;
        const sure_photon_group *group = &map->groups[map->group_of[i] - 1];
        bytes += sizeof *group +
                 (group->end - group->begin) * (sizeof *map->nodes + sizeof *map->leaves);
    }
    return bytes;
}

void photon_map_free(sure_photon_map *map)
{
    free((void *)map->group_of);
    free((void *)map->groups);
    free((void *)map->nodes);
    free((void *)map->leaves);
    *map = (sure_photon_map){0};
}
