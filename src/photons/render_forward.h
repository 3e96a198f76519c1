/* Photons of a scene, on all cores: the same sums whatever their number. */
#ifndef PHOTONS_RENDER_FORWARD_H
#define PHOTONS_RENDER_FORWARD_H

#include "film.h"
#include "../tracer/render.h"

#include <surehit/forward.h>

typedef struct {
    sure_tier tier;
    int threads;      /* 0: one a core */
    bool progress;    /* a bar on standard error, with the picture's error so far */
    bool without_bvh; /* every ray asks every object: the same sums, slower */
    sure_forward_options how;
    uint64_t first, end; /* photons first .. end - 1 */
} forward_run;

typedef struct {
    uint64_t end;       /* photons first .. end - 1 were traced: less than asked for after a */
    render_times times; /* SIGINT, but one at least */
} forward_outcome;

/* Is there a light that a photon could leave? */
bool render_forward_possible(const sure_scene *scene);

/* Adds to a film of the scene's size and to *statistics, whose photons the film has. */
forward_outcome render_forward(const sure_scene *scene, const forward_run *run, film *sums,
                               sure_forward_statistics *statistics);

#endif
