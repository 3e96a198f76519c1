/* The tiers' functions as a shared library could have them, so that they can be called and timed as
 * its functions are (plugin.h). */
#ifndef JUDGE_TIER_FUNCTIONS_H
#define JUDGE_TIER_FUNCTIONS_H

#include <surehit/object.h>

#include <stdbool.h>

typedef struct {
    sure_hit hit;
    sure_vec3 normal;
} tier_output;

/* Doubles of ray and object in the order of the case format; the tier_output as sure_*_hit_* leaves
 * it; a sure_status. */
typedef int tier_function(const void *ray, const void *object, void *to);

/* Of the hit alone, or with its normal. */
tier_function *tier_function_of(sure_tier tier, sure_shape shape, bool with_normals);

#endif
