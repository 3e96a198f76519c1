/* The bisection oracle against answers worked out by hand, in every floating-point mode, and
 * against the formulas on a lattice. It compares bits: nothing here has a tolerance. */
#include "../support/bisection_result.h"
#include "../support/face_by_face.h"
#include "../support/suite.h"
#include "../support/surroundings.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SQRT1_2 "0.70710678118654752440084436210484903928"
#define SQRT1_3 "0.57735026918962576450914878050195745565"
#define TWO_MINUS_SQRT3 "0.26794919243112270647255365849412763306"

/* A question, its answer, and the chord on the whole line as `t_enter t_leave part part`; "-" where
 * the closed chord does not meet [t_min, t_max]. */
typedef struct {
    const char *question, *answer, *chord;
} row;

static const row plane_rows[] = {
    {"plane 0 0 0 0 0 1 0 inf 0 0 3 0 0 1", "hit 3 surface 0 0 1", "3 3 surface surface"},
    {"plane 0 0 6 0 0 -1 0 inf 0 0 3 0 0 1", "hit 3 surface 0 0 1", "3 3 surface surface"},
    {"plane 0 0 0 0 0 1 0 inf 7 8 3 0 0 -2", "hit 3 surface 0 0 -1", "3 3 surface surface"},
    {"plane 0 0 0 0 0 3 0 inf 0 0 1 0 0 1", "hit 0.33333333333333333333333 surface 0 0 1",
     "0.33333333333333333333333 0.33333333333333333333333 surface surface"},
    {"plane 0 0 4 0 0 1 0 inf 0 0 3 0 0 1", "miss", "-"},
    /* In the plane every t is a hit: the first is t_min. Beside it none is. */
    {"plane 5 0 0 1 0 0 0.5 inf 0 0 0 0 0 1", "hit 0.5 surface 0 0 1",
     "-inf inf surface surface"},
    {"plane 5 0 0 1 0 0 0 0 0 0 -0.0 0 0 1", "hit 0 surface 0 0 1", "-inf inf surface surface"},
    {"plane 5 0 0 1 0 0 -0.0 -0.0 0 0 0 0 0 1", "hit 0 surface 0 0 1",
     "-inf inf surface surface"},
    {"plane 5 0 0x1p-1074 1 0 0 0 inf 0 0 0 0 0 1", "miss", "-"},
    /* Both ends of the range belong to it. */
    {"plane 0 0 0 0 0 1 3 3 0 0 3 0 0 1", "hit 3 surface 0 0 1", "3 3 surface surface"},
    {"plane 0 0 0 0 0 3 0x1.5555555555555p-2 inf 0 0 1 0 0 1",
     "hit 0x1.5555555555555p-2 surface 0 0 1",
     "0x1.5555555555555p-2 0x1.5555555555555p-2 surface surface"},
    /* t* = 1/3 lies above its double. */
    {"plane 0 0 0 0 0 3 0 0x1.5555555555555p-2 0 0 1 0 0 1", "miss", "-"},
    /* A zero is +0, whatever was multiplied to it. */
    {"plane 0 0 -0.0 0 0 -1 -0.0 inf 0 0 0 -0.0 -0.0 1", "hit 0 surface 0 0 1",
     "0 0 surface surface"},
    /* t* halfway between two doubles goes to the even one; a hair off the tie goes its own way. */
    {"plane 0 0 -1 0 0 1 0 inf 0 0 0x1p53 0 0 1", "hit 0x1p53 surface 0 0 1",
     "0x1p53 0x1p53 surface surface"},
    {"plane 0 0 -3 0 0 1 0 inf 0 0 0x1p53 0 0 1", "hit 0x1.0000000000002p53 surface 0 0 1",
     "0x1.0000000000002p53 0x1.0000000000002p53 surface surface"},
    {"plane 0 0 -0x1.0000000000001p0 0 0 1 0 inf 0 0 0x1p53 0 0 1",
     "hit 0x1.0000000000001p53 surface 0 0 1",
     "0x1.0000000000001p53 0x1.0000000000001p53 surface surface"},
    {"plane 0 0 -0x1.7ffffffffffffp1 0 0 1 0 inf 0 0 0x1p53 0 0 1",
     "hit 0x1.0000000000001p53 surface 0 0 1",
     "0x1.0000000000001p53 0x1.0000000000001p53 surface surface"},
    /* Ties between subnormals; half the least goes to 0 and is still a hit. */
    {"plane 0 0 0 0 0 2 0 inf 0 0 0x1p-1074 0 0 1", "hit 0 surface 0 0 1",
     "0 0 surface surface"},
    {"plane 0 0 0 0 0 2 0 inf 0 0 0x3p-1074 0 0 1", "hit 0x2p-1074 surface 0 0 1",
     "0x2p-1074 0x2p-1074 surface surface"},
    {"plane 0 0 0 0 0 2 0x1p-1074 inf 0 0 0x1p-1074 0 0 1", "miss", "-"},
    {"plane 0 0 0 0 0 2 0 0 0 0 0x1p-1074 0 0 1", "miss", "-"},
    {"plane 0 0 0x1p-1074 0 0 1 0 inf 0 0 0x1.fffffffffffffp-1022 0 0 1",
     "hit 0x1.ffffffffffffep-1022 surface 0 0 1",
     "0x1.ffffffffffffep-1022 0x1.ffffffffffffep-1022 surface surface"},
    {"plane 0 0 0 0 0 0x1p1023 0 inf 0 0 1.5 0 0 1", "hit 0x1.8p-1023 surface 0 0 1",
     "0x1.8p-1023 0x1.8p-1023 surface surface"},
    {"plane 0 0 0 0 0 0x1p1023 0 inf 0 0 0x1p-51 0 0 1", "hit 0x1p-1074 surface 0 0 1",
     "0x1p-1074 0x1p-1074 surface surface"},
    /* 2^1024 - 2^970 is the tie that overflows; a tilt by 2^-1000 takes t* below or above it. */
    {"plane 0 0 -0x1.fffffffffffffp1022 0 0 1 0 inf 0 0 0x1p1023 0 0 1",
     "hit inf surface 0 0 1", "inf inf surface surface"},
    {"plane 0 0 -0x1.fffffffffffffp1022 0 0 1 0 inf -1 0 0x1p1023 0x1p-1000 0 1",
     "hit 0x1.fffffffffffffp1023 surface 0x1p-1000 0 1",
     "0x1.fffffffffffffp1023 0x1.fffffffffffffp1023 surface surface"},
    {"plane 0 0 -0x1.fffffffffffffp1022 0 0 1 0 0x1.fffffffffffffp1023 0 0 0x1p1023 0 0 1",
     "miss", "-"},
    {"plane 0 0 0 0 0 0x1p-1074 0 inf 0 0 0x1p1023 0 0 1", "hit inf surface 0 0 1",
     "inf inf surface surface"},
    /* Normals: 3-4-5, the diagonals, and lengths whose squares leave the range. */
    {"plane 0 0 0 1 0 0 0 inf 2 0 0 3 4 0", "hit 2 surface 0.6 0.8 0", "2 2 surface surface"},
    {"plane 0 0 0 1 0 0 0 inf 2 0 0 -0x1p1023 0x1p1023 0",
     "hit 2 surface -" SQRT1_2 " " SQRT1_2 " 0", "2 2 surface surface"},
    {"plane 0 0 0 1 0 0 0 inf 2 0 0 0x1p-1074 0x1p-1074 -0x1p-1074",
     "hit 2 surface " SQRT1_3 " " SQRT1_3 " -" SQRT1_3, "2 2 surface surface"},
    /* 2^-1074 / sqrt(1 + 2^-2148) is nearest to 2^-1074; half as much to 0. */
    {"plane 0 0 0 1 0 0 0 inf 2 0 0 1 -0x1p-1074 0", "hit 2 surface 1 -0x1p-1074 0",
     "2 2 surface surface"},
    {"plane 0 0 0 1 0 0 0 inf 2 0 0 2 -0x1p-1074 0", "hit 2 surface 1 0 0",
     "2 2 surface surface"},
};

