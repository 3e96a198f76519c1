/* SPDX-License-Identifier: MIT */
/* A picture in pieces, which are squares of its pixels (render.h): their light, and where it is
 * asked for what their pixels see. */
#pragma once

#include "../../photons/render_file.h"

/* CUT_GOES_ON with all of it in *drawn, which has room for it; else an exit status (cut.h). */
int squares_do(const char *scene, const placed_scene *placed, const render_settings *settings,
               rendering *drawn);
