/* What a first stage promises (src/stages/filter.h), held against numbers wide enough to be
 * exact: in every regime, in every rounding mode, with subnormals kept and flushed. */
#ifndef SUPPORT_FILTER_SUITE_H
#define SUPPORT_FILTER_SUITE_H

#include "../../src/stages/polish.h"
#include "../../src/cases/case.h"

#include <check.h>
#include <mpfr.h>

enum { FILTER_BITS = 4000 };

typedef struct {
    sure_shape shape;
    sure_vec3 (*place)(const sure_case *); /* what the contract measures the distance from, ... */
    double (*size)(const sure_case *);     /* ... and the size that it adds */
    filter_verdict (*filter)(const sure_case *, filter_interval *);
    bool (*polish)(const sure_case *, const filter_end *, double *t);
    polish_step (*step)(const sure_case *, end_kind at, double t);
    /* Both ends of the line's true chord, or false: no point of the object. Entry: valid. */
    bool (*truth)(const sure_case *, mpfr_t enter, mpfr_t leave);
} filter_subject;

/* Prints the worst error/bound, the worst error/limit of the contract, and what stayed uncertain;
 * fails where one is above 1 or an answer is wrong, and where a typical case stays open. */
void filter_promises(const filter_subject *subject);

/* Looks for a violation uphill: numbers of a case changed at random, kept where error/bound grows.
 * Prints the greatest found; fails above 1. */
void filter_search(const filter_subject *subject);

/* A step of the polish from places at all distances from an end: prints the worst error/bound of
 * steps that are certain; fails above 1. */
void filter_steps(const filter_subject *subject);

/* Calls `what` for the case, or valid ones of all regimes, in each environment; it must only
 * compute. Then `judge` in the default one. */
typedef void filter_compute(const sure_case *, void *context);
void filter_in_each(const sure_case *c, filter_compute *what, filter_compute *judge, void *context);
void filter_each(sure_shape shape, filter_compute *what, filter_compute *judge, void *context);

/* x = o - c, y = v.w, exactly. */
typedef mpfr_t filter_triple[3];
void filter_triple_init(filter_triple v);
void filter_triple_clear(filter_triple v);
void filter_triple_set(filter_triple v, sure_vec3 from, sure_vec3 to);
void filter_triple_dot(mpfr_t dot, filter_triple v, filter_triple w);

#endif