static const row disc_rows[] = {
    {"disc 0 0 0 0 0 1 0 inf 0 0 5 0 0 1 2", "hit 5 surface 0 0 1", "5 5 surface surface"},
    {"disc 3 4 0 0 0 1 0 inf 0 0 5 0 0 -1 5", "hit 5 surface 0 0 -1", "5 5 surface surface"},
    {"disc 0x1.8000000000001p1 4 0 0 0 1 0 inf 0 0 5 0 0 1 5", "miss", "-"},
    {"disc 3 4 0 0 0 1 0 inf 0 0 5 0 0 1 0x1.3ffffffffffffp2", "miss", "-"},
    /* In its own plane: the rim from outside, t_min from inside, one point when tangent. */
    {"disc -10 0 5 1 0 0 0 inf 0 0 5 0 0 1 2", "hit 8 surface 0 0 1", "8 12 surface surface"},
    {"disc 0 0 5 1 0 0 0 inf 0 0 5 0 0 1 2", "hit 0 surface 0 0 1", "-2 2 surface surface"},
    {"disc 0 0 5 1 0 0 1 1 0 0 5 0 0 1 2", "hit 1 surface 0 0 1", "-2 2 surface surface"},
    {"disc 0 0 5 1 0 0 2 9 0 0 5 0 0 1 2", "hit 2 surface 0 0 1", "-2 2 surface surface"},
    {"disc 0 0 5 1 0 0 3 9 0 0 5 0 0 1 2", "miss", "-"},
    {"disc -10 2 5 1 0 0 0 inf 0 0 5 0 0 1 2", "hit 10 surface 0 0 1", "10 10 surface surface"},
    {"disc -10 0x1.0000000000001p1 5 1 0 0 0 inf 0 0 5 0 0 1 2", "miss", "-"},
    {"disc -10 0 4 1 0 0 0 inf 0 0 5 0 0 1 2", "miss", "-"},
    {"disc -10 1 5 5 0 0 0 inf 0 0 5 0 0 1 2",
     "hit 1.6535898384862245412945107316988255266 surface 0 0 1",
     "1.6535898384862245412945107316988255266 2.3464101615137754587054892683011744734 "
     "surface surface"},
    /* Radius 0: a point, from all sides. */
    {"disc 0 0 0 0 0 1 0 inf 0 0 5 1 0 1 0", "hit 5 surface " SQRT1_2 " 0 " SQRT1_2,
     "5 5 surface surface"},
    {"disc 0 0 0 0 0 1 0 inf 0 0 5 1 0 0 -0.0", "hit 5 surface 1 0 0", "5 5 surface surface"},
    {"disc 0 0x1p-1074 0 0 0 1 0 inf 0 0 5 0 0 1 0", "miss", "-"},
};

