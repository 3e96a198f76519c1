/* A small world of integers in which every product of the textbook formulas is exact in single
 * precision (axes have a power of two for their squared length), so that a tier that promises
 * nothing still has to decide rightly, ties included. */
#ifndef SUPPORT_WORLD_H
#define SUPPORT_WORLD_H

#include "case.h"

uint64_t world_count(sure_shape shape);

/* Member 0 <= index < world_count(shape). */
sure_case world_case(sure_shape shape, uint64_t index);

#endif
