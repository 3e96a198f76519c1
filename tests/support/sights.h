/* SPDX-License-Identifier: MIT */
/* Which object each pixel shows: as a tier draws it, and in truth. All end the program where there
 * is no memory. */
#pragma once

#include "picture.h"

#include <surehit/scene.h>

#define SIGHT_NOTHING (-1)

/* The indices of objects, rows from the top. */
typedef struct {
    int width, height;
    int *objects;
} sights;

sights sights_new(const sure_scene *scene);
void sights_free(sights *seen);

/* Objects in a colour of their own, the bytes of their number from 1 on, in ambient light alone.
 * Entry: fewer than 2^24 objects. */
picture sights_picture(const sure_scene *scene, sure_tier tier);

/* What that shows. */
sights sights_drawn(const sure_scene *scene, sure_tier tier);

/* What the pixels' rays meet first in front of the eye, of two at one t the object of the lower
 * index, by the exact reference. */
sights sights_true(const sure_scene *scene);

/* Pixels that show another object. */
int sights_differ(const sights *seen, const sights *expected);

/* Pixels that show an object in shadow, from a lamp in the eye: that shines on what the eye sees,
 * so there are none. (Where the eye is in a surface, or two edges are seen a rounding apart, there
 * may be.) */
int sights_dark(const sure_scene *scene, sure_tier tier);
