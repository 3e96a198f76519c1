/* On which side of an object a point is: -1 in a solid's interior, 0 on its boundary, 1 outside the
 * closed solid; for plane and disc the sign of N.(p - Q). */
#ifndef SHAPES_WHERE_H
#define SHAPES_WHERE_H

#include <surehit/object.h>

#include <stdbool.h>

/* One source, three stages (number.h). False when the stage can't tell; the last always can. Entry:
 * a valid object, a finite point; round to nearest but for the last. */
bool where_near(const sure_object *object, sure_vec3 p, int *side);
bool where_residue(const sure_object *object, sure_vec3 p, int *side);
bool where_exact(const sure_object *object, sure_vec3 p, int *side);

#endif
