/* SPDX-License-Identifier: MIT */
#include "../numbers/valid.h"
#include "../numbers/scale.h"

#include <surehit/light.h>

#include <assert.h>

/* The way to the light is -light_direction of the notes, L = P_light - P_hit:
 *
 *     intensity = max(0, N.L / (|N| |L|))
 */
double TIER(sure_light_intensity)(sure_vec3 point, sure_vec3 normal, sure_vec3 light_position)
{
    assert(all_finite(point) && direction_ok(normal) && all_finite(light_position));
    vec3 to_light = scale_way(point, light_position);
    real cosine = vec3_dot(vec3_unit(vec3_from(normal)), vec3_unit(to_light));
    return cosine > 0 ? cosine < 1 ? cosine : 1 : 0;
}

static inline bool light_ok(const sure_light *light)
{
    const sure_vec3 color = light->color;
    return all_finite(light->position) && all_finite(color) && is_finite_bits(light->brightness) &&
           not_negative(color.x) && not_negative(color.y) && not_negative(color.z) &&
           not_negative(light->brightness);
}

/* light_rgb * brightness / (4 pi distance^2) */
#ifndef SURE_STABLE
/* What overflows is the greatest number: infinity times a colour's zero is none. */
static real limited(real x)
{
    return x < REAL_MAX ? x : REAL_MAX;
}

sure_vec3 TIER(sure_light_color)(const sure_light *light, sure_vec3 point, sure_falloff falloff)
{
    const real pi = (real)3.14159265358979323846;
    assert(light_ok(light) && all_finite(point));
    real share = limited((real)light->brightness);
    if (falloff == SURE_FALLOFF_INVERSE_SQUARE) {
        vec3 to_light = vec3_sub(vec3_from(light->position), vec3_from(point));
        real square = vec3_dot(to_light, to_light);
        share = square > 0 ? share / (4 * pi * square) : 0;
    }
    return vec3_public(vec3_scale(limited(share), vec3_from(light->color)));
}
#else
/* Stable: brightness and distance near one, their powers of two put back at the end. */
sure_vec3 TIER(sure_light_color)(const sure_light *light, sure_vec3 point, sure_falloff falloff)
{
    const real pi = 3.14159265358979323846;
    assert(light_ok(light) && all_finite(point));
    vec3 color = vec3_from(light->color);
    if (falloff != SURE_FALLOFF_INVERSE_SQUARE)
        return vec3_public(vec3_scale(light->brightness, color));
    vec3 to_light = scale_way(light->position, point);
    if (vec3_is_zero(to_light))
        return (sure_vec3){0, 0, 0};
    int of_way = scale_exponent(scale_largest(to_light)),
        of_light = scale_exponent(light->brightness);
    vec3 way = scale_vector(to_light, -of_way);
    real share = ldexp(light->brightness, -of_light) / (4 * pi * vec3_dot(way, way));
    if (scale_unit(light->position, point) != 1) /* a quarter of the way */
        of_way += 2;
    return vec3_public(scale_vector(vec3_scale(share, color), of_light - 2 * of_way));
}
#endif
