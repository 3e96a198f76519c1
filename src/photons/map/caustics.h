/* SPDX-License-Identifier: MIT */
/* Does a scene need photons for what mirrors and glass send to its matte surfaces? If so, their
 * map; the same one whatever the number of threads. */
#pragma once

#include "../render_file.h"

#include <surehit/mixed.h>

/* Makes *map (free it with photon_map_free) where the state is CAUSTICS_ON. The scene has its
 * hierarchy, or none. */
caustics_statistics caustics_build(const sure_scene *scene, const render_settings *settings,
                                   sure_photon_map *map);

/* Why the forward pass is on, or off; and a line with what it came to. */
const char *caustics_why(caustics_state state);
void caustics_print(FILE *out, const caustics_statistics *statistics, double seconds);

/* The map itself. */

/* How many photons are gathered, of so many that landed: consistent, since it grows without end and
 * yet is an ever smaller share of them. */
uint64_t photon_map_nearest(uint64_t landed);

/* Makes *map of photons whose weights are finite and not all 0 (free it with photon_map_free);
 * `objects` are the scene's. False when there is no memory. threads 0: one a core. */
bool photon_map_build(const sure_photon *photons, size_t count, size_t objects,
                      sure_falloff falloff, int threads, sure_photon_map *map);

void photon_map_free(sure_photon_map *map);

/* What it takes of memory. */
size_t photon_map_bytes(const sure_photon_map *map, size_t objects);
