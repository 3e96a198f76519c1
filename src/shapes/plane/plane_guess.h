/* What the tier stable answers where the first stage of the plane is uncertain: as textbook has it.
 */
#ifndef SHAPES_PLANE_GUESS_H
#define SHAPES_PLANE_GUESS_H

#include "plane.h"

static span plane_guess(const sure_ray *ray, const void *shape)
{
    const sure_plane *plane = shape;
    plane_line line = plane_line_from(ray, plane->point, plane->normal);
    return plane_line_span(&line);
}

#endif
