/* The place of a hit from its t, in double-doubles. */
#ifndef STAGES_HIT_POINT_H
#define STAGES_HIT_POINT_H

#include <surehit/object.h>

#include <stdbool.h>

/* o + t* d, correctly rounded; false where that is not certain. Entry: the hit is right and t*
 * within its t_error; the default environment. */
bool hit_point(const sure_ray *ray, const sure_object *object, const sure_hit *hit,
               sure_vec3 *place);

#endif
