/* SPDX-License-Identifier: MIT */
/* Sphere. */
#include "../objects.h"
#include "../test_shape.h"

/* The cylinder that has the same section with the plane of centre and ray. */
static sure_object companion(const sure_ray *ray, const sure_object *object)
{
    const sure_sphere *s = &object->as.sphere;
    sure_vec3 across = cross(ray->direction, minus(ray->origin, s->centre));
    return (sure_object){
        SURE_SHAPE_CYLINDER,
        {.cylinder = {minus(s->centre, across), plus(s->centre, across), s->radius}}};
}

static true_frame frame(const sure_object *object)
{
    const sure_sphere *s = &object->as.sphere;
    return (true_frame){.from = s->centre, .radius = s->radius, .round = true};
}

const test_shape test_shape_sphere = {
    .through = {{{-3, -2, -6}, {0, 0, 0}, 7}, {{-3, -2, -6}, {0, 0, 0}, 7}},
    .companion = companion,
    .frame = frame,
    .in_object = true_in_body,
};
