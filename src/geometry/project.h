/* The projection stem's formula, for the stems that project. */
#ifndef GEOMETRY_PROJECT_H
#define GEOMETRY_PROJECT_H

#include "../numbers/scale.h"

/* proj_N V = k N with (V - k N).N = 0, so k = N.V / N.N. */
static inline vec3 project_in_range(vec3 v, vec3 n)
{
    return vec3_scale(vec3_dot(n, v) / vec3_dot(n, n), n);
}

#ifndef SURE_STABLE
static inline vec3 project(vec3 v, vec3 n)
{
    return project_in_range(v, n);
}
#else
/* Stable: for vectors near one, and the length of V put back. */
static inline bool project_is_moderate(vec3 v, vec3 n)
{
    return scale_is_moderate(vec3_dot(v, v)) && scale_is_moderate(vec3_dot(n, n));
}

static inline vec3 project(vec3 v, vec3 n)
{
    if (project_is_moderate(v, n))
        return project_in_range(v, n);
    return scale_vector(project_in_range(vec3_near_one(v), vec3_near_one(n)),
                        scale_exponent(scale_largest(v)));
}
#endif

#endif
