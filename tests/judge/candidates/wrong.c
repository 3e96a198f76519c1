/* SPDX-License-Identifier: MIT */
/* A candidate that answers right and does one thing wrong, now and then: the one that the variable
 * SUREHIT_WRONG names, behind `always` or `rarely` where it is to be so often. Compiled one case at
 * a time, with -DMANY many at a time, with -DFLOAT in float, with -DPREPARED with objects that are
 * built; as a program with program.c. */
#define _POSIX_C_SOURCE 200809L /* sleep, clock_gettime */

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "wrong.h"
#include "../../../src/geometry/coordinate.h"
#include "../../../src/support/cpu_time.h"

#ifndef VERSION
#define VERSION SURE_CANDIDATE_VERSION
#endif
const int sure_candidate_version = VERSION;

#ifdef SPHERE_ALONE
const char sure_candidate_name[] = "Spheres & <co>", sure_candidate_release[] = "2.1";
#endif

static void write_hit(const sure_ray *ray, const sure_object *object, const sure_hit *hit,
                      outputs *to)
{
    sure_vec3 normal = sure_object_normal(ray, object, SURE_TIER_EXACT, hit);
    to->t = (real)hit->t;
    to->part = (int)hit->part;
    for (int i = 0; i < 3; i++)
        to->normal[i] = (real)coordinate(normal, i);
}

static int right(sure_shape shape, const real *numbers, const real *of, outputs *to)
{
    sure_ray ray = {vector(numbers), vector(numbers + 3), numbers[6], numbers[7]};
    sure_object object = object_of(shape, of);
    sure_hit hit;
    switch (sure_object_hit(&ray, &object, SURE_TIER_EXACT, &hit)) {
    case SURE_HIT: write_hit(&ray, &object, &hit, to); return SURE_CANDIDATE_HIT;
    case SURE_MISS: return SURE_CANDIDATE_MISS;
    default: return SURE_CANDIDATE_INVALID;
    }
}

static void *volatile kept;
static int *volatile nowhere;

/* 10 microseconds, by the clock that it is timed by. */
static void take_long(void)
{
    const double begun = cpu_time();
    while (cpu_time() - begun < 10000)
        continue;
}

/* What ends it or does not show in the answer. */
static void misbehave(const real *ray)
{
    if (is_wrong("crashes"))
        *nowhere = 0;
    if (is_wrong("aborts"))
        abort();
    if (is_wrong("exits"))
        exit(3);
    if (is_wrong("exits quietly"))
        _exit(0);
    if (is_wrong("hangs"))
        for (;;)
            sleep(1);
    if (is_wrong("leaks"))
        kept = malloc(100);
    if (is_wrong("frees")) {
        kept = malloc(100);
        free(kept);
    }
    if (is_wrong("writes its input"))
        *(volatile real *)(uintptr_t)ray = 1;
}

static int misanswer_hit(const real *ray, outputs *to)
{
    if (is_wrong("false miss"))
        return SURE_CANDIDATE_MISS;
    if (is_wrong("part"))
        to->part ^= 1;
    if (is_wrong("nan"))
        to->t = (real)NAN;
    if (is_wrong("nan in the normal"))
        to->normal[1] = (real)NAN;
    if (is_wrong("range"))
        to->t = nextreal(ray[6], (real)-INFINITY);
    if (is_wrong("3 ulps"))
        to->t = nextreal(nextreal(nextreal(to->t, 0), 0), 0);
    if (is_wrong("normal"))
        to->normal[0] += (real)0x1p-20;
    return SURE_CANDIDATE_HIT;
}

static int misanswer(const real *ray, int status, outputs *to)
{
    static int count;
    if (is_wrong("refuses"))
        return SURE_CANDIDATE_INVALID;
    if (is_wrong("garbage"))
        return 7;
    if (is_wrong("changes") && ++count > 10)
        return status == SURE_CANDIDATE_MISS ? SURE_CANDIDATE_INVALID : SURE_CANDIDATE_MISS;
    if (status == SURE_CANDIDATE_HIT)
        return misanswer_hit(ray, to);
    if (is_wrong("false hit") && status == SURE_CANDIDATE_MISS) {
        to->t = ray[6];
        return SURE_CANDIDATE_HIT;
    }
    if (is_wrong("accepts"))
        return SURE_CANDIDATE_MISS;
    return status;
}

