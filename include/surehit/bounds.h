/* SPDX-License-Identifier: MIT */
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
 * off by at most this many ulps of the larger of |C_i| and h/2
 * (docs/derivations/cylinder_height.md counts 4 1/2; more than 4 occur). */
#define SURE_END_POINT_ULPS 5

/* sure_*_certain: t_error |d| is at most this share of |o - object| + size, where object is the
 * point, the centre, the base's centre or low, and size is 0 (plane), the radius (disc, sphere),
 * radius + height (cylinder, cone) or |high - low| (box). Where doubles are coarser than that at t,
 * t is correctly rounded. */
#define SURE_T_ERROR_CAP 0x1p-24

/* sure_*_normal_certain: each component is off by at most this. */
#define SURE_NORMAL_ERROR 0x1p-24

/* sure_*_normal_certain_f: likewise; the same, rounded to a float. */
#define SURE_FLOAT_NORMAL_ERROR 0x1.8p-24

/* sure_quadratic_stable: the count is right, and each root is off by at most this many of its own
 * ulps; finite a, half_b, c of any size (docs/proofs/stable.md counts a little over 4). */
#define SURE_STABLE_ROOT_ULPS 5

/* sure_refract_*: let u be 2^-53, in float32 2^-24, T the true direction, i and t the angles of
 * incident and T with the normal. For index ratios from SURE_INDEX_RATIO_LEAST to its inverse, the
 * numbers of the tier given,
 *
 *     |refracted - T| <= SURE_REFRACT_ULPS u |incident| max(1, index_ratio) / cos t
 *     stable          <= SURE_REFRACT_ULPS u |incident|   and half the least double a component
 *
 * and total reflection is told rightly where 1 - (index_ratio sin i)^2, which is cos^2 t, is off 0
 * by more than SURE_REFRACT_ULPS u max(1, index_ratio), in stable by more than the square of
 * SURE_REFRACT_ULPS u (docs/proofs/refract.md counts 31 1/4). */
#define SURE_REFRACT_ULPS 32
#define SURE_INDEX_RATIO_LEAST 0x1p-10

/* sure_refract_fresnel_*: likewise, with R the true share,
 *
 *     |share - R| <= SURE_FRESNEL_ULPS u (1 + index_ratio^2) / (cos i cos t)
 *     stable      <= SURE_FRESNEL_ULPS u R        where cos t >= SURE_STABLE_GRAZING
 */
#define SURE_FRESNEL_ULPS 48
#define SURE_STABLE_GRAZING 0x1p-20

/* sure_spawn: each coordinate is at most this many doubles away from the correctly rounded
 * coordinate of the true hit point. */
#define SURE_SPAWN_STEPS 3

/* The rest is internal: what the first stages of certain and exact compute with. It is published
 * because the proofs name it; docs/proofs/ has for each constant a script that proves it. */

/* plane_filter.h, disc too: t is off by at most this times |N| (|m| + |t| |d|) / |e|, ... */
#define SURE_CROSSING_T_BOUND 0x1.3p-50

/* ... where |e| is more than this times |N| |d|. */
#define SURE_CROSSING_CERTAIN 0x1p-40

/* Where |e| is more than this times |N| |d|, the error keeps to the contract's limit. */
#define SURE_CROSSING_STEEP 0x1p-12

/* h + t_min e is off by at most the first times |N| (|m| + t_min |d|), e by the second times |N|
 * |d|. */
#define SURE_CROSSING_BEHIND_BOUND 0x1.8p-50
#define SURE_CROSSING_SIGN_BOUND 0x1p-50

/* Polish: a step to the crossing is off by at most the first times |N| |d| |step| and the second
 * times |N| |x|, both over |e|, where |e| is more than the third times |N| |d|. */
#define SURE_CROSSING_STEP_BOUND 0x1.4p-50
#define SURE_CROSSING_RESIDUAL_BOUND 0x1.cp-101
#define SURE_CROSSING_SLOPE_CERTAIN 0x1p-47

/* flat_close.h: t and a step to it are off by at most this of themselves, besides what the residual
 * and e are. */
#define SURE_FLAT_T_BOUND 0x1p-50

/* disc_filter.h: |e m - h d| and r |e| together are off by at most this times |N| |d| (|m| + r),
 * the rounding of the squares included. */
#define SURE_DISC_FOOT_BOUND 0x1.ap-49

/* disc_close.h: |p|^2 - r^2 is off by at most this times |p| most + r^2, and what is computed from
 * it and p in doubles by the second times its terms. */
