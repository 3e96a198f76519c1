/* The first stage of sure_spawn: doubles with proven bounds. */
#ifndef STAGES_SPAWN_QUICK_H
#define STAGES_SPAWN_QUICK_H

#include <surehit/object.h>

#include <stdbool.h>

/* True and *origin when the answer is certain, and then it is what the rest of sure_spawn would
 * find; else false and *origin untouched. wanted: the side, as where.h counts. Entry: as of
 * sure_spawn, the object has an inside if that is wanted; round to nearest, subnormals kept or
 * flushed. */
bool spawn_quick(const sure_ray *ray, const sure_object *object, const sure_hit *hit, int wanted,
                 sure_vec3 *origin);

#endif
