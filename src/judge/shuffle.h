/* Cases in another order, for times: a branch predictor learns even thousands of cases that come in
 * the same order, by one routine or by another. */
#ifndef JUDGE_SHUFFLE_H
#define JUDGE_SHUFFLE_H

#include "../cases/case.h"
#include "../cases/rng.h"

void shuffle(sure_case *cases, int count, draws *d);

#endif
