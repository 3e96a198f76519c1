#include "axial_plane.h"

#include "../quarter_terms.h"

/* How much A.d, A.m and A.m - A.A may be where they may be zero, as shares of |A| |d| and |A|
 * sqrt(size): more than their rounding errors, 4, 5 and 10 2^-52 (docs/proofs/axial_filter.md). */
#define SPEED_SHARE 0x1p-49
#define PLACE_SHARE 0x1p-47

#ifdef MODULAR_EXISTS
static axial_plane plane_of(const axis_modular *line, double f, double height, double most)
{
    if (!modular_is_whole(2 * most, line->exponent))
        return AXIAL_PLANE_UNKNOWN;
    if (line->from == 0 && fabs(f) <= most)
        return AXIAL_PLANE_FROM;
    return line->to == 0 && fabs(f - height) <= most ? AXIAL_PLANE_TO : AXIAL_PLANE_UNKNOWN;
}

/* The end that may be at 0, or NULL. Both can't be: they are farther apart than uncertain. */
static filter_end *end_near_start(filter_chord *found)
{
    if (fabs(found->enter.t) <= found->enter.error)
        return &found->enter;
    return fabs(found->leave.t) <= found->leave.error ? &found->leave : NULL;
}
#endif

bool axial_starts(const sure_ray *ray, sure_vec3 from, sure_vec3 to, filter_vector axis,
                  filter_vector m, double size, point of_from, point of_to, filter_chord *found)
{
#ifdef MODULAR_EXISTS
    filter_end *end = bits_of(ray->t_min) == 0 ? end_near_start(found) : NULL;
    if (end == NULL || (end->end.at != of_from && end->end.at != of_to))
        return false;
    double height = filter_dot(axis, axis), f = filter_dot(axis, m);
    axis_modular line = axis_line_modular(ray, from, to);
    axial_plane plane = plane_of(&line, f, height, PLACE_SHARE * sqrt(height * size));
    if (plane != (end->end.at == of_from ? AXIAL_PLANE_FROM : AXIAL_PLANE_TO))
        return false;
    end->t = end->error = 0;
    return true;
#else
    (void)ray, (void)from, (void)to, (void)axis, (void)m, (void)size;
    (void)of_from, (void)of_to, (void)found;
    return false;
#endif
}

axial_plane axial_plane_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to, filter_vector axis,
                           filter_vector m, filter_vector d, double size)
{
#ifdef MODULAR_EXISTS
    double height = filter_dot(axis, axis), e = filter_dot(axis, d), f = filter_dot(axis, m);
    double away = fmin(fabs(f), fabs(f - height)), dd = filter_dot(d, d);
    if (e * e > SPEED_SHARE * SPEED_SHARE * (height * dd) ||
        away * away > PLACE_SHARE * PLACE_SHARE * (height * size))
        return AXIAL_PLANE_UNKNOWN;
    axis_modular line = axis_line_modular(ray, from, to);
    double speed_most = SPEED_SHARE * sqrt(height * dd);
    if (line.speed != 0 || !modular_is_whole(2 * speed_most, line.speed_exponent))
        return AXIAL_PLANE_UNKNOWN;
    return plane_of(&line, f, height, PLACE_SHARE * sqrt(height * size));
#else
    (void)ray, (void)from, (void)to, (void)axis, (void)m, (void)d, (void)size;
    return AXIAL_PLANE_UNKNOWN;
#endif
}
