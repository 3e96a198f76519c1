/* SPDX-License-Identifier: MIT */
/* A candidate for the queries besides hit, as wrong.c is one for hits; with -DFLOAT in float, with
 * -DPREPARED with objects that are built (copies of their numbers). */
#include "wrong.h"

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

#ifdef FLOAT
typedef sure_candidate_interval_float ends;
#define IN(name) name##_float
#else
typedef sure_candidate_interval ends;
#define IN(name) name
#endif

static int misanswer(int status)
{
    static int count;
    if (is_wrong("refuses"))
        return SURE_CANDIDATE_INVALID;
    if (is_wrong("garbage"))
        return 7;
    if (is_wrong("changes"))
        return ++count % 2;
    if (is_wrong("false hit") && status == SURE_CANDIDATE_MISS)
        return SURE_CANDIDATE_HIT;
    if (is_wrong("false miss") && status == SURE_CANDIDATE_HIT)
        return SURE_CANDIDATE_MISS;
    return status;
}

static int occluded(sure_shape shape, const real *ray, const real *numbers)
{
    const sure_ray asked = {vector(ray), vector(ray + 3), ray[6], ray[7]};
    const sure_object object = object_of(shape, numbers);
    int status = (int)sure_object_occluded(&asked, &object, SURE_TIER_EXACT);
    return is_now(ray, 8) ? misanswer(status) : status;
}

static void write_ends(int is_now, const real *ray, const sure_interval *chord, ends *to)
{
    to->t_enter = (real)chord->t_enter;
    to->t_leave = (real)chord->t_leave;
    if (is_wrong("clips") && to->t_enter < ray[6])
        to->t_enter = ray[6];
    if (is_now && is_wrong("nan"))
        to->t_leave = (real)NAN;
    if (is_now && is_wrong("3 ulps"))
        to->t_leave = nextreal(nextreal(nextreal(to->t_leave, 0), 0), 0);
}

static int interval(sure_shape shape, const real *ray, const real *numbers, ends *to)
{
    const sure_ray asked = {vector(ray), vector(ray + 3), ray[6], ray[7]};
    const sure_object object = object_of(shape, numbers);
    sure_interval chord = {0};
    int status = (int)sure_object_interval(&asked, &object, SURE_TIER_EXACT, &chord);
    int now = is_now(ray, 8);
    if (now)
        status = misanswer(status);
    if (now && is_wrong("one end") && status == SURE_CANDIDATE_HIT)
        to->t_leave = (real)chord.t_leave;
    else if (status == SURE_CANDIDATE_HIT || (now && is_wrong("touches")))
        write_ends(now, ray, &chord, to);
    return status;
}

/* It is asked for a point, and no more can be read. */
static int inside(sure_shape shape, const real *point, const real *numbers)
{
    const sure_ray at = {vector(point), {0, 0, 1}, 0, 0};
    const sure_object object = object_of(shape, numbers);
    sure_interval chord;
    int status = (int)sure_object_interval(&at, &object, SURE_TIER_EXACT, &chord);
    if (is_wrong("open") && sure_object_occluded(&at, &object, SURE_TIER_EXACT) == SURE_HIT)
        return SURE_CANDIDATE_MISS;
    return is_now(point, 3) ? misanswer(status) : status;
}

#ifdef PREPARED
#define OBJECT void *object
#define NAMED(shape, query) IN(sure_candidate_##shape##_##query##_prepared)
#define BUILD(shape, SHAPE)                                                                        \
    void *IN(sure_candidate_##shape##_new)(const real *numbers)                                    \
    {                                                                                              \
        size_t size = (size_t)sure_shape_info_of(SURE_SHAPE_##SHAPE)->numbers * sizeof *numbers;   \
        return memcpy(malloc(size), numbers, size);                                                \
    }                                                                                              \
    void sure_candidate_##shape##_free(void *object)                                               \
    {                                                                                              \
        free(object);                                                                              \
    }
SURE_EACH_SHAPE(BUILD)
#else
#define OBJECT const real *object
#define NAMED(shape, query) IN(sure_candidate_##shape##_##query)
#endif

#define DEFINE(shape, SHAPE)                                                                       \
    int NAMED(shape, occluded)(const real *ray, OBJECT)                                            \
    {                                                                                              \
        return occluded(SURE_SHAPE_##SHAPE, ray, object);                                          \
    }                                                                                              \
    int NAMED(shape, interval)(const real *ray, OBJECT, ends *to)                                  \
    {                                                                                              \
        return interval(SURE_SHAPE_##SHAPE, ray, object, to);                                      \
    }                                                                                              \
    int NAMED(shape, inside)(const real *point, OBJECT)                                            \
    {                                                                                              \
        return inside(SURE_SHAPE_##SHAPE, point, object);                                          \
    }

SURE_EACH_SHAPE(DEFINE)
