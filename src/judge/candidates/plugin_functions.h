/* SPDX-License-Identifier: MIT */
/* The functions that a shared library defines, or that a tier has as if it were one. */
#pragma once

#include "plugin.h"

#include <surehit/floats.h>

/* Pointers to doubles, floats and outputs are handed on alike, as pointers to anything. */
typedef int one_routine(const void *ray, const void *object, void *hit);
typedef int decision_routine(const void *ray, const void *object);
typedef void many_routine(int count, const void *rays, const void *objects, int *statuses,
                          void *hits);
typedef void *build_routine(const void *object);
typedef void free_routine(const void *prepared);

/* NULL where there is none. Who builds objects is asked about these, one by one. */
typedef struct {
    one_routine *one;
    decision_routine *decide; /* in its place, of queries that only decide */
    many_routine *many;
    build_routine *build;
    free_routine *free;
} functions;

/* A tier's output, and in floats. */
typedef struct {
    sure_hit hit;
    sure_vec3 normal;
} tier_output;

typedef struct {
    sure_hit_f hit;
    sure_float_vec3 normal;
} tier_output_float;

/* Of each query, shape and precision. */
typedef functions function_table[QUERIES][SURE_SHAPES][2];

/* False after the answers' message. */
bool functions_find(const plugin_source *from, function_table of, plugin_answers *to);
