/* The surface at a hit, in double-doubles with a bound: t* from the hit's t by a step of Newton's
 * method, then the point and the normal. */
#ifndef STAGES_INTERACTION_H
#define STAGES_INTERACTION_H

#include "surface.h"

/* The hit point o + t* d, correctly rounded. Entry for both: a hit by certain or exact, round to
 * nearest. False where it can't be told. */
bool interaction_point(const shape_row *row, const sure_ray *ray, const void *shape,
                       const sure_hit *hit, sure_vec3 *point);

/* Each component of the normal within SURE_NORMAL_ERROR, or rounded correctly. */
bool interaction_normal(const shape_row *row, const sure_ray *ray, const void *shape,
                        const sure_hit *hit, bool rounded, sure_vec3 *normal);

#endif
