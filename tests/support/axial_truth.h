/* The chord of a line in a cylinder or cone by numbers wide enough to be exact, from formulas of
 * its own: scalar products only. */
#ifndef SUPPORT_AXIAL_TRUTH_H
#define SUPPORT_AXIAL_TRUTH_H

#include "filter_suite.h"

typedef struct {
    mpfr_t ends[2];
    end_kind at[2];
} axial_truth;

void axial_truth_init(axial_truth *truth);
void axial_truth_clear(axial_truth *truth);

/* False where the line misses, is parallel to axis or generator, or across the axis. Entry: a valid
 * cylinder or cone. */
bool axial_truth_of(const sure_case *asked, axial_truth *truth);

/* The steps of a polish from places at all distances from each end: prints the worst error/bound of
 * steps that are certain; fails above 1. */
void axial_steps(sure_shape shape, polish_step (*step)(const sure_case *, end_kind at, double t));

/* Are the ends of a chord the points that the filter says, with the parts that these are on? */
void axial_points(const filter_subject *subject);

/* The bound of the discriminant: the greatest radius at which a line is said to miss, found by
 * bisection in every rounding mode. Does it miss? */
void axial_edges(const filter_subject *subject);

/* The bound of the wall's t: numbers of a case changed at random, kept where error/bound of an end
 * on the wall grows. Prints the greatest found; fails above 1. */
void axial_search(const filter_subject *subject);

/* The filter's discriminant, and whether it says that this is certain; its square is then more than
 * `certain`. */
typedef bool axial_discriminant(const sure_case *, double *value, double *certain);

/* Uphill to the greatest error of a certain discriminant over the root of `certain`. Prints it;
 * fails above 1. */
void axial_discriminants(sure_shape shape, axial_discriminant *terms);

#endif
