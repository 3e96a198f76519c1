#include "axial_plane.h"

#include "quarter_terms.h"

/* How much A.d, A.m and A.m - A.A may be where they may be zero, as shares of |A| |d| and |A|
 * sqrt(size): more than their rounding errors, 4, 5 and 10 2^-52 (docs/proofs/axial_filter.md). */
#define SPEED_SHARE 0x1p-49
#define PLACE_SHARE 0x1p-47

axial_plane axial_plane_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to, filter_vector axis,
                           filter_vector m, filter_vector d, double size)
{
#ifdef MODULAR_EXISTS
    double height = filter_dot(axis, axis), e = filter_dot(axis, d), f = filter_dot(axis, m);
    double away = fmin(fabs(f), fabs(f - height)), dd = filter_dot(d, d);
    if (e * e > SPEED_SHARE * SPEED_SHARE * (height * dd) ||
        away * away > PLACE_SHARE * PLACE_SHARE * (height * size))
        return AXIAL_PLANE_UNKNOWN;
    double speed_most = SPEED_SHARE * sqrt(height * dd),
           place_most = PLACE_SHARE * sqrt(height * size);
    axis_modular line = axis_line_modular(ray, from, to);
    if (line.speed != 0 || !modular_is_whole(2 * speed_most, line.speed_exponent) ||
        !modular_is_whole(2 * place_most, line.exponent))
        return AXIAL_PLANE_UNKNOWN;
    if (line.from == 0 && fabs(f) <= place_most)
        return AXIAL_PLANE_FROM;
    if (line.to == 0 && fabs(f - height) <= place_most)
        return AXIAL_PLANE_TO;
#else
    (void)ray, (void)from, (void)to, (void)axis, (void)m, (void)d, (void)size;
#endif
    return AXIAL_PLANE_UNKNOWN;
}
