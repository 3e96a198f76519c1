/* SPDX-License-Identifier: MIT */
/* What the headers promise of the camera, of any question: the law that is broken, or NULL. */
#pragma once

#include <surehit/camera.h>
#include <surehit/pixel_ray.h>
#include <surehit/tier.h>

/* Of any view, and that times 2^k. */
const char *rotation_law_broken(sure_tier tier, sure_vec3 view, int k);

typedef struct {
    sure_camera camera;
    int width, height, column, row;
} pixel;

const char *pixel_law_broken(sure_tier tier, const pixel *p);
