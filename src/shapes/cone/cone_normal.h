/* The cone_normal stem's formula, for the stems that need a cone's normal. */
#ifndef SHAPES_CONE_NORMAL_H
#define SHAPES_CONE_NORMAL_H

#include "../../numbers/vec3.h"

/* The normal at P meets the axis in S. The triangle Q P S has its right angle at P, so
 *
 *     |QS| = |PQ| / cos(theta) = |PQ| s / h      s^2 = h^2 + r^2, h^2 = N.N
 *     S    = Q - |QS| N/h
 *     N_hit ~ P - S = (P - Q) + |PQ| s / h^2 N
 *
 * with P seen from the apex Q and N from base to apex.
 */
static inline vec3 cone_wall_outward(vec3 from_apex, vec3 axis, real radius)
{
    real height_square = vec3_dot(axis, axis);
    real slant_square = height_square + radius * radius;
    real distance = REAL(sqrt)(vec3_dot(from_apex, from_apex) * slant_square);
    return vec3_add(from_apex, vec3_scale(distance / height_square, axis));
}

#endif
