/* What `surehit render` is asked for, and the two ways to draw it. */
#ifndef CLI_RENDER_H
#define CLI_RENDER_H

#include "options.h"

#include "../evidence/heat.h"
#include "../photons/render_file.h"

#include <jansson.h>

#define NO_HEAT HEATS
#define EXIT_INTERRUPTED 130 /* as a shell says of SIGINT; what was done is written */

typedef struct {
    const char *scene;
    cli_list outputs;
    bool quiet, explain, time;
    const char *certificate; /* its path, or NULL */
    heat_kind heat;          /* NO_HEAT: light */
    render_settings settings;
    /* of photons from the lights to the eye */
    uint64_t first;    /* photon */
    int bounces;       /* 0: the default, which is the falloff's */
    double aperture;   /* 0: a pinhole */
    const char *share; /* where their sums go, or NULL */
    const char *from;  /* the share that is continued, or NULL */
} render_request;

/* By the words of the one command that there is. */
extern render_request asked;

/* Both return the exit status. */
int render_backward(const placed_scene *placed);
int render_photons(const placed_scene *placed);

/* Writes all of them, or returns EXIT_OUTPUT. */
int render_write_pictures(const picture *image);

/* "a.ppm, a.png, other: 320x180, 1.23 s"; `other` may be NULL. */
void render_print_summary(const char *other, int width, int height, double seconds);

/* Seconds, for programs; `forward` may be NULL. */
json_t *render_times_json(const placed_scene *placed, double build, json_t *forward, double frame,
                          double write);

#endif
