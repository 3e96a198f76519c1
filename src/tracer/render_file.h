/* From a scene's file to its picture: read, place, render. The one way there, so that a command
 * which compares a scene's picture compares what `surehit render` draws. */
#ifndef TRACER_RENDER_FILE_H
#define TRACER_RENDER_FILE_H

#include "../image/picture.h"
#include "render.h"
#include "../scene/rt.h"

/* What a command line says of it. */
typedef struct {
    rt_options reading;
    rt_options_set reading_set;
    render_options how;
    bool counted, recorded; /* a rendering gets its statistics and its records */
} render_settings;

/* What holds where the command line says nothing: the default tier is named here. */
render_settings render_defaults(void);

/* Makes *image (free it with picture_free) of the scene at `path`. On false at least one error was
 * written to `messages` and nothing is left allocated; warnings are written there, too. */
bool render_file(const char *path, const render_settings *settings, FILE *messages, picture *image);

/* The same in two steps, for those who want to know more than the picture. */

typedef struct {
    sure_scene scene;
    rt_options options; /* the scene's own and the command line's, resolved */
    double read, place; /* seconds that it took */
} placed_scene;

typedef struct {
    picture image;
    render_times times;
    sure_statistics statistics; /* where the settings ask for it */
    pixel_record *records;      /* where they do: one a pixel; else NULL */
} rendering;

/* Free them with placed_scene_free and rendering_free; on false as render_file. */
bool render_file_place(const char *path, const render_settings *settings, FILE *messages,
                       placed_scene *placed);
bool render_file_draw(const char *path, const placed_scene *placed, const render_settings *settings,
                      FILE *messages, rendering *drawn);

void placed_scene_free(placed_scene *placed);
void rendering_free(rendering *drawn);

/* Reads "X,Y,WxH": digits, and neither W nor H is 0. False: *part is untouched. */
bool render_part_from(const char *text, picture_part *part);

/* How many threads these options mean here. */
int render_threads(const render_options *how);

#endif
