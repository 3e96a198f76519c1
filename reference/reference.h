/* SPDX-License-Identifier: MIT */
/* The first oracle: an exact answer to every question of docs/contract.md, computed in exact
 * numbers by a shim on CGAL, GMP and MPFR that shares no code with the library. docs/reference.md
 * says how.
 *
 * "Correctly rounded" is to nearest, ties to even, subnormal results and overflow to an infinity
 * included; a zero is +0. What is not written stays untouched: outputs are written on SURE_HIT
 * only. Where a ray and an object are taken, any values are answered, the invalid ones by
 * SURE_INVALID; an output pointer may be NULL and is then not computed. The caller's
 * floating-point environment (rounding mode, flush to zero, exception flags) neither matters nor
 * changes. */
#ifndef REFERENCE_REFERENCE_H
#define REFERENCE_REFERENCE_H

#include <stdint.h>

#include <surehit/object.h>
#include <surehit/quadratic.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The first invalid field in the contract's order, or SURE_FIELD_NONE. */
sure_field reference_check(const sure_ray *ray, const sure_object *object);

/* The first boundary point: t and the components of the normal correctly rounded. */
sure_status reference_hit(const sure_ray *ray, const sure_object *object, double *t,
                          sure_part *part, sure_vec3 *normal);

/* The chord of the ray's whole line, both ends correctly rounded. SURE_HIT when the chord and
 * [t_min, t_max] have a point in common. */
sure_status reference_interval(const sure_ray *ray, const sure_object *object,
                               sure_interval *interval);

/* The status of reference_hit. */
sure_status reference_occluded(const sure_ray *ray, const sure_object *object);

/* -1, 0, +1: the hit on `first` comes before, together with, after that on `second`; compared as
 * real numbers. SURE_HIT when both are hit; SURE_INVALID when either object or the ray is
 * invalid. */
sure_status reference_hit_order(const sure_ray *ray, const sure_object *first,
                                const sure_object *second, int *order);

/* Sign of t* - x for the hit's real t*; x may be infinite. */
sure_status reference_compare_hit(const sure_ray *ray, const sure_object *object, double x,
                                  int *sign);

/* 1 when |t - t*| <= error, otherwise 0; decided on the real numbers. False for t or error that are
 * not a number and for an infinite t; true for a finite t and an infinite error. */
sure_status reference_hit_within(const sure_ray *ray, const sure_object *object, double t,
                                 double error, int *within);

/* 1 when every component of `normal` is within `error` of the true one's, likewise. */
sure_status reference_normal_within(const sure_ray *ray, const sure_object *object,
                                    sure_vec3 normal, double error, int *within);

/* How many steps from one double to the next lead from a to b; -0 and +0 are one double, and the
 * infinities follow the largest finite ones. UINT64_MAX when either is not a number. From a
 * computed t to reference_hit's this is the distance in ulps: 0 exactly when it is correctly
 * rounded. */
uint64_t reference_ulps(double a, double b);

/* A sign that does not apply. */
#define REFERENCE_NONE 2

/* The signs behind the answer, for the ray's whole line. `roots` points P_i, in the order of t,
 * are where the line meets the sphere or the endless wall; a line within the wall has none. */
typedef struct {
    int leading;      /* a of the quadratic; REFERENCE_NONE for plane and disc */
    int discriminant; /* D/4 = half_b^2 - a c; for a disc that of the circle, when axis is 0 */
    int axis;         /* A.d, A from base to top or apex; N.d for plane and disc */
    int roots;        /* 0, 1 or 2; a double root counts once */
    int base_side[2]; /* A.(P_i - base): negative below the base's plane */
    int top_side[2];  /* A.(P_i - top): positive beyond the top or on the other nappe */
    int base_cap;     /* |P - centre|^2 - r^2 where the line crosses the base's or disc's plane */
    int top_cap;      /* the same at the top of a cylinder */
} reference_decisions;

sure_status reference_decide(const sure_ray *ray, const sure_object *object,
                             reference_decisions *decisions);

/* The point against the closed object: -1 inside, 0 on the boundary, +1 outside. For a plane
 * the sign of N.(point - Q); for a disc 0 on it and +1 off it. By CGAL's exact kernel.
 * Entry: a valid object, a finite point. */
int reference_where(const sure_object *object, sure_vec3 point);

/* The same for the ray's point o + t d itself, not for its rounding: the sign of the implicit
 * function along the ray. Entry: valid ray and object, finite t. */
int reference_where_at(const sure_ray *ray, const sure_object *object, double t);

/* The endless wall of a cylinder, both nappes of the endless wall of a cone: its first point,
 * and t_min on a ray within it. Entry: a cylinder or a cone. */
sure_status reference_wall_hit(const sure_ray *ray, const sure_object *object, double *t);

/* The sign of its quadratic at t_min. Entry: a valid ray and object. */
int reference_wall_side(const sure_ray *ray, const sure_object *object);

/* The unit normal that a wall has at any point off its axis by the notes' construction: from the
 * axis to the point for a cylinder, from the point of the axis at |PQ| / cos(theta) from the
 * apex Q for a cone. Zero where these coincide; at the apex the direction from base to apex.
 * Correctly rounded. Entry: a valid cylinder or cone, a finite point. */
sure_vec3 reference_wall_normal(const sure_object *object, sure_vec3 point);

/* 1 or 0. Cylinder: is the point between the end planes, ends included? Cone: is it no farther
 * from the apex than the rim is, and not beyond the apex? Entry: as above. */
int reference_height(const sure_object *object, sure_vec3 point);

/* C - h/2 N/|N| and C + h/2 N/|N|, correctly rounded. Entry: finite; axis not zero. */
void reference_end_points(sure_vec3 centre, sure_vec3 axis, double height, sure_vec3 *low,
                          sure_vec3 *high);

/* sure_quadratic_*'s contract; the roots correctly rounded. */
sure_roots reference_quadratic(double a, double half_b, double c, double roots[2]);

/* (N.V / N.N) N, and 2 proj_N V - V. Correctly rounded. Entry: finite; n not zero. */
sure_vec3 reference_project(sure_vec3 v, sure_vec3 n);
sure_vec3 reference_reflect(sure_vec3 v, sure_vec3 n);

/* v turned by an angle (radians) about axis 0, 1, 2 = x, y, z, right-handed. Correctly rounded.
 * Entry: finite. */
sure_vec3 reference_rotate(int axis, double angle, sure_vec3 v);

/* 2 f tan(pi/360 fov), correctly rounded. Entry: finite f > 0; 0 < fov < 180. */
double reference_viewport_extent(double focal_length, double fov);

/* The second routes that the tests hold against the first.
 *
 * reference_interval answered by CGAL's own linear and spherical kernels, without a quadratic
 * of this project; parts are SURE_PART_SURFACE. Entry: reference_has_kernel. */
int reference_has_kernel(sure_shape shape);
sure_status reference_kernel_interval(const sure_ray *ray, const sure_object *object,
                                      sure_interval *interval);

/* 1 when the answer's exact chord proves right against the object's definition: an empty one by
 * the least value on the line, found without a root; any other by where its ends, its middle and
 * points beyond its ends lie, and by the definition's gradient for the normals there.
 * Entry: a valid ray and object. */
int reference_certify(const sure_ray *ray, const sure_object *object);

#ifdef __cplusplus
}
#endif
#endif
