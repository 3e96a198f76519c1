/* SPDX-License-Identifier: MIT */
/* The mixed tracer: backward, with the light that mirrors and glass send to matte surfaces
 * (caustics) brought there by photons. */
#pragma once

#include <surehit/photon_map.h>
#include <surehit/scene.h>

SURE_C_BEGIN

/* A photon where it landed. */
typedef struct {
    sure_photon_face face;
    sure_vec3 position;
    sure_vec3 weight; /* its share of the light's power, in the colours that it came through */
    double length;    /* of its way */
} sure_photon;

/* Directions from a light: those through a cell of a cube about it. Every octant of directions is
 * parted alike, so that what is mirrored in a coordinate plane is mirrored photon by photon.
 *
 * With the signs that the octant takes away, direction[axis] is 1 and direction[axis + 1] and [axis
 * + 2], counted in a circle, are between column / cells and (column + 1) / cells, and the same of
 * the row. */
typedef struct {
    size_t light;
    int axis;        /* 0 x, 1 y, 2 z */
    int octant;      /* 0..7: 1 where x is negative, and 2 for y and 4 for z */
    int column, row; /* 0..cells - 1 */
    int cells;       /* a power of two */
} sure_mixed_cell;

/* Does the object turn light aside on its way, as a mirror or clear? */
int sure_mixed_is_shiny(const sure_material *material);

/* Do photons land on it, as a surface that is matte at least in part? */
int sure_mixed_is_matte(const sure_material *material);

/* Columns (along = 1) or rows (2) in which a ray may meet the object, for one axis and octant. */
typedef struct {
    int first, last; /* first > last: none */
} sure_mixed_strip;

/* Entry    a valid object, a finite light_position; axis 0..2, octant 0..7, along 1 or 2, cells a
 *          power of two.
 * Returns  a range: a ray from the light through any other column (or row) of that axis and octant
 *          doesn't meet the object. All of them for a plane.
 * Bound    none: no ray is lost, whatever the rounding mode.
 * Source   projection maps: H. W. Jensen, Realistic Image Synthesis Using Photon Mapping, 2001,
 *          5.3.
 * Proof    docs/derivations/mixed.md
 *
 * Law 1: rays to points of the object are in a column and a row that are named. */
sure_mixed_strip sure_mixed_strip_of(const sure_object *object, sure_vec3 light_position, int axis,
                                     int octant, int along, int cells);

/* The way of a photon from a light, through a cell, to the first matte surface; but only by mirrors
 * or through clear surfaces, `depth` of the scene at most. The cell is parted into strata^2 parts
 * of which each photon has one.
 *
 * Entry    a scene whose objects are valid; a cell as said above, its light one of the scene's;
 *          1 <= strata <= 65536; number < strata^2.
 * Returns  1 and *landed; 0 and *landed untouched where it doesn't arrive, or by no such way.
 * Bound    none: where it goes is what the tier decides.
 * Source   H. W. Jensen, Realistic Image Synthesis Using Photon Mapping, 2001, 5.2 and 5.3.
 * Proof    docs/derivations/mixed.md
 *
 * Law 2: a photon depends on nothing but scene, tier, cell, strata, number and seed.
 * Law 3: the mean over seeds of the sum of all photons' weights is the power that lands: on an
 *        opaque surface its matte share, 1 - mirror.
 * Law 4: a scene mirrored in a coordinate plane has the mirrored photons, and one scaled by 2^k the
 *        same ones scaled. */
int sure_mixed_photon(const sure_scene *scene, sure_tier tier, const sure_mixed_cell *cell,
                      uint32_t strata, uint32_t number, uint64_t seed, sure_photon *landed);

SURE_C_END
