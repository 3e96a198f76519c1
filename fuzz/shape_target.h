/* Everything that the contract promises of one shape, asked of the question that the bytes are. */
#ifndef FUZZ_SHAPE_TARGET_H
#define FUZZ_SHAPE_TARGET_H

#include "fuzz.h"

#include <surehit/object.h>

bool shape_target(sure_shape shape, const uint8_t *data, size_t size);

#endif
