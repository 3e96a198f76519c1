/* What the tier stable answers where the first stage of the plane is uncertain: as textbook has it.
 */
#include "../stable.h"
#include "plane.h"
#include "plane_filter.h"

static span plane_guess(const sure_ray *ray, const void *shape)
{
    const sure_plane *plane = shape;
    plane_line line = plane_line_from(ray, plane->point, plane->normal);
    return plane_line_span(&line);
}

STABLE_QUESTIONS(plane)
