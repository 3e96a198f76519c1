/* SPDX-License-Identifier: MIT */
/* What happened on the way to a pixel, for those who ask. */
#pragma once

#include <stdint.h>

#include <surehit/scene.h>

SURE_C_BEGIN

typedef enum { SURE_RAY_PIXEL, SURE_RAY_SHADOW, SURE_RAY_MIRROR, SURE_RAY_REFRACTED } sure_ray_kind;

#define SURE_RAY_KINDS 4

/* "pixel", "shadow", "mirror", "refracted"; NULL for a number that is no kind. */
const char *sure_ray_kind_name(sure_ray_kind kind);

/* Begun as {0}. The first three are the last pixel's, all others are added up. */
typedef struct {
    sure_status seen;     /* by the pixel's own ray */
    sure_nearest nearest; /* where that is SURE_HIT, ... */
    sure_stage stage;     /* ... and the stage that tells its hit (sure_object_stage) */
    uint64_t rays[SURE_RAY_KINDS];
    uint64_t decided[SURE_STAGES]; /* rays that met an object, by the stage that tells its hit */
    uint64_t missed;               /* rays that met none */
    uint64_t origins;        /* starts of further rays (certain, exact; else 0), and of these: */
    uint64_t without_origin; /* hits that sure_spawn has none for: nothing goes on there */
    uint64_t covered;        /* another surface lies between hit and origin, exactly */
    uint64_t acne; /* rays that met the surface they had left on the side they had left it on */
} sure_statistics;

/* Adds what `more` has counted; the last pixel is its. */
void sure_statistics_add(sure_statistics *sum, const sure_statistics *more);

SURE_C_END
