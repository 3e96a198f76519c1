#include "../geometry/vec3.h"

#include <surehit/light.h>

/* The way to the light is -light_direction of the notes, L = P_light - P_hit:
 *
 *     intensity = max(0, N.L / (|N| |L|))
 */
double TIER(sure_light_intensity)(sure_vec3 point, sure_vec3 normal, sure_vec3 light_position)
{
    vec3 to_light = vec3_sub(vec3_from(light_position), vec3_from(point));
    real cosine = vec3_dot(vec3_unit(vec3_from(normal)), vec3_unit(to_light));
    return REAL(fmin)(1, REAL(fmax)(0, cosine));
}

/* light_rgb * brightness / (4 pi distance^2) */
sure_vec3 TIER(sure_light_color)(const sure_light *light, sure_vec3 point, sure_falloff falloff)
{
    const real pi = (real)3.14159265358979323846;
    real share = (real)light->brightness;
    if (falloff == SURE_FALLOFF_INVERSE_SQUARE) {
        vec3 to_light = vec3_sub(vec3_from(light->position), vec3_from(point));
        real square = vec3_dot(to_light, to_light);
        share = square > 0 ? share / (4 * pi * square) : 0;
    }
    return vec3_public(vec3_scale(share, vec3_from(light->color)));
}
