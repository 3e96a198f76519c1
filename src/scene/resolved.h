/* A scene's resolved options, for files that say what they are of. */
#ifndef SCENE_RESOLVED_H
#define SCENE_RESOLVED_H

#include "rt.h"

#include <jansson.h>

/* As JSON, the size among them. Read back, what is wrong is returned, or NULL. */
json_t *resolved_json(const rt_options *options);
const char *resolved_from_json(const json_t *object, rt_options *options);

#endif
