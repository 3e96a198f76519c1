/* What is asked of a hit, in exact numbers. No floating-point operation decides anything here, so
 * neither does the environment. */
#ifndef STAGES_ROUNDED_H
#define STAGES_ROUNDED_H

#include "../shape.h"

/* Entry everywhere: valid input. */

/* The normal at, and the place of, the ray's first boundary point. Entry: there is one. */
sure_vec3 rounded_normal(const sure_ray *ray, const shape_row *row, const void *shape);
sure_vec3 rounded_point(const sure_ray *ray, const shape_row *row, const void *shape);

/* -1, 0, 1: the first boundary point of `first` comes before, with, after that of `second`. Entry:
 * there are both. */
int rounded_order(const sure_ray *ray, const shape_row *first_row, const void *first,
                  const shape_row *second_row, const void *second);

#endif
