/* SPDX-License-Identifier: MIT */
/* From a scene's file to its picture: read, place, light, render. The one way there, so that a
 * command which compares a scene's picture compares what `surehit render` draws. */
#pragma once

#include "../scene/placement.h"
#include "../tracer/render.h"

/* Which way light is followed. MIXED is BACKWARD where a scene needs no more. AUTO is MIXED where
 * light falls off with the square of the distance; where it doesn't, scenes are tuned for BACKWARD.
 */
typedef enum {
    INTEGRATOR_AUTO,
    INTEGRATOR_BACKWARD,
    INTEGRATOR_FORWARD,
    INTEGRATOR_MIXED
} integrator_kind;

/* What a command line says of it. */
typedef struct {
    rt_options reading;
    rt_options_set reading_set;
    render_options how;
    integrator_kind integrator; /* FORWARD draws elsewhere: forward_sum.h */
    uint64_t photons;           /* that leave the lights; 0: the default */
    uint64_t seed;              /* of their random numbers */
    bool counted, recorded;     /* a rendering gets its statistics and its records */
} render_settings;

/* What holds where the command line says nothing: the default tier is named here. */
#define RENDER_DEFAULTS                                                                            \
    {                                                                                              \
        .reading = RT_DEFAULTS, .how = {.tier = SURE_TIER_CERTAIN }                                \
    }

/* What becomes of the forward pass. */
typedef enum {
    CAUSTICS_ON,
    CAUSTICS_NOT_ASKED,    /* another integrator */
    CAUSTICS_NOT_SHINY,    /* no mirror or glass */
    CAUSTICS_NOT_FOLLOWED, /* or at depth 0 */
    CAUSTICS_NOT_LIT,      /* no light */
    CAUSTICS_NOT_MATTE,    /* nothing to land on */
    CAUSTICS_ENDLESS,      /* light that doesn't fall off, and nobody insists */
    CAUSTICS_NO_WAY,       /* no photon landed */
    CAUSTICS_NO_MEMORY
} caustics_state;

typedef struct {
    caustics_state state;
    uint64_t traced, landed; /* photons */
    size_t bytes;            /* of their map */
} caustics_statistics;

/* What a picture took: seconds, memory, photons. */
typedef struct {
    double build, forward, frame; /* what is made of the objects; the forward pass; the pixels */
    size_t bytes;                 /* of the hierarchy */
    caustics_statistics caustics; /* of the forward pass */
} scene_times;

/* What objects and lights of a scene take. */
size_t scene_bytes(const sure_scene *scene, sure_tier tier);

/* Fills *image, as render does, by the integrator that the settings ask for, and by a hierarchy
 * where that is worthwhile. */
scene_times render_scene(const sure_scene *scene, const render_settings *settings, picture *image);

/* Makes *image (free it with picture_free) of the scene at `path`. On false at least one error was
 * written to `messages` and nothing is left allocated; warnings are written there, too. */
bool render_file(const char *path, const render_settings *settings, FILE *messages, picture *image);

/* The same in two steps, for those who want to know more than the picture. */

typedef struct {
    sure_scene scene;
    rt_options options; /* the scene's own and the command line's, resolved */
    uint64_t hash;      /* of the file's bytes, as they were read */
    double read, place; /* seconds that it took */
} placed_scene;

typedef struct {
    picture image;
    scene_times times;
    sure_statistics statistics; /* where the settings ask for it */
    pixel_record *records;      /* where they do: one a pixel; else NULL */
} rendering;

/* Free &placed->scene with placement_free, and *drawn with rendering_free; on false as render_file.
 */
bool render_file_place(const char *path, const render_settings *settings, FILE *messages,
                       placed_scene *placed);
bool render_file_draw(const char *path, const placed_scene *placed, const render_settings *settings,
                      FILE *messages, rendering *drawn);

/* And that again: the room for it, black, which is to be freed; and the drawing, of which nothing
 * is freed on false. */
bool rendering_room(const char *path, const placed_scene *placed, const render_settings *settings,
                    FILE *messages, rendering *drawn);
bool rendering_draw(const char *path, const placed_scene *placed, const render_settings *settings,
                    FILE *messages, rendering *drawn);

void rendering_free(rendering *drawn);
