/* SPDX-License-Identifier: MIT */
/* A candidate that is a function of whoever holds the judge: of a script, in a page. */
#pragma once

#include "candidate.h"

/* Cases as exchange_numbers writes them (shape, count, then so many cases), and room for as many
 * answers of EXCHANGE_ANSWER doubles (docs/coprocess.md). Returns how many it answered: it crashed
 * in the case after these, where they are fewer. */
typedef int candidate_callback(void *context, const double *questions, double *answers);

/* It is asked for hits, of any shape. NULL after a message. */
candidate *candidate_of_callback(candidate_callback *answer, void *context,
                                 const candidate_options *how, char *message);
