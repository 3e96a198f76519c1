/* SPDX-License-Identifier: MIT */
/* Walkers that go side by side, so that truth and routine are asked of many cases at once. */
#pragma once

#include "walk.h"

enum { CROWD = 64, CROWD_CASES = CROWD * WALK_SOLIDS };

typedef struct {
    walk_step last; /* the one that led here; met -1: the walk begins */
    setting in;
    sure_ray ray;
    int side[WALK_SOLIDS];             /* of the start, as it should be, then as it is */
    case_answer ahead[WALK_SOLIDS];    /* the truth, */
    sure_status behind[WALK_SOLIDS];   /* ... and of the backward ray */
    sure_status answered[WALK_SOLIDS]; /* by the routine, */
    sure_hit hits[WALK_SOLIDS];
    bool is_asked; /* it may be, by its entry */
    rng g;
} walker;

typedef struct {
    const walk_routine *by;
    truth *known;
    sure_shape shape;
    walk_kind kind;
    walker walkers[CROWD];
    sure_case ahead[CROWD_CASES], behind[CROWD_CASES];
    case_answer answers[CROWD_CASES];
    sure_status statuses[CROWD_CASES];
    walk_sum sum;
    char message[CANDIDATE_MESSAGE];
} crowd;

/* What a walker is asked of a solid, or of the other way. */
sure_case case_of(const walker *w, int solid, sure_vec3 direction);

/* What is there in truth; false after a message. */
bool ask_truth(crowd *all);

/* What the routine says. */
void ask_routine(crowd *all);
