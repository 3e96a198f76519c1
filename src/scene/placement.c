/* SPDX-License-Identifier: MIT */
#include "placement.h"

#include "shapes/rt_shape.h"

#include <math.h>
#include <stdlib.h>

static const double focal_length = 1;
static const int mirror_depth = 8;

static bool is_within(const rt_scene *file, sure_vec3 p)
{
    const sure_vec3 eye = file->camera_position;
    return isfinite(p.x - eye.x) && isfinite(p.y - eye.y) && isfinite(p.z - eye.z);
}

static bool is_element_within(const rt_scene *file, const rt_element *e)
{
    bool within = true;
    for (const rt_field *f = rt_shapes[e->shape]->fields; f->name; f++)
        within = within && (f->kind != RT_POINT || is_within(file, *(sure_vec3 *)rt_value(e, f)));
    return within;
}

static void place_object(const rt_scene *file, size_t i, rt_notes *notes, sure_object *object)
{
    const sure_ray forward = {{0, 0, 0}, {0, 0, -1}, 0, 0};
    const rt_element *e = &file->elements[i];
    object->shape = e->shape;
    const char *why = is_element_within(file, e) ? NULL : rt_wrong(SURE_FIELD_CENTRE);
    if (!why)
        why = rt_shapes[e->shape]->place(e, &file->options, object);
    if (!why)
        why = rt_wrong(sure_object_check(&forward, object));
    if (why)
        rt_complain(notes, RT_ERROR, e->at, "%s: %s", sure_shape_name(e->shape), why);
}

static void place_light(const rt_scene *file, size_t i, rt_notes *notes, sure_light *light)
{
    const rt_light *given = &file->lights[i];
    *light = given->light;
    if (!is_within(file, light->position))
        rt_complain(notes, RT_ERROR, given->at, "light: %s", rt_wrong(SURE_FIELD_CENTRE));
}

/* In the order of the text, which is that of the errors. */
static void place_all(const rt_scene *file, rt_notes *notes, sure_object *objects,
                      sure_light *lights)
{
    size_t object = 0, light = 0;
    while (object < file->element_count || light < file->light_count) {
        bool is_light = object == file->element_count ||
                        (light < file->light_count &&
                         file->lights[light].at.line < file->elements[object].at.line);
        if (is_light)
            place_light(file, light, notes, &lights[light]);
        else
            place_object(file, object, notes, &objects[object]);
        *(is_light ? &light : &object) += 1;
    }
}

static sure_camera window(const rt_scene *file)
{
    const rt_options *options = &file->options;
    double extent = viewport_extent(focal_length, file->camera_fov);
    double aspect = (double)options->width / options->height;
    sure_camera camera = {.position = file->camera_position, .focal_length = focal_length};
    camera.viewport_width = options->fov == RT_FOV_HORIZONTAL ? extent : extent * aspect;
    camera.viewport_height = options->fov == RT_FOV_HORIZONTAL ? extent / aspect : extent;
    return camera;
}

/* Left-handed: +x is to the left of what a right-handed file shows. */
static bool turn_of(const rt_scene *file, sure_mat3 *turn)
{
    if (sure_camera_rotation_textbook(file->camera_direction, turn) != SURE_HIT)
        return false;
    sure_vec3 *right = &turn->row[0];
    if (file->options.handedness == RT_LEFT_HANDED)
        *right = (sure_vec3){-right->x, -right->y, -right->z};
    return true;
}

bool placement(rt_scene *file, FILE *messages, sure_scene *scene)
{
    rt_notes notes = {.name = file->name, .messages = messages};
    sure_camera camera = window(file);
    sure_mat3 turn;
    sure_object *objects = calloc(file->element_count + 1, sizeof *objects);
    sure_light *lights = calloc(file->light_count + 1, sizeof *lights);
    bool ok = objects && lights;
    if (!ok)
        fprintf(messages, "%s: error: no memory for %zu objects\n", file->name,
                file->element_count);
    if (!turn_of(file, &turn))
        rt_complain(&notes, RT_ERROR, file->camera_at, "camera: direction is zero");
    else if (!(camera.viewport_width > 0 && camera.viewport_height > 0))
        rt_complain(&notes, RT_ERROR, file->camera_at,
                    "camera: field of view underflows to zero; expected a larger one");
    else if (ok)
        place_all(file, &notes, objects, lights);
    if (rt_report(&notes, &file->options) > 0 || !ok) {
        free(objects);
        free(lights);
        return false;
    }
    double ratio = file->ambient_ratio;
    sure_vec3 ambient = file->ambient_color;
    *scene = (sure_scene){
        .objects = objects,
        .materials = file->materials,
        .object_count = file->element_count,
        .lights = lights,
        .light_count = file->light_count,
        .ambient = {ratio * ambient.x, ratio * ambient.y, ratio * ambient.z},
        .falloff = file->options.falloff,
        .camera = camera,
        .turn = turn,
        .width = file->options.width,
        .height = file->options.height,
        .depth = mirror_depth,
    };
    file->materials = NULL;
    return true;
}

sure_float_object *placement_floats(const sure_scene *scene, sure_tier tier)
{
    sure_float_object *floats = NULL;
    if (tier == SURE_TIER_FLOAT32)
        floats = malloc(scene->object_count * sizeof *floats);
    for (size_t i = 0; floats && i < scene->object_count; i++)
        sure_float_object_of(&scene->objects[i], &floats[i]);
    return floats;
}

void placement_free(sure_scene *scene)
{
    free((void *)scene->objects);
    free((void *)scene->materials);
    free((void *)scene->lights);
    *scene = (sure_scene){0};
}
