/* SPDX-License-Identifier: MIT */
/* Builds bounding volume hierarchies, on all cores; the same one whatever their number. */
#pragma once

#include <surehit/scene.h>

#include <stdbool.h>

/* From so many bounded objects on a hierarchy saves more than it costs. */
#define BVH_WORTHWHILE 6

/* How many of the objects have a box. */
size_t bvh_bounded(const sure_object *objects, size_t count);

/* Makes *bvh of valid objects, fewer than 2^32 (free it with bvh_free). False when there is no
 * memory. threads 0: one a core. */
bool bvh_build(const sure_object *objects, size_t count, int threads, sure_bvh *bvh);

void bvh_free(sure_bvh *bvh);

/* What it takes of memory. */
size_t bvh_bytes(const sure_bvh *bvh, size_t objects);

/* Builds one where it is wanted and worthwhile; else NULL, and bvh_free(bvh) is right all the
 * same. */
static inline const sure_bvh *bvh_for(const sure_scene *scene, bool wanted, int threads,
                                      sure_bvh *bvh)
{
    const size_t count = scene->object_count;
    *bvh = (sure_bvh){0};
    bool built = wanted && bvh_bounded(scene->objects, count) >= BVH_WORTHWHILE &&
                 bvh_build(scene->objects, count, threads, bvh);
    return built ? bvh : NULL;
}
