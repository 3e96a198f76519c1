/* The words that say how scenes are read and drawn, for every command that draws some. */
#ifndef CLI_DRAWING_H
#define CLI_DRAWING_H

#include "args.h"

#include "../tracer/render_file.h"

/* They stand in a command's table of options, behind its own. */
/* clang-format off */
#define DRAWING_OPTIONS \
    {"--size", true}, \
    {"--tier", true}, \
    {"--threads", true}, \
    {"--handedness", true}, \
    {"--fov", true}, \
    {"--cylinder-position", true}, \
    {"--cone-position", true}, \
    {"--falloff", true}, \
    {"--skip-unknown", false}
/* clang-format on */

/* Sets the option of that name: returns 0, or EXIT_USAGE after a complaint. */
int drawing_set(const args *line, const char *name, const char *value, render_settings *settings);

/* A part of --help: size, tier and threads. */
void drawing_print_help(void);

#endif
