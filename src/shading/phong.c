/* SPDX-License-Identifier: MIT */
#include "../numbers/valid.h"
#include "reflect.h"

#include <surehit/phong.h>

#include <assert.h>

/* x^n by squaring: products only. */
static real power(real x, int n)
{
    real result = 1;
    for (; n > 0; n >>= 1) {
        if (n & 1)
            result *= x;
        x *= x;
    }
    return result;
}

/* R = 2 proj_N V - V; the highlight is the closer R and L. */
double TIER(sure_phong_specular)(sure_vec3 normal, sure_vec3 to_eye, sure_vec3 to_light, int shine)
{
    assert(direction_ok(normal) && direction_ok(to_eye) && direction_ok(to_light) && shine >= 0);
    vec3 mirrored = reflect(vec3_unit(vec3_from(to_eye)), vec3_unit(vec3_from(normal)));
    real closeness = vec3_dot(mirrored, vec3_unit(vec3_from(to_light)));
    return closeness > 0 ? power(closeness < 1 ? closeness : 1, shine) : 0;
}

sure_vec3 TIER(sure_phong_mix)(const sure_material *material, sure_vec3 incoming, double intensity,
                               double highlight)
{
    assert(all_finite(material->color) && is_finite_bits(material->specular));
    assert(all_finite(incoming) && is_finite_bits(intensity) && is_finite_bits(highlight));
    vec3 light = vec3_from(incoming);
    vec3 diffuse = vec3_scale((real)intensity, vec3_from(material->color));
    real specular = (real)material->specular * (real)highlight;
    return vec3_public((vec3){light.x * (diffuse.x + specular), light.y * (diffuse.y + specular),
                              light.z * (diffuse.z + specular)});
}

sure_vec3 TIER(sure_phong_mirror)(const sure_material *material, sure_vec3 own, sure_vec3 reflected)
{
    assert(is_finite_bits(material->mirror) && all_finite(own) && all_finite(reflected));
    real mirror = (real)material->mirror;
    return vec3_public(
        vec3_add(vec3_scale(1 - mirror, vec3_from(own)), vec3_scale(mirror, vec3_from(reflected))));
}
