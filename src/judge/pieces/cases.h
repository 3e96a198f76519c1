/* SPDX-License-Identifier: MIT */
/* A judgement in pieces, which are ranges of the cases that each row has. */
#pragma once

#include "../judging_state.h"

/* Which rows there are, by number: query, shape and regime. */
#define PIECE_ROWS (QUERIES * SURE_SHAPES * REGIMES)

/* CUT_GOES_ON with all cases in the ledgers of these rows, where the judgement is cut; else an exit
 * status (cut.h). */
int cases_do(judging *by, const bool rows[PIECE_ROWS], char *message);
