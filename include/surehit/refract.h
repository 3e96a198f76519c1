/* SPDX-License-Identifier: MIT */
/* Refraction: light that goes on behind the surface of something transparent. */
#pragma once

#include <surehit/answer.h>
#include <surehit/vector.h>

SURE_C_BEGIN

/* Snell's law, n1 sin i = n2 sin t: the way on of a ray that goes along `incident` in a medium of
 * index n1 and meets one of index n2. index_ratio is n1/n2: 1/1.5 from air into glass, 1.5 from
 * glass into air.
 *
 * Entry    finite, not zero; incident and normal of any length, the normal on the side the ray
 *          comes from; index_ratio > 0. In float32 and textbook |normal|^2, (|normal| |incident|)^2
 *          and index_ratio^2 times that, |incident| / |normal| and index_ratio / |normal|^2 neither
 *          over- nor underflow; in stable index_ratio is from 2^-100 to 2^100.
 * Returns  SURE_HIT and the direction, as long as incident up to rounding; a component beyond the
 *          greatest double is infinite. It leads to the side of -normal, whatever the sign of
 *          N.incident; at the critical angle along the surface. For index ratio 1, as the tier has
 *          it, it is incident itself, to whichever side.
 *          SURE_MISS and *refracted untouched: total reflection.
 * Bound    SURE_REFRACT_ULPS.
 * Source   Snell's law: M. Born, E. Wolf, Principles of Optics, 1.5.1. Not in the notes, which have
 *          transparent things and no law for them.
 * Proof    docs/derivations/refract.md, docs/proofs/refract.md
 *
 * Law 1: on integers for which |normal|^2 is a power of two, and a ratio of eighths, everything is
 *        exact but for the root: total reflection is told from the critical angle and from
 *        refraction, and where the root is a number the direction is the right one.
 * Law 2: while nothing underflows, normal -> 2^k normal changes nothing, and incident -> 2^k
 *        incident gives 2^k the direction.
 * Law 3: index ratio 1 leaves incident as it is; one below 1 is never a miss.
 * Law 4: back along the same way: -refracted at -normal with the inverse ratio gives -incident;
 *        exactly where Law 1 holds for both.
 * Law 5: n1 N x incident = n2 N x refracted, |refracted| = |incident|, N.refracted <= 0, within the
 *        bound: the ray stays in the plane of incidence. */
SURE_TIERED(sure_status, sure_refract, sure_vec3 incident, sure_vec3 normal, double index_ratio,
            sure_vec3 *refracted);

/* The share of unpolarised light that is reflected where it meets the surface, by Fresnel's
 * equations: the mean of both polarisations. The rest is refracted; nothing is absorbed.
 *
 * Entry    as sure_refract; the normal may be on either side.
 * Returns  0..1; 1 on total reflection, 0 for index ratio 1.
 * Bound    SURE_FRESNEL_ULPS.
 * Source   Fresnel's equations: M. Born, E. Wolf, Principles of Optics, 1.5.2; E. Hecht, Optics,
 *          4.6.2.
 * Proof    docs/derivations/refract.md, docs/proofs/refract.md
 *
 * Law 6: 1 where sure_refract of the same tier says SURE_MISS, 0 for index ratio 1, both exactly;
 *        1 at the critical angle and at grazing incidence, for stable up to rounding.
 * Law 7: ((n1 - n2) / (n1 + n2))^2 along the normal; the parallel polarisation is not reflected at
 *        Brewster's angle.
 * Law 8: the same from the other side: -refracted, the inverse ratio; exactly where Law 4 is exact.
 * Law 9: grows with the angle, up to rounding, for indices whose ratio is at most 2 + sqrt(3).
 * Law 10: with the share that is transmitted it is 1. */
SURE_TIERED(double, sure_refract_fresnel, sure_vec3 incident, sure_vec3 normal, double index_ratio);

SURE_C_END
