/* SPDX-License-Identifier: MIT */
/* The projection stem's formula, for the stems that project. */
#pragma once

#include "../numbers/scale.h"
#include "../numbers/valid.h"

/* proj_N V = k N with (V - k N).N = 0, so k = N.V / N.N. */
static inline real project_factor(vec3 v, vec3 n)
{
    return vec3_dot(n, v) / vec3_dot(n, n);
}

/* What is asked on entry and can be told: without powers of two taken out, what is not finite or
 * overflows leaves no finite k. One that underflows may be that of vectors at right angles. */
static inline bool project_entry_ok(sure_vec3 v, sure_vec3 n)
{
#ifdef SURE_STABLE
    return all_finite(v) && direction_ok(n);
#else
    vec3 to = vec3_from(n), from = vec3_from(v);
    return scale_is_in_range(vec3_dot(to, to)) && REAL(fabs)(project_factor(from, to)) <= REAL_MAX;
#endif
}

/* A formula of V and N that is as long as V, whatever the length of N. Stable: of an N near one,
 * and where V may not stay as it is of such a V, whose length is put back. */
static inline vec3 project_scaled(vec3 (*formula)(vec3, vec3), vec3 v, vec3 n)
{
#ifdef SURE_STABLE
    n = vec3_near_one(n);
    if (!scale_is_moderate(vec3_dot(v, v)))
        return scale_vector(formula(vec3_near_one(v), n), scale_exponent(scale_largest(v)));
#endif
    return formula(v, n);
}

static inline vec3 project_in_range(vec3 v, vec3 n)
{
    return vec3_scale(project_factor(v, n), n);
}

static inline vec3 project(vec3 v, vec3 n)
{
    return project_scaled(project_in_range, v, n);
}
