/* The first oracle against answers reasoned out by hand. */
#include <math.h>

#include <mpfr.h>

#include "reference.h"
#include "reference_answer.h"
#include "suite.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* <case> -> <answer>, and why. */
typedef struct {
    const char *question, *answer, *why;
} hand_case;

static const hand_case hand_cases[] = {
    {"plane 0 0 4 0 0 -2 0 inf 1 2 0 0 0 3", "hit 2 surface 0 0 1", "t = -N.m / N.d = 12 / 6"},
    {"plane 0 0 -4 0 0 2 0 inf 1 2 0 0 0 3", "hit 2 surface 0 0 1", "the normal as given"},
    {"plane 0 0 4 0 0 2 0 inf 1 2 0 0 0 3", "miss", "behind: t = -2"},
    {"plane 0 0 0 0 0 2 0 inf 1 2 0 0 0 -3", "hit 0 surface 0 0 -1", "from the plane"},
    {"plane 5 5 0 1 1 0 0.5 3 1 2 0 0 0 3", "hit 0.5 surface 0 0 1", "within the plane: t_min"},
    {"plane 5 5 0x1p-1074 1 1 0 0.5 3 1 2 0 0 0 3", "miss", "parallel, a step beside it"},
    {"plane 0 0 0 3 4 0 0 inf 25 0 0 3 4 0", "hit 3 surface 0.6 0.8 0", "75 / 25; (3, 4)/5"},
    {"plane 0 0 0 1 0 0 0 inf 1 0 0 0x1p-1074 0 0", "hit 1 surface 1 0 0", "the least normal"},
    {"plane 0 0 0 1 0 0 0 inf 1 0 0 0x1p1023 0x1p1023 0",
     "hit 1 surface 0x1.6a09e667f3bcdp-1 0x1.6a09e667f3bcdp-1 0", "the greatest, 1/sqrt 2 twice"},
    {"plane 0 0 0 1 0 0 0 inf 1 0 0 1 -0x1p-1074 0", "hit 1 surface 1 -0x1p-1074 0",
     "N.y/|N| just above -2^-1074: a subnormal component"},

    {"plane 0 0 0 3 0 0 0 0x1.5555555555555p-2 1 0 0 1 0 0", "miss", "1/3 is beyond that t_max"},
    {"plane 0 0 0 3 0 0 0 0x1.5555555555556p-2 1 0 0 1 0 0",
     "hit 0x1.5555555555555p-2 surface 1 0 0", "1/3 rounds to below 1/3"},
    {"plane 0 0 0 3 0 0 0x1.5555555555555p-2 inf 1 0 0 1 0 0",
     "hit 0x1.5555555555555p-2 surface 1 0 0", "1/3 is after that t_min"},
    {"plane 0 0 0 3 0 0 0x1.5555555555556p-2 inf 1 0 0 1 0 0", "miss", "1/3 is before that t_min"},

    /* t = 2^54 - 1, times 2^970, comes from Q.x - o.x, which no double holds. */
    {"plane -1 0 0 1 0 0 0 inf 0x1.fffffffffffffp+53 0 0 1 0 0", "hit 0x1p54 surface 1 0 0",
     "2^54 - 1 is halfway between two doubles, and 2^54 the even one"},
    {"plane -1 0 0 1 0 0 0 inf 0x1.ffffffffffffep+53 0 0 1 0 0",
     "hit 0x1.ffffffffffffep+53 surface 1 0 0", "2^54 - 3 is halfway too, and the lower is even"},
    {"plane -0x1.fffffffffffffp-1 0 0 1 0 0 0 inf 0x1.fffffffffffffp+53 0 0 1 0 0",
     "hit 0x1.fffffffffffffp+53 surface 1 0 0", "2^-53 below that halfway"},
    {"plane -1 0 0 0x1p-970 0 0 0 inf 0x1.fffffffffffffp+53 0 0 1 0 0", "hit inf surface 1 0 0",
     "halfway to 2^1024: the tie overflows"},
    {"plane -0x1.fffffffffffffp-1 0 0 0x1p-970 0 0 0 inf 0x1.fffffffffffffp+53 0 0 1 0 0",
     "hit 0x1.fffffffffffffp+1023 surface 1 0 0", "just below that, the largest double"},
    {"plane -1 0 0 0x1p-970 0 0 0 0x1.fffffffffffffp+1023 0x1.fffffffffffffp+53 0 0 1 0 0", "miss",
     "its real t is beyond the largest double"},
    {"plane 0 0 0 0x1p1015 0 0 0 inf 0x1p-60 0 0 1 0 0", "hit 0 surface 1 0 0",
     "2^-1075, halfway to the least double: 0 is even"},
    {"plane 0 0 0 0x1p1015 0 0 0 inf 0x3p-60 0 0 1 0 0", "hit 0x2p-1074 surface 1 0 0",
     "1.5 least doubles: 2 is even"},
    {"plane 0 0 0 0x1p1015 0 0 0 inf 0x5p-60 0 0 1 0 0", "hit 0x2p-1074 surface 1 0 0",
     "2.5 least doubles: 2 is even"},
    {"plane 0 0 0 0x1p1015 0 0 0 inf 0x1.0000000000001p-60 0 0 1 0 0",
     "hit 0x1p-1074 surface 1 0 0", "a little over half the least double"},
    {"plane 0 0 0 0x1p1015 0 0 0x1p-1074 inf 0x1p-60 0 0 1 0 0", "miss",
     "and before a t_min of the least double"},

    {"disc 0 0 4 3 4 -4 0 inf 0 0 0 0 0 2 5", "hit 1 surface 0 0 1", "the rim, at (3, 4, 0)"},
    {"disc 0 0 4 3 4 -4 0 inf 0 0 0 0 0 2 0x1.3ffffffffffffp+2", "miss", "radius one ulp smaller"},
    {"disc 0 0 4 0 0 -1 0 inf 0 0 0 0 0 2 0", "hit 4 surface 0 0 1", "a point"},
    {"disc 0 0 4 0x1p-1074 0 -1 0 inf 0 0 0 0 0 2 0", "miss", "a point, missed by 2^-1072"},
    {"disc -10 3 0 1 0 0 0 inf 0 0 0 0 0 2 5", "hit 6 surface 0 0 1", "in its plane, from 6 to 14"},
    {"disc -10 3 0 1 0 0 8 inf 0 0 0 0 0 2 5", "hit 8 surface 0 0 1", "all of it is the disc"},
    {"disc -10 3 0 1 0 0 14 inf 0 0 0 0 0 2 5", "hit 14 surface 0 0 1", "its last point"},
    {"disc -10 3 0 1 0 0 0x1.c000000000001p+3 inf 0 0 0 0 0 2 5", "miss", "one ulp later"},
    {"disc -10 3 0 1 0 0 0 0x1.7ffffffffffffp+2 0 0 0 0 0 2 5", "miss", "one ulp too early"},
    {"disc -10 5 0 1 0 0 0 inf 0 0 0 0 0 2 5", "hit 10 surface 0 0 1", "in its plane, tangent"},
    {"disc -10 0x1.4000000000001p+2 0 1 0 0 0 inf 0 0 0 0 0 2 5", "miss", "one ulp outside"},
    {"disc -10 0 0 1 0 0 0 inf 0 0 0 0 0 2 0", "hit 10 surface 0 0 1", "in its plane, a point"},
    {"disc -10 3 0x1p-1074 1 0 0 0 inf 0 0 0 0 0 2 5", "miss", "beside its plane"},

    {"sphere -5 0 0 1 0 0 0 inf 0 0 0 1", "hit 4 surface -1 0 0", "head on"},
    {"sphere -5 1 0 1 0 0 0 inf 0 0 0 1", "hit 5 surface 0 1 0", "tangent: D/4 = 0"},
    {"sphere -5 0x1.0000000000001p+0 0 1 0 0 0 inf 0 0 0 1", "miss", "one ulp outside"},
    {"sphere -5 0x1.fffffffffffffp-1 0 1 0 0 0 inf 0 0 0 1",
     "hit 0x1.3ffffffp+2 surface -0x1p-26 0x1.fffffffffffffp-1 0",
     "one ulp inside: sqrt(2^-52 - 2^-106) is 2^-81 below 2^-26"},
    {"sphere 0 0 0 0 3 4 0 inf 0 0 0 5", "hit 1 surface 0 0.6 0.8", "from the centre outwards"},
    {"sphere -1 0 0 1 0 0 0 inf 0 0 0 1", "hit 0 surface -1 0 0", "from the boundary inwards"},
    {"sphere -1 0 0 1 0 0 0x1p-1074 inf 0 0 0 1", "hit 2 surface 1 0 0", "the same a moment later"},
    {"sphere 1 0 0 1 0 0 0 inf 0 0 0 1", "hit 0 surface 1 0 0", "from the boundary outwards"},
    {"sphere 1 0 0 1 0 0 0x1p-1074 inf 0 0 0 1", "miss", "the same a moment later"},
    {"sphere 0 0 0 1 0 0 0 0x1.fffffffffffffp-1 0 0 0 1", "miss", "the ray ends inside"},
    {"sphere 0 0 0 1 0 0 0 0 0 0 0 1", "miss", "a ray of one point, inside"},
    {"sphere -1 0 0 1 0 0 0 0 0 0 0 1", "hit 0 surface -1 0 0", "a ray of one point, boundary"},
    {"sphere -5 0 0 1 0 0 0 inf 0 0 0 0", "hit 5 surface -1 0 0", "a point: the normal is -d/|d|"},
    {"sphere 3 4 0 -3 -4 0 0 inf 0 0 0 0", "hit 1 surface 0.6 0.8 0", "a point"},
    {"sphere -5 0x1p-1074 0 1 0 0 0 inf 0 0 0 0", "miss", "beside a point"},
    {"sphere -5 0x1p-1074 0 1 0 0 0 inf 0 0 0 0x1p-1074", "hit 5 surface 0 1 0",
     "the least sphere, tangent"},
    {"sphere 0 0 0 0x1p-100 0 0 0 inf 0x1p1000 0 0 0x1p999", "hit inf surface -1 0 0",
     "t* = 2^1099"},
    {"sphere 0 0 0 0x1p-100 0 0 0 0x1.fffffffffffffp+1023 0x1p1000 0 0 0x1p999", "miss",
     "t* is beyond the largest double"},
    {"sphere 0 0 0 0x1p1000 0 0 0 inf 0x1p-100 0 0 0x1p-101", "hit 0 surface -1 0 0",
     "t* = 2^-1101 rounds to 0"},
    {"sphere 0 0 0 0x1p1000 0 0 0x1p-1074 inf 0x1p-100 0 0 0x1p-101", "miss",
     "both ends before the least positive t_min"},
    {"sphere 0 0 0 0x1p-1074 0 0 0 inf 0x1.8p1000 0 0 0x1p1000", "hit inf surface -1 0 0",
     "t* = 2^2073: a product of doubles would be neither 0 nor finite"},
    {"sphere 0 1 0 0 0 1 0 inf 0 -0x1p-53 5 2",
     "hit 0x1.a24c28bd3d9abp+1 surface 0 0.5 -0x1.bb67ae8584caap-1",
     "n.y = (1 + 2^-53) / 2 is halfway, 0.5 even; t = 5 - sqrt(3 - 2^-52 - 2^-106)"},

    {"cylinder -5 0 1 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 4 wall -1 0 0", "the wall"},
    {"cylinder 0 0 1 3 4 0 0 inf 0 0 0 0 0 2 5", "hit 1 wall 0.6 0.8 0", "the wall from inside"},
    {"cylinder 0 0 -3 0 0 1 0 inf 0 0 0 0 0 2 1", "hit 3 base 0 0 -1", "the base, along the axis"},
    {"cylinder 0 0 5 0 0 -1 0 inf 0 0 0 0 0 2 1", "hit 3 top 0 0 1", "the top, along the axis"},
    {"cylinder 0 0 1 0 0 -1 0 inf 0 0 0 0 0 2 1", "hit 1 base 0 0 -1", "the base from inside"},
    {"cylinder -5 0 0 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 4 base 0 0 -1", "in the base's plane"},
    {"cylinder -5 0 0 1 0 0 5 inf 0 0 0 0 0 2 1", "hit 5 base 0 0 -1", "there, all is boundary"},
    {"cylinder -5 0 2 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 4 top 0 0 1", "in the top's plane"},
    {"cylinder -5 0 0x1.0000000000001p+1 1 0 0 0 inf 0 0 0 0 0 2 1", "miss", "one ulp above it"},
    {"cylinder -5 0 -0x1p-1074 1 0 0 0 inf 0 0 0 0 0 2 1", "miss", "a step below the base"},
    {"cylinder -5 1 0 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 5 base 0 0 -1",
     "in the base's plane, tangent to the rim"},
    {"cylinder -5 1 1 1 0 0 0 inf 0 0 0 0 0 2 1", "hit 5 wall 0 1 0", "tangent to the wall"},
    {"cylinder -5 0x1.0000000000001p+0 1 1 0 0 0 inf 0 0 0 0 0 2 1", "miss", "one ulp outside"},
    {"cylinder -5 1 -9 1 0 2 0 inf 0 0 0 0 0 2 1", "hit 5 wall 0 1 0", "tangent, on the slant"},
    {"cylinder -5 1 -7 1 0 2 0 inf 0 0 0 0 0 2 1", "miss", "tangent to the wall above the top"},
    {"cylinder -5 1 -8 1 0 2 0 inf 0 0 0 0 0 2 1", "hit 5 top 0 0 1", "tangent at the top's rim"},
    {"cylinder 1 0 -3 0 0 1 0 inf 0 0 0 0 0 2 1", "hit 3 base 0 0 -1", "along the wall: a = c = 0"},
    {"cylinder 1 0 -3 0 0 1 3.5 inf 0 0 0 0 0 2 1", "hit 3.5 wall 1 0 0", "all is boundary there"},
    {"cylinder 1 0 -3 0 0 1 5 inf 0 0 0 0 0 2 1", "hit 5 top 0 0 1", "its last point"},
    {"cylinder 1 0 -3 0 0 1 0x1.4000000000001p+2 inf 0 0 0 0 0 2 1", "miss", "one ulp later"},
    {"cylinder 0x1.0000000000001p+0 0 -3 0 0 1 0 inf 0 0 0 0 0 2 1", "miss", "a = 0, c > 0"},
    {"cylinder 0x1.fffffffffffffp-1 0 -3 0 0 1 3.5 inf 0 0 0 0 0 2 1", "hit 5 top 0 0 1",
     "a = 0, c < 0: inside from 3 to 5"},
    {"cylinder -2 0 -1 1 0 1 0 inf 0 0 0 0 0 2 1", "hit 1 base 0 0 -1", "through both rims"},
    {"cylinder -2 0 -1 1 0 1 2 inf 0 0 0 0 0 2 1", "hit 3 top 0 0 1", "the rim at which it leaves"},
    {"cylinder -2 0 1 1 0 -1 0 inf 0 0 0 0 0 2 1", "hit 1 base 0 0 -1", "touches a rim only"},
    {"cylinder -2 0 0x1.fffffffffffffp-1 1 0 -1 0 inf 0 0 0 0 0 2 1", "miss", "misses the rim"},
    {"cylinder -5 0 1 1 0 0 0 inf 0 0 0 0 0 2 0", "hit 5 wall -1 0 0", "a segment, across"},
    {"cylinder -5 0 0 1 0 0 0 inf 0 0 0 0 0 2 0", "hit 5 base 0 0 -1", "its end"},
    {"cylinder -5 0 2 1 0 0 0 inf 0 0 0 0 0 2 0", "hit 5 top 0 0 1", "its other end"},
    {"cylinder 0 0 -3 0 0 2 0 inf 0 0 0 0 0 2 0", "hit 1.5 base 0 0 -1", "along it"},
    {"cylinder 0 0 -3 0 0 2 2 inf 0 0 0 0 0 2 0", "hit 2 wall 0 0 -1", "along it, from within"},
    {"cylinder 0 0 -3 0 0 2 2.5 inf 0 0 0 0 0 2 0", "hit 2.5 top 0 0 1", "its last point"},
    {"cylinder -5 0x1p-1074 1 1 0 0 0 inf 0 0 0 0 0 2 0", "miss", "beside it"},
    {"cylinder 0 0 0 0x1p900 0 0 0 inf 0x1p1000 -0x1p1000 0 0x1p1000 0x1p1000 0 0x1p999",
     "hit 0x1p99 wall -1 0 0", "(2^1000 - 2^999) / 2^900, coordinates whose squares overflow"},
    {"cylinder 0 0 0 0x1p-1000 0 0 0 inf 0x1p-1000 -0x1p-1000 0 0x1p-1000 0x1p-1000 0 0x1p-1001",
     "hit 0.5 wall -1 0 0", "and whose squares underflow"},

    /* Base of radius 3 around 0, apex at z = 4, slant 5: the wall's normal is (4/5 out, 3/5 up). */
    {"cone -10 0 2 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 8.5 wall -0.8 0 0.6", "radius 1.5 at z = 2"},
    {"cone 0 0 1 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 2.25 wall 0.8 0 0.6", "from inside, z = 1"},
    {"cone 0 0 -1 0 0 1 0 inf 0 0 0 0 0 4 3", "hit 1 base 0 0 -1", "the base, along the axis"},
    {"cone 0 0 -1 0 0 1 2 inf 0 0 0 0 0 4 3", "hit 5 wall 0 0 1", "the apex from inside"},
    {"cone 0 0 10 0 0 -1 0 inf 0 0 0 0 0 4 3", "hit 6 wall 0 0 1", "the apex: a < 0, D = 0"},
    {"cone -10 0 4 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 10 wall 0 0 1", "touches the apex only: a > 0"},
    {"cone -10 0 0x1.0000000000001p+2 1 0 0 0 inf 0 0 0 0 0 4 3", "miss", "one ulp above it"},
    {"cone -3 0 8 3 0 -4 0 inf 0 0 0 0 0 4 3", "hit 1 wall 0 0 1", "a = b = c = 0: a generator"},
    {"cone -3 0 8 3 0 -4 1.5 inf 0 0 0 0 0 4 3", "hit 1.5 wall 0.8 0 0.6", "all of it boundary"},
    {"cone -3 0 8 3 0 -4 2 inf 0 0 0 0 0 4 3", "hit 2 base 0 0 -1", "its foot"},
    {"cone -3 0 8 3 0 -4 0x1.0000000000001p+1 inf 0 0 0 0 0 4 3", "miss", "one ulp later"},
    {"cone -3 0x1p-1074 8 3 0 -4 0 inf 0 0 0 0 0 4 3", "miss", "a = b = 0, c > 0: beside it"},
    {"cone -5 0 -4 3 0 4 0 inf 0 0 0 0 0 4 3", "hit 1 base 0 0 -1", "a = 0: enters by the base"},
    {"cone -5 0 -4 3 0 4 1.5 inf 0 0 0 0 0 4 3", "hit 0x1.d555555555555p+0 wall 0.8 0 0.6",
     "a = 0: 3 t - 5 = 3 (4 - (4 t - 4)) / 4 at t = 11/6"},
    {"cone -7 0 -4 3 0 4 0 inf 0 0 0 0 0 4 3", "miss", "a = 0, on the other nappe's side"},
    {"cone 1 0 -4 0 0 1 0 inf 0 0 0 0 0 4 3", "hit 4 base 0 0 -1", "a < 0: enters by the base"},
    {"cone 1 0 -4 0 0 1 5 inf 0 0 0 0 0 4 3", "hit 0x1.aaaaaaaaaaaabp+2 wall 0.8 0 0.6",
     "a < 0: leaves by the wall at z = 8/3"},
    {"cone 1 0 8 0 0 -1 0 inf 0 0 0 0 0 4 3", "hit 0x1.5555555555555p+2 wall 0.8 0 0.6",
     "a < 0: enters by the wall, not by the other nappe"},
    {"cone 3 0 -4 0 0 1 0 inf 0 0 0 0 0 4 3", "hit 4 base 0 0 -1", "touches the rim only"},
    {"cone 0x1.8000000000001p+1 0 -4 0 0 1 0 inf 0 0 0 0 0 4 3", "miss", "one ulp outside the rim"},
    {"cone -10 0 6 1 0 0 0 inf 0 0 0 0 0 4 3", "miss", "the other nappe"},
    {"cone -10 0 0 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 7 base 0 0 -1", "in the base's plane"},
    {"cone -10 0 0 1 0 0 9 inf 0 0 0 0 0 4 3", "hit 9 base 0 0 -1", "there all is boundary"},
    {"cone -10 3 0 1 0 0 0 inf 0 0 0 0 0 4 3", "hit 10 base 0 0 -1", "there, tangent to the rim"},
    {"cone -10 0 -0x1p-1074 1 0 0 0 inf 0 0 0 0 0 4 3", "miss", "a step below the base"},
    {"cone -1.5 -10 2 0 1 0 0 inf 0 0 0 0 0 4 3", "hit 10 wall -0.8 0 0.6", "tangent to the wall"},
    {"cone -0x1.8000000000001p+0 -10 2 0 1 0 0 inf 0 0 0 0 0 4 3", "miss", "one ulp outside"},
    {"cone -10 0 2 1 0 0 0 inf 0 0 0 0 0 4 0", "hit 10 wall -1 0 0", "a segment, across"},
    {"cone -10 0 4 1 0 0 0 inf 0 0 0 0 0 4 0", "hit 10 wall 0 0 1", "its apex"},
    {"cone -10 0 0 1 0 0 0 inf 0 0 0 0 0 4 0", "hit 10 base 0 0 -1", "its base"},
    {"cone 0 0 9 0 0 -1 0 inf 0 0 0 0 0 4 0", "hit 5 wall 0 0 1", "along it, the apex first"},
    {"cone 0 0 9 0 0 -1 6 inf 0 0 0 0 0 4 0", "hit 6 wall 0 0 1", "along it, from within: -d/|d|"},
    {"cone 0 0 9 0 0 -1 9 inf 0 0 0 0 0 4 0", "hit 9 base 0 0 -1", "its last point"},
    {"cone -0x1p1000 0 0x1p999 0x1p990 0 0 0 inf 0 0 0 0 0 0x1p1000 0x1.8p999",
     "hit 0x1.4p9 wall -0.8 0 0.6", "the same cone times 2^998: x = -0.75 2^999 at t = 640"},

    {"sphere nan 0 0 0 0 0 -1 nan nan 0 0 -1", "invalid o", "everything wrong: the first field"},
    {"sphere inf 0 0 1 0 0 0 inf 0 0 0 1", "invalid o", "not finite"},
    {"sphere 0 0 0 0 -0 0 -1 nan nan 0 0 -1", "invalid d", "zero, whatever its sign"},
    {"sphere 0 0 0 0 0 inf -1 nan nan 0 0 -1", "invalid d", "not finite"},
    {"sphere 0 0 0 1 0 0 -0x1p-1074 nan nan 0 0 -1", "invalid t_min", "negative"},
    {"sphere 0 0 0 1 0 0 inf inf 0 0 0 1", "invalid t_min", "not finite"},
    {"sphere 0 0 0 1 0 0 nan inf 0 0 0 1", "invalid t_min", "not a number"},
    {"sphere 0 0 0 1 0 0 1 0x1.fffffffffffffp-1 nan 0 0 -1", "invalid t_max", "before t_min"},
    {"sphere 0 0 0 1 0 0 0 nan 0 0 0 1", "invalid t_max", "not a number"},
    {"sphere 0 0 0 1 0 0 0 -inf 0 0 0 1", "invalid t_max", "before t_min"},
    {"sphere 0 0 0 1 0 0 -0 -0 nan 0 0 -1", "invalid centre", "-0 is a valid t_min and t_max"},
    {"sphere 0 0 0 1 0 0 0 1 0 0 0 -0x1p-1074", "invalid radius", "negative"},
    {"sphere 0 0 0 1 0 0 0 1 0 0 0 inf", "invalid radius", "not finite"},
    {"sphere 0 0 0 1 0 0 0 1 0 0 0 -0", "hit 0 surface -1 0 0", "-0 is a valid radius"},
    {"plane 0 0 0 1 0 0 0 1 0 nan 0 0 0 0", "invalid point", "before the normal"},
    {"plane 0 0 0 1 0 0 0 1 0 0 0 0 -0 0", "invalid normal", "zero"},
    {"plane 0 0 0 1 0 0 0 1 0 0 0 1 inf 0", "invalid normal", "not finite"},
    {"disc 0 0 0 1 0 0 0 1 0 inf 0 0 0 0 nan", "invalid centre", "before normal and radius"},
    {"disc 0 0 0 1 0 0 0 1 0 0 0 0 0 0 nan", "invalid normal", "before the radius"},
    {"disc 0 0 0 1 0 0 0 1 0 0 0 0 0 1 nan", "invalid radius", "not a number"},
    {"cylinder 0 0 0 1 0 0 0 1 nan 0 0 0 nan 1 -1", "invalid base", "before top and radius"},
    {"cylinder 0 0 0 1 0 0 0 1 0 0 0 0 inf 1 -1", "invalid top", "before the radius"},
    {"cylinder 0 0 0 1 0 0 0 1 0 5 0 -0 5 0 -1", "invalid top", "top = base"},
    {"cylinder 0 0 0 1 0 0 0 1 0 0 0 0 0 1 -1", "invalid radius", "negative"},
    {"cone 0 0 0 1 0 0 0 1 nan 0 0 0 nan 1 -1", "invalid base", "before apex and radius"},
    {"cone 0 0 0 1 0 0 0 1 0 5 0 -0 5 0 -1", "invalid apex", "apex = base"},
    {"cone 0 0 0 1 0 0 0 1 0 0 0 0 0 1 nan", "invalid radius", "not a number"},
};

