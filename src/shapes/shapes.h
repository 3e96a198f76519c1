/* The rows of the table (shapes.c); each is defined in its shape's folder. */
#ifndef SHAPES_SHAPES_H
#define SHAPES_SHAPES_H

#include "../stages/shape.h"

extern const shape_row plane_row, disc_row, sphere_row, cylinder_row, cone_row;

#endif
