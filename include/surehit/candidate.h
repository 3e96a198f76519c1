/* SPDX-License-Identifier: MIT */
/* What a shared library defines to be judged by `surehit judge --candidate ./mine.so`
 * (docs/judge.md). Nothing of surehit is linked, and surehit.h does not include this header.
 *
 * Define sure_candidate_version and the functions of the shapes that you answer, any of them:
 *
 *     #include <surehit/candidate.h>
 *     const int sure_candidate_version = SURE_CANDIDATE_VERSION;
 *     int sure_candidate_sphere(const double *ray, const double *sphere, sure_candidate_hit *hit)
 *     ...
 *     cc -O2 -shared -fPIC mine.c -o mine.so -lm
 *
 * Entry    ray: ox oy oz dx dy dz t_min t_max; then the object's numbers in the order of the case
 *          format and of the shape's struct (docs/contract.md).
 * Returns  SURE_CANDIDATE_HIT and *hit: t, and where the routine knows them part and normal; what
 *          is left alone is not judged. SURE_CANDIDATE_MISS or _INVALID and *hit untouched.
 *
 * Who computes in float defines the _float functions: he is then asked what floats can say, and
 * judged by the floats next to the truth. The _many functions take `count` cases at a time, ray by
 * ray and object by object as above, and write as many statuses and hits.
 *
 * Who builds an object once to ask it often defines _new, which builds it from its numbers (NULL:
 * it is invalid), _free, which frees it, and _prepared, which is asked as above with what was built
 * in the object's place. Building is timed apart.
 *
 * There are other questions than for the first hit, each of them judged by itself:
 *
 *     _occluded   is there a hit at all? HIT or MISS, and no output
 *     _interval   both ends of the chord, of the whole line, HIT where it and [t_min, t_max] have a
 *                 point in common (docs/contract.md)
 *     _inside     is the point in the closed object? HIT or MISS, and no output
 *
 * Names go on in this order: sure_candidate_sphere_interval_prepared_float. */
#pragma once

#include <surehit/shape.h>

SURE_C_BEGIN

#define SURE_CANDIDATE_VERSION 1

#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

extern const int sure_candidate_version;

/* Who can't be asked everything may say so, in words of docs/judge.md, "Entry conditions":
 *
 *     const char sure_candidate_entry[] = "unit local ray touch=miss"; */
extern const char sure_candidate_entry[];

/* Any of these, too: whose routine it is, which version of that, how it was built. The verdict says
 * so.
 *
 *     const char sure_candidate_name[] = "Bullet", sure_candidate_release[] = "3.24"; */
extern const char sure_candidate_name[], sure_candidate_release[], sure_candidate_build[];

enum { SURE_CANDIDATE_MISS, SURE_CANDIDATE_HIT, SURE_CANDIDATE_INVALID };

/* SURE_CANDIDATE_SURFACE of a plane, disc or sphere, SURE_CANDIDATE_BASE, ... */
#define SURE_CANDIDATE_PART(part, PART) SURE_CANDIDATE_##PART = SURE_PART_##PART,
enum { SURE_EACH_PART(SURE_CANDIDATE_PART) };

typedef struct {
    double t;
    int part;
    double normal[3]; /* outward, of length 1 */
} sure_candidate_hit;

typedef struct {
    float t;
    int part;
    float normal[3];
} sure_candidate_hit_float;

typedef struct {
    double t_enter, t_leave;
} sure_candidate_interval;

typedef struct {
    float t_enter, t_leave;
} sure_candidate_interval_float;

/* `how` is nothing or _prepared, `in` nothing or _float. */
#define SURE_CANDIDATE_QUERIES(shape, how, in, real, object)                                       \
    int sure_candidate_##shape##how##in(const real *ray, object, sure_candidate_hit##in *hit);     \
    int sure_candidate_##shape##_occluded##how##in(const real *ray, object);                       \
    int sure_candidate_##shape##_interval##how##in(const real *ray, object,                        \
                                                   sure_candidate_interval##in *interval);         \
    int sure_candidate_##shape##_inside##how##in(const real *point, object);

#define SURE_CANDIDATE_IN(shape, in, real)                                                         \
    SURE_CANDIDATE_QUERIES(shape, , in, real, const real *shape)                                   \
    SURE_CANDIDATE_QUERIES(shape, _prepared, in, real, void *prepared)                             \
    void *sure_candidate_##shape##_new##in(const real *shape);                                     \
    void sure_candidate_##shape##_many##in(int count, const real *rays, const real *shape##s,      \
                                           int *statuses, sure_candidate_hit##in *hits);

#define SURE_CANDIDATE_FUNCTIONS(shape, SHAPE)                                                     \
    void sure_candidate_##shape##_free(void *prepared);                                            \
    SURE_CANDIDATE_IN(shape, , double)                                                             \
    SURE_CANDIDATE_IN(shape, _float, float)

SURE_EACH_SHAPE(SURE_CANDIDATE_FUNCTIONS)

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

SURE_C_END
