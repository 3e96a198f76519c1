/* SPDX-License-Identifier: MIT */
/* The Phong reflection model. */
#pragma once

#include <surehit/vector.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 color; /* diffuse, linear, 0..1 a component */
    double specular; /* 0..1: strength of the highlight */
    double mirror;   /* 0..1: share of perfect reflection */
    double refract;  /* index of refraction; 0 for an opaque surface */
    int shine;       /* exponent of the highlight, >= 0 */
} sure_material;

/* (R.L)^shine for R the mirror image of the way to the eye in the normal; 0 where R.L <= 0. The
 * power is a product, so it is the same on every machine.
 *
 * Entry    finite, not zero, of any length; shine >= 0.
 * Returns  0..1.
 * Bound    none.
 * Source   notes, "Phong Reflection Model".
 * Proof    docs/derivations/phong.md
 *
 * Law 1: the eye in the mirror direction of the light sees 1 (up to rounding; exactly along an
 *        axis).
 * Law 2: for shine > 0 exchanging to_eye and to_light changes the result by rounding only; shine 0
 *        gives 1 where R.L, as computed, is above 0. */
SURE_TIERED(double, sure_phong_specular, sure_vec3 normal, sure_vec3 to_eye, sure_vec3 to_light,
            int shine);

/* The mix of one lamp's light on a material: incoming * (color * intensity + specular * highlight),
 * the highlight in the lamp's own colour. Ambient light is incoming light with intensity 1 and
 * highlight 0.
 *
 * Entry    finite.
 * Law 3: linear in incoming; no light gives none; both while nothing overflows. */
SURE_TIERED(sure_vec3, sure_phong_mix, const sure_material *material, sure_vec3 incoming,
            double intensity, double highlight);

/* (1 - mirror) own + mirror reflected. Entry: finite. */
SURE_TIERED(sure_vec3, sure_phong_mirror, const sure_material *material, sure_vec3 own,
            sure_vec3 reflected);

SURE_C_END
