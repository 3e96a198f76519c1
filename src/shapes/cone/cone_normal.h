/* The cone_normal stem's formula, for the stems that need a cone's normal. */
#ifndef SHAPES_CONE_NORMAL_H
#define SHAPES_CONE_NORMAL_H

#include "../../numbers/scale.h"

/* The normal at P meets the axis in S. The triangle Q P S has its right angle at P, so
 *
 *     |QS| = |PQ| / cos(theta) = |PQ| s / h      s^2 = h^2 + r^2, h^2 = N.N
 *     S    = Q - |QS| N/h
 *     N_hit ~ P - S = (P - Q) + |PQ| s / h^2 N
 *
 * with P seen from the apex Q and N from base to apex.
 */
#ifndef SURE_STABLE
static inline vec3 cone_wall_outward(vec3 from_apex, vec3 axis, real radius)
{
    real height_square = vec3_dot(axis, axis);
    real slant_square = height_square + radius * radius;
    real distance = REAL(sqrt)(vec3_dot(from_apex, from_apex) * slant_square);
    return vec3_add(from_apex, vec3_scale(distance / height_square, axis));
}
#else
/* Stable: P - S is r of |N| along the axis and |N| of r across it, the two at right angles. With
 * the way across g = N x (p x N), p = P - Q, |g| = |N| |p x N|:
 *
 *     N_hit ~ |N| g + r |p x N| N
 *
 * On the axis there is no way across: N itself, or nothing when that is all of the cone. */
static inline vec3 cone_wall_outward(vec3 from_apex, vec3 axis, real radius)
{
    int of_n = scale_exponent(scale_larger(scale_largest(axis), radius));
    vec3 n = scale_vector(axis, -of_n);
    vec3 turn = vec3_near_one(vec3_cross(vec3_near_one(from_apex), n));
    if (vec3_is_zero(turn))
        return radius > 0 ? axis : turn;
    real length = sqrt(vec3_dot(n, n)), across = sqrt(vec3_dot(turn, turn));
    return vec3_add(vec3_scale(length, vec3_cross(n, turn)),
                    vec3_scale(ldexp(radius, -of_n) * across, n));
}
#endif

#endif
