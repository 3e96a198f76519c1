/* The rows of the table (shapes.c); each is defined in its shape's folder. */
#ifndef SHAPES_SHAPES_H
#define SHAPES_SHAPES_H

#include "../stages/shape.h"

#define DECLARE_ROW(shape, SHAPE) extern const shape_row shape##_row;
SURE_EACH_SHAPE(DECLARE_ROW)
#undef DECLARE_ROW

#endif
