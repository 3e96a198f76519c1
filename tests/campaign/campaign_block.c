/* SPDX-License-Identifier: MIT */
#include "campaign_block.h"

#include <surehit/many.h>

#include <string.h>

enum { BLOCK = 9 }; /* in no lanes as a whole */

typedef struct {
    uint8_t status[BLOCK], part[BLOCK], leaves[BLOCK];
    unsigned char t[BLOCK * sizeof(double)];
} answers;

/* t: of so many bytes. */
static sure_hits hits_in(answers *to, size_t size)
{
    return (sure_hits){.status = {to->status, 1},
                       .part = {to->part, 1},
                       .leaves = {to->leaves, 1},
                       .t = {to->t, (ptrdiff_t)size}};
}

static bool are_all(const answers *given, sure_status status, const void *t, size_t size,
                    sure_part part, int leaves)
{
    for (size_t i = 0; i < BLOCK; i++) {
        if (given->status[i] != status)
            return false;
        if (status == SURE_HIT && !(memcmp(given->t + i * size, t, size) == 0 &&
                                    given->part[i] == part && given->leaves[i] == leaves))
            return false;
    }
    return true;
}

bool is_same_in_a_block(const sure_case *q, sure_status status, const sure_hit *hit)
{
    answers given;
    const sure_hits hits = hits_in(&given, sizeof hit->t);
    const sure_rays rays = sure_rays_of(&q->ray, 0);
    const sure_objects objects = sure_objects_of(q->object.shape, &q->object.as, 0);
    sure_objects_hits(BLOCK, &rays, &objects, SURE_TIER_CERTAIN, &hits);
    return are_all(&given, status, &hit->t, sizeof hit->t, hit->part, hit->leaves);
}

bool is_same_in_a_block_of_floats(const float_query *q, sure_status status, const sure_hit_f *hit)
{
    answers given;
    const sure_hits hits = hits_in(&given, sizeof hit->t);
    const sure_rays rays = sure_rays_of_f(&q->ray, 0);
    const sure_objects objects = sure_objects_of_f(q->shape, q->object, 0);
    sure_objects_hits_certain_f(BLOCK, &rays, &objects, &hits);
    return are_all(&given, status, &hit->t, sizeof hit->t, hit->part, hit->leaves);
}
