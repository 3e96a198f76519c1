/* Is a line in one of the planes across an axis at its ends? */
#ifndef INTERSECT_AXIAL_PLANE_H
#define INTERSECT_AXIAL_PLANE_H

#include "axial_filter.h"

typedef enum { AXIAL_PLANE_UNKNOWN, AXIAL_PLANE_FROM, AXIAL_PLANE_TO } axial_plane;

/* Certain, or unknown; mostly the latter at once. axis, m, d: what the filters have of axis, origin
 * and direction, seen from the axis's first end; size is theirs. */
axial_plane axial_plane_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to, filter_vector axis,
                           filter_vector m, filter_vector d, double size);

/* The chord is boundary, so its first end is an answer only when it is certainly in the range. */
static inline filter_verdict axial_plane_chord(filter_verdict verdict, sure_part part,
                                               const sure_ray *ray, filter_chord *found)
{
    if (verdict != FILTER_CHORD)
        return verdict;
    found->enter.end.part = found->leave.end.part = part;
    return found->enter.t - ray->t_min > found->enter.error ? FILTER_CHORD : FILTER_UNCERTAIN;
}

#endif
