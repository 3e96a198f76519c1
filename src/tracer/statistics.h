/* SPDX-License-Identifier: MIT */
/* Counting for sure_statistics. Who does not ask passes NULL and pays a comparison. */
#pragma once

#include "packet.h"

#include <surehit/statistics.h>

#include <stdbool.h>

/* What is drawn and how. */
typedef struct {
    const sure_scene *scene;
    sure_tier tier;
    sure_statistics *statistics;  /* or NULL */
    const packet_walks *together; /* NULL: rays go one by one */
} tracing;

/* sure_shadow_reaches, counted (shadow.c). */
bool shadow_reaches(const tracing *t, const sure_surface_point *from, sure_vec3 light_position);

/* The same of up to PACKET points: a bit each. */
unsigned shadow_reach(const tracing *t, const sure_surface_point *const *from, size_t count,
                      sure_vec3 light_position);

/* A ray that has met scene->objects[object], or none. */
void statistics_ray(const tracing *t, sure_ray_kind kind, const sure_ray *ray,
                    const sure_surface_point *leaving, sure_status met, size_t object);

void statistics_pixel(const tracing *t, const sure_ray *ray, sure_status seen,
                      const sure_nearest *nearest);

/* A start for further rays next to a hit of the ray, or (NULL) none. */
void statistics_origin(const tracing *t, const sure_ray *ray, const sure_nearest *hit,
                       const sure_vec3 *origin);
