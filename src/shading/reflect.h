/* The reflection stem's formula, for the stems that mirror. */
#ifndef SHADING_REFLECT_H
#define SHADING_REFLECT_H

#include "../geometry/project.h"

/* The part of V along N is kept, the rest is turned round:
 * R = proj_N V - (V - proj_N V) = 2 proj_N V - V.
 */
#ifndef SURE_STABLE
static inline vec3 reflect(vec3 v, vec3 n)
{
    return vec3_sub(vec3_scale(2, project(v, n)), v);
}
#else
/* Stable: 2 proj_N V may overflow where R does not. */
static inline vec3 reflect(vec3 v, vec3 n)
{
    if (project_is_moderate(v, n))
        return vec3_sub(vec3_scale(2, project_in_range(v, n)), v);
    vec3 near = vec3_near_one(v), along = project_in_range(near, vec3_near_one(n));
    return scale_vector(vec3_sub(vec3_scale(2, along), near), scale_exponent(scale_largest(v)));
}
#endif

#endif
