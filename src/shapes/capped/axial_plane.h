/* Is a line in one of the planes across an axis at its ends? */
#ifndef SHAPES_AXIAL_PLANE_H
#define SHAPES_AXIAL_PLANE_H

#include "axial_filter.h"

typedef enum { AXIAL_PLANE_UNKNOWN, AXIAL_PLANE_FROM, AXIAL_PLANE_TO } axial_plane;

/* Certain, or unknown; mostly the latter at once. `of`: what the filter has of the line, seen from
 * the axis's first end. */
axial_plane axial_plane_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to,
                           const axial_terms *of);

/* Does the ray start, at t_min = 0, in the plane of one of the chord's ends? That end is then put
 * at 0. of_from, of_to: which ends are in the planes through `from` and `to`. */
bool axial_starts(const sure_ray *ray, sure_vec3 from, sure_vec3 to, const axial_terms *of,
                  end_kind of_from, end_kind of_to, filter_interval *found);

/* The chord is boundary: a ray that starts between its ends is there already. */
static inline filter_verdict axial_plane_chord(filter_verdict verdict, sure_part part,
                                               const sure_ray *ray, bool both_ends,
                                               filter_interval *found)
{
    const filter_end start = {.end = {END_START, part}};
    if (verdict != FILTER_INTERVAL)
        return verdict;
    found->enter.end.part = found->leave.end.part = part;
    if (both_ends || found->enter.t - ray->t_min > found->enter.error ||
        ray->t_min - found->leave.t > found->leave.error)
        return FILTER_INTERVAL;
    if (!(bits_of(ray->t_min) == 0 && -found->enter.t > found->enter.error &&
          found->leave.t > found->leave.error))
        return FILTER_UNCERTAIN;
    *found = (filter_interval){start, start};
    return FILTER_INTERVAL;
}

#endif
