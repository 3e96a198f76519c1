/* Validity, by the contract's table: the first bad field in its order. Told by bits, so that it
 * does not matter whether subnormals are taken for zero. */
#ifndef STAGES_CHECK_H
#define STAGES_CHECK_H

#include "shape.h"
#include "valid.h"

/* Entry: a shape of that row. */
sure_field shape_check(const shape_row *row, const sure_ray *ray, const void *shape);

#endif
