/* How far a right decision's t and normal are from the true ones, as the judge measures it. */
#ifndef JUDGE_ERROR_SIZE_H
#define JUDGE_ERROR_SIZE_H

#include "reply.h"

/* The precision that a candidate answers in. */
typedef enum { PRECISION_DOUBLE, PRECISION_FLOAT } precision;

/* How many steps from one double (float) to the next lead from x to the one next to the truth,
 * which is known to the nearest double: 0 exactly when x is correctly rounded. Where that double is
 * halfway between two floats, either will do. Infinite for a NaN. -0 is 0, and infinity follows the
 * largest finite number. */
double error_ulps(double x, double truth, precision of);

/* |x - truth| / |truth|: 0 for the same, infinite against a truth of 0. */
double error_relative(double x, double truth);

/* The largest difference of two components. */
double error_normal(sure_vec3 normal, sure_vec3 truth);

/* The same in ulps of its length 1, ... */
double error_normal_ulps(double error, precision of);

/* ... and whether each component is the one next to the truth. */
bool error_normal_none(sure_vec3 normal, sure_vec3 truth, precision of);

#endif