START_TEST(test_hand_cases)
{
    const hand_case *hand = &hand_cases[_i];
    sure_case question = case_of(hand->question);
    case_answer expected;
    ck_assert_msg(case_answer_read(hand->answer, &expected), "not an answer: %s", hand->answer);
    expect_answer(&question, &expected, hand->why);
}
END_TEST

/* <case> -> both ends of the chord. */
typedef struct {
    const char *question;
    sure_status status;
    sure_interval chord;
    const char *why;
} chord_case;

#define SURFACE SURE_PART_SURFACE
#define BASE SURE_PART_BASE
#define TOP SURE_PART_TOP
#define WALL SURE_PART_WALL

static const chord_case chord_cases[] = {
    {"plane 0 0 0 1 0 0 7 8 3 0 0 0 1 0", SURE_HIT, {-INFINITY, INFINITY, SURFACE, SURFACE},
     "the line lies in the plane"},
    {"plane 0 0 0 1 0 0 0 2 3 0 0 1 0 0", SURE_MISS, {0, 0, BASE, BASE},
     "the chord is one point, beyond t_max"},
    {"plane 0 0 0 1 0 0 0 3 3 0 0 1 0 0", SURE_HIT, {3, 3, SURFACE, SURFACE}, "and at t_max"},
    {"disc 0 3 0 1 0 0 1 2 0 0 0 0 0 1 5", SURE_HIT, {-4, 4, SURFACE, SURFACE}, "in its plane"},
    {"sphere 0 0 0 1 0 0 0.25 0.5 0 0 0 1", SURE_HIT, {-1, 1, SURFACE, SURFACE},
     "the ray is wholly inside: unclipped"},
    {"sphere 0 0 0 1 0 0 0 inf -1 0 0 1", SURE_HIT, {-2, 0, SURFACE, SURFACE}, "leaves at t_min"},
    {"sphere 0 0 0 1 0 0 0x1p-1074 inf -1 0 0 1", SURE_MISS, {0, 0, BASE, BASE},
     "has left before t_min"},
    {"sphere 0 0 0 1 0 0 0 1 2 0 0 1", SURE_HIT, {1, 3, SURFACE, SURFACE}, "enters at t_max"},
    {"sphere 0 0 0 0x1p-100 0 0 0 0 0 0 0 0x1p999", SURE_HIT,
     {-INFINITY, INFINITY, SURFACE, SURFACE}, "ends that overflow"},
    {"sphere 0 0 0 0x1p1000 0 0 0 0 0 0 0 0x1p-1000", SURE_HIT, {0, 0, SURFACE, SURFACE},
     "ends that underflow, the first to +0"},
    {"cylinder 1 0 0 1 0 0 0 inf -0x1.fffffffffffffp+53 0 0 5 0 0 1", SURE_HIT,
     {-0x1p54, 4, BASE, TOP}, "1 - 2^54 is halfway, and -2^54 even"},
    {"cylinder 1 0 0 1 0 0 0 inf -0x1.ffffffffffffep+53 0 0 5 0 0 1", SURE_HIT,
     {-0x1.ffffffffffffep+53, 4, BASE, TOP}, "3 - 2^54 is halfway, and 4 - 2^54 even"},
    {"cylinder 0 0 0 0x1p1015 0 0 0 inf -0x3p-60 0 0 0x5p-60 0 0 1", SURE_HIT,
     {-0x2p-1074, 0x2p-1074, BASE, TOP}, "-1.5 and 2.5 least doubles: 2 is even"},
    {"cylinder -2 0 -1 1 0 1 0 inf 0 0 0 0 0 2 1", SURE_HIT, {1, 3, BASE, TOP}, "rim to rim"},
    {"cylinder 0 0 1 1 0 0 0 inf 0 0 0 0 0 2 1", SURE_HIT, {-1, 1, WALL, WALL}, "wall to wall"},
    {"cylinder 0 0 0 0 0 -4 0 inf 0 0 0 0 0 2 1", SURE_HIT, {-0.5, 0, TOP, BASE}, "along the axis"},
    {"cylinder 1 0 0 0 0 2 0 inf 0 0 0 0 0 2 1", SURE_HIT, {0, 1, BASE, TOP}, "along the wall"},
    {"cone 1 0 8 0 0 -1 0 inf 0 0 0 0 0 4 3", SURE_HIT, {0x1.5555555555555p+2, 8, WALL, BASE},
     "a < 0: from the wall at z = 8/3"},
    {"cone 0 0 10 0 0 -1 0 inf 0 0 0 0 0 4 3", SURE_HIT, {6, 10, WALL, BASE}, "along the axis"},
    {"cone -3 0 8 3 0 -4 0 inf 0 0 0 0 0 4 3", SURE_HIT, {1, 2, WALL, BASE}, "along a generator"},
    {"cone -10 0 4 1 0 0 0 inf 0 0 0 0 0 4 3", SURE_HIT, {10, 10, WALL, WALL}, "the apex"},
    {"cone -5 0 -4 3 0 4 0 inf 0 0 0 0 0 4 3", SURE_HIT, {1, 0x1.d555555555555p+0, BASE, WALL},
     "a = 0: one end is the base"},
};

