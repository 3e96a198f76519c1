/* SPDX-License-Identifier: MIT */
/* A shader's function, in float as it is: what GLSL has and C has not is said before it is
 * included. To be judged:
 *
 *     cc -O2 -shared -fPIC -Iinclude docs/examples/shader.c -o shader.so -lm
 *     ./run judge --candidate ./shader.so
 */
#include <math.h>
#include <surehit/candidate.h>

typedef float vec3 __attribute__((vector_size(16))); /* GCC and Clang: + - * as in GLSL */
#define vec3(at) ((vec3){(at)[0], (at)[1], (at)[2]})
#define sqrt sqrtf

static float dot(vec3 a, vec3 b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

#include "sphere.glsl"

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

int sure_candidate_sphere_float(const float *ray, const float *object,
                                sure_candidate_hit_float *hit)
{
    float t = sphere(vec3(ray), vec3(ray + 3), ray[6], ray[7], vec3(object), object[3]);
    if (t < 0)
        return SURE_CANDIDATE_MISS;
    hit->t = t;
    return SURE_CANDIDATE_HIT;
}
