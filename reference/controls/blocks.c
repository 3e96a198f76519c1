/* SPDX-License-Identifier: MIT */
/* The calls for many rays (surehit/many.h, surehit/floats.h) as a candidate: an array of cases at a
 * time. Right in every regime, without conditions. */
#include "../peers/precision.h"

#include <surehit/surehit.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

enum { RAY = 8, AT_ONCE = 301 }; /* numbers; no whole number of any block */

#ifdef PEER_FLOAT
#define MANY(shape) sure_candidate_##shape##_many_float
#define RAYS_OF sure_rays_of_f
#define OBJECTS_OF sure_objects_of_f
#define HITS sure_objects_hits_certain_f
#else
#define MANY(shape) sure_candidate_##shape##_many
#define RAYS_OF sure_rays_of
#define OBJECTS_OF sure_objects_of
#define HITS(count, rays, objects, hits)                                                           \
    sure_objects_hits(count, rays, objects, SURE_TIER_CERTAIN, hits)
#endif

static void answer_some(sure_shape shape, int count, const real *first_ray,
                        const real *first_object, int *statuses, peer_hit *first)
{
    const int numbers = sure_shape_info_of(shape)->numbers;
    const sure_rays rays = RAYS_OF(first_ray, RAY * sizeof(real));
    const sure_objects objects = OBJECTS_OF(shape, first_object, numbers * (int)sizeof(real));
    uint8_t status[AT_ONCE], part[AT_ONCE];
    const sure_hits hits = {.status = {status, 1},
                            .part = {part, 1},
                            .t = {&first->t, sizeof *first},
                            .normal = {{&first->normal[0], sizeof *first},
                                       {&first->normal[1], sizeof *first},
                                       {&first->normal[2], sizeof *first}}};
    HITS((size_t)count, &rays, &objects, &hits);
    for (int i = 0; i < count; i++) {
        statuses[i] = status[i];
        if (status[i] == SURE_HIT)
            first[i].part = part[i];
    }
}

#define ANSWER(shape, SHAPE)                                                                       \
    void MANY(shape)(int count, const real *rays, const real *shape##s, int *statuses,             \
                     peer_hit *hits)                                                               \
    {                                                                                              \
        const int numbers = sure_shape_info_of(SURE_SHAPE_##SHAPE)->numbers;                       \
        for (int i = 0; i < count; i += AT_ONCE)                                                   \
            answer_some(SURE_SHAPE_##SHAPE, count - i < AT_ONCE ? count - i : AT_ONCE,             \
                        rays + i * RAY, shape##s + i * numbers, statuses + i, hits + i);           \
    }
SURE_EACH_SHAPE(ANSWER)