START_TEST(test_chords)
{
    const chord_case *hand = &chord_cases[_i];
    const sure_interval untouched = {77, 78, WALL, WALL};
    sure_case question = case_of(hand->question);
    sure_interval is = untouched, ought = hand->status == SURE_HIT ? hand->chord : untouched;
    ck_assert_msg(reference_interval(&question.ray, &question.object, &is) == hand->status, "%s",
                  hand->why);
    ck_assert_msg(same_number(is.t_enter, ought.t_enter) && same_number(is.t_leave, ought.t_leave),
                  "%s: %s: %a, %a", hand->why, hand->question, is.t_enter, is.t_leave);
    ck_assert_msg(is.enter_part == ought.enter_part && is.leave_part == ought.leave_part, "%s: %s",
                  hand->why, hand->question);
}
END_TEST

/* <case> -> the signs behind it. */
typedef struct {
    const char *question;
    reference_decisions signs;
} signs_case;

#define NONE REFERENCE_NONE

static const signs_case signs_cases[] = {
    {"plane 0 0 4 0 0 -1 0 inf 0 0 0 0 0 1",
     {NONE, NONE, -1, 0, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"disc 0 0 4 3 4 -4 0 inf 0 0 0 0 0 1 5",
     {NONE, NONE, -1, 0, {NONE, NONE}, {NONE, NONE}, 0, NONE}},
    {"disc 0 0 4 3 4 -4 0 inf 0 0 0 0 0 1 6",
     {NONE, NONE, -1, 0, {NONE, NONE}, {NONE, NONE}, -1, NONE}},
    {"disc 9 5 0 1 0 0 0 inf 0 0 0 0 0 1 5",
     {NONE, 0, 0, 0, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"sphere 9 2 0 1 0 0 0 inf 0 0 0 1",
     {1, -1, NONE, 0, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"sphere 9 1 0 1 0 0 0 inf 0 0 0 1",
     {1, 0, NONE, 1, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"sphere 9 0 0 1 0 0 0 inf 0 0 0 1",
     {1, 1, NONE, 2, {NONE, NONE}, {NONE, NONE}, NONE, NONE}},
    {"cylinder -2 0 -1 1 0 1 0 inf 0 0 0 0 0 2 1",
     {1, 1, 1, 2, {0, 1}, {-1, 0}, 0, 0}},
    {"cylinder -2 0 -2 1 0 1 0 inf 0 0 0 0 0 2 1",
     {1, 1, 1, 2, {-1, 1}, {-1, -1}, -1, 1}},
    {"cylinder 1 0 -2 0 0 1 0 inf 0 0 0 0 0 2 1",
     {0, 0, 1, 0, {NONE, NONE}, {NONE, NONE}, 0, 0}},
    {"cylinder 9 0 5 1 0 0 0 inf 0 0 0 0 0 2 1",
     {1, 1, 0, 2, {1, 1}, {1, 1}, NONE, NONE}},
    {"cone 1 0 8 0 0 -1 0 inf 0 0 0 0 0 4 3",
     {-1, 1, -1, 2, {1, 1}, {1, -1}, -1, NONE}},
    {"cone -10 0 4 1 0 0 0 inf 0 0 0 0 0 4 3",
     {1, 0, 0, 1, {1, NONE}, {0, NONE}, NONE, NONE}},
    {"cone -5 0 -4 3 0 4 0 inf 0 0 0 0 0 4 3",
     {0, 1, 1, 1, {1, NONE}, {-1, NONE}, -1, NONE}},
    {"cone -3 0 8 3 0 -4 0 inf 0 0 0 0 0 4 3",
     {0, 0, -1, 0, {NONE, NONE}, {NONE, NONE}, 0, NONE}},
};

START_TEST(test_signs)
{
    const reference_decisions *ought = &signs_cases[_i].signs;
    sure_case question = case_of(signs_cases[_i].question);
    reference_decisions is;
    ck_assert_int_eq(reference_decide(&question.ray, &question.object, &is), SURE_HIT);
    ck_assert_int_eq(is.leading, ought->leading);
    ck_assert_int_eq(is.discriminant, ought->discriminant);
    ck_assert_int_eq(is.axis, ought->axis);
    ck_assert_int_eq(is.roots, ought->roots);
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(is.base_side[i], ought->base_side[i]);
        ck_assert_int_eq(is.top_side[i], ought->top_side[i]);
    }
    ck_assert_int_eq(is.base_cap, ought->base_cap);
    ck_assert_int_eq(is.top_cap, ought->top_cap);
}
END_TEST

/* The ray of the first and the objects of both -> which is hit first. */
typedef struct {
    const char *first, *second;
    sure_status status;
    int order;
    const char *why;
} order_case;

static const order_case order_cases[] = {
    {"sphere 0.5 0 0 0 1 0 0 inf 0 5 0 1", "sphere 0 0 0 1 0 0 0 1 0 5 0 1", SURE_HIT, 0,
     "the same irrational t"},
    {"sphere 0.5 0 0 0 1 0 0 inf 0 5 0 1", "sphere 0 0 0 1 0 0 0 1 0 5 0 0x1.0000000000001p+0",
     SURE_HIT, 1, "a sphere larger by an ulp comes sooner"},
    {"sphere 0.5 0 0 0 1 0 0 inf 0 5 0 1", "cylinder 0 0 0 1 0 0 0 1 0 5 -1 0 5 2 1", SURE_HIT, 0,
     "sphere and cylinder of one cross-section: 5 - sqrt(3/4) of two quadratics"},
    {"sphere 0.5 0 0 0 1 0 0 inf 0 5 0 1",
     "cylinder 0 0 0 1 0 0 0 1 0 5 -1 0 5 2 0x1.fffffffffffffp-1", SURE_HIT, -1,
     "the cylinder one ulp thinner"},
    {"cone 0 -9 2 0 1 0 0 inf 0 0 0 0 0 4 2", "cylinder 0 0 0 1 0 0 0 1 0 0 0 0 0 4 1", SURE_HIT, 0,
     "cone and cylinder where they are equally wide"},
    {"cone 0.25 -9 2 0 1 0 0 inf 0 0 0 0 0 4 2", "sphere 0 0 0 1 0 0 0 1 0 0 2 1", SURE_HIT, 0,
     "cone and sphere, 9 - sqrt(15)/4 of two quadratics"},
    {"cone 0.25 -9 2 0 1 0 0 inf 0 0 0 0 0 4 2",
     "sphere 0 0 0 1 0 0 0 1 0 0 0x1.0000000000001p+1 1", SURE_HIT, -1,
     "the sphere's centre moved"},
    {"plane 0 0 0 3 0 0 0 inf 1 0 0 1 0 0", "plane 0 0 0 1 0 0 0 1 2 5 7 3 0 0", SURE_HIT, -1,
     "1/3 before 2/3"},
    {"plane 0 0 0 3 0 0 0 inf 1 0 0 1 0 0", "sphere 0 0 0 1 0 0 0 1 2 0 0 1", SURE_HIT, 0,
     "1/3 twice"},
    {"sphere 0 0 0 1 0 0 0 inf 5 0 0 1", "sphere 0 0 0 1 0 0 0 1 0 5 0 1", SURE_MISS, 77,
     "the second is missed"},
    {"sphere 0 0 0 1 0 0 0 inf 0 5 0 1", "sphere 0 0 0 1 0 0 0 1 0 5 0 nan", SURE_INVALID, 77,
     "the first is missed, the second invalid"},
};

START_TEST(test_order)
{
    const order_case *hand = &order_cases[_i];
    sure_case first = case_of(hand->first), second = case_of(hand->second);
    int order = 77, reverse = 77;
    sure_status status = reference_hit_order(&first.ray, &first.object, &second.object, &order);
    ck_assert_msg(status == hand->status && order == hand->order, "%s: order %d", hand->why, order);
    reference_hit_order(&first.ray, &second.object, &first.object, &reverse);
    ck_assert_int_eq(reverse, status == SURE_HIT ? -order : 77);
}
END_TEST

/* On a miss or an invalid input nothing is written; a NULL output is none. */
START_TEST(test_outputs)
{
    static const char *lines[] = {"sphere 0 9 0 1 0 0 0 inf 0 0 0 1",
                                  "sphere 0 9 0 0 0 0 0 inf 0 0 0 1"};
    for (size_t i = 0; i < COUNT(lines); i++) {
        sure_case q = case_of(lines[i]);
        double t = 77;
        sure_part part = SURE_PART_TOP;
        sure_vec3 n = {77, 78, 79};
        int sign = 77;
        sure_status status = reference_hit(&q.ray, &q.object, &t, &part, &n);
        ck_assert_int_eq(status, i == 0 ? SURE_MISS : SURE_INVALID);
        ck_assert_int_eq(reference_compare_hit(&q.ray, &q.object, 0, &sign), status);
        ck_assert_int_eq(reference_hit_within(&q.ray, &q.object, 0, INFINITY, &sign), status);
        ck_assert_int_eq(reference_normal_within(&q.ray, &q.object, n, INFINITY, &sign), status);
        ck_assert(t == 77 && part == SURE_PART_TOP && n.x == 77 && n.y == 78 && n.z == 79);
        ck_assert_int_eq(sign, 77);
    }
    sure_case q = case_of("sphere -5 0 0 1 0 0 0 inf 0 0 0 1");
    ck_assert_int_eq(reference_hit(&q.ray, &q.object, NULL, NULL, NULL), SURE_HIT);
    ck_assert_int_eq(reference_interval(&q.ray, &q.object, NULL), SURE_HIT);
}
END_TEST

static int compared(const char *line, double x)
{
    sure_case question = case_of(line);
    int sign = 77;
    reference_compare_hit(&question.ray, &question.object, x, &sign);
    return sign;
}

static int within(const char *line, double t, double error)
{
    sure_case question = case_of(line);
    int is = 77;
    reference_hit_within(&question.ray, &question.object, t, error, &is);
    return is;
}

static int normal_within(const char *line, sure_vec3 normal, double error)
{
    sure_case question = case_of(line);
    int is = 77;
    reference_normal_within(&question.ray, &question.object, normal, error, &is);
    return is;
}

START_TEST(test_comparisons)
{
    static const char third[] = "plane 0 0 0 3 0 0 0 inf 1 0 0 1 0 0";
    static const char four[] = "sphere -5 0 0 1 0 0 0 inf 0 0 0 1";
    static const char beyond[] = "plane 0 0 0 0x1p-900 0 0 0 inf 0x1p900 0 0 1 0 0";
    ck_assert_int_eq(compared(third, 1.0 / 3), 1);
    ck_assert_int_eq(compared(third, nextafter(1.0 / 3, 1)), -1);
    ck_assert_int_eq(compared(four, 4), 0);
    ck_assert_int_eq(compared(four, nextafter(4, 5)), -1);
    ck_assert_int_eq(compared(four, INFINITY), -1);
    ck_assert_int_eq(compared(beyond, -INFINITY), 1);
    ck_assert_int_eq(compared(beyond, 0x1.fffffffffffffp+1023), 1);
    ck_assert_int_eq(compared(beyond, INFINITY), -1);

    /* 1/3 = 0x1.5555555555555p-2 + 2^-54 / 3, and the double 0x1.5555555555556p-56 is above
     * 2^-54 / 3. */
    ck_assert(within(third, 0x1.5555555555555p-2, 0x1.5555555555556p-56));
    ck_assert(!within(third, 0x1.5555555555555p-2, 0x1.5555555555555p-56));
    ck_assert(!within(third, 1.0 / 3, 0));
    ck_assert(within(four, 4, 0));
    ck_assert(within(four, 3, 1) && within(four, 5, 1));
    ck_assert(!within(four, 3, nextafter(1, 0)) && !within(four, 5, nextafter(1, 0)));
    ck_assert(within(four, 0, INFINITY) && within(beyond, 0, INFINITY));
    ck_assert(!within(beyond, INFINITY, INFINITY) && !within(four, NAN, INFINITY));
    ck_assert(!within(four, 4, NAN) && !within(four, 4, -1));

    /* The normal (-1, 0, 0) and, on the cone, (-4/5, 0, 3/5): 0.8 is 4/5 + 2^-53 2/5. */
    static const char side[] = "cone -10 0 2 1 0 0 0 inf 0 0 0 0 0 4 3";
    ck_assert(normal_within(four, (sure_vec3){-1, 0, 0}, 0));
    ck_assert(normal_within(four, (sure_vec3){-1, 0.5, 0}, 0.5));
    ck_assert(!normal_within(four, (sure_vec3){-1, nextafter(0.5, 1), 0}, 0.5));
    ck_assert(!normal_within(side, (sure_vec3){-0.8, 0, 0.6}, 0));
    ck_assert(normal_within(side, (sure_vec3){-0.8, 0, 0.6}, 0x1p-54));
    ck_assert(!normal_within(side, (sure_vec3){-0.8, 0, 0.6}, 0x1p-57));

    ck_assert_uint_eq(reference_ulps(1, 1), 0);
    ck_assert_uint_eq(reference_ulps(1, nextafter(1, 2)), 1);
    ck_assert_uint_eq(reference_ulps(1, nextafter(1, 0)), 1);
    ck_assert_uint_eq(reference_ulps(-0.0, 0.0), 0);
    ck_assert_uint_eq(reference_ulps(-0x1p-1074, 0x1p-1074), 2);
    ck_assert_uint_eq(reference_ulps(1, 2), UINT64_C(1) << 52);
    ck_assert_uint_eq(reference_ulps(INFINITY, 0x1.fffffffffffffp+1023), 1);
    ck_assert_uint_eq(reference_ulps(-INFINITY, INFINITY), UINT64_C(0xffe0000000000000));
    ck_assert_uint_eq(reference_ulps(NAN, 1), UINT64_MAX);
}
END_TEST

/* object fields of a case (its ray is not asked), point -> side. */
typedef struct {
    const char *object;
    sure_vec3 point;
    int side;
} place_case;

#define ANY_RAY " 0 0 0 1 0 0 0 1 "

static const place_case place_cases[] = {
    {"plane" ANY_RAY "0 0 1 0 0 2", {7, 8, 1}, 0},
    {"plane" ANY_RAY "0 0 1 0 0 2", {7, 8, 0x1.0000000000001p+0}, 1},
    {"plane" ANY_RAY "0 0 1 0 0 2", {7, 8, -1}, -1},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 0}, 0},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {1, 1, 0}, 0},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 0x1p-1074}, 1},
    {"disc" ANY_RAY "0 0 0 0 0 2 5", {3, 0x1.0000000000001p+2, 0}, 1},
    {"sphere" ANY_RAY "0 0 0 5", {3, 4, 0}, 0},
    {"sphere" ANY_RAY "0 0 0 5", {3, 4, 0x1p-1074}, 1},
    {"sphere" ANY_RAY "0 0 0 5", {3, 0x1.fffffffffffffp+1, 0}, -1},
    {"sphere" ANY_RAY "1 0 0 0", {1, 0, 0}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 1}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 2}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 4, 0x1.0000000000001p+1}, 1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {0, 0, 0}, 0},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {0, 0, -0x1p-1074}, 1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {0, 0, 0x1p-1074}, -1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 5", {3, 0x1.0000000000001p+2, 1}, 1},
    {"cylinder" ANY_RAY "0 0 0 0 0 2 0", {0, 0, 1}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {0, 0, 4}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {0, 0, 0x1.0000000000001p+2}, 1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0, 2}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0, 0x1.fffffffffffffp+0}, -1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0x1p-1074, 2}, 1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {1.5, 0, 6}, 1},
    {"cone" ANY_RAY "0 0 0 0 0 4 3", {3, 0, 0}, 0},
    {"cone" ANY_RAY "0 0 0 0 0 4 0", {0, 0, 1}, 0},
};

