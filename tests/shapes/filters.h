/* The shapes' first stages side by side (src/stages/filter.h). */
#ifndef SHAPES_FILTERS_H
#define SHAPES_FILTERS_H

#include "../../src/stages/filter.h"
#include "case.h"

/* A discriminant and what it may be off by, where it is told. */
typedef struct {
    double value, error;
    bool told;
} told_number;

typedef struct {
    /* Of the line alone, wherever the ray starts; NULL: the first stage itself is. */
    filter_verdict (*filter)(const sure_case *, filter_interval *);
    /* Of the polish; NULL: none */
    polish_step (*step)(const sure_case *, end_kind at, double t);
    /* (b^2 - a c) / (A.A)^powers of true_hit.h, by both ways that the filter has; NULL: none */
    void (*discriminants)(const sure_case *, told_number found[2]);
    int powers;
} filter_subject;

/* What a shape has besides its row. */
extern const filter_subject filter_subjects[SURE_SHAPES];

filter_verdict filter_line(const sure_case *c, filter_interval *found);

#endif
