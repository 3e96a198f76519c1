/* SPDX-License-Identifier: MIT */
/* The shapes' first stages side by side (src/stages/filter.h). */
#pragma once

#include "../../src/stages/shape.h"
#include "../support/true_hit.h"

/* A discriminant and what it may be off by, where it is told. */
typedef struct {
    double value, error;
    bool told;
} told_number;

/* Of a shape that is bounded by a body. */
typedef struct {
    bool fits;            /* the filter's range takes it */
    double measure;       /* G, what D is measured by */
    told_number found[2]; /* D by both ways that the filter has */
} body_terms;

typedef struct {
    /* Of the line alone, wherever the ray starts; NULL: the first stage itself is. */
    filter_verdict (*filter)(const sure_case *, filter_interval *);
    /* Of the polish; NULL: none */
    polish_step (*step)(const sure_case *, end_kind at, double t);
    /* NULL: no body */
    body_terms (*body)(const sure_case *);
    /* D is (b^2 - a c) / (A.A)^powers of true_hit.h. */
    int powers;
    double bound; /* what the second stage takes for it */
} filter_subject;

/* What a shape has besides its row. */
extern const filter_subject filter_subjects[SURE_SHAPES];

filter_verdict filter_line(const sure_case *c, filter_interval *found);

/* Has it a body, and takes the filter's range the case? */
bool filter_fits(const sure_case *c);

/* D, from the line's coefficients. */
void true_discriminant(const filter_subject *of, const true_line *line, mpfr_t d);

end_kind end_kind_of(true_end at);
