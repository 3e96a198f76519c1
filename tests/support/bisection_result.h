/* SPDX-License-Identifier: MIT */
/* Results of the bisection oracle in tests: made, compared bit for bit, printed. */
#pragma once

#include "../../reference/bisection.h"

#include "case.h"

/* The oracle's result, into memory that held something else. */
bisection_result bisection_of(const sure_case *question);

/* What has no meaning is 0, so that whole results can be compared. */
bool bisection_same(const bisection_result *x, const bisection_result *y);
bool bisection_same_vector(sure_vec3 v, sure_vec3 w);

/* Fails the running test with the case line, both results and why, unless they are the same. */
void bisection_expect(const sure_case *question, const bisection_result *got,
                      const bisection_result *expected, const char *why);
