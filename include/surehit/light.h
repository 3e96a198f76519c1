/* SPDX-License-Identifier: MIT */
/* What a lamp gives a point of a surface. */
#pragma once

#include <surehit/vector.h>

SURE_C_BEGIN

/* How brightness falls with distance. */
typedef enum {
    SURE_FALLOFF_NONE,          /* the cosine law alone: what .rt scenes are tuned for */
    SURE_FALLOFF_INVERSE_SQUARE /* and 1 / (4 pi distance^2): the notes' law */
} sure_falloff;

typedef struct {
    sure_vec3 position;
    sure_vec3 color;   /* linear, 0..1 a component */
    double brightness; /* >= 0; a ratio, or a power under the inverse square law */
} sure_light;

/* cos of the angle between the normal and the way to the light, 0 where the light is behind.
 *
 * Entry    finite; normal not zero, of any length, on the lit side.
 * Returns  0..1; 0 also for a light at the point itself.
 * Bound    none.
 * Source   notes, "apply light"; the printed closeness of N to P_hit - P_light is an erratum.
 * Proof    docs/derivations/light.md
 *
 * Law 1: a light straight above gives 1, one in the tangent plane 0, both up to rounding and
 *        exactly along the axes; one below gives 0. But for stable, while the way to the light
 *        does not overflow.
 * Law 2: normal -> 2^k normal and light, point -> 2^k (light, point) change nothing while nothing
 *        underflows and, but for stable, nothing overflows. */
SURE_TIERED(double, sure_light_intensity, sure_vec3 point, sure_vec3 normal,
            sure_vec3 light_position);

/* color * brightness * falloff, without the angle: what arrives at the point from the light.
 *
 * Entry    finite; color and brightness as said above.
 * Returns  the light, never a NaN. Under the inverse square law zero for a light at the point
 *          itself; but for stable, also where the squared distance underflows. A share that
 *          overflows is the greatest number, in stable +infinity.
 * Bound    none.
 * Source   notes, "apply light".
 * Proof    docs/derivations/light.md
 *
 * Law 3: the inverse square law at distance 2^k is 4^-k times that at distance 1, exactly (nothing
 *        over- or underflowing). */
SURE_TIERED(sure_vec3, sure_light_color, const sure_light *light, sure_vec3 point,
            sure_falloff falloff);

SURE_C_END
