/* SPDX-License-Identifier: MIT */
/* Where a line meets an object, by numbers as wide as one asks for, from the definitions of
 * docs/contract.md: a body (a quadratic of scalar products) and planes. No arithmetic of the
 * library. */
#pragma once

#include "case.h"
#include "true_number.h"

typedef mpfr_t true_vector[3];
void true_vector_init(true_vector v, mpfr_prec_t bits);
void true_vector_clear(true_vector v);
void true_vector_between(true_vector v, sure_vec3 from, sure_vec3 to);
void true_dot(mpfr_t dot, true_vector v, true_vector w);

/* What an end of the line's interval is: a root of the body's quadratic, the lesser one or the only
 * one, or the greater one; the crossing of a plane (of a plane or disc: its base); none at all. */
typedef enum { TRUE_LESS, TRUE_MORE, TRUE_BASE, TRUE_TOP, TRUE_ENDLESS } true_end;

/* A goes from `back` to `to`; m comes from `from`. */
typedef struct {
    sure_vec3 from, back, to;
    double radius;
    bool flat;           /* the object is in one plane; ... */
    bool round;          /* ... is bounded by a body; ... */
    bool capped, tapers; /* ... is between two planes, is a cone */
} true_frame;

true_frame true_frame_of(const sure_object *object);

typedef struct {
    mpfr_prec_t bits;
    sure_case of;
    bool flat, round, capped, tapers; /* as its frame */
    /* A.A, A.d and A.m: A is the normal, or the axis from base to top or from apex to base; m leads
     * from its point, or the sphere's centre, to the ray's origin. */
    mpfr_t height, slope, level;
    mpfr_t dd, md, mm; /* d.d, m.d, m.m */
    /* The body is where a t^2 + 2 b t + c <= 0: |m + t d|^2 - r^2, times A.A for a cylinder and
     * (A.A)^2 for a cone. A plane has r = 0, and no body. */
    mpfr_t a, b, c, discriminant; /* b^2 - a c */
    /* The part of the line that is in the object. */
    bool exists, on_boundary; /* all of it */
    mpfr_t t[2];
    true_end at[2];
    sure_part part[3]; /* of the ends, and between them on a line in the boundary */
} true_line;

void true_line_init(true_line *line, mpfr_prec_t bits);
void true_line_clear(true_line *line);

/* Declared, begun, and cleared at the end of its block. */
#define TRUE_LINE(bits, line)                                                                      \
    __attribute__((cleanup(true_line_clear))) true_line line;                                      \
    true_line_init(&line, bits)

/* The coefficients alone, and what the line has in common with the object, too. Entry: valid but
 * for the range of t. */
void true_line_coefficients(true_line *line, const sure_case *c);
void true_line_set(true_line *line, const sure_case *c);

/* Calls `what` for the coefficients, with more and more bits until no operation rounds: by its end
 * MPFR's inexact flag is not set. */
typedef void true_use(true_line *line, void *context);
void true_exactly(const sure_case *c, true_use *what, void *context);

/* What a shape's row makes its interval by, from the coefficients. */
bool true_in_plane(true_line *line);
bool true_in_body(true_line *line);
bool true_in_capped(true_line *line);

/* The first t in the case's range at which the boundary is met, if there is one. */
bool true_first(const true_line *line, mpfr_t t);

/* The part at a t of true_first, or an end: where several meet the lowest one. */
sure_part true_part(const true_line *line, mpfr_t t);

/* Of the quadratic's real roots the greatest |t|, rounded; 0 without one. */
double true_largest_root(true_line *line);

/* The sign of the quadratic at n/k. */
int true_side(true_line *line, mpfr_t n, mpfr_t k);

/* The hit's t and its point, each number correctly rounded. False without a hit. */
bool true_point(const sure_case *c, double *t, double point[3]);
