/* SPDX-License-Identifier: MIT */
/* A failing case made simple: zeros, ones, fewer mantissa bits, smaller exponents, as long as it
 * fails. */
#pragma once

#include "../cases/case.h"

typedef bool case_fails(const sure_case *question, void *context);

/* The simplest case found for which fails() still holds; `question` itself must fail. Coarsely:
 * mantissas are cut to some numbers of bits only, which takes a third of the tries. */
sure_case shrink_case(const sure_case *question, bool coarsely, case_fails *fails, void *context);

/* What is held against the tier exact: status, field and part; every bit of the answer; or what
 * `certain` promises: the decision, t in range and within t_error, the normal's bound. */
typedef enum { AGAINST_DECISION, AGAINST_ANSWER, AGAINST_PROMISE } against;

/* False: the tier answers rightly. Else *simple is the simplest case found that it answers wrongly
 * in the same way. */
bool tier_failure_simple(const sure_case *question, sure_tier tier, against by, sure_case *simple);
