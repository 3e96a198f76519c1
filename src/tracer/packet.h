/* SPDX-License-Identifier: MIT */
/* Rays that walk through the hierarchy together. */
#pragma once

#include <surehit/scene.h>

#include <stddef.h>

enum { PACKET = 8 };

/* Up to PACKET rays of tier certain; leaving: of each the surface point that it comes from, or
 * NULL. */
typedef struct {
    size_t count;
    sure_ray ray[PACKET];
    const sure_surface_point *leaving[PACKET];
} packet;

/* Each answers a bit a ray: does it meet an object? As sure_backward_nearest and visible_any. */
typedef struct {
    unsigned (*nearest)(const sure_scene *scene, const packet *rays, sure_nearest nearest[PACKET]);
    unsigned (*any)(const sure_scene *scene, const packet *rays);
} packet_walks;

extern const packet_walks packet_walks_2, packet_walks_4, packet_walks_8;

/* Those of this processor, as block_stages; NULL where rays walk one by one. */
const packet_walks *packet_walks_here(void);
