#include "tier_functions.h"

#include <stddef.h>

/* The numbers of a case are ray and object as they lie in memory. */
_Static_assert(offsetof(sure_ray, t_max) == 7 * sizeof(double), "a ray's");

#define FUNCTIONS(shape, tier)                                                                     \
    static int shape##_##tier(const void *ray, const void *object, void *to)                       \
    {                                                                                              \
        return (int)sure_##shape##_hit_##tier(ray, object, &((tier_output *)to)->hit);             \
    }                                                                                              \
    static int shape##_##tier##_normal(const void *ray, const void *object, void *to)              \
    {                                                                                              \
        tier_output *of = to;                                                                      \
        int status = shape##_##tier(ray, object, to);                                              \
        if (status == SURE_HIT)                                                                    \
            of->normal = sure_##shape##_normal_##tier(ray, object, &of->hit);                      \
        return status;                                                                             \
    }

#define TIERS(X, shape)                                                                            \
    X(shape, float32) X(shape, textbook) X(shape, stable) X(shape, certain) X(shape, exact)

#define ALL_FUNCTIONS(shape, SHAPE) TIERS(FUNCTIONS, shape)
SURE_EACH_SHAPE(ALL_FUNCTIONS)

#define BOTH(shape, tier) {shape##_##tier, shape##_##tier##_normal},
#define ALL_TIERS(shape, SHAPE) {TIERS(BOTH, shape)},
static tier_function *const functions[SURE_SHAPES][SURE_TIERS][2] = {SURE_EACH_SHAPE(ALL_TIERS)};

tier_function *tier_function_of(sure_tier tier, sure_shape shape, bool with_normals)
{
    return functions[shape][tier][with_normals];
}
