/* SPDX-License-Identifier: MIT */
/* The row of an object, for what takes objects of any shape. */
#pragma once

#include "shape.h"

#include <surehit/object.h>

extern const shape_row *const shape_rows[SURE_SHAPES];

static inline const shape_row *row_of(const sure_object *object)
{
    return shape_rows[object->shape];
}
