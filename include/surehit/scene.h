/* SPDX-License-Identifier: MIT */
/* A scene as the tracer sees it: the file's, and a camera in it. */
#pragma once

#include <stddef.h>

#include <surehit/bvh.h>
#include <surehit/light.h>
#include <surehit/object.h>
#include <surehit/phong.h>
#include <surehit/photon_map.h>
#include <surehit/pixel_ray.h>

SURE_C_BEGIN

/* Arrays stay the caller's, and unchanged while the scene is used. One is begun as {0}: whatever a
 * later version adds takes room that is reserved, and 0 there means what it means today. */
typedef struct {
    const sure_object *objects;
    const sure_material *materials; /* one an object */
    size_t object_count;
    const sure_float_object *floats; /* as float32 has these; NULL: it rounds them when asked */
    const sure_bvh *bvh;             /* of these objects; NULL to ask every one: the same of certain
                                      * and exact; others may see an object outside of its box */
    const sure_photon_map *caustics; /* what mirrors and glass send to matte ones; NULL: nothing */
    const sure_light *lights;
    size_t light_count;
    sure_vec3 ambient; /* linear colour times ratio */
    sure_falloff falloff;
    sure_camera camera; /* the focal length from 2^-400 to 2^400, the viewport at most 2^400 wide
                         * and high: ways to its pixels are squared */
    sure_mat3 turn;     /* sure_camera_rotation's: its rows are the camera's right, up and back */
    int width, height;  /* pixels */
    int depth; /* how many mirrors and clear surfaces are followed in a row; none below 1. Each
                * takes stack, and each clear one may double the time */
    const void *reserved[8]; /* NULL */
} sure_scene;

/* The pixel's ray (sure_pixel_ray_textbook), turned into the world: its direction, as rounded, is
 * the ray's.
 *
 * Entry    0 <= column < width, 0 <= row < height, row 0 lowest.
 * Law 1: the objects are where the scene has them: no ray moves or turns one. */
sure_ray sure_scene_pixel_ray(const sure_scene *scene, int column, int row);

/* The nearest object along a ray. */
typedef struct {
    size_t object; /* index; of two objects at one t the lower */
    sure_hit hit;
} sure_nearest;

/* A point from which a further ray leaves: which surface it belongs to and on which side it is. */
typedef struct {
    size_t object;
    sure_vec3 point;  /* tiers certain and exact: sure_spawn's; others: o + t d, rounded */
    sure_vec3 normal; /* unit, on that side */
    int inside;       /* that side is the inside of a solid */
} sure_surface_point;

/* Where a ray that leaves a surface point, away from the surface, meets that point's own object
 * again: nowhere on its convex outside; from the inside of a solid at the end of its chord.
 * Returns SURE_HIT and *hit, or SURE_MISS and *hit untouched. */
sure_status sure_scene_meets_again(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                   const sure_surface_point *leaving, sure_hit *hit);

SURE_C_END
