/* SPDX-License-Identifier: MIT */
/* Rays of tier certain that go through the hierarchy together: what each of them meets is what it
 * meets alone. */
#pragma once

#include <surehit/scene.h>

#include <stddef.h>

/* How many at most, and from how many on that is faster than one by one. */
enum { PACKET = 8, PACKET_LEAST = 2 };

#ifdef __GNUC__
#define PACKET_ALIGNED __attribute__((aligned(64)))
#else
#define PACKET_ALIGNED
#endif

/* Ray i < count is the numbers i; leaving: of each the surface point that it comes from, or NULL.
 * One is begun with count 0 and its light. */
typedef struct {
    double origin[3][PACKET], direction[3][PACKET], t_min[PACKET], t_max[PACKET];
    const sure_surface_point *leaving[PACKET];
    const sure_vec3 *light; /* that all lead to, or NULL */
    size_t count;
} PACKET_ALIGNED packet;

static inline void packet_add(packet *rays, const sure_vec3 *origin, const sure_vec3 *direction,
                              double t_min, double t_max, const sure_surface_point *leaving)
{
    const size_t i = rays->count++;
    rays->origin[0][i] = origin->x;
    rays->origin[1][i] = origin->y;
    rays->origin[2][i] = origin->z;
    rays->direction[0][i] = direction->x;
    rays->direction[1][i] = direction->y;
    rays->direction[2][i] = direction->z;
    rays->t_min[i] = t_min;
    rays->t_max[i] = t_max;
    rays->leaving[i] = leaving;
}

static inline sure_ray packet_ray(const packet *rays, size_t i)
{
    return (sure_ray){{rays->origin[0][i], rays->origin[1][i], rays->origin[2][i]},
                      {rays->direction[0][i], rays->direction[1][i], rays->direction[2][i]},
                      rays->t_min[i],
                      rays->t_max[i]};
}

/* pixels: the packet of up to PACKET pixels' rays, as sure_scene_pixel_ray has each. The others
 * answer a bit a ray: does it meet an object of the scene? As sure_backward_nearest, and
 * visible_any. They may write to what is unused of the rays. */
typedef struct {
    void (*pixels)(const sure_scene *scene, size_t count, const int *column, const int *row,
                   packet *rays);
    unsigned (*nearest)(const sure_scene *scene, packet *rays, sure_nearest nearest[PACKET]);
    unsigned (*any)(const sure_scene *scene, packet *rays);
} packet_walks;

/* By the width of what they are compiled for. */
extern const packet_walks packet_walks_2, packet_walks_4, packet_walks_8;

/* Those of this processor, as block_lanes says; NULL where rays go one by one. */
const packet_walks *packet_walks_here(void);
