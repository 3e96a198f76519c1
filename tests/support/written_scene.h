/* A scene as text. */
#ifndef SUPPORT_WRITTEN_SCENE_H
#define SUPPORT_WRITTEN_SCENE_H

#include "rt.h"

/* Reads back as the same: numbers as hexadecimal floats, every option on a line of its own. To be
 * freed; NULL when there is no memory. */
char *written_scene(const rt_scene *scene);

#endif
