/* SPDX-License-Identifier: MIT */
/* The laws that the header of every shape numbers, as a check of one case on one tier. */
#pragma once

#include "case.h"

/* The law that the tier breaks on the case, as in "Law 3: exchanging x and y"; NULL for none.
 * *checked counts the laws that the case allowed to be checked (scaling is void where anything
 * over- or underflows). */
const char *shape_law_broken(const sure_case *question, sure_tier tier, unsigned long *checked);
