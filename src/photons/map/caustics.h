/* Does a scene need photons for what mirrors and glass send to its matte surfaces? If so, their
 * map; the same one whatever the number of threads. */
#ifndef PHOTONS_CAUSTICS_H
#define PHOTONS_CAUSTICS_H

#include <surehit/mixed.h>

#include <stdbool.h>
#include <stdio.h>

/* What becomes of the forward pass. */
typedef enum {
    CAUSTICS_ON,
    CAUSTICS_NOT_ASKED, /* another integrator */
    CAUSTICS_NOT_SHINY, /* no mirror or glass, or none is followed */
    CAUSTICS_NOT_LIT,   /* no light */
    CAUSTICS_NOT_MATTE, /* nothing to land on */
    CAUSTICS_ENDLESS,   /* light that doesn't fall off, and nobody insists */
    CAUSTICS_NO_WAY,    /* no photon landed */
    CAUSTICS_NO_MEMORY
} caustics_state;

typedef struct {
    caustics_state state;
    uint64_t traced, landed; /* photons */
} caustics_statistics;

typedef struct {
    sure_tier tier;
    int threads;      /* 0: one a core */
    bool insists;     /* also on light that doesn't fall off, which has no power to hand on */
    uint64_t photons; /* about so many leave the lights; 0: CAUSTICS_PHOTONS */
    uint64_t seed;
} caustics_options;

#define CAUSTICS_PHOTONS 1000000

/* Makes *map (free it with photon_map_free) where the state is CAUSTICS_ON. */
caustics_statistics caustics_build(const sure_scene *scene, const caustics_options *options,
                                   sure_photon_map *map);

/* A line that says what the forward pass came to, and why. */
void caustics_print(FILE *out, const caustics_statistics *statistics);

/* The map itself. */

/* How many photons are gathered, of so many that landed: consistent, since it grows without end and
 * yet is an ever smaller share of them. */
uint64_t photon_map_nearest(uint64_t landed);

/* Makes *map of photons whose weights are finite and not all 0 (free it with photon_map_free);
 * `objects` are the scene's. False when there is no memory. threads 0: one a core. */
bool photon_map_build(const sure_photon *photons, size_t count, size_t objects,
                      sure_falloff falloff, int threads, sure_photon_map *map);

void photon_map_free(sure_photon_map *map);

#endif
