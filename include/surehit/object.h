/* SPDX-License-Identifier: MIT */
/* An object of any shape, for those who hold several. */
#pragma once

#include <surehit/box.h>
#include <surehit/cone.h>
#include <surehit/cylinder.h>
#include <surehit/disc.h>
#include <surehit/plane.h>
#include <surehit/shape.h>
#include <surehit/sphere.h>
#include <surehit/tier.h>

SURE_C_BEGIN

typedef struct {
    sure_shape shape;
    union {
        sure_plane plane;
        sure_disc disc;
        sure_sphere sphere;
        sure_cylinder cylinder;
        sure_cone cone;
        sure_box box;
    } as;
} sure_object;

/* The functions of the object's own header, by tier. Entry: shape and tier are members. */
sure_field sure_object_check(const sure_ray *ray, const sure_object *object);
sure_status sure_object_hit(const sure_ray *ray, const sure_object *object, sure_tier tier,
                            sure_hit *hit);
sure_status sure_object_interval(const sure_ray *ray, const sure_object *object, sure_tier tier,
                                 sure_interval *interval);
sure_status sure_object_occluded(const sure_ray *ray, const sure_object *object, sure_tier tier);
sure_vec3 sure_object_normal(const sure_ray *ray, const sure_object *object, sure_tier tier,
                             const sure_hit *hit);

/* A ray and an object as tier float32 has them, rounded once for those who ask often. The ray or
 * object that was rounded outlives it, unchanged: rare cases are asked of that. */
typedef struct {
    sure_float_vec3 origin, direction;
    float t_min, t_max;
    const sure_ray *of;
} sure_float_ray;

typedef struct {
    float numbers[SURE_SHAPE_NUMBERS]; /* of the shape's struct */
    sure_shape shape;
    const sure_object *of;
} sure_float_object;

/* Law 1: the answer about what was rounded is sure_object_hit's in tier float32, bit by bit. */
void sure_float_ray_of(const sure_ray *ray, sure_float_ray *rounded);
void sure_float_object_of(const sure_object *object, sure_float_object *rounded);
sure_status sure_float_object_hit(const sure_float_ray *ray, const sure_float_object *object,
                                  sure_hit *hit);

/* A box, its faces across the axes, in which all of the closed object lies; all space for a shape
 * that is not bounded. A face is off the object's extent by no more than some roundings of its
 * coordinates and size, with two exceptions. A disc, cylinder or cone whose normal or axis squared
 * is out of the range of doubles gets the box of balls of its radius about its centres. A face
 * beyond SURE_BVH_FAR is infinite if it is the outer one, else it is at SURE_BVH_FAR.
 *
 * Entry    a valid object.
 * Bound    none on the outside: whatever the rounding mode, subnormals flushed or not, no point of
 *          the object is outside.
 * Source   docs/proofs/bvh.md
 * Proof    docs/proofs/bvh.md */
void sure_object_bounds(const sure_object *object, sure_vec3 *low, sure_vec3 *high);

/* Which stage answers sure_object_hit. Those who don't ask don't pay: it is found out by going
 * through the stages again. The plain tiers have one, SURE_STAGE_DOUBLE, and invalid input is told
 * by it. */
sure_stage sure_object_stage(const sure_ray *ray, const sure_object *object, sure_tier tier);

SURE_C_END
