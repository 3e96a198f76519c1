/* SPDX-License-Identifier: MIT */
/* The ray: the points origin + t * direction for t in the closed interval [t_min, t_max]. */
#pragma once

#include <surehit/answer.h>
#include <surehit/vector.h>

SURE_C_BEGIN

typedef struct {
    sure_vec3 origin;    /* o: finite, in the scene's unit of length */
    sure_vec3 direction; /* d: finite, not zero, of any length; t counts multiples of it */
    double t_min;        /* finite, >= 0 */
    double t_max;        /* >= t_min; +infinity allowed */
} sure_ray;

/* The first field of the ray that docs/contract.md calls invalid, or SURE_FIELD_NONE. */
sure_field sure_ray_check(const sure_ray *ray);

SURE_C_END
