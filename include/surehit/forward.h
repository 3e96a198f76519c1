/* SPDX-License-Identifier: MIT */
/* The forward tracer: photons, from the lights to the eye. */
#pragma once

#include <stdint.h>

#include <surehit/scene.h>

SURE_C_BEGIN

typedef struct {
    uint64_t seed;
    int bounces;     /* matte surfaces that one photon may light, >= 1; 1 under SURE_FALLOFF_NONE */
    double aperture; /* radius of the eye's opening, which photons must enter by themselves; 0: a
                      * pinhole, to which every point that a photon lights is joined */
} sure_forward_options;

/* What became of photons: emitted = escaped + absorbed + stopped + entered. */
typedef struct {
    uint64_t emitted;
    uint64_t escaped;  /* met nothing more */
    uint64_t absorbed; /* by a matte surface */
    uint64_t stopped;  /* by a limit: bounces, the scene's depth, a hit that can't be left */
    uint64_t entered;  /* the opening */
    uint64_t lit;      /* points of matte surfaces that photons lit */
    uint64_t through;  /* the window, towards the eye: photons, or for a pinhole points' joins */
    uint64_t reached;  /* of these the eye: entered, or with nothing in between */
} sure_forward_statistics;

/* Adds what `more` has counted. */
void sure_forward_statistics_add(sure_forward_statistics *sum, const sure_forward_statistics *more);

/* Told of light at the eye: a pixel, row 0 lowest, and what it adds there, finite. The sum, divided
 * by the number of photons, is the picture: pi times the mean radiance over the pixel's area on the
 * window, which for matte surfaces is what sure_backward_pixel gives. */
typedef void (*sure_forward_splat)(void *film, int column, int row, sure_vec3 value);

/* The way of the photon of that number.
 *
 * It leaves a light, which is chosen by its power (brightness times the mean of its colour), in a
 * direction that is uniform on the sphere. A mirror or clear surface sends it on, as many in a row
 * as the scene's depth; a matte one, or what is left of a mirror, is lit by it, and then takes it
 * in or sends it on by the cosine law. Ambient light and highlights are not light that travels:
 * photons know nothing of them.
 *
 * Entry    a scene whose objects are valid; options as said above; neither splat nor statistics is
 *          NULL. Without a light of a power above 0 there is no photon, and nothing is counted.
 * Returns  nothing; *statistics is added to, `splat` called with `film` for light that reaches the
 *          eye. Through an opening that is light which a matte surface has scattered: a light is a
 *          point and can't be seen.
 * Bound    none: where it goes is what the tier decides.
 * Source   notes, "Physically Based Rendering (Forward Ray Tracing)", "apply light"; the estimator:
 *          P. Dutre, E. Lafortune, Y. Willems, Monte Carlo light tracing with direct computation of
 *          pixel intensities, Compugraphics 1993. Random numbers: J. Salmon et al., Parallel random
 *          numbers: as easy as 1, 2, 3, SC 2011.
 * Proof    docs/derivations/forward.md
 *
 * Law 1: a photon's way depends on nothing but scene, tier, options and its number.
 * Law 2: every photon ends once.
 * Law 3: in the mean over photons, the pixel of a matte scene (bounces 1) is the mean of
 *        sure_backward_pixel over the pixel's area. */
void sure_forward_photon(const sure_scene *scene, sure_tier tier,
                         const sure_forward_options *options, uint64_t number,
                         sure_forward_splat splat, void *film, sure_forward_statistics *statistics);

SURE_C_END
