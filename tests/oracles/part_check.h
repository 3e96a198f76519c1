/* SPDX-License-Identifier: MIT */
/* The notes' parts against the reference: which promise is broken, or NULL.
 *
 * A plain tier promises little, but where it rounds nothing, by the flags that the processor
 * raises, its answer is the exact one. Where the notes' vectors are rounded, the roundings are
 * counted in part_check.c. */
#pragma once

#include <stdbool.h>

#include <surehit/object.h>

/* How many plain answers were exact for that reason, and were compared as such. */
typedef struct {
    unsigned long heights, walls, others;
} part_unrounded;

/* Is it a cylinder or a cone: has it walls, a height, and end points? */
bool has_parts(sure_shape shape);

/* sure_<shape>_height_<tier>. Entry: a valid solid that has parts, a tier that has heights. */
int height_of(const sure_object *solid, sure_vec3 p, sure_tier tier);

/* Certain's and exact's height of any finite point, in any environment of surroundings.h; the plain
 * tiers'. Entry: a valid solid that has parts. */
const char *height_broken(const sure_object *solid, sure_vec3 point, part_unrounded *count);

/* First point of the endless wall. Entry: a solid that has parts. */
const char *wall_hit_broken(const sure_ray *ray, const sure_object *solid, part_unrounded *count);

/* Entry: a valid solid that has parts, a finite point. */
const char *wall_normal_broken(const sure_object *solid, sure_vec3 point, part_unrounded *count);

/* sure_<shape>_from_axis. Entry: a shape that has parts. */
const char *end_points_broken(sure_shape shape, sure_vec3 centre, sure_vec3 axis, double radius,
                              double height, part_unrounded *count);

/* Projection and reflection. Entry: finite; n not zero. */
const char *vectors_broken(sure_vec3 v, sure_vec3 n, part_unrounded *count);

/* Exact's first hit, of any shape: a sign change of the object's own function along the ray, as the
 * reference tells it, is enclosed by sure_bracket, between whose neighbours the hit's t lies. Not
 * asked where the ray starts on the surface, only touches it, or lies in it; *asked counts. */
const char *bracket_broken(const sure_ray *ray, const sure_object *object, unsigned long *asked);
