/* The contract's definition of hit and miss, decided in exact integers (GMP) without any part of the
 * library: what a generator of cases is checked against. */
#ifndef SUPPORT_LINE_TRUTH_H
#define SUPPORT_LINE_TRUTH_H

#include <gmp.h>

#include "../../src/judge/case.h"

/* Exact facts of a case; where it is invalid only the first two are set. Signs are -1, 0, 1. */
typedef struct {
    sure_field invalid; /* the first bad field, or SURE_FIELD_NONE */
    sure_status status;

    /* Of a t^2 + 2 half_b t + c, not positive where the line is in the infinite round body (ball, infinite
     * cylinder, double cone; of a disc, the ball around it); none for a plane. */
    int a, half_b, c, discriminant;

    /* Of N.d and N.(o - place), and of how far o is above the plane of the other end. */
    int slope, height, height_over_end;

    /* The whole line, not only the ray. */
    bool meets_base_rim, meets_end_rim, meets_apex, along_axis;
} line_truth;

line_truth line_truth_of(const sure_case *question);

/* Where the whole line of a valid case enters the object, if it does at one point: 1 and *t, or 0 where it does not
 * or where that t is irrational. */
int line_truth_entry(const sure_case *question, mpq_t t);

#endif
