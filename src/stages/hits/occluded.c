/* SPDX-License-Identifier: MIT */
/* Bits of statuses, for shadows. */
#include "block.h"

#include <surehit/floats.h>

#include <string.h>

_Static_assert(BLOCK % 8 == 0, "whole bytes");

static void move_on(sure_numbers *columns, int count)
{
    for (int k = 0; k < count; k++)
        columns[k].first = (const char *)columns[k].first + BLOCK * columns[k].stride;
}

/* The statuses' bits; how many are invalid. */
static size_t pack(const uint8_t *status, size_t count, uint8_t *mask)
{
    size_t invalid = 0;
    memset(mask, 0, (count + 7) / 8);
    for (size_t i = 0; i < count; i++) {
        mask[i / 8] = (uint8_t)(mask[i / 8] | (status[i] == SURE_HIT) << i % 8);
        invalid += status[i] == SURE_INVALID;
    }
    return invalid;
}

static size_t occluded(size_t count, const sure_rays *rays, const sure_objects *objects,
                       bool of_floats, sure_tier tier, uint8_t *mask)
{
    const int numbers = sure_shape_info_of(objects->shape)->numbers;
    sure_rays ray = *rays;
    sure_objects object = *objects;
    uint8_t status[BLOCK];
    const sure_hits hits = {.status = {status, 1}};
    size_t invalid = 0;
    for (size_t done = 0; done < count; done += BLOCK, mask += BLOCK / 8) {
        const size_t now = count - done < BLOCK ? count - done : BLOCK;
        if (done > 0) {
            move_on(ray.origin, RAY_NUMBERS); /* and the others behind it */
            move_on(object.numbers, numbers);
        }
        if (of_floats)
            sure_objects_hits_certain_f(now, &ray, &object, &hits);
        else
            sure_objects_hits(now, &ray, &object, tier, &hits);
        invalid += pack(status, now, mask);
    }
    return invalid;
}

size_t sure_objects_occluded(size_t count, const sure_rays *rays, const sure_objects *objects,
                             sure_tier tier, uint8_t *mask)
{
    return occluded(count, rays, objects, false, tier, mask);
}

size_t sure_objects_occluded_certain_f(size_t count, const sure_rays *rays,
                                       const sure_objects *objects, uint8_t *mask)
{
    return occluded(count, rays, objects, true, SURE_TIER_CERTAIN, mask);
}
