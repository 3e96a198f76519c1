/* Makes maps of photons, on all cores; the same one whatever their number. */
#ifndef PHOTONS_PHOTON_MAP_BUILD_H
#define PHOTONS_PHOTON_MAP_BUILD_H

#include <surehit/mixed.h>

#include <stdbool.h>

/* How many photons are gathered, of so many that landed: consistent, since it grows without end and
 * yet is an ever smaller share of them. */
uint64_t photon_map_nearest(uint64_t landed);

/* Makes *map of photons whose weights are finite and not all 0 (free it with photon_map_free);
 * `objects` are the scene's. False when there is no memory. threads 0: one a core. */
bool photon_map_build(const sure_photon *photons, size_t count, size_t objects,
                      sure_falloff falloff, int threads, sure_photon_map *map);

void photon_map_free(sure_photon_map *map);

#endif