static const row sphere_rows[] = {
    {"sphere 0 0 0 0 0 1 0 inf 0 0 5 1", "hit 4 surface 0 0 -1", "4 6 surface surface"},
    {"sphere 3 0 0 0 0 2 0 inf 0 0 10 5", "hit 3 surface 0.6 0 -0.8", "3 7 surface surface"},
    {"sphere 1 0 0 0 0 1 0 inf 0 0 2 2",
     "hit " TWO_MINUS_SQRT3 " surface 0.5 0 -0.86602540378443864676372317075293618347",
     TWO_MINUS_SQRT3 " 3.7320508075688772935274463415058723669 surface surface"},
    {"sphere 0 0 0 1 1 1 0 inf 0 0 0 1",
     "hit " SQRT1_3 " surface " SQRT1_3 " " SQRT1_3 " " SQRT1_3,
     "-" SQRT1_3 " " SQRT1_3 " surface surface"},
    /* Tangent, one ulp outside, one ulp inside: 5 -+ 2^-26 sqrt(1 - 2^-54). */
    {"sphere 1 0 0 0 0 1 0 inf 0 0 5 1", "hit 5 surface 1 0 0", "5 5 surface surface"},
    {"sphere 0x1.0000000000001p0 0 0 0 0 1 0 inf 0 0 5 1", "miss", "-"},
    {"sphere 0x1.fffffffffffffp-1 0 0 0 0 1 0 inf 0 0 5 1",
     "hit 0x1.3ffffffp2 surface 0x1.fffffffffffffp-1 0 -0x1p-26",
     "0x1.3ffffffp2 0x1.4000001p2 surface surface"},
    /* Inside, on, behind. */
    {"sphere 0 0 5 0 0 1 0 inf 0 0 5 1", "hit 1 surface 0 0 1", "-1 1 surface surface"},
    {"sphere 0 0 5 0 0 1 0 0.5 0 0 5 1", "miss", "-1 1 surface surface"},
    {"sphere 0 0 4 0 0 1 0 inf 0 0 5 1", "hit 0 surface 0 0 -1", "0 2 surface surface"},
    {"sphere 0 0 4 0 0 1 0x1p-1074 inf 0 0 5 1", "hit 2 surface 0 0 1", "0 2 surface surface"},
    {"sphere 0 0 6 0 0 1 0 inf 0 0 5 1", "hit 0 surface 0 0 1", "-2 0 surface surface"},
    {"sphere 0 0 6 0 0 1 0x1p-1074 inf 0 0 5 1", "miss", "-"},
    {"sphere 0 0 10 0 0 1 0 inf 0 0 5 1", "miss", "-"},
    {"sphere 0 0 0 0 0 1 6 6 0 0 5 1", "hit 6 surface 0 0 1", "4 6 surface surface"},
    {"sphere 0 0 0 0 0 1 4 4 0 0 5 1", "hit 4 surface 0 0 -1", "4 6 surface surface"},
    {"sphere 0 0 0 0 0 1 0 0x1.fffffffffffffp1 0 0 5 1", "miss", "-"},
    /* A point. */
    {"sphere 0 0 0 0 0 2 0 inf 0 0 5 0", "hit 2.5 surface 0 0 -1", "2.5 2.5 surface surface"},
    {"sphere 0 0 5 1 1 0 0 inf 0 0 5 -0.0", "hit 0 surface -" SQRT1_2 " -" SQRT1_2 " 0",
     "0 0 surface surface"},
    {"sphere 0x1p-1074 0 0 0 0 2 0 inf 0 0 5 0", "miss", "-"},
    /* Both ends are rounded ties: 2^53 + 1 and 2^53 + 3. */
    {"sphere 0 0 0 0 0 1 0 inf 0 0 0x1.0000000000001p53 1", "hit 0x1p53 surface 0 0 -1",
     "0x1p53 0x1.0000000000002p53 surface surface"},
    /* Squares beyond the range of doubles. */
    {"sphere 0 0 0 0 0 1 0 inf 0 0 0x1p1000 0x1p990", "hit 0x1.ff8p999 surface 0 0 -1",
     "0x1.ff8p999 0x1.004p1000 surface surface"},
    {"sphere 0 0 0 0 0 1 0 inf 0 0 0x3p-1074 0x1p-1074", "hit 0x2p-1074 surface 0 0 -1",
     "0x2p-1074 0x4p-1074 surface surface"},
    {"sphere 0 0 0 0 0 0x1p-1074 0 inf 0 0 0x1p1023 1", "hit inf surface 0 0 -1",
     "inf inf surface surface"},
    {"sphere 0 0 0 0 0 -0x1p-1074 0 inf 0 0 0x1p1023 0x1.8p1023", "hit inf surface 0 0 -1",
     "-inf inf surface surface"},
    {"sphere 0 0 0 0 0 0x1p-1074 0 0x1.fffffffffffffp1023 0 0 0x1p1023 1", "miss", "-"},
    /* Neither end is a double: -2^-1075 and 2^-1075, ties that go to zero. */
    {"sphere 0 0 0 0 0 2 0 inf 0 0 0 0x1p-1074", "hit 0 surface 0 0 1", "0 0 surface surface"},
    {"sphere 0 0 0 0 0 2 0x1p-1074 inf 0 0 0 0x1p-1074", "miss", "-"},
};

