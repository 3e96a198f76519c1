/* SPDX-License-Identifier: MIT */
/* An object whose faces are moved: what the judge asks of one that is a little larger or smaller
 * (docs/judge.md, "Margins"). A face goes at least as far as it was told to: what roundings may
 * take away is added to its way. */
#pragma once

#include "case.h"

/* Each part of the shape, in the order of its parts, goes outwards by by[part], where that is
 * negative inwards; a disc's rim likewise. Of a flat shape the whole goes along its normal by
 * `along`, too; a solid has none of this.
 *
 * Returns true and *moved; false: nothing is left, or doubles can't tell what.
 * Law 1: where all of it goes outwards, *moved contains the solid whose faces are moved by the real
 *        numbers; where all goes inwards, it lies in that. */
typedef struct {
    double by[SURE_SHAPE_PARTS], along;
} movement;
bool object_moved(const sure_object *object, const movement *how, sure_object *moved);

/* All of a solid's faces by the same length. */
movement movement_of_all(double by);

/* Each face as far as it is from the middle of an object that has an end: it becomes twice as
 * large, of a disc its rim. */
movement movement_of_growth(const sure_object *object);

/* So many times as far. */
movement movement_times(const movement *how, double by);

/* All points less than `by` from a disc's plane and less than that beyond its rim, as a cylinder;
 * false as above. Entry: a flat object with a radius. */
bool object_slab(const sure_object *disc, double by, sure_object *slab);

/* With its infinite wall moved; false where there is none that stays one, or nothing is left. */
bool wall_moved(const sure_object *object, const movement *how, sure_object *moved);

/* Half of the largest extent: the radius or half of the height, whichever is larger; of a box half
 * of its longest side; 0 of what has no end. */
double object_size(const sure_object *object);

/* For the rows of the shapes. */

/* A way, and how far roundings may lead from it: both ends of an axis are rounded, and so are the
 * numbers from which the way is found. `numbers` are the object's, `most` the longest way of any of
 * its points. False where the axis is too short or too long to be told. */
typedef struct {
    double unit[3]; /* of the axis */
    double height;
    double rounding; /* a point is off by less */
    bool aligned;    /* the axis is one of the coordinates': it can't be tilted */
} moved_axis;
bool moved_axis_of(const double *numbers, int count, const double vector[3], double most,
                   moved_axis *axis);

/* What is to be added to the way of every face, once the axis has that height and no point is
 * farther from it than `radius`; negative where doubles can't tell. */
double moved_allowance(const moved_axis *axis, double height, double radius);

/* `by`, and so much more in its direction. */
double moved_farther(double by, double allowance);

/* point + by unit, rounded. */
void moved_point(const double point[3], double by, const double unit[3], double to[3]);
