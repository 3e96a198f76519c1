/* Every published error bound, by name. A tolerance in a test is one of these or zero. The ulp of a
 * number is the step to its neighbour of greater magnitude in the tier's precision: for x in
 * [2^e, 2^(e+1)) it is 2^(e-52) in double and 2^(e-23) in float, and never less than the smallest
 * subnormal. */
#ifndef SUREHIT_BOUNDS_H
#define SUREHIT_BOUNDS_H

/* sure_quadratic_*: where half_b^2, a c and their difference D/4 are each computed without rounding
 * in the tier's precision, each root is off by at most this many ulps of the larger root's
 * magnitude (docs/derivations/quadratic.md counts 2 1/2). Nothing is said where one of them is
 * rounded: D/4 may then have lost all its digits. It holds for the ends of a shape's chord in the
 * same sense. */
#define SURE_ROOT_ULPS 3

/* sure_cylinder_from_axis_textbook, sure_cone_from_axis_textbook: component i of an end point is
 * off by at most this many ulps of the larger of |C_i| and h/2 (docs/derivations/cylinder_height.md
 * counts 4 1/2; more than 4 occur). */
#define SURE_END_POINT_ULPS 5

#endif
