/* Cases in another order, for times: a branch predictor learns even thousands of cases that come in
 * the same order, by one routine or by another. */
#ifndef JUDGE_SHUFFLE_H
#define JUDGE_SHUFFLE_H

#include "case.h"
#include "draw.h"

void shuffle(sure_case *cases, int count, draws *d);

#endif
