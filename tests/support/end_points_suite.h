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

/* Adds the tests: known ends, the laws, SURE_END_POINT_ULPS against 300 bits, what is refused. The
 * stems (one a tier) must outlive the suite. */
void end_points_add(Suite *suite, const end_points_stem stems[PART_TIERS]);

#endif
