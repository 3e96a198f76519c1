/* SPDX-License-Identifier: MIT */
/* What the referee found, for people and for programs. */
#pragma once

#include "referee.h"

#include <jansson.h>

/* "of its size", ... */
const char *referee_unit_words(margin_unit unit);

/* Lines of a table, whose first columns are printed before; false: there is nothing to tell. */
bool referee_tells(const verdict *sum, const refereed *of, const entry *by);
void referee_print_head(int width, const margins *told, const entry *by);
void referee_print(const verdict *sum, const refereed *of, const margins *told, const entry *by);

/* NULL where no margins are told. */
json_t *referee_margins(const margins *told, const refereed *of);
json_t *referee_events(const refereed *of);
