/* The projection stem's formula, for the stems that project. */
#ifndef GEOMETRY_PROJECT_H
#define GEOMETRY_PROJECT_H

#include "vec3.h"

/* proj_N V = k N with (V - k N).N = 0, so k = N.V / N.N. */
static inline vec3 project(vec3 v, vec3 n)
{
    return vec3_scale(vec3_dot(n, v) / vec3_dot(n, n), n);
}

#endif
