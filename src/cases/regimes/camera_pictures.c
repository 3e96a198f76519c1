/* SPDX-License-Identifier: MIT */
/* The pictures of the regime camera: what they show, their pixels' rays, what a hierarchy asks. */
#include "camera_pictures.h"

#include "../shapes/case_shape.h"

#include <math.h>

/* The caps of a body between two points, as discs: how many. */
static int caps_of(const sure_object *body, sure_object caps[2])
{
    const sure_shape_info *info = sure_shape_info_of(body->shape);
    const double *x = (const double *)(const void *)&body->as;
    if (info->field_count < 3 || info->fields[1].kind != SURE_KIND_OTHER_POINT)
        return 0;
    const sure_vec3 ends[2] = {*(const sure_vec3 *)x, *(const sure_vec3 *)(x + info->fields[1].at)};
    int count = case_shape_has(body->shape, CASE_HAS_TWO_CAPS) ? 2 : 1;
    for (int i = 0; i < count; i++)
        caps[i] = (sure_object){
            SURE_SHAPE_DISC,
            {.disc = {ends[i], difference_of(ends[i], ends[1 - i]), x[info->fields[2].at]}}};
    return count;
}

int camera_shown_by(const sure_object *object, sure_shape shape, sure_object shown[2])
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    if (object->shape != shape) /* what is flat and ends may be a cap */
        return info->bounded && !info->solid ? caps_of(object, shown) : 0;
    shown[0] = *object;
    return 1;
}

bool camera_has_shape(const camera_picture *picture, sure_shape shape)
{
    sure_object shown[2];
    size_t i = 0;
    while (i < picture->scene.object_count &&
           camera_shown_by(&picture->scene.objects[i], shape, shown) == 0)
        i++;
    return i < picture->scene.object_count;
}

bool camera_shows(sure_shape shape)
{
    bool shown = false;
    for (int i = 0; i < camera_picture_count && !shown; i++)
        shown = camera_has_shape(&camera_pictures[i], shape);
    return shown;
}

bool camera_has_kind(const camera_picture *picture, sure_ray_kind kind)
{
    bool found =
        kind == SURE_RAY_PIXEL || (kind == SURE_RAY_SHADOW && picture->scene.light_count > 0);
    for (size_t i = 0; i < picture->scene.object_count && !found; i++) {
        const sure_material *material = &picture->scene.materials[i];
        found = kind == SURE_RAY_MIRROR ? material->mirror > 0
                                        : kind == SURE_RAY_REFRACTED && material->refract > 0;
    }
    return found;
}

int camera_window(int pixels, int window, int which)
{
    return pixels / 4 * (which == 0 ? 1 : 3) - window / 2;
}

sure_ray camera_pixel_ray(const camera_picture *picture, int finer, int column, int row)
{
    sure_scene scene = picture->scene;
    scene.width *= finer;
    scene.height *= finer;
    sure_ray ray = sure_scene_pixel_ray(&scene, column, row);
    ray.t_min = 0x1p-1074; /* what the eye touches is not in front of it */
    return ray;
}

/* Cuts the range to where the line is between two parallel planes. */
static void cut(double range[2], double o, double d, double low, double high)
{
    double to_low = (low - o) / d, to_high = (high - o) / d;
    if (d != 0) {
        double enter = to_low < to_high ? to_low : to_high;
        double leave = to_low < to_high ? to_high : to_low;
        range[0] = range[0] > enter ? range[0] : enter;
        range[1] = range[1] < leave ? range[1] : leave;
    } else if (o < low || o > high) {
        range[1] = -1;
    }
}

bool camera_meets_box(const sure_ray *ray, const sure_bounds *box)
{
    double range[2] = {ray->t_min, ray->t_max};
    cut(range, ray->origin.x, ray->direction.x, box->low[0], box->high[0]);
    cut(range, ray->origin.y, ray->direction.y, box->low[1], box->high[1]);
    cut(range, ray->origin.z, ray->direction.z, box->low[2], box->high[2]);
    return range[0] <= range[1];
}
