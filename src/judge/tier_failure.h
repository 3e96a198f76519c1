/* A case that a tier answers wrongly, `exact` being right, made simple. */
#ifndef JUDGE_TIER_FAILURE_H
#define JUDGE_TIER_FAILURE_H

#include "../cases/case.h"

/* What is held against the tier exact: status, field and part; every bit of the answer; or what
 * `certain` promises: the decision, t in range and within t_error, the normal's bound. */
typedef enum { AGAINST_DECISION, AGAINST_ANSWER, AGAINST_PROMISE, AGAINSTS } against;

/* False: the tier answers rightly. Else *simple is the simplest case found that it answers wrongly
 * in the same way. */
bool tier_failure_simple(const sure_case *question, sure_tier tier, against by, sure_case *simple);

#endif
