/* SPDX-License-Identifier: MIT */
/* What the headers promise of light and of the Phong model, of any question: what is broken, or
 * NULL. Numbers are the tier's (tiers.h: rounded). */
#pragma once

#include <surehit/light.h>
#include <surehit/phong.h>
#include <surehit/tier.h>

/* Of light.h, Laws 1 to 3, and both functions against their formulas in long double. Entry: finite;
 * the normal is not zero, brightness and colour are not negative. */
const char *light_broken(sure_tier tier, sure_vec3 point, sure_vec3 normal, const sure_light *light,
                         sure_falloff falloff);

/* Of phong.h, Laws 1 and 2, and the highlight against its formula in long double. Entry: finite,
 * not zero; shine >= 0. */
const char *highlight_broken(sure_tier tier, sure_vec3 normal, sure_vec3 to_eye, sure_vec3 to_light,
                             int shine);

/* Law 3, and both mixes against their formulas. Entry: finite and not negative; shares are 0..1. */
const char *mix_broken(sure_tier tier, const sure_material *material, sure_vec3 incoming,
                       sure_vec3 reflected, double intensity, double highlight);
