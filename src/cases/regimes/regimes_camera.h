/* SPDX-License-Identifier: MIT */
/* The regime camera: what the rays of pictures ask of the objects in them (docs/regimes.md). */
#pragma once

#include "camera_pictures.h"
#include "../case.h"

/* A pixel of a picture at its own size, or up to CAMERA_FINEST times as wide and high. */
typedef struct {
    const camera_picture *of;
    int finer, column, row;
} camera_pixel;

enum { CAMERA_FINEST = 8 };

/* A case and where it comes from.
 *
 * Law 1: half of the rays are pixels', a quarter go to lights, an eighth each are reflected and
 *        refracted.
 * Law 2: the ray is, bit by bit, the one that the tracer follows by the tier exact.
 * Law 3: the object is one that a hierarchy asks, or a cap in whose box the ray is. A surface that
 *        the ray has left is asked from within alone, for the far half of the chord. */
typedef struct {
    sure_case question;
    camera_pixel pixel;
    sure_ray_kind kind;
    double way; /* of light between the eye and the ray's start */
} camera_case;

/* Entry: camera_shows(shape); g as regime_rng makes it. */
camera_case camera_case_of(sure_shape shape, rng *g);

/* What the errors of a case can be measured by. */
typedef struct {
    double extent; /* of the scene: the diagonal of the box around the eye and all that ends */
    double pixel;  /* a pixel's width at distance 1 from the eye along its ray */
    double way;    /* the case's */
    double speed;  /* |d|: a difference of t has that many times its length */
} camera_lengths;

camera_lengths camera_lengths_of(const camera_case *of);
