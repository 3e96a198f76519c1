/* The reference's answers in tests: made, compared, and held against what is right. */
#ifndef SUPPORT_REFERENCE_ANSWER_H
#define SUPPORT_REFERENCE_ANSWER_H

#include <check.h>

#include "case.h"

case_answer reference_answer_of(const sure_case *question);

/* The case that a line of the case format holds; fails the running test if it holds none. */
sure_case case_of(const char *line);

/* The same number, and +0 for a zero. */
bool same_number(double value, double expected);

/* The same answer in that sense. */
bool same_answer(const case_answer *answer, const case_answer *expected);

/* Fails the running test with the case line and why, unless the reference gives that answer. */
void expect_answer(const sure_case *question, const case_answer *expected, const char *why);

#endif
