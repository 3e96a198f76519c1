/* SPDX-License-Identifier: MIT */
/* A shared library in a process of its own: what that process and the judge have in common. The
 * judge writes questions and a request and sends a byte; the child answers and sends a byte back.
 */
#pragma once

#include "candidate.h"

/* Waking each other takes little then. */
#define PLUGIN_BLOCK BLOCK_CASES
#define PLUGIN_RAY 8    /* numbers of a ray */
#define PLUGIN_OBJECT 7 /* the most of an object */

/* In the precision that is asked. */
typedef union {
    double of_double[PLUGIN_BLOCK * PLUGIN_RAY];
    float of_float[PLUGIN_BLOCK * PLUGIN_RAY];
} plugin_numbers;
_Static_assert(PLUGIN_OBJECT <= PLUGIN_RAY && CASE_NUMBERS_MAX == PLUGIN_RAY + PLUGIN_OBJECT,
               "room for any object");

/* Read-only in the child. */
typedef struct {
    sure_shape shape;
    query asks;
    precision in;
    int count;
    int passes; /* how often each is asked: 2, or 1 */
    plugin_numbers rays, objects;
} plugin_questions;

typedef struct {
    /* Once it is loaded: which functions there are, or what is wrong. */
    bool has[QUERIES][SURE_SHAPES][2]; /* of shape and precision */
    char message[CANDIDATE_MESSAGE];
    char entry[CANDIDATE_MESSAGE]; /* its conditions; "" */
    identity who;

    /* Which case is being asked; -1 where several are at once. */
    volatile int at;
    volatile unsigned progress; /* changes with every call that has come back */

    double nanoseconds; /* of the faster pass */
    double building;    /* likewise, of objects that are prepared */
    reply replies[PLUGIN_BLOCK];
} plugin_answers;

/* Where the functions come from: a shared library, or a tier as if it were one. */
typedef struct {
    const char *path; /* NULL: the tier */
    sure_tier tier;
    bool with_normals; /* the tier's */
} plugin_source;

/* Of a tier: has it functions that take floats for this (surehit/floats.h)? Others are asked the
 * same numbers as doubles. */
static inline bool tier_takes_floats(sure_tier tier, query asks)
{
    return tier >= SURE_TIER_CERTAIN && asks == QUERY_HIT;
}

/* The child's whole life: finds the functions, then answers each byte from `requests` by one to
 * `results`. */
_Noreturn void plugin_child(const plugin_source *from, const plugin_questions *questions,
                            plugin_answers *answers, int requests, int results);
