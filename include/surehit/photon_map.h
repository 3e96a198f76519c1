/* SPDX-License-Identifier: MIT */
/* Light that came to matte surfaces by mirrors or through glass (caustics): a map of the photons
 * that landed there, and how bright they make a point. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include <surehit/bvh.h>
#include <surehit/spawn.h>

SURE_C_BEGIN

/* The face of an object that a photon landed on: what it lights it lights on this side alone, and
 * not around a rim. */
typedef struct {
    size_t object;
    sure_side side;
    sure_part part;
} sure_photon_face;

/* Faces of an object. */
#define SURE_PHOTON_FACES (2 * SURE_PARTS)

static inline size_t sure_photon_face_index(const sure_photon_face *face)
{
    const size_t side = face->side, part = face->part;
    return SURE_PHOTON_FACES * face->object + SURE_PARTS * side + part;
}

#define SURE_PHOTON_LEAF 8

/* So many photons. An empty place is infinitely far away. Weights are whole numbers, of two digits,
 * so that their sum is the same in any order. */
typedef struct {
    double x[SURE_PHOTON_LEAF], y[SURE_PHOTON_LEAF], z[SURE_PHOTON_LEAF];
    uint32_t digit[6][SURE_PHOTON_LEAF]; /* red, green, blue in 2^-31; then in 2^-62 */
} sure_photon_leaf;

/* A range of leaves that is parted in two: no photon of the first half has more than `low` along
 * the axis, none of the second less than `high`. */
typedef struct {
    double low, high;
    uint32_t axis; /* 0..2 */
} sure_photon_node;

/* A face that photons landed on: leaves `begin` to `end`. Those from a to b, where there is more
 * than one, are parted at a + (b - a) / 2, and that is their node's index. */
typedef struct {
    uint32_t begin, end;
    sure_bounds box;
    double unit;  /* of the weights: a power of two */
    double reach; /* the square of the greatest radius that is gathered from */
} sure_photon_group;

/* The most that are gathered: as many as two billion photons ask for. */
#define SURE_PHOTON_NEAREST 8192

/* Entry for all who use it: as made of photons; the library makes none, and frees none. Lengths are
 * multiplied by `scale`, a power of two that brings them near one. One is begun as {0}, for what a
 * later version adds. */
typedef struct {
    const uint32_t *group_of; /* by sure_photon_face_index: of groups, plus one; 0: none */
    const sure_photon_group *groups;
    const sure_photon_node *nodes;
    const sure_photon_leaf *leaves;
    uint64_t nearest; /* photons that are gathered, 1 .. SURE_PHOTON_NEAREST */
    double scale;
    int spreads; /* weights are powers, that fall off with the square of lengths; else ratios */
    const void *reserved[4]; /* NULL */
} sure_photon_map;

/* What photons bring to a point, for light of any direction: its colour times the cosine law, as
 * sure_light_color times sure_light_intensity. With r the distance of the k-th nearest photon of
 * the point's own face,
 *
 *     sum of the weights of those that are nearer / (pi r^2)
 *
 * or, where fewer than k are within the face's reach, of those within / (pi reach^2).
 *
 * Entry    a finite point.
 * Returns  the light; zero for a face without photons, and where the k nearest are at the point.
 * Bound    none on the light, which is an estimate. Which photons are within is told exactly for
 *          the distances as they are computed; the sum is exact but for one rounding of each digit.
 * Source   H. W. Jensen, Realistic Image Synthesis Using Photon Mapping, 2001, 7.2.
 * Proof    docs/derivations/mixed.md
 *
 * Law 1: of all photons of the face, as if each were asked.
 * Law 2: the order of photons changes nothing.
 * Law 3: all lengths times 2^k, and under the inverse square law weights times 4^k, change
 *        nothing. */
sure_vec3 sure_photon_map_gather(const sure_photon_map *map, const sure_photon_face *face,
                                 sure_vec3 point);

SURE_C_END
