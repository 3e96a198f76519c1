/* All pixels of a scene, on all cores, the same bytes whatever their number. */
#ifndef TRACER_RENDER_H
#define TRACER_RENDER_H

#include "picture.h"

#include <surehit/scene.h>

typedef struct {
    sure_tier tier;
    int threads;    /* 0: one a core */
    bool
        progress; /* a bar with the time left on standard error, from the first second on */
} render_options;

/* Fills *image (allocated by picture_new, of the scene's size). Linear colours are clamped to 0..1,
 * times 255, rounded to nearest. */
void render(const sure_scene *scene, const render_options *options, picture *image);

#endif
