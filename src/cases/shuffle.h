/* Cases in another order, for times: a branch predictor learns even thousands of cases that come in
 * the same order, by one routine or by another. */
#ifndef CASES_SHUFFLE_H
#define CASES_SHUFFLE_H

#include "case.h"
#include "rng.h"

void shuffle(sure_case *cases, int count, rng *g);

#endif
