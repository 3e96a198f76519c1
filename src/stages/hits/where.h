/* On which side of an object a point is: -1 in a solid's interior, 0 on its boundary, 1 outside the
 * closed solid; for plane and disc the sign of N.(p - Q). Each shape has the signs of its
 * functions (<shape>_tmpl.h). */
#ifndef STAGES_WHERE_H
#define STAGES_WHERE_H

#include "surface.h"

/* Entry: a valid object, a finite point, round to nearest. */
int where_is(const shape_row *row, const void *shape, sure_vec3 p);

#endif
