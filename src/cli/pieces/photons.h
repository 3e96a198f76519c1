/* SPDX-License-Identifier: MIT */
/* A picture's photons in pieces: each result has a share of them. */
#pragma once

#include "../../photons/forward_sum.h"

/* CUT_GOES_ON with all of them in done->sum, which has none; else an exit status (cut.h). */
int photons_do(const forward_plan *plan, forward_sum *done);
