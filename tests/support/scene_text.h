/* SPDX-License-Identifier: MIT */
/* Scenes in tests: read, changed number by number, written anew, drawn. */
#pragma once

#include "picture.h"
#include "render_file.h"
#include "rt.h"

#include <glob.h>

/* Those of tests/scenes/extreme; before them, if wanted, those of tests/scenes. */
const glob_t *scene_files(bool all);

/* Each fails the running test, with what the reader says, where something is wrong. */

/* Free it with rt_scene_free. */
rt_scene scene_from_file(const char *path);
rt_scene scene_of_size(const char *path, int width, int height);
rt_scene scene_from_text(const char *text, const char *name);

/* Its objects, lights and window. Free it with placement_free. */
sure_scene scene_placed(const rt_scene *file);

/* What is drawn of the scene's text, from the text on. Free it with picture_free. */
picture scene_drawn(const rt_scene *file, const render_settings *settings);
