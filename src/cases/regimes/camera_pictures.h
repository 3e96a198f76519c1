/* SPDX-License-Identifier: MIT */
/* The pictures whose rays the regime camera has. */
#pragma once

#include <stdbool.h>

#include <surehit/bvh.h>
#include <surehit/scene.h>
#include <surehit/statistics.h>

/* Its scene is where the file has it; of a crowd there is what may be met from four windows about
 * the middles of the picture's quarters. Windows of half its width and height make up all of it. */
typedef struct {
    const char *name;
    sure_scene scene;
    double extent;            /* the diagonal of the box around the eye and all that ends */
    const sure_bounds *boxes; /* by object: that of its leaf in the hierarchy, or all space */
    int columns, rows;        /* of a window */
} camera_picture;

/* Those of camera_scenes.jsonl. */
extern const camera_picture camera_pictures[];
extern const int camera_picture_count;

/* Has it an object of the shape; can a ray of that kind start in it? */
bool camera_has_shape(const camera_picture *picture, sure_shape shape);
bool camera_has_kind(const camera_picture *picture, sure_ray_kind kind);

/* Is an object of the shape in one of them? */
bool camera_shows(sure_shape shape);

/* What of the shape an object shows: itself; its caps as discs, which no line of a scene makes.
 * Returns how many. */
int camera_shown_by(const sure_object *object, sure_shape shape, sure_object shown[2]);

/* Where the first or second window of so many of the picture's columns (or rows) begins. */
int camera_window(int pixels, int window, int which);

/* The tracer's, of the picture in so many times as many columns and rows; row 0 is the lowest. */
sure_ray camera_pixel_ray(const camera_picture *picture, int finer, int column, int row);

/* Does the ray meet the box, but for roundings? */
bool camera_meets_box(const sure_ray *ray, const sure_bounds *box);
