/* SPDX-License-Identifier: MIT */
/* The reflection stem's formula, for the stems that mirror. */
#pragma once

#include "../geometry/project.h"

/* The part of V along N is kept, the rest is turned round:
 * R = proj_N V - (V - proj_N V) = 2 proj_N V - V.
 */
static inline vec3 reflect_in_range(vec3 v, vec3 n)
{
    return vec3_sub(vec3_scale(2, project_in_range(v, n)), v);
}

/* Scaled as a whole: 2 proj_N V may overflow where R does not. */
static inline vec3 reflect(vec3 v, vec3 n)
{
    return project_scaled(reflect_in_range, v, n);
}
