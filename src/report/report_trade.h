/* What each tier gives and takes over a folder of scenes, for the report. */
#ifndef REPORT_TRADE_H
#define REPORT_TRADE_H

#include "../photons/render_file.h"

#include <jansson.h>
#include <stdbool.h>

typedef struct {
    char *name; /* its file's, without the ending */
    placed_scene placed;
} trade_scene;

typedef struct {
    trade_scene *scenes;
    int count;
} trade;

/* Reads all scenes (*.rt) of the folder, in the order of their names. To be freed with
 * report_trade_free, whatever is returned; false after a line to standard error that names the file
 * or the folder. */
bool report_trade_read(const char *folder, trade *of);

/* Draws them: for each scene and tier how many pixels show another object than exact's do, and the
 * processor time a pixel. `shown`: with a bar, where it takes long. NULL after a line to standard
 * error. */
json_t *report_trade_draw(const trade *of, bool shown);

void report_trade_free(trade *of);

#endif