#define SURE_DISC_RIM_BOUND 0x1p-100
#define SURE_DISC_TERMS_BOUND 0x1p-50

/* sphere_filter.h: D is off by at most this times M. */
#define SURE_SPHERE_DISCRIMINANT_BOUND 0x1.5p-48

/* t is off by at most this times (m.m + r^2) / sqrt(D), where D is certain: ... */
#define SURE_SPHERE_T_BOUND 0x1.9p-48

/* ... more than this times M. It is (9/8 2^24 SURE_SPHERE_T_BOUND)^2 and a little, so that the
 * error given for t keeps to the contract's limit. */
#define SURE_SPHERE_CERTAIN 0x1.8cp-47

/* By the other way to D, |d x m|^2 and a r^2: where D is more than that, it is off by at most the
 * first times sqrt(M (a r^2 + |d x m|^2)), and t by the second times sqrt(M) / a besides D's error
 * over a sqrt(D). The contract's limit is then kept. */
#define SURE_SPHERE_CLOSE_BOUND 0x1.ep-49
#define SURE_SPHERE_CLOSE_T_BOUND 0x1.ap-49

/* Polish: a step to the root is off by at most the first times |p| |d| |step| and the second times
 * |p|^2, both over 2 s, besides the curvature; s is more than the third times |p| |d|. */
#define SURE_SPHERE_STEP_BOUND 0x1.2p-48
#define SURE_SPHERE_RESIDUAL_BOUND 0x1.4p-100
#define SURE_SPHERE_SLOPE_CERTAIN 0x1p-46

/* cylinder_filter.h: D is certain when D^2 is more than this squared times (r^2 a + (X.m)^2) H d.d
 * (m.m + r^2). */
#define SURE_CYLINDER_DISCRIMINANT_BOUND 0x1.cp-48

/* A wall's t is off by at most this times H |d| size sqrt(r^2 a / D) / a, size^2 = m.m + r^2 + H.
 * */
#define SURE_CYLINDER_WALL_BOUND 0x1.4p-46

/* cone_filter.h: D is certain when D^2 is more than this squared times (r^2 g.g + H (A.w)^2) K H
 * d.d m.m. */
#define SURE_CONE_DISCRIMINANT_BOUND 0x1.2p-47

/* a's sign is certain when |a| is more than this times sqrt(K H d.d M). */
#define SURE_CONE_LEADING_BOUND 0x1.1p-47

/* A wall's t is off by at most this times size sqrt(K H M r^2 g.g / D) / |a|, size^2 = m.m + K. */
#define SURE_CONE_WALL_BOUND 0x1.2p-45

/* axial_filter.h, of cylinder and cone: the crossing of an end plane is off by at most this times
 * |A| size / |A.d|. */
#define SURE_AXIAL_PLANE_BOUND 0x1.4p-48

/* height_filter.h: what the sign is asked of is off by at most this times its terms' magnitudes. */
#define SURE_HEIGHT_BOUND 0x1p-49

/* axial_polish.h: a step to the wall is off by at most the first times |A| |d| S |step|, the second
 * times |A| S most and 3/2 |a| step^2, all over twice the slope, which is more than the third times
 * |A| |d| S. S is the surface's own measure: C + r |A|, or for the cone H C + r^2 h, with
 * C = |A x p| + AXIAL_CANCELLED |A| most and h = |A.p| + AXIAL_CANCELLED |A| most. */
#define SURE_AXIAL_STEP_BOUND 0x1p-47
#define SURE_AXIAL_RESIDUAL_BOUND 0x1p-96
#define SURE_AXIAL_SLOPE_CERTAIN 0x1p-44

/* The cone's leading coefficient is certain when it is more than this times |A| |d| (H |A x d| +
 * r^2 |A.d|). */
#define SURE_AXIAL_LEADING_CERTAIN 0x1p-46

/* A step to an end plane is off by at most the first times |A| |d| |step| and the second times |A|
 * most, both over |A.d|, which is more than the third times |A| |d|. */
#define SURE_AXIAL_PLANE_STEP_BOUND 0x1p-49
#define SURE_AXIAL_PLANE_RESIDUAL_BOUND 0x1p-100
#define SURE_AXIAL_PLANE_SLOPE_CERTAIN 0x1p-46

/* A box of a hierarchy has no finite face farther from 0 than this. docs/proofs/bvh.md */
#define SURE_BVH_FAR 0x1p1000

#endif
