/* SPDX-License-Identifier: MIT */
#include "../numbers/vec3.h"

#include <surehit/camera.h>

/* The view f = (x, y, z) is brought to (0, 0, -|f|) by R_y, which makes its x zero and its z
 * negative, and then R_x, which does that to its y. With rho = sqrt(x^2 + z^2), |f| = sqrt(rho^2 +
 * y^2):
 *
 *     R_y: c = -z/rho, s =  x/rho      takes (x, y, z)    to (0, y, -rho)
 *     R_x: C = rho/|f|, S = -y/|f|     takes (0, y, -rho) to (0, 0, -|f|)
 *
 *               |  c    0    s  |
 *     R_x R_y = |  S s  C  -S c |
 *               | -C s  S   C c |
 *
 * rho = 0, straight up or down: c = 1, s = 0, the limit for x = 0, z -> -0. */
typedef struct {
    real c, s, length;
} bearing;

/* The cosine and sine of the way to (along, across), whose squares must not underflow together; the
 * first axis for no way at all. */
static bearing bearing_of(real along, real across)
{
    real length = REAL(sqrt)(along * along + across * across);
    if (length == 0)
        return (bearing){1, 0, 0};
    return (bearing){along / length, across / length, length};
}

sure_status TIER(sure_camera_rotation)(sure_vec3 view_given, sure_mat3 *world)
{
    vec3 view = vec3_from(view_given);
    if (!(REAL(fabs)(view.x) <= REAL_MAX && REAL(fabs)(view.y) <= REAL_MAX &&
          REAL(fabs)(view.z) <= REAL_MAX) ||
        vec3_is_zero(view))
        return SURE_INVALID;
    vec3 f = vec3_near_one(view);
    vec3 level = vec3_near_one((vec3){view.x, 0, view.z});
    bearing y_turn = bearing_of(-level.z, level.x);
    bearing x_turn = bearing_of(bearing_of(-f.z, f.x).length, -f.y);
    real c = y_turn.c, s = y_turn.s, C = x_turn.c, S = x_turn.s;
    world->row[0] = (sure_vec3){c, 0, s};
    world->row[1] = (sure_vec3){S * s, C, -(S * c)};
    world->row[2] = (sure_vec3){-(C * s), S, C * c};
    return SURE_HIT;
}