START_TEST(test_places)
{
    const place_case *hand = &place_cases[_i];
    sure_case question = case_of(hand->object);
    ck_assert_msg(reference_where(&question.object, hand->point) == hand->side, "%s at %a %a %a",
                  hand->object, hand->point.x, hand->point.y, hand->point.z);
    sure_ray ray = {{0, 0, 0}, hand->point, 0, 1};
    if (hand->point.x != 0 || hand->point.y != 0 || hand->point.z != 0)
        ck_assert_int_eq(reference_where_at(&ray, &question.object, 1), hand->side);
}
END_TEST

/* 3 t rounds to 1 for the double t next to 1/3, but o + t d itself is not on the plane x = 1. */
START_TEST(test_place_on_the_ray)
{
    sure_case question = case_of("plane 0 0 0 3 0 0 0 inf 1 0 0 1 0 0");
    ck_assert_int_eq(reference_where_at(&question.ray, &question.object, 0x1.5555555555555p-2), -1);
    ck_assert_int_eq(reference_where_at(&question.ray, &question.object, 0x1.5555555555556p-2), 1);
}
END_TEST

typedef struct {
    const char *question;
    sure_status status;
    double t;
    const char *why;
} wall_case;

static const wall_case wall_cases[] = {
    {"cylinder -5 0 9 1 0 0 0 inf 0 0 0 0 0 2 1", SURE_HIT, 4, "above the top"},
    {"cylinder 0 0 9 1 0 0 0 inf 0 0 0 0 0 2 1", SURE_HIT, 1, "from inside"},
    {"cylinder 1 0 9 0 0 1 0.5 inf 0 0 0 0 0 2 1", SURE_HIT, 0.5, "along the wall: t_min"},
    {"cylinder 0.5 0 9 0 0 1 0 inf 0 0 0 0 0 2 1", SURE_MISS, 0, "along it, inside"},
    {"cylinder -5 0 9 1 0 0 0 inf 0 0 0 0 0 2 0", SURE_HIT, 5, "radius 0: the axis"},
    {"cylinder 0 0 9 0 0 1 2 inf 0 0 0 0 0 2 0", SURE_HIT, 2, "along it"},
    {"cone -10 0 6 1 0 0 0 inf 0 0 0 0 0 4 3", SURE_HIT, 8.5, "the other nappe"},
    {"cone -10 0 -4 1 0 0 0 inf 0 0 0 0 0 4 3", SURE_HIT, 4, "below the base: radius 6"},
    {"cone 0 0 9 0 0 -1 0 inf 0 0 0 0 0 4 3", SURE_HIT, 5, "the apex, from the other nappe"},
    {"cone 0 0 9 0 0 -1 0x1.4000000000001p+2 inf 0 0 0 0 0 4 3", SURE_MISS, 0, "beyond it"},
    {"cone 1 0 8 0 0 -1 0 inf 0 0 0 0 0 4 3", SURE_HIT, 0x1.5555555555555p+1,
     "a < 0: out of the other nappe at z = 16/3"},
    {"cone -3 0 8 3 0 -4 0.25 inf 0 0 0 0 0 4 3", SURE_HIT, 0.25, "along a generator: t_min"},
    {"cone -7 0 -4 3 0 4 0 inf 0 0 0 0 0 4 3", SURE_HIT, 0x1.1555555555555p+1,
     "a = 0: 3 t - 7 = 3 t - 6 never, 7 - 3 t = 3 t - 6 at 13/6"},
    {"cone 0 0 4 0 0 0 0 inf 0 0 0 0 0 4 3", SURE_INVALID, 0, "d = 0"},
};

