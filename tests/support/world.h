/* SPDX-License-Identifier: MIT */
/* Small worlds of integers: every origin of 5^3 and every direction of 3^3 but zero, against
 * objects of a few axes and radii about the middle. */
#pragma once

#include "case.h"

/* In the first every product of the textbook formulas is exact in single precision (axes have a
 * power of two for their squared length), so that a tier that promises nothing still has to decide
 * rightly, ties included; the other has axes of other lengths. */
typedef enum { WORLD_EXACT, WORLD_LATTICE } world;

uint64_t world_count(world of, sure_shape shape);

/* Member 0 <= index < world_count(of, shape), on the whole ray. */
sure_case world_case(world of, sure_shape shape, uint64_t index);