static const row cylinder_rows[] = {
    {"cylinder -5 0 1 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 4 wall -1 0 0", "4 6 wall wall"},
    {"cylinder 0 0 -3 0 0 1 0 inf 0 0 0 0 0 2 1", "hit 3 base 0 0 -1", "3 5 base top"},
    {"cylinder 0 0 5 0 0 -1 0 inf 0 0 0 0 0 2 1", "hit 3 top 0 0 1", "3 5 top base"},
    {"cylinder 0 0 1 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 1 wall 1 0 0", "-1 1 wall wall"},
    {"cylinder 0 0 1 1 0 3 0 inf 0 0 0 0 0 2 1", "hit 0.33333333333333333333333 top 0 0 1",
     "-0.33333333333333333333333 0.33333333333333333333333 base top"},
    {"cylinder 0.6 -5 1 0 1 0 0 inf 0 0 0 0 0 2 1",
     "hit 4.2 wall 0x1.3333333333333p-1 -0x1.999999999999ap-1 0", "4.2 5.8 wall wall"},
    /* Rims: through the solid, and touching one point from outside. */
    {"cylinder -2 0 -1 1 0 1 0 inf 0 0 0 0 0 2 1", "hit 1 base 0 0 -1", "1 3 base top"},
    {"cylinder -2 0 1 1 0 -1 0 inf 0 0 0 0 0 2 1", "hit 1 base 0 0 -1", "1 1 base base"},
    {"cylinder -2 0 0x1.fffffffffffffp-1 1 0 -1 0 inf 0 0 0 0 0 2 1", "miss", "-"},
    {"cylinder -2 0 1 1 0 1 0 inf 0 0 0 0 0 2 1", "hit 1 top 0 0 1", "1 1 top top"},
    /* Tangent to the wall, inside and outside the height. */
    {"cylinder 1 -5 1 0 1 0 0 inf 0 0 0 0 0 2 1", "hit 5 wall 1 0 0", "5 5 wall wall"},
    {"cylinder 1 -5 2 0 1 0 0 inf 0 0 0 0 0 2 1", "hit 5 top 0 0 1", "5 5 top top"},
    {"cylinder 1 -5 0x1.0000000000001p1 0 1 0 0 inf 0 0 0 0 0 2 1", "miss", "-"},
    {"cylinder 0x1.0000000000001p0 -5 1 0 1 0 0 inf 0 0 0 0 0 2 1", "miss", "-"},
    /* Along the wall: rim, middle, rim, nothing. */
    {"cylinder 1 0 -1 0 0 1 0 inf 0 0 0 0 0 2 1", "hit 1 base 0 0 -1", "1 3 base top"},
    {"cylinder 1 0 -1 0 0 1 1.5 inf 0 0 0 0 0 2 1", "hit 1.5 wall 1 0 0", "1 3 base top"},
    {"cylinder 1 0 -1 0 0 1 3 inf 0 0 0 0 0 2 1", "hit 3 top 0 0 1", "1 3 base top"},
    {"cylinder 1 0 -1 0 0 1 0x1.8000000000001p1 inf 0 0 0 0 0 2 1", "miss", "-"},
    {"cylinder 1 0 1 0 0 1 0 inf 0 0 0 0 0 2 1", "hit 0 wall 1 0 0", "-1 1 base top"},
    {"cylinder 0x1.0000000000001p0 0 -1 0 0 1 0 inf 0 0 0 0 0 2 1", "miss", "-"},
    {"cylinder 0x1.fffffffffffffp-1 0 -1 0 0 1 1.5 inf 0 0 0 0 0 2 1", "hit 3 top 0 0 1",
     "1 3 base top"},
    /* In a cap's plane: the rim from outside, any point from inside; an ulp above, a chord. */
    {"cylinder -5 0 0 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 4 base 0 0 -1", "4 6 base base"},
    {"cylinder -5 0 0 1 0 0 5 inf 0 0 0 0 0 2 1", "hit 5 base 0 0 -1", "4 6 base base"},
    {"cylinder -5 0 2 1 0 0 5 inf 0 0 0 0 0 2 1", "hit 5 top 0 0 1", "4 6 top top"},
    {"cylinder -5 0 0x1p-1074 1 0 0 5 inf 0 0 0 0 0 2 1", "hit 6 wall 1 0 0", "4 6 wall wall"},
    {"cylinder -5 0 -0x1p-1074 1 0 0 5 inf 0 0 0 0 0 2 1", "miss", "-"},
    {"cylinder -5 1 2 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 5 top 0 0 1", "5 5 top top"},
    /* A segment. */
    {"cylinder -5 0 1 1 0 0 0 inf 0 0 0 0 0 2 0", "hit 5 wall -1 0 0", "5 5 wall wall"},
    {"cylinder -5 0 0 1 0 0 0 inf 0 0 0 0 0 2 0", "hit 5 base 0 0 -1", "5 5 base base"},
    {"cylinder -5 0 2 1 0 0 0 inf 0 0 0 0 0 2 0", "hit 5 top 0 0 1", "5 5 top top"},
    {"cylinder -5 0 0x1.0000000000001p1 1 0 0 0 inf 0 0 0 0 0 2 0", "miss", "-"},
    {"cylinder 0 0 -1 0 0 1 0 inf 0 0 0 0 0 2 0", "hit 1 base 0 0 -1", "1 3 base top"},
    {"cylinder 0 0 -1 0 0 1 2 inf 0 0 0 0 0 2 0", "hit 2 wall 0 0 -1", "1 3 base top"},
    {"cylinder -5 0x1p-1074 1 1 0 0 0 inf 0 0 0 0 0 2 0", "miss", "-"},
    /* A slanted axis: a ray along it, and across it through (1, 1, 0). */
    {"cylinder -1 -1 0 1 1 0 0 inf 0 0 0 2 2 0 1",
     "hit 1 base -" SQRT1_2 " -" SQRT1_2 " 0", "1 3 base top"},
    {"cylinder 3 -1 0 -1 1 0 0 inf 0 0 0 2 2 0 1",
     "hit 1.2928932188134524755991556378951509607 wall " SQRT1_2 " -" SQRT1_2 " 0",
     "1.2928932188134524755991556378951509607 2.7071067811865475244008443621048490393 "
     "wall wall"},
    /* Needle and coin. */
    {"cylinder -0x1p60 0 0x1p40 0x1p60 0 0 0 inf 0 0 0 0 0 0x1p80 0x1p-80",
     "hit 1 wall -1 0 0", "1 1 wall wall"},
    {"cylinder 0 0 -1 0 0 1 0 inf 0 0 0 0 0 0x1p-1074 0x1p1023", "hit 1 base 0 0 -1",
     "1 1 base top"},
};

