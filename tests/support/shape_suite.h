/* The tests that every shape shares: its hard cases, its laws and the exact answers in every
 * regime, and a small world in which all tiers have to be right. */
#ifndef SUPPORT_SHAPE_SUITE_H
#define SUPPORT_SHAPE_SUITE_H

#include <check.h>

#include <surehit/object.h>

/* Adds the test cases "hard", "truth", "laws" and "world" and runs the suite. With a case line in
 * the environment variable SUREHIT_CASE it says instead what truth and tiers answer to it and which
 * law they break, and fails if they break one: the command that a failure prints. */
int shape_suite_run(Suite *suite, sure_shape shape);

#endif
