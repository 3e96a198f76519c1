/* The cone in exact numbers: what its row gives to the last stage (stages/shape.h). */
#ifndef SHAPES_CONE_EXACT_H
#define SHAPES_CONE_EXACT_H

#include "../../stages/last/line.h"

tagged_interval cone_exact_interval(exact_context *c, const sure_ray *ray, const void *shape,
                                    line_coefficients *l);
sure_vec3 cone_round_normal(exact_context *c, const sure_ray *ray, const void *shape,
                            const line_coefficients *l, tagged_end at);
int cone_side_of(exact_context *c, const void *shape, sure_vec3 p);

#endif
