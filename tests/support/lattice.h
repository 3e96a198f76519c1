/* Rays and objects on a small lattice: every origin of 5^3 and every direction of 3^3 but zero,
 * against objects of five axes and three radii about the middle. */
#ifndef SUPPORT_LATTICE_H
#define SUPPORT_LATTICE_H

#include "case.h"

/* The anchor is the point, centre or base; the axis the normal or the way from the base to the
 * other end, not zero unless the shape is a sphere. */
typedef struct {
    sure_shape shape;
    int origin[3], direction[3], anchor[3], axis[3], radius;
} lattice_case;

uint64_t lattice_count(sure_shape shape);

/* Member 0 <= index < lattice_count(shape). */
lattice_case lattice_member(sure_shape shape, uint64_t index);

/* The question in doubles; a negative t_max stands for infinity. */
sure_case lattice_question(const lattice_case *c, int t_min, int t_max);

#endif