/* The answer of the case before, if that was a hit as well. */
static void remember(int status, outputs *to)
{
    static outputs last;
    static int was_hit;
    outputs mine = *to;
    if (status == SURE_CANDIDATE_HIT && was_hit)
        to->t = last.t;
    was_hit = status == SURE_CANDIDATE_HIT;
    last = mine;
}

static int answer(sure_shape shape, const real *ray, const real *object, outputs *to)
{
    outputs mine = *to, untouched = *to;
    if (is_wrong("is slow"))
        take_long();
    if (is_now(ray, 8))
        misbehave(ray);
    if (is_wrong("leaks always"))
        kept = memset(malloc(1000), 1, 1000);
    int status = right(shape, ray, object, &mine);
    if (is_wrong("remembers"))
        remember(status, &mine);
    if (is_now(ray, 8))
        status = misanswer(ray, status, &mine);
    if (status == SURE_CANDIDATE_HIT)
        *to = mine;
    if (is_now(ray, 8) && is_wrong("no t"))
        *to = untouched;
    if (is_now(ray, 8) && is_wrong("touches"))
        to->normal[2] = 0;
    return status;
}

#ifdef FLOAT
#define NAMED(name) sure_candidate_##name##_float
#define NAMED_MANY(name) sure_candidate_##name##_many_float
#else
#define NAMED(name) sure_candidate_##name
#define NAMED_MANY(name) sure_candidate_##name##_many
#endif

#ifdef PREPARED
/* An object that is prepared: a copy of its numbers. */
static void *built(sure_shape shape, const real *numbers)
{
    size_t size = (size_t)sure_shape_info_of(shape)->numbers * sizeof *numbers;
    if (is_wrong("crashes while building"))
        abort();
    return is_wrong("builds nothing") ? NULL : memcpy(malloc(size), numbers, size);
}
#endif

#ifdef MANY
#define DEFINE(name, NAME)                                                                         \
    void NAMED_MANY(name)(int count, const real *rays, const real *objects, int *statuses,         \
                          outputs *hits)                                                           \
    {                                                                                              \
        int numbers = sure_shape_info_of(SURE_SHAPE_##NAME)->numbers;                              \
        if (is_wrong("crashes in company") && count > 1)                                           \
            abort();                                                                               \
        for (int i = 0; i < count; i++)                                                            \
            statuses[i] =                                                                          \
                answer(SURE_SHAPE_##NAME, rays + 8 * i, objects + numbers * i, hits + i);          \
    }
#elif defined PREPARED
#define DEFINE(name, NAME)                                                                         \
    void *sure_candidate_##name##_new(const real *object)                                          \
    {                                                                                              \
        return built(SURE_SHAPE_##NAME, object);                                                   \
    }                                                                                              \
    int sure_candidate_##name##_prepared(const real *ray, void *object, outputs *hit)              \
    {                                                                                              \
        return answer(SURE_SHAPE_##NAME, ray, object, hit);                                        \
    }
#else
#define DEFINE(name, NAME)                                                                         \
    int NAMED(name)(const real *ray, const real *object, outputs *hit)                             \
    {                                                                                              \
        return answer(SURE_SHAPE_##NAME, ray, object, hit);                                        \
    }
#endif

#ifdef SPHERE_ALONE
DEFINE(sphere, SPHERE)
#else
SURE_EACH_SHAPE(DEFINE)
#endif

#if defined PREPARED && !defined HALF
#define DEFINE_FREE(name, NAME)                                                                    \
    void sure_candidate_##name##_free(void *object)                                                \
    {                                                                                              \
        if (!is_wrong("keeps objects"))                                                            \
            free(object);                                                                          \
    }
SURE_EACH_SHAPE(DEFINE_FREE)
#endif