START_TEST(test_walls)
{
    const wall_case *hand = &wall_cases[_i];
    sure_case question = case_of(hand->question);
    double t = 77;
    ck_assert_msg(reference_wall_hit(&question.ray, &question.object, &t) == hand->status, "%s",
                  hand->why);
    ck_assert_msg(same_number(t, hand->status == SURE_HIT ? hand->t : 77), "%s: %a", hand->why, t);
}
END_TEST

START_TEST(test_wall_normals)
{
    sure_object cylinder = case_of("cylinder" ANY_RAY "0 0 0 0 0 2 1").object;
    sure_object cone = case_of("cone" ANY_RAY "0 0 0 0 0 4 3").object;
    sure_object thin = case_of("cone" ANY_RAY "0 0 0 0 0 4 0").object;
    sure_vec3 slanted = {0.8, 0, 0.6}, up = {0, 0, 1}, out = {0.6, 0.8, 0}, none = {0, 0, 0};
    ck_vector_same(reference_wall_normal(&cylinder, (sure_vec3){3, 4, 9}), out);
    ck_vector_same(reference_wall_normal(&cylinder, (sure_vec3){0, 0, 9}), none);
    ck_vector_same(reference_wall_normal(&cone, (sure_vec3){1.5, 0, 2}), slanted);
    ck_vector_same(reference_wall_normal(&cone, (sure_vec3){6, 0, -4}), slanted);
    ck_vector_same(reference_wall_normal(&cone, (sure_vec3){0, 0, 4}), up);
    /* |PQ| = 4, cos = 4/5: S is 5 below the apex, a step further down than P, which is the
     * base's centre. */
    ck_vector_same(reference_wall_normal(&cone, none), up);
    ck_vector_same(reference_wall_normal(&thin, (sure_vec3){0, 0, 1}), none);
    /* |PQ| = 5, cos = 1: S is 5 below the apex and P = (3, 0, 0) is (3, 0, 1) from it. */
    ck_vector_same(reference_wall_normal(&thin, (sure_vec3){3, 0, 0}),
                   (sure_vec3){0x1.e5b9d136c6d96p-1, 0, 0x1.43d136248490fp-2});
}
END_TEST

