/* The second stages of plane and disc (src/shapes/planar/flat_close.h) side by side, and cases that
 * are hard for them. */
#pragma once

#include "../../src/shapes/planar/flat_close.h"
#include "../support/every_case.h"

enum { PLANAR_BITS = 12000 };

/* |p|^2 - r^2 of the point where the plane is crossed, in `outside`; its t in `t`. */
void planar_crossing(const true_line *line, mpfr_t t, mpfr_t outside);

/* Case i whose t_min and radius are what the line has, but for a few ulps: all mantissas full, a
 * part of the lines within the plane z = 0, from up to 2^50 radii away, slopes down to 2^-50. */
sure_case planar_near(sure_shape shape, uint64_t i, true_line *line);

/* Calls both for such cases in each environment. */
void planar_each_near(sure_shape shape, case_compute *what, case_compute *judge, void *context);
