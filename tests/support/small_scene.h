/* SPDX-License-Identifier: MIT */
/* Scenes of a few objects, as tests write them. */
#pragma once

#include "objects.h"

#include <surehit/scene.h>

static const double pi = 3.14159265358979323846;

static inline sure_object plane(double x, double y, double z, double nx, double ny, double nz)
{
    return (sure_object){SURE_SHAPE_PLANE, {.plane = {{x, y, z}, {nx, ny, nz}}}};
}

/* Each coordinate times that of `by`: mirrored, scaled, of another colour. */
static inline sure_vec3 by_parts(sure_vec3 by, sure_vec3 v)
{
    return (sure_vec3){by.x * v.x, by.y * v.y, by.z * v.z};
}

/* By -1 along the axis. */
static inline sure_vec3 mirror_of(int axis)
{
    return (sure_vec3){axis == 0 ? -1 : 1, axis == 1 ? -1 : 1, axis == 2 ? -1 : 1};
}

/* The eye at the origin, looking along (0, 0, -1): a window of 2 by 2 at distance 1, one pixel. */
static inline sure_scene looking(const sure_object *objects, const sure_material *materials,
                                 size_t count, const sure_light *lights, size_t light_count)
{
    return (sure_scene){.objects = objects,
                        .materials = materials,
                        .object_count = count,
                        .lights = lights,
                        .light_count = light_count,
                        .camera = {.focal_length = 1, .viewport_width = 2, .viewport_height = 2},
                        .turn = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                        .width = 1,
                        .height = 1,
                        .depth = 4};
}

/* The same, its light falling off with the square of the distance. */
static inline sure_scene falling_off(const sure_object *objects, const sure_material *materials,
                                     size_t count, const sure_light *lights, size_t light_count)
{
    sure_scene scene = looking(objects, materials, count, lights, light_count);
    scene.falloff = SURE_FALLOFF_INVERSE_SQUARE;
    return scene;
}