static const row cone_rows[] = {
    {"cone -5 0 2 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 3.5 wall -0.8 0 0.6", "3.5 6.5 wall wall"},
    {"cone -5 0 0 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 2 base 0 0 -1", "2 8 base base"},
    {"cone -5 0 0 1 0 0 3 inf 0 0 0 0 0 4 3", "hit 3 base 0 0 -1", "2 8 base base"},
    {"cone 0 0 -1 0 0 1 0 inf 0 0 0 0 0 4 3", "hit 1 base 0 0 -1", "1 5 base wall"},
    {"cone 0 0 1 0 0 -1 0 inf 0 0 0 0 0 4 3", "hit 1 base 0 0 -1", "-3 1 wall base"},
    /* The apex: from the side, from above, from inside. */
    {"cone -5 0 4 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 5 wall 0 0 1", "5 5 wall wall"},
    {"cone 0 0 10 0 0 -1 0 inf 0 0 0 0 0 4 3", "hit 6 wall 0 0 1", "6 10 wall base"},
    {"cone 0 0 2 0 0 1 0 inf 0 0 0 0 0 4 3", "hit 2 wall 0 0 1", "-2 2 base wall"},
    {"cone -5 0 0x1.0000000000001p2 1 0 0 0 inf 0 0 0 0 0 4 3", "miss", "-"},
    {"cone -5 0x1p-1074 4 1 0 0 0 inf 0 0 0 0 0 4 3", "miss", "-"},
    /* The other nappe is no part of it, not even where the line goes on into this one. */
    {"cone -5 0 6 1 0 0 0 inf 0 0 0 0 0 4 3", "miss", "-"},
    {"cone 0.375 0 10 0 0 -1 0 inf 0 0 0 0 0 4 3", "hit 6.5 wall 0.8 0 0.6",
     "6.5 10 wall base"},
    {"cone 3 0 8 -3 0 -4 0 inf 0 0 0 0 0 4 3", "hit 1 wall 0 0 1", "1 2 wall base"},
    /* Along a generator: rim, middle, apex, nothing. */
    {"cone 6 0 -4 -3 0 4 0 inf 0 0 0 0 0 4 3", "hit 1 base 0 0 -1", "1 2 base wall"},
    {"cone 6 0 -4 -3 0 4 1.5 inf 0 0 0 0 0 4 3", "hit 1.5 wall 0.8 0 0.6", "1 2 base wall"},
    {"cone 6 0 -4 -3 0 4 2 inf 0 0 0 0 0 4 3", "hit 2 wall 0 0 1", "1 2 base wall"},
    {"cone 6 0 -4 -3 0 4 0x1.0000000000001p1 inf 0 0 0 0 0 4 3", "miss", "-"},
    {"cone -3 0 8 3 0 -4 0 inf 0 0 0 0 0 4 3", "hit 1 wall 0 0 1", "1 2 wall base"},
    /* Parallel to a generator, inside: the quadratic is linear. */
    {"cone 0 0 1 -3 0 4 0 inf 0 0 0 0 0 4 3", "hit 0.375 wall -0.8 0 0.6",
     "-0.25 0.375 base wall"},
    {"cone 0 0 1 3 0 -4 0 inf 0 0 0 0 0 4 3", "hit 0.25 base 0 0 -1", "-0.375 0.25 wall base"},
    /* Parallel to one in the tangent plane: y = 1 never meets the wall's side of it. */
    {"cone 3 1 0 -3 0 4 0 inf 0 0 0 0 0 4 3", "miss", "-"},
    /* Tangent to the wall. */
    {"cone 1.5 -5 2 0 1 0 0 inf 0 0 0 0 0 4 3", "hit 5 wall 0.8 0 0.6", "5 5 wall wall"},
    {"cone 0x1.8000000000001p0 -5 2 0 1 0 0 inf 0 0 0 0 0 4 3", "miss", "-"},
    {"cone 3 -5 0 0 1 0 0 inf 0 0 0 0 0 4 3", "hit 5 base 0 0 -1", "5 5 base base"},
    /* The rim alone; from below it is the way in. */
    {"cone -4 0 1 1 0 -1 0 inf 0 0 0 0 0 4 3", "hit 1 base 0 0 -1", "1 1 base base"},
    {"cone -4 0 -1 1 0 1 0 inf 0 0 0 0 0 4 3", "hit 1 base 0 0 -1",
     "1 4.4285714285714285714286 base wall"},
    /* A segment. */
    {"cone -5 0 2 1 0 0 0 inf 0 0 0 0 0 4 0", "hit 5 wall -1 0 0", "5 5 wall wall"},
    {"cone -5 0 4 1 0 0 0 inf 0 0 0 0 0 4 0", "hit 5 wall 0 0 1", "5 5 wall wall"},
    {"cone -5 0 0 1 0 0 0 inf 0 0 0 0 0 4 0", "hit 5 base 0 0 -1", "5 5 base base"},
    {"cone 0 0 8 0 0 -2 0 inf 0 0 0 0 0 4 0", "hit 2 wall 0 0 1", "2 4 wall base"},
    {"cone 0 0 8 0 0 -2 3 inf 0 0 0 0 0 4 0", "hit 3 wall 0 0 1", "2 4 wall base"},
    {"cone 1 0 1 1 0 0 0 inf 0 0 0 0 0 4 0", "miss", "-"},
    /* Numbers whose sixth powers are far beyond the doubles. */
    {"cone -0x5p900 0 0x2p900 0x1p900 0 0 0 inf 0 0 0 0 0 0x4p900 0x3p900",
     "hit 3.5 wall -0.8 0 0.6", "3.5 6.5 wall wall"},
    {"cone -0xap-1074 0 0x4p-1074 0x2p-1074 0 0 0 inf 0 0 0 0 0 0x8p-1074 0x6p-1074",
     "hit 3.5 wall -0.8 0 0.6", "3.5 6.5 wall wall"},
};

