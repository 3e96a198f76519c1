/* SPDX-License-Identifier: MIT */
#include "../numbers/valid.h"
#include "../numbers/scale.h"

#include <surehit/rotation.h>

#include <assert.h>

/* The matrices of the notes, with c = cos(angle), s = sin(angle):
 *
 *          | 1  0  0 |          |  c  0  s |          | c -s  0 |
 *    R_x = | 0  c -s |    R_y = |  0  1  0 |    R_z = | s  c  0 |
 *          | 0  s  c |          | -s  0  c |          | 0  0  1 |
 *
 * turn (y, z), (z, x) and (x, y) by the angle. */
static void turn_by(double angle, real *first, real *second)
{
    real c = REAL(cos)((real)angle), s = REAL(sin)((real)angle), a = *first, b = *second;
    *first = c * a - s * b;
    *second = s * a + c * b;
}

sure_vec3 TIER(sure_rotate_x)(double angle, sure_vec3 v)
{
    assert(is_finite_bits(angle) && all_finite(v));
    vec3 p = vec3_from(v);
    turn_by(angle, &p.y, &p.z);
    return vec3_public(p);
}

sure_vec3 TIER(sure_rotate_y)(double angle, sure_vec3 v)
{
    assert(is_finite_bits(angle) && all_finite(v));
    vec3 p = vec3_from(v);
    turn_by(angle, &p.z, &p.x);
    return vec3_public(p);
}

sure_vec3 TIER(sure_rotate_z)(double angle, sure_vec3 v)
{
    assert(is_finite_bits(angle) && all_finite(v));
    vec3 p = vec3_from(v);
    turn_by(angle, &p.x, &p.y);
    return vec3_public(p);
}

/* The vector whose components are those of v along x, y and z. */
static inline vec3 along(vec3 x, vec3 y, vec3 z, vec3 v)
{
#ifdef SURE_STABLE
    const real largest = scale_largest(v);
    if (largest > REAL_MAX / 4 && largest <= REAL_MAX) /* a sum of two terms may overflow */
        return scale_vector(along(x, y, z, vec3_scale(0.25, v)), 2);
#endif
    return (vec3){vec3_dot(x, v), vec3_dot(y, v), vec3_dot(z, v)};
}

sure_vec3 TIER(sure_rotation_apply)(const sure_mat3 *matrix, sure_vec3 v)
{
    vec3 x = vec3_from(matrix->row[0]), y = vec3_from(matrix->row[1]);
    vec3 z = vec3_from(matrix->row[2]);
    return vec3_public(along(x, y, z, vec3_from(v)));
}

sure_vec3 TIER(sure_rotation_undo)(const sure_mat3 *matrix, sure_vec3 v)
{
    vec3 x = vec3_from(matrix->row[0]), y = vec3_from(matrix->row[1]);
    vec3 z = vec3_from(matrix->row[2]);
    return vec3_public(
        along((vec3){x.x, y.x, z.x}, (vec3){x.y, y.y, z.y}, (vec3){x.z, y.z, z.z}, vec3_from(v)));
}
