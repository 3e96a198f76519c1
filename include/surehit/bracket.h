/* SPDX-License-Identifier: MIT */
/* The sign change that encloses a collision. */
#pragma once

#include <surehit/ray.h>

SURE_C_BEGIN

/* f(point) > 0 outside, 0 on the surface, < 0 inside; `surface` is handed through. */
typedef double sure_implicit(const void *surface, sure_vec3 point);

/* The first of `steps` equal steps P_n -> P_n+1 along [t_min, t_max] of the ray at which f goes
 * from > 0 to <= 0, halved until its ends are neighbouring reals of the tier: f > 0 at t[0], f <= 0
 * at t[1]. A surface that is touched between two P_n without a sign change is not seen.
 *
 * Entry    any ray, any steps; f without state. An f that is NaN counts as <= 0.
 * Returns  SURE_HIT and t; SURE_MISS and t untouched; SURE_INVALID and t untouched: an invalid ray,
 *          steps < 1, or a t_max that is not finite in the tier.
 * Bound    none: f is evaluated in the tier's precision at rounded points.
 * Source   notes, "Ray-Object Intersection"; the strict f(P_n+1) < 0 is an erratum.
 * Proof    docs/derivations/bracket.md
 *
 * Law 1: t[0] < t[1] are neighbours, f(t[0]) > 0 >= f(t[1]).
 * Law 2: a ray that starts at or inside the surface has no step from > 0 there. */
SURE_TIERED(sure_status, sure_bracket, sure_implicit *f, const void *surface, const sure_ray *ray,
            int steps, double t[2]);

SURE_C_END
