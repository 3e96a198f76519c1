/* SPDX-License-Identifier: MIT */
/* A block that is one case, some times over: is every answer that of the single call, which is
 * given? */
#pragma once

#include "../../src/cases/case_floats.h"

bool is_same_in_a_block(const sure_case *q, sure_status status, const sure_hit *hit);
bool is_same_in_a_block_of_floats(const float_query *q, sure_status status, const sure_hit_f *hit);