START_TEST(test_heights)
{
    sure_object cylinder = case_of("cylinder" ANY_RAY "0 0 0 0 0 2 1").object;
    sure_object cone = case_of("cone" ANY_RAY "0 0 0 0 0 4 3").object;
    ck_assert(reference_height(&cylinder, (sure_vec3){9, 9, 0}));
    ck_assert(reference_height(&cylinder, (sure_vec3){9, 9, 2}));
    ck_assert(!reference_height(&cylinder, (sure_vec3){9, 9, -0x1p-1074}));
    ck_assert(!reference_height(&cylinder, (sure_vec3){9, 9, 0x1.0000000000001p+1}));
    ck_assert(reference_height(&cone, (sure_vec3){3, 0, 0}));
    ck_assert(!reference_height(&cone, (sure_vec3){3, 0, -0x1p-1074}));
    ck_assert(reference_height(&cone, (sure_vec3){0, 0, 4}));
    ck_assert(!reference_height(&cone, (sure_vec3){0, 0, 0x1.0000000000001p+2}));
    ck_assert(!reference_height(&cone, (sure_vec3){3, 0, 8}));
    ck_assert(reference_height(&cone, (sure_vec3){0, 0, -1}));
}
END_TEST

START_TEST(test_end_points)
{
    sure_vec3 low, high;
    reference_end_points((sure_vec3){1, 2, 3}, (sure_vec3){0, 3, -4}, 10, &low, &high);
    ck_vector_same(low, (sure_vec3){1, -1, 7});
    ck_vector_same(high, (sure_vec3){1, 5, -1});
    reference_end_points((sure_vec3){0, 0, 0}, (sure_vec3){0x1p1023, 0x1p1023, 0}, 2, &low, &high);
    ck_vector_same(high, (sure_vec3){0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0});
    ck_vector_same(low, (sure_vec3){-0x1.6a09e667f3bcdp-1, -0x1.6a09e667f3bcdp-1, 0});
    /* 1 + 2^-53 is halfway to the next double, and 1 even; 1 - 2^-54 halfway, and 1 even again. */
    reference_end_points((sure_vec3){1, 1, 1}, (sure_vec3){0x1p-1074, 0, 0}, 0x1p-52, &low, &high);
    ck_vector_same(high, (sure_vec3){1, 1, 1});
    reference_end_points((sure_vec3){1, 1, 1}, (sure_vec3){5, 0, 0}, 0x1p-53, &low, &high);
    ck_vector_same(low, (sure_vec3){1, 1, 1});
    reference_end_points((sure_vec3){1, 1, 1}, (sure_vec3){5, 0, 0}, 0x1.0000000000001p-53, &low,
                         &high);
    ck_vector_same(low, (sure_vec3){0x1.fffffffffffffp-1, 1, 1});
}
END_TEST

