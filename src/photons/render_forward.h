/* Photons of a scene, on all cores: the same sums whatever their number. */
#ifndef PHOTONS_RENDER_FORWARD_H
#define PHOTONS_RENDER_FORWARD_H

#include "partial_film.h"
#include "../tracer/render.h"

typedef struct {
    uint64_t end;       /* photons first .. end - 1 were traced: less than asked for after a */
    render_times times; /* SIGINT, but one at least */
} forward_outcome;

/* Is there a light that a photon could leave? */
bool render_forward_possible(const sure_scene *scene);

/* Traces photons as *sum says, and adds them to its film, of the scene's size, and statistics; its
 * ranges are the caller's. Of the options those count that are not about pixels; the bar of progress
 * shows the picture's error so far. */
forward_outcome render_forward(const sure_scene *scene, const render_options *options,
                               photon_range photons, partial_film *sum);

#endif
