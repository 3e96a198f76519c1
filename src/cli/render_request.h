/* What the words of `surehit render` ask for. */
#ifndef CLI_RENDER_REQUEST_H
#define CLI_RENDER_REQUEST_H

#include "args.h"

#include "../evidence/heat.h"
#include "../tracer/render_file.h"

#define NO_HEAT HEATS

/* What photons from the lights to the eye are asked for. */
typedef struct {
    uint64_t first;    /* photon */
    int bounces;       /* 0: the default, which is the falloff's */
    double aperture;   /* 0: a pinhole */
    const char *share; /* where their sums go, or NULL */
    const char *from;  /* the share that is continued, or NULL */
} forward_request;

typedef struct {
    bool help, quiet, explain, time;
    const char *scene;
    const char **outputs; /* room for every word */
    int output_count;
    const char *certificate; /* its path, or NULL */
    heat_kind heat;          /* NO_HEAT: light */
    render_settings settings;
    forward_request forward;
} render_request;

void render_print_help(void);

/* Returns the exit status, 0 to go on. */
int render_read_words(args *line, render_request *asked);

/* What is asked for by one option, and can't be had with another's value: returns EXIT_USAGE. */
int render_clash(const args *line, const char *option, const char *other, const char *why);

/* Writes all of them, or returns EXIT_OUTPUT. */
int render_write_pictures(const render_request *asked, const picture *image);

#endif
