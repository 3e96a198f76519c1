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

sure_vec3 TIER(sure_rotation_apply)(const sure_mat3 *matrix, sure_vec3 v)
{
    vec3 p = vec3_from(v);
#ifdef SURE_STABLE
    if (scale_largest(p) >
        REAL_MAX / 4) /* a sum of two terms may overflow where all three do not */
        return vec3_public(scale_vector(
            vec3_from(TIER(sure_rotation_apply)(matrix, vec3_public(vec3_scale(0.25, p)))), 2));
#endif
    return vec3_public((vec3){vec3_dot(vec3_from(matrix->row[0]), p),
                              vec3_dot(vec3_from(matrix->row[1]), p),
                              vec3_dot(vec3_from(matrix->row[2]), p)});
}
