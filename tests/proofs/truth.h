/* SPDX-License-Identifier: MIT */
/* What the exact tier says, in doubles. */
#pragma once

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct truth {
    bool meets, ahead; /* does the line meet the object, and the ray from t_min on? */
    double t[2];       /* where the line enters and leaves it */
    int part[2];
    bool hits; /* does the ray, in its range, and where? */
    double hit_t;
    int hit_part;
};

/* Of a query's numbers; false where they are no valid one. */
bool truth_of(const double *inputs, int shape, struct truth *truth);

#ifdef __cplusplus
}
#endif