static const row invalid_rows[] = {
    {"plane nan 0 0 0 0 0 -1 -2 0 0 0 0 0 0", "invalid o", "-"},
    {"sphere 0 -inf 0 0 0 1 0 inf 0 0 5 1", "invalid o", "-"},
    {"sphere 0 0 0 0 -0.0 0 -1 inf 0 0 5 1", "invalid d", "-"},
    {"sphere 0 0 0 0 0 inf 0 inf 0 0 5 1", "invalid d", "-"},
    {"disc 0 0 0 0 0 1 -0x1p-1074 -1 0 0 nan 0 0 0 -1", "invalid t_min", "-"},
    {"disc 0 0 0 0 0 1 nan 1 0 0 0 0 0 1 1", "invalid t_min", "-"},
    {"disc 0 0 0 0 0 1 inf inf 0 0 0 0 0 1 1", "invalid t_min", "-"},
    {"disc 0 0 0 0 0 1 0 nan 0 0 0 0 0 1 1", "invalid t_max", "-"},
    {"disc 0 0 0 0 0 1 0 -nan 0 0 0 0 0 1 1", "invalid t_max", "-"},
    {"disc 0 0 0 0 0 1 0 -inf 0 0 0 0 0 1 1", "invalid t_max", "-"},
    {"disc 0 0 0 0 0 1 0 -0x1p-1074 0 0 nan 0 0 1 1", "invalid t_max", "-"},
    {"disc 0 0 0 0 0 1 0x1.0000000000001p0 1 nan 0 0 0 0 1 1", "invalid t_max", "-"},
    {"disc 0 0 0 0 0 1 0x1p-1074 -0.0 0 0 0 0 0 1 1", "invalid t_max", "-"},
    {"plane 0 0 0 0 0 1 0 inf 0 0 inf 0 0 0", "invalid point", "-"},
    {"plane 0 0 0 0 0 1 0 inf 0 0 0 0 -0.0 0", "invalid normal", "-"},
    {"plane 0 0 0 0 0 1 0 inf 0 0 0 0 nan 1", "invalid normal", "-"},
    {"disc 0 0 0 0 0 1 0 inf 0 nan 0 0 0 0 -1", "invalid centre", "-"},
    {"disc 0 0 0 0 0 1 0 inf 0 0 0 0 0 0 -1", "invalid normal", "-"},
    {"disc 0 0 0 0 0 1 0 inf 0 0 0 0 0 1 -0x1p-1074", "invalid radius", "-"},
    {"sphere 0 0 0 0 0 1 0 inf inf 0 0 -1", "invalid centre", "-"},
    {"sphere 0 0 0 0 0 1 0 inf 0 0 0 nan", "invalid radius", "-"},
    {"sphere 0 0 0 0 0 1 0 inf 0 0 0 inf", "invalid radius", "-"},
    {"cylinder 0 0 0 0 0 1 0 inf nan 0 0 nan 0 0 nan", "invalid base", "-"},
    {"cylinder 0 0 0 0 0 1 0 inf 0 0 0 nan 0 0 nan", "invalid top", "-"},
    {"cylinder 0 0 0 0 0 1 0 inf 1 0 2 1 -0.0 2 -1", "invalid top", "-"},
    {"cylinder 0 0 0 0 0 1 0 inf 1 0 2 1 0x1p-1074 2 -1", "invalid radius", "-"},
    {"cone 0 0 0 0 0 1 0 inf 0 0 -inf 0 0 -inf -1", "invalid base", "-"},
    {"cone 0 0 0 0 0 1 0 inf 0 0 -0.0 0 0 0 -1", "invalid apex", "-"},
    {"cone 0 0 0 0 0 1 0 inf 0 0 0 0 0 inf -1", "invalid apex", "-"},
    {"cone 0 0 0 0 0 1 0 inf 0 0 0 0 0 1 -inf", "invalid radius", "-"},
};

static sure_part read_part(const char *name)
{
    for (int part = SURE_PART_SURFACE; part <= SURE_PART_WALL; part++) {
        if (strcmp(name, sure_part_name((sure_part)part)) == 0)
            return (sure_part)part;
    }
    ck_abort_msg("no part: %s", name);
}

static bisection_result read_result(const row *r)
{
    case_answer said;
    char enter[16], leave[16];
    sure_interval *chord;
    ck_assert_msg(case_answer_read(r->answer, &said), "cannot read %s", r->answer);
    bisection_result result = {.status = said.status,
                               .field = said.field,
                               .part = said.part,
                               .t = said.t,
                               .normal = said.normal,
                               .interval_status = SURE_MISS};
    if (said.status == SURE_INVALID)
        result.interval_status = SURE_INVALID;
    if (strcmp(r->chord, "-") != 0) {
        chord = &result.interval;
        result.interval_status = SURE_HIT;
        ck_assert_int_eq(sscanf(r->chord, "%lf %lf %15s %15s", &chord->t_enter, &chord->t_leave,
                                enter, leave),
                         4);
        chord->enter_part = read_part(enter);
        chord->leave_part = read_part(leave);
    }
    return result;
}

static void check_rows(const row *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        sure_case question;
        ck_assert_msg(case_read(rows[i].question, &question), "cannot read %s",
                      rows[i].question);
        bisection_result expected = read_result(&rows[i]), got = bisection_of(&question);
        bisection_expect(&question, &got, &expected, "by hand");
    }
}

#define COUNT(rows) (sizeof(rows) / sizeof((rows)[0]))
#define CHECK_ROWS(rows) check_rows(rows, COUNT(rows))

static void check_all_rows(void)
{
    CHECK_ROWS(plane_rows);
    CHECK_ROWS(disc_rows);
    CHECK_ROWS(sphere_rows);
    CHECK_ROWS(cylinder_rows);
    CHECK_ROWS(cone_rows);
    CHECK_ROWS(invalid_rows);
}

START_TEST(by_hand)
{
    check_all_rows();
}
END_TEST

/* The expected numbers are read by strtod, which does heed the mode: they are read before it is
 * set. */
typedef struct {
    sure_case question;
    bisection_result expected;
} read_row;

static size_t read_rows(const row *rows, size_t count, read_row *out)
{
    for (size_t i = 0; i < count; i++) {
        ck_assert(case_read(rows[i].question, &out[i].question));
        out[i].expected = read_result(&rows[i]);
    }
    return count;
}

#define MODE_ROWS (COUNT(plane_rows) + COUNT(sphere_rows) + COUNT(cone_rows))

