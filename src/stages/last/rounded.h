/* The last stage: any query decided, and any number of its answer rounded correctly. No
 * floating-point operation decides anything here, so neither does the environment. */
#ifndef STAGES_ROUNDED_H
#define STAGES_ROUNDED_H

#include "../shape.h"

/* Entry everywhere: valid input. */

/* The first boundary point; *t rounded, *whole whether that is t* itself. */
sure_status rounded_hit(const sure_ray *ray, const shape_row *row, const void *shape,
                        tagged_end *first, double *t, bool *whole);

sure_status rounded_interval(const sure_ray *ray, const shape_row *row, const void *shape,
                             sure_interval *interval);

/* The normal at, and the place of, the ray's first boundary point. Entry: there is one. */
sure_vec3 rounded_normal(const sure_ray *ray, const shape_row *row, const void *shape);
sure_vec3 rounded_point(const sure_ray *ray, const shape_row *row, const void *shape);

/* -1, 0, 1: the first boundary point of `first` comes before, with, after that of `second`. Entry:
 * there are both. */
int rounded_order(const sure_ray *ray, const sure_object *first, const sure_object *second);

#endif
