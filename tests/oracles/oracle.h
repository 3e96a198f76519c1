/* SPDX-License-Identifier: MIT */
/* The oracles behind one face: bisection, and CGAL's reference where that is built. */
#pragma once

#include "bisection_result.h"

#ifdef WITH_REFERENCE
enum { ORACLES = 2 };
#else
enum { ORACLES = 1 };
#endif

typedef struct {
    const char *name;
    bisection_result (*answer)(const sure_case *);
    /* The sign of t* - x. Entry: a hit. */
    int (*compare)(const sure_case *, double x);
    /* Of two hits. Entry: both are hit. */
    int (*order)(const sure_ray *, const sure_object *, const sure_object *);
} oracle;

extern const oracle oracles[ORACLES];