START_TEST(any_floating_point_mode)
{
    read_row rows[MODE_ROWS];
    bisection_result got[MODE_ROWS];
    size_t count = read_rows(plane_rows, COUNT(plane_rows), rows);
    count += read_rows(sphere_rows, COUNT(sphere_rows), rows + count);
    count += read_rows(cone_rows, COUNT(cone_rows), rows + count);
    surroundings_set(_i);
    for (size_t i = 0; i < count; i++)
        bisection_answer(&rows[i].question.ray, &rows[i].question.object, &got[i]);
    surroundings_set(0);
    for (size_t i = 0; i < count; i++)
        bisection_expect(&rows[i].question, &got[i], &rows[i].expected, surroundings_name(_i));
}
END_TEST

/* Pairs along one ray, by hand. */
typedef struct {
    const char *first, *second;
    int order;
} pair;

static const pair pairs[] = {
    /* A sphere in a cylinder touch along a circle: the same irrational root of two polynomials,
     * also where the second is written in other units, and a cone through the same circle. */
    {"sphere 0.25 0 -5 0 0 1 0 inf 0 0 0 1", "cylinder 0.25 0 -5 0 0 1 0 inf 0 -1 0 0 3 0 1", 0},
    {"sphere 0.25 0 -5 0 0 1 0 inf 0 0 0 1",
     "cylinder 0.25 0 -5 0 0 1 0 inf 0 -0x1p500 0 0 0x1p-1074 0 1", 0},
    {"sphere 0.25 0 -5 0 0 1 0 inf 0 0 0 1", "cone 0.25 0 -5 0 0 1 0 inf 0 -1 0 0 1 0 2", 0},
    {"cylinder 0.25 0 -5 0 0 1 0 inf 0 -1 0 0 3 0 1", "cone 0.25 0 -5 0 0 1 0 inf 0 -1 0 0 1 0 2",
     0},
    /* Differences that no double shows. */
    {"sphere 0.25 0 -5 0 0 1 0 inf 0 0 0 1", "sphere 0.25 0 -5 0 0 1 0 inf 0 0x1p-100 0 1", -1},
    {"sphere 0.25 0 -5 0 0 1 0 inf 0 0 0x1p-300 1", "sphere 0.25 0 -5 0 0 1 0 inf 0 0 0 1", 1},
    {"sphere 0.25 0 -5 0 0 1 0 inf 0x1p-1074 0 0 1", "sphere 0.25 0 -5 0 0 1 0 inf 0 0 0 1", -1},
    /* The two roots of one polynomial, told apart by the ray that starts inside. */
    {"sphere 0.25 0 0 0 0 1 0 inf 0 0 0 1", "sphere 0.25 0 0 0 0 1 0 inf 0 0 0x1p-1074 1", -1},
    /* A rational t against an irrational one, and rational ties. */
    {"plane 1 0 -5 0 0 1 0 inf 0 0 0x1.0p-53 0 0 1", "sphere 1 0 -5 0 0 1 0 inf 0 0 0 1", 1},
    {"plane 1 0 -5 0 0 1 0 inf 0 0 0 0 0 7", "sphere 1 0 -5 0 0 1 0 inf 0 0 0 1", 0},
    {"plane 0 0 0 0 0 3 0 inf 0 0 1 0 0 1", "sphere 0 0 0 0 0 3 0 inf 0 0 2 1", 0},
    {"plane 0 0 0 0 0 3 0 inf 0 0 1 0 0 1",
     "disc 0 0 0 0 0 3 0 inf 0 0 0x1.0000000000001p0 0 0 1 1", -1},
    /* Both infinite as doubles. */
    {"plane 0 0 0 0 0 0x1p-1074 0 inf 0 0 0x1p1000 0 0 1",
     "plane 0 0 0 0 0 0x1p-1074 0 inf 0 0 0x1p1001 0 0 1", -1},
};

START_TEST(pairs_by_hand)
{
    for (size_t i = 0; i < COUNT(pairs); i++) {
        sure_case first, second;
        ck_assert_msg(case_read(pairs[i].first, &first), "%s", pairs[i].first);
        ck_assert_msg(case_read(pairs[i].second, &second), "%s", pairs[i].second);
        ck_assert_mem_eq(&first.ray, &second.ray, sizeof first.ray);
        int order = bisection_order(&first.ray, &first.object, &second.object);
        ck_assert_msg(order == pairs[i].order, "%s\n%s\n  %d, expected %d", pairs[i].first,
                      pairs[i].second, order, pairs[i].order);
        ck_assert_int_eq(bisection_order(&first.ray, &second.object, &first.object), -order);
    }
}
END_TEST

START_TEST(comparison_by_hand)
{
    static const struct {
        const char *question;
        double x;
        int order;
    } rows[] = {
        {"sphere 0 0 0 0 0 1 0 inf 0 0 5 1", 4, 0},
        {"sphere 1 0 0 0 0 1 0 inf 0 0 5 1", 5, 0},
        {"sphere 0.6 0 0 0 0 1 0 inf 0 0 5 1", 4.2, -1}, /* 0.6 is a double below 3/5 */
        {"plane 0 0 0 0 0 3 0 inf 0 0 1 0 0 1", 0x1.5555555555555p-2, 1},
        {"plane 0 0 0 0 0 3 0 inf 0 0 1 0 0 1", 0x1.5555555555556p-2, -1},
        {"plane 0 0 -1 0 0 1 0 inf 0 0 0x1p53 0 0 1", 0x1p53, 1},
        {"plane 0 0 0 0 0 2 0 inf 0 0 0x1p-1074 0 0 1", 0, 1},
        {"plane 0 0 0 0 0 2 0 inf 0 0 0x1p-1074 0 0 1", 0x1p-1074, -1},
        {"cylinder 1 0 -1 0 0 1 1.5 inf 0 0 0 0 0 2 1", 1.5, 0},
        {"plane 0 0 0 0 0 0x1p-1074 0 inf 0 0 0x1p1023 0 0 1", 0x1.fffffffffffffp1023, 1},
        {"plane 0 0 0 0 0 0x1p-1074 0 inf 0 0 0x1p1023 0 0 1", INFINITY, -1},
        {"plane 0 0 0 0 0 1 0 inf 0 0 0 0 0 1", -INFINITY, 1},
        {"plane 0 0 0 0 0 1 0 inf 0 0 0 0 0 1", -0.0, 0},
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        sure_case question;
        ck_assert_msg(case_read(rows[i].question, &question), "%s", rows[i].question);
        int order = bisection_compare(&question.ray, &question.object, rows[i].x);
        ck_assert_msg(order == rows[i].order, "%s against %a: %d, expected %d",
                      rows[i].question, rows[i].x, order, rows[i].order);
    }
}
END_TEST

