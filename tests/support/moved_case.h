/* SPDX-License-Identifier: MIT */
/* A case in other units, or seen in a mirror: what laws compare it with. */
#pragma once

#include "case.h"

/* Each kind times 2^power of its own; false where that rounds. */
bool case_scaled(const sure_case *c, const int powers[NUMBER_KINDS], sure_case *scaled);

/* Coordinate i of a vector becomes sign[i] times what was coordinate from[i]. */
typedef struct {
    int from[3], sign[3];
} turn;

sure_vec3 vector_turned(sure_vec3 v, const turn *by);
sure_case case_turned(const sure_case *c, const turn *by);