typedef struct {
    double a, half_b, c;
    sure_roots count;
    double low, high;
    const char *why;
} roots_case;

#define LARGEST 0x1.fffffffffffffp+1023

static const roots_case roots_cases[] = {
    {0, 0, 0, SURE_ROOTS_ALL, 77, 78, "every t"},
    {0, -0.0, 0x1p-1074, SURE_ROOTS_NONE, 77, 78, "0 = c"},
    {0, 3, -2, SURE_ROOTS_ONE, 0x1.5555555555555p-2, 78, "2 / 6"},
    {1, 1, 1, SURE_ROOTS_TWO, -1, -1, "a double root, twice"},
    {1, 1, 0x1.0000000000001p+0, SURE_ROOTS_NONE, 77, 78, "D/4 = -2^-52"},
    {-1, 0, 4, SURE_ROOTS_TWO, -2, 2, "a < 0: in order"},
    {1, 0, 0, SURE_ROOTS_TWO, 0, 0, "+0 twice"},
    {2, -3, 0, SURE_ROOTS_TWO, 0, 3, "one is 0"},
    {1, 0, -2, SURE_ROOTS_TWO, -0x1.6a09e667f3bcdp+0, 0x1.6a09e667f3bcdp+0, "sqrt 2"},
    {1, -0x1p600, 1, SURE_ROOTS_TWO, 0x1p-601, 0x1p601, "2^-601 and a root just below 2^601"},
    {0x1p-1074, 0x1p1000, -0x1p1000, SURE_ROOTS_TWO, -INFINITY, 0.5, "-2^2075 overflows"},
    {0x1p1000, 0x1p1000, 0x1p-1074, SURE_ROOTS_TWO, -2, 0, "-2^-2075 rounds to +0"},
    {0x1p1000, 0x1p1000, -0x1.8p-74, SURE_ROOTS_TWO, -2, 0x1p-1074, "3/4 of the least double"},
    {LARGEST, LARGEST, LARGEST, SURE_ROOTS_TWO, -1, -1, "products overflow"},
    /* A root's numerator divides c: halfway between two doubles it can only be below the normal
     * ones. */
    {0, 1, -0x3p-1074, SURE_ROOTS_ONE, 0x2p-1074, 78, "1.5 least doubles: 2 is even"},
    {0, -1, 0x5p-1074, SURE_ROOTS_ONE, 0x2p-1074, 78, "2.5 least doubles: 2 is even"},
};

