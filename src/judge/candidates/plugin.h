/* A shared library in a process of its own: what that process and the judge have in common. The
 * judge writes questions and a request and sends a byte; the child answers, leaves its outputs as
 * the routine wrote them, and sends a byte back. */
#ifndef JUDGE_PLUGIN_H
#define JUDGE_PLUGIN_H

#include <surehit/candidate.h>

#include "candidate.h"
#include "tier_functions.h"

#define PLUGIN_BLOCK 512 /* all of it stays in the cache */
#define PLUGIN_RAY 8          /* numbers of a ray */
#define PLUGIN_OBJECT 7       /* the most of an object */
#define PLUGIN_PASSES 2       /* every case is asked twice */
#define PLUGIN_NO_STATUS (-1) /* what statuses hold before */

/* Read-only in the child. */
typedef struct {
    sure_shape shape;
    precision in;
    int first, count; /* the cases to be asked */
    double rays[PLUGIN_BLOCK * PLUGIN_RAY], objects[PLUGIN_BLOCK * PLUGIN_OBJECT];
    float rays_float[PLUGIN_BLOCK * PLUGIN_RAY], objects_float[PLUGIN_BLOCK * PLUGIN_OBJECT];
} plugin_questions;

typedef struct {
    /* Once it is loaded: which functions there are, or what is wrong. */
    bool has[SURE_SHAPES][2]; /* of shape and precision */
    char message[CANDIDATE_MESSAGE];

    /* Which case is being asked; -1 where several are at once. */
    volatile int at;
    volatile unsigned progress; /* changes with every call that has come back */

    double nanoseconds; /* of the faster pass */
    bool leaked[PLUGIN_BLOCK];
    int statuses[PLUGIN_PASSES][PLUGIN_BLOCK];
    union {
        sure_candidate_hit of_double[PLUGIN_BLOCK];
        sure_candidate_hit_float of_float[PLUGIN_BLOCK];
        tier_output of_tier[PLUGIN_BLOCK];
    } hits[PLUGIN_PASSES];
} plugin_answers;

/* What a hit holds before: everything is a NaN of these bits and the part is REPLY_NO_PART. */
#define PLUGIN_UNTOUCHED UINT64_C(0x7ff4a5a5a5a5a5a5)
#define PLUGIN_UNTOUCHED_FLOAT UINT32_C(0x7fa5a5a5)

/* Where the functions come from: a shared library, or a tier as if it were one. */
typedef struct {
    const char *path; /* NULL: the tier */
    sure_tier tier;
    bool with_normals; /* the tier's */
} plugin_source;

/* The child's whole life: finds the functions, then answers each byte from `requests` by one to
 * `results`. */
_Noreturn void plugin_child(const plugin_source *from, const plugin_questions *questions,
                            plugin_answers *answers, int requests, int results);

#endif