/* The first point of the pieces in the range and the lowest part that has it. */
static bool first_of(const faces *f, long t_min, long t_max, surd *first, sure_part *part)
{
    const surd low = {t_min, 0, 1}, high = {t_max, 0, 1};
    bool found = false;
    for (int i = 0; i < f->count; i++) {
        const piece *p = &f->piece[i];
        surd t = surd_order(p->low, low, f->root) < 0 ? low : p->low;
        bool outside = surd_order(t, p->high, f->root) > 0 ||
                       (t_max >= 0 && surd_order(t, high, f->root) > 0);
        int order = found && !outside ? surd_order(t, *first, f->root) : -1;
        if (outside || order > 0 || (order == 0 && p->part >= *part))
            continue;
        *first = t;
        *part = p->part;
        found = true;
    }
    return found;
}

typedef struct {
    long cases, hits;
} tally;

#define EXPECT(condition)                                                                          \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            char line[CASE_LINE_MAX], text[RESULT_TEXT_MAX];                                       \
            case_print(&question, line);                                                           \
            bisection_print(&got, text);                                                           \
            ck_abort_msg("%s: %s\n  %s", #condition, line, text);                                  \
        }                                                                                          \
    } while (0)

/* t -> -t */
static surd mirrored(surd t)
{
    return (surd){-t.u, -t.v, t.w};
}

static faces mirrored_faces(const faces *f)
{
    faces out = *f;
    for (int i = 0; i < f->count; i++) {
        out.piece[i].low = mirrored(f->piece[i].high);
        out.piece[i].high = mirrored(f->piece[i].low);
    }
    return out;
}

/* The chord's ends are the boundary's first point and its last, the first of the mirrored line. */
static void check_ends(const lattice_case *c, const faces *f)
{
    const long before_all = -1000000;
    const surd zero = {0, 0, 1};
    sure_case question = lattice_question(c, 0, -1);
    bisection_result got = bisection_of(&question);
    faces reversed = mirrored_faces(f);
    surd enter = zero, leave = zero;
    sure_part enter_part, leave_part;
    bool met = first_of(f, before_all, -1, &enter, &enter_part) &&
               first_of(&reversed, before_all, -1, &leave, &leave_part) &&
               surd_order(leave, zero, f->root) <= 0;
    EXPECT(got.interval_status == (met ? SURE_HIT : SURE_MISS));
    if (!met)
        return;
    EXPECT(surd_nearest(enter, f->root, got.interval.t_enter));
    EXPECT(surd_nearest(mirrored(leave), f->root, got.interval.t_leave));
    EXPECT(got.interval.enter_part == enter_part);
    EXPECT(got.interval.leave_part == leave_part);
}

static void check_on_lattice(const lattice_case *c, tally *total)
{
    static const int ranges[][2] = {{0, -1}, {1, -1}, {0, 1}, {1, 2}, {2, 2}};
    faces f = faces_on_line(c);
    for (size_t i = 0; i < COUNT(ranges); i++) {
        sure_case question = lattice_question(c, ranges[i][0], ranges[i][1]);
        bisection_result got = bisection_of(&question);
        surd t = {ranges[i][0], 0, 1};
        sure_part part = SURE_PART_SURFACE;
        bool hit = f.endless || first_of(&f, ranges[i][0], ranges[i][1], &t, &part);
        total->cases++;
        total->hits += hit;
        EXPECT(got.status == (hit ? SURE_HIT : SURE_MISS));
        if (!hit)
            continue;
        EXPECT(got.part == part);
        EXPECT(surd_nearest(t, f.root, got.t));
        EXPECT(normal_nearest(c, part, t, f.root, 0, got.normal.x));
        EXPECT(normal_nearest(c, part, t, f.root, 1, got.normal.y));
        EXPECT(normal_nearest(c, part, t, f.root, 2, got.normal.z));
    }
    if (!f.endless)
        check_ends(c, &f);
}

START_TEST(face_by_face)
{
    sure_shape shape = (sure_shape)_i;
    tally total = {0, 0};
    for (uint64_t index = 0; index < lattice_count(shape); index++) {
        lattice_case c = lattice_member(shape, index);
        check_on_lattice(&c, &total);
    }
    printf("%s: %ld cases on the lattice, %ld hits\n", sure_shape_name(shape), total.cases,
           total.hits);
    ck_assert_int_gt(total.hits, total.cases / 20);
    ck_assert_int_lt(total.hits, total.cases);
}
END_TEST

static TCase *case_named(Suite *suite, const char *name)
{
    TCase *tcase = tcase_create(name);
    tcase_set_timeout(tcase, 600);
    suite_add_tcase(suite, tcase);
    return tcase;
}

int main(void)
{
    Suite *suite = suite_create("bisection");
    tcase_add_test(case_named(suite, "by_hand"), by_hand);
    tcase_add_loop_test(case_named(suite, "modes"), any_floating_point_mode, 0, SURROUNDINGS);
    tcase_add_test(case_named(suite, "pairs"), pairs_by_hand);
    tcase_add_test(case_named(suite, "comparison"), comparison_by_hand);
    tcase_add_loop_test(case_named(suite, "lattice"), face_by_face, 0, SURE_SHAPES);
    return suite_run(suite);
}
