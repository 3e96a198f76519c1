/* SPDX-License-Identifier: MIT */
/* What was counted in a row, as a result of a piece has it, and its sum with that of other cases:
 * the same as if all had been counted together. */
#pragma once

#include "../judging_state.h"

#include <jansson.h>

/* NULL: no memory. */
json_t *ledger_json(const ledger *of);

/* Adds what was counted of other cases of that row. Returns what is wrong, or NULL. */
const char *ledger_add_json(ledger *to, const json_t *from);
