/* A failing case made simple: zeros, ones, fewer mantissa bits, smaller exponents, as long as it
 * fails. */
#ifndef JUDGE_SHRINK_H
#define JUDGE_SHRINK_H

#include "../cases/case.h"

typedef bool case_fails(const sure_case *question, void *context);

/* The simplest case found for which fails() still holds; `question` itself must fail. Coarsely:
 * mantissas are cut to some numbers of bits only, which takes a third of the tries. */
sure_case shrink_case(const sure_case *question, bool coarsely, case_fails *fails, void *context);

#endif
