/* SPDX-License-Identifier: MIT */
/* What the referee found, for people and for programs. */
#pragma once

#include "referee.h"

#include <jansson.h>

/* "of its size", ... */
const char *referee_unit_words(margin_unit unit);

/* A row of the judge's. */
typedef struct {
    const char *shape;
    int width; /* its, in print */
    const char *regime;
    const verdict *sum;
    const refereed *of;
} referee_row;

/* One line, and the head before the first. False and nothing: there is nothing to tell. */
bool referee_print(const referee_row *row, const margins *told, const entry *by, bool has_head);

/* NULL where no margins are told. */
json_t *referee_margins(const margins *told, const refereed *of);
json_t *referee_events(const refereed *of);
