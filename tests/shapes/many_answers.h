/* SPDX-License-Identifier: MIT */
/* What calls for many rays write, byte by byte, and what calls for one would have written there. */
#pragma once

#include "../../src/stages/hits/block.h"

#include "case_floats.h"
#include "suite.h"

#include <string.h>

/* More than a block of the library's. */
enum { MOST = BLOCK + 12, FILLER = 0x5a };

/* What a call may write, and what lies between: all of it is compared. */
typedef struct {
    unsigned char room[MOST][8 * (int)sizeof(double)];
} answers;

/* Where an answer's numbers, doubles or floats, are in its room: off any alignment, too. */
enum { AT_T = 5, AT_ERROR = 14, AT_NORMAL = 25, NORMAL_STEP = 10 };

/* Of floats there is no t_error. */
static sure_hits hits_in(answers *to, bool normals, bool floats)
{
    unsigned char *at = to->room[0];
    const ptrdiff_t stride = sizeof to->room[0];
    sure_hits hits = {
        .status = {at, stride},
        .part = {at + 1, stride},
        .leaves = {at + 2, stride},
        .t = {at + AT_T, stride},
    };
    if (!floats)
        hits.t_error = (sure_number_column){at + AT_ERROR, stride};
    if (normals)
        for (int k = 0; k < 3; k++)
            hits.normal[k] = (sure_number_column){at + AT_NORMAL + NORMAL_STEP * k, stride};
    memset(to, FILLER, sizeof *to);
    return hits;
}

/* A number and the next ones behind it, each to its place. */
static void put(unsigned char *to, const void *from, size_t size, int count)
{
    for (int k = 0; k < count; k++)
        memcpy(to + NORMAL_STEP * k, (const char *)from + (size_t)k * size, size);
}

/* The single call's answer, of doubles and of floats (_f). */
#define ANSWER_ALONE(name, f, question, ask, ask_normal, vector)                                   \
    static void name(const question *q, sure_tier tier, bool normals, unsigned char *to)           \
    {                                                                                              \
        sure_hit##f hit;                                                                           \
        sure_status status = ask;                                                                  \
        to[0] = (unsigned char)status;                                                             \
        if (status != SURE_HIT)                                                                    \
            return;                                                                                \
        to[1] = (unsigned char)hit.part;                                                           \
        to[2] = (unsigned char)hit.leaves;                                                         \
        put(to + AT_T, &hit.t, sizeof hit.t, 1);                                                   \
        PUT_ERROR##f(to);                                                                          \
        if (!normals)                                                                              \
            return;                                                                                \
        vector normal = ask_normal;                                                                \
        put(to + AT_NORMAL, &normal, sizeof hit.t, 3);                                             \
    }
#define PUT_ERROR(to) put((to) + AT_ERROR, &hit.t_error, sizeof hit.t_error, 1)
#define PUT_ERROR_f(to) (void)0
ANSWER_ALONE(answer_alone, , sure_case, sure_object_hit(&q->ray, &q->object, tier, &hit),
             sure_object_normal(&q->ray, &q->object, tier, &hit), sure_vec3)
ANSWER_ALONE(answer_floats, _f, float_query, float_query_hit(q, tier, &hit),
             float_query_normal(q, tier, &hit), sure_float_vec3)

/* The next case of `typical` whose ray says `is` of the object, or, if that is NULL, of its own. */
static inline sure_case case_that(sure_shape shape, const sure_object *object, sure_status is,
                                  uint64_t *next)
{
    sure_case one;
    sure_hit hit;
    do
        one = regime_case(shape, REGIME_TYPICAL, 1, ++*next);
    while (sure_object_hit(&one.ray, object ? object : &one.object, SURE_TIER_CERTAIN, &hit) != is);
    return one;
}
