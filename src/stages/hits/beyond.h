/* SPDX-License-Identifier: MIT */
/* What is asked of a hit, beyond a shape's first stage. */
#pragma once

#include "surface.h"

/* In double-doubles with a bound (interaction.c): t* from the hit's t by a step of Newton's method,
 * then the point and the normal. */

/* The hit point o + t* d, correctly rounded. Entry for both: a hit by certain or exact, round to
 * nearest. False where it can't be told. */
bool interaction_point(const shape_row *row, const sure_ray *ray, const void *shape,
                       const sure_hit *hit, sure_vec3 *point);

/* Each component of the normal within SURE_NORMAL_ERROR, or rounded correctly. */
bool interaction_normal(const shape_row *row, const sure_ray *ray, const void *shape,
                        const sure_hit *hit, bool rounded, sure_vec3 *normal);

/* In exact numbers (rounded.c). No floating-point operation decides anything here, so neither does
 * the environment. Entry everywhere: valid input. */

/* The normal at, and the place of, the ray's first boundary point. Entry: there is one. */
sure_vec3 rounded_normal(const sure_ray *ray, const shape_row *row, const void *shape);
sure_vec3 rounded_point(const sure_ray *ray, const shape_row *row, const void *shape);

/* Its t and normal, rounded to odd (numbers/exact.h). */
double odd_t(const sure_ray *ray, const shape_row *row, const void *shape);
sure_vec3 odd_normal(const sure_ray *ray, const shape_row *row, const void *shape);

/* -1, 0, 1: the first boundary point of `first` comes before, with, after that of `second`. Entry:
 * there are both. */
int rounded_order(const sure_ray *ray, const shape_row *first_row, const void *first,
                  const shape_row *second_row, const void *second);
