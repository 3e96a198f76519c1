/* The tests of the end points C -+ h/2 N/|N|, which cylinder and cone share. */
#ifndef SUPPORT_END_POINTS_SUITE_H
#define SUPPORT_END_POINTS_SUITE_H

#include "suite.h"

typedef struct {
    /* ends[0] is the base, ends[1] the other end. */
    sure_field (*make)(sure_vec3 centre, sure_vec3 axis, double radius, double height,
                       sure_vec3 ends[2]);
    sure_field upper; /* the field that names the other end */
} end_points_stem;

void end_points_known(const end_points_stem *stem);
void end_points_laws(const end_points_stem *stem, int tier);

/* SURE_END_POINT_ULPS holds, against 300 bits. */
void end_points_bound(const end_points_stem *stem);

void end_points_invalid(const end_points_stem *stem);

#endif
