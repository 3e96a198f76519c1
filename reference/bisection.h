/* SPDX-License-Identifier: MIT */
/* The second oracle: the answers of docs/contract.md from nothing but signs. The solid's
 * implicit function is evaluated at points of the ray, in integers; where it changes sign the
 * boundary is bracketed, and bisection over the doubles rounds it. No root is ever extracted and
 * no floating-point operation takes place. It checks the first oracle, with which it shares
 * nothing (docs/bisection.md). */
#ifndef REFERENCE_BISECTION_H
#define REFERENCE_BISECTION_H

#include <surehit/object.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Every number is correctly rounded (to nearest, ties to even, overflow to an infinity) and
 * every zero is +0. What has no meaning is 0: all but status and field where invalid; part, t
 * and normal on a miss; the interval unless interval_status is SURE_HIT. */
typedef struct {
    sure_status status;
    sure_field field; /* the first invalid one, or SURE_FIELD_NONE */
    sure_part part;
    double t;
    sure_vec3 normal;            /* outward, unit */
    sure_status interval_status; /* does the closed chord meet [t_min, t_max]? */
    sure_interval interval;      /* of the ray's whole line */
} bisection_result;

/* Writes the whole of *result and returns its status.
 *
 * Law 1: scaling origin, object and t range by 2^k (d kept, nothing over- or underflowing) leaves
 *        status, parts and normal and turns every t into t * 2^k.
 * Law 2: d -> 2^k d turns every t into t * 2^-k; a plane's or disc's normal may be scaled too.
 * Law 3: permuting or negating coordinates of everything does the same to the normal, and no more.
 * Law 4: an exact translation changes nothing.
 * Law 5: the sign of t*(c d) - x is that of t*(d) - c x, for c > 0.
 * Law 6: exchanging a cylinder's ends exchanges base and top.
 * Law 7: replacing t_max by t leaves a hit exactly when t* <= t, replacing t_min when t* >= t.
 * Law 8: t* lies strictly between the neighbours of t.
 * Law 9: the order of two hits turns with them, is 0 for one object, and is that of t where the two
 *        differ. */
sure_status bisection_answer(const sure_ray *ray, const sure_object *object,
                             bisection_result *result);

/* The sign of t* - x. Entry: bisection_answer says SURE_HIT (the program is aborted otherwise);
 * x is not a NaN. */
int bisection_compare(const sure_ray *ray, const sure_object *object, double x);

/* The sign of t*(first) - t*(second): the order of one ray's hits on two objects. Entry: both
 * are hit (the program is aborted otherwise). */
int bisection_order(const sure_ray *ray, const sure_object *first, const sure_object *second);

#ifdef __cplusplus
}
#endif
#endif