START_TEST(test_quadratic)
{
    const roots_case *hand = &roots_cases[_i];
    double roots[2] = {77, 78};
    sure_roots count = reference_quadratic(hand->a, hand->half_b, hand->c, roots);
    ck_assert_msg(count == hand->count && same_number(roots[0], hand->low) &&
                      same_number(roots[1], hand->high),
                  "%s: %d roots, %a %a", hand->why, (int)count, roots[0], roots[1]);
}
END_TEST

START_TEST(test_projections)
{
    sure_vec3 v = {1, 2, 3}, n = {0, 0x1.8p1000, -0x1p1001};
    /* n.v / n.n n = (6 - 12) / 25 (0, 3, -4) in n's own unit */
    ck_vector_same(reference_project(v, n), (sure_vec3){0, -0.72, 0.96});
    ck_vector_same(reference_reflect(v, n), (sure_vec3){-1, -3.44, -1.08});
    sure_vec3 across = {4, -3, 7}, none = {0, 0, 0}, diagonal = {1, 1, 1};
    ck_vector_same(reference_project(across, (sure_vec3){3, 4, 0}), none);
    ck_assert(!signbit(reference_project((sure_vec3){-0.0, 0, -0.0}, n).x));
    /* A third of 2^1023 three times over: nothing overflows on the way. */
    sure_vec3 far = {0x1p1023, 0x1p1023, 0x1p1023}, edge = {0, LARGEST, LARGEST};
    ck_vector_same(reference_project(far, diagonal), far);
    ck_vector_same(reference_reflect(edge, diagonal),
                   (sure_vec3){INFINITY, 0x1.5555555555555p+1022, 0x1.5555555555555p+1022});
}
END_TEST

/* y cos(angle) - z sin(angle) in one rounding from far more digits than the cases below can
 * need. */
static double turned(double angle, double y, double z)
{
    mpfr_t w, c, s;
    mpfr_inits2(6000, w, c, s, (mpfr_ptr)NULL);
    mpfr_set_d(w, angle, MPFR_RNDN);
    mpfr_sin_cos(s, c, w, MPFR_RNDN);
    mpfr_mul_d(c, c, y, MPFR_RNDN);
    mpfr_mul_d(s, s, z, MPFR_RNDN);
    mpfr_sub(c, c, s, MPFR_RNDN);
    double x = mpfr_get_d(c, MPFR_RNDN);
    mpfr_clears(w, c, s, (mpfr_ptr)NULL);
    return x == 0 ? 0 : x;
}

START_TEST(test_rotation)
{
    sure_vec3 v = {3, 4, 5};
    ck_vector_same(reference_rotate(0, 0, v), v);
    ck_vector_same(reference_rotate(1, -0.0, v), v);
    ck_vector_same(reference_rotate(0, 1, (sure_vec3){7, 0, 0}), (sure_vec3){7, 0, 0});
    /* Right-handed: +y to +z, +z to +x, +x to +y; sin(1), cos(1). */
    double s = 0x1.aed548f090ceep-1, c = 0x1.14a280fb5068cp-1;
    ck_vector_same(reference_rotate(0, 1, (sure_vec3){0, 1, 0}), (sure_vec3){0, c, s});
    ck_vector_same(reference_rotate(1, 1, (sure_vec3){0, 0, 1}), (sure_vec3){s, 0, c});
    ck_vector_same(reference_rotate(2, 1, (sure_vec3){1, 0, 0}), (sure_vec3){c, s, 0});
    /* 1.5 (least - least^3 / 6) is just below halfway between the least double and twice it. */
    ck_vector_same(reference_rotate(2, 0x1p-1074, (sure_vec3){1.5, 0, 0}),
                   (sure_vec3){1.5, 0x1p-1074, 0});
    /* 1 - 2^-121 + 2^-53 - ... is just below halfway between 1 and the next double. */
    ck_vector_same(reference_rotate(2, 0x1p-60, (sure_vec3){1, -0x1p7, 0}),
                   (sure_vec3){1, -0x1p7, 0});
    /* The double next to cot(1): cos(1) - cot(1) sin(1) loses 53 bits. */
    double cot = 0x1.48c05d04e1cfep-1;
    ck_vector_same(reference_rotate(0, 1, (sure_vec3){0, 1, cot}),
                   (sure_vec3){0, turned(1, 1, cot), turned(1, cot, -1)});
    for (uint64_t i = 0; i < 2000; i++) {
        double angle = suite_double(1, i, 1 << (i % 9));
        double y = suite_double(2, i, 1 << (i % 10)), z = suite_double(3, i, 1 << (i % 10));
        sure_vec3 x = reference_rotate(0, angle, (sure_vec3){9, y, z});
        ck_vector_same(x, (sure_vec3){9, turned(angle, y, z), turned(angle, z, -y)});
        sure_vec3 about_y = reference_rotate(1, angle, (sure_vec3){z, 9, y});
        ck_vector_same(about_y, (sure_vec3){x.z, 9, x.y});
        sure_vec3 about_z = reference_rotate(2, angle, (sure_vec3){y, z, 9});
        ck_vector_same(about_z, (sure_vec3){x.y, x.z, 9});
    }
}
END_TEST

/* tan by way of the angle, not of the turn; MPFR's own pi. */
static double extent(double focal_length, double fov)
{
    mpfr_t x;
    mpfr_init2(x, 6000);
    mpfr_const_pi(x, MPFR_RNDN);
    mpfr_mul_d(x, x, fov, MPFR_RNDN);
    mpfr_div_ui(x, x, 360, MPFR_RNDN);
    mpfr_tan(x, x, MPFR_RNDN);
    mpfr_mul_d(x, x, focal_length, MPFR_RNDN);
    mpfr_mul_ui(x, x, 2, MPFR_RNDN);
    double result = mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return result;
}

START_TEST(test_viewport)
{
    ck_double_same(reference_viewport_extent(1.5, 90), 3);
    ck_double_same(reference_viewport_extent(0x1.fffffffffffffp+1023, 90), INFINITY);
    ck_double_same(reference_viewport_extent(0x1p-1074, 90), 0x1p-1073);
    /* 2 tan(30 degrees) = 2 / sqrt 3, 2 tan(60 degrees) = 2 sqrt 3 */
    ck_double_same(reference_viewport_extent(1, 60), 0x1.279a74590331cp+0);
    ck_double_same(reference_viewport_extent(1, 120), 0x1.bb67ae8584caap+1);
    for (uint64_t i = 0; i < 2000; i++) {
        double fov = fabs(suite_double(4, i, i % 2 ? 7 : 300)), f = fabs(suite_double(5, i, 400));
        if (fov > 0 && fov < 180 && f > 0)
            ck_double_same(reference_viewport_extent(f, fov), extent(f, fov));
    }
    ck_double_same(reference_viewport_extent(3, nextafter(180, 0)), extent(3, nextafter(180, 0)));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("reference");
    add_looped(suite, "hand", test_hand_cases, COUNT(hand_cases));
    add_looped(suite, "chords", test_chords, COUNT(chord_cases));
    add_looped(suite, "signs", test_signs, COUNT(signs_cases));
    add_looped(suite, "order", test_order, COUNT(order_cases));
    add_looped(suite, "outputs", test_outputs, 1);
    add_looped(suite, "comparisons", test_comparisons, 1);
    add_looped(suite, "places", test_places, COUNT(place_cases));
    add_looped(suite, "places on the ray", test_place_on_the_ray, 1);
    add_looped(suite, "walls", test_walls, COUNT(wall_cases));
    add_looped(suite, "wall normals", test_wall_normals, 1);
    add_looped(suite, "heights", test_heights, 1);
    add_looped(suite, "end points", test_end_points, 1);
    add_looped(suite, "quadratic", test_quadratic, COUNT(roots_cases));
    add_looped(suite, "projections", test_projections, 1);
    add_looped(suite, "rotation", test_rotation, 1);
    add_looped(suite, "viewport", test_viewport, 1);
    return suite_run(suite);
}
