/* The hit point o + t* d, each coordinate correctly rounded, by numbers so wide that their
 * roundings don't matter, from the definitions of docs/contract.md. */
#ifndef SUPPORT_TRUE_POINT_H
#define SUPPORT_TRUE_POINT_H

#include "case.h"

/* False where numbers alone don't tell which of two points that round to the same t is the hit.
 * Entry: the reference says that there is one, at t when rounded. */
bool true_point(const sure_case *question, double t, double point[3]);

#endif
