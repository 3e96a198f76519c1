#include "placement.h"

#include "viewport.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double focal_length = 1;
static const int mirror_depth = 8;

/* How the file's space becomes the camera's. */
typedef struct {
    sure_vec3 eye;
    sure_mat3 rotation;
    bool mirrored; /* a left-handed file: +x is to the left of what a right-handed one shows */
} motion;

static sure_vec3 turned(const motion *m, sure_vec3 direction)
{
    sure_vec3 v = sure_rotation_apply_textbook(&m->rotation, direction);
    if (m->mirrored)
        v.x = -v.x;
    return v;
}

static sure_vec3 moved(const motion *m, sure_vec3 point)
{
    sure_vec3 from_eye = {point.x - m->eye.x, point.y - m->eye.y, point.z - m->eye.z};
    return turned(m, from_eye);
}

static bool same(sure_vec3 a, sure_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Both end points of a body whose `position` is one of them or the middle; `axis` points from low
 * to high. An end point is the middle of a body of twice the height. */
static sure_field ends(rt_position at, sure_vec3 position, sure_vec3 axis, double height,
                       sure_vec3 *low, sure_vec3 *high)
{
    sure_cylinder body;
    double around_position = at == RT_POSITION_MIDDLE ? height : 2 * height;
    if (around_position > DBL_MAX)
        return SURE_FIELD_CENTRE;
    sure_field bad = sure_cylinder_from_axis_textbook(position, axis, 0, around_position, &body);
    if (bad != SURE_FIELD_NONE)
        return bad;
    *low = at == RT_POSITION_BASE ? position : body.base;
    *high = at == RT_POSITION_APEX ? position : body.top;
    return same(*low, *high) ? SURE_FIELD_TOP : SURE_FIELD_NONE;
}

static sure_field place(const rt_element *element, const rt_options *options, const motion *m,
                        sure_object *object)
{
    sure_vec3 position = moved(m, element->position);
    sure_vec3 axis = turned(m, element->axis);
    double radius = element->diameter / 2;
    sure_field bad = SURE_FIELD_NONE;
    object->shape = element->shape;
    switch (element->shape) {
    case SURE_SHAPE_PLANE: object->as.plane = (sure_plane){position, axis}; break;
    case SURE_SHAPE_DISC: object->as.disc = (sure_disc){position, axis, radius}; break;
    case SURE_SHAPE_SPHERE: object->as.sphere = (sure_sphere){position, radius}; break;
    case SURE_SHAPE_CYLINDER:
        object->as.cylinder.radius = radius;
        bad = ends(options->cylinder_position, position, axis, element->height,
                   &object->as.cylinder.base, &object->as.cylinder.top);
        break;
    case SURE_SHAPE_CONE:
        object->as.cone.radius = radius;
        if (options->cone_position == RT_POSITION_APEX) /* it opens along the axis */
            axis = (sure_vec3){-axis.x, -axis.y, -axis.z};
        bad = ends(options->cone_position, position, axis, element->height, &object->as.cone.base,
                   &object->as.cone.apex);
        break;
    }
    if (bad != SURE_FIELD_NONE)
        return bad;
    const sure_ray forward = {{0, 0, 0}, {0, 0, -1}, 0, 0};
    return sure_object_check(&forward, object);
}

static const char out_of_range[] =
    "lies out of range of the camera; expected coordinates whose differences are finite";

/* What the eye makes of a field that the reader let pass. */
static const char *reason(sure_field field)
{
    switch (field) {
    case SURE_FIELD_TOP:
    case SURE_FIELD_APEX:
        return "end points coincide once rounded; expected a height that can be told from 0 there";
    case SURE_FIELD_NORMAL: return "direction underflows to zero; expected a larger one";
    case SURE_FIELD_RADIUS: return "diameter is not a size; expected a finite one";
    default: return out_of_range;
    }
}

static bool complain(FILE *messages, const rt_scene *file, size_t line, size_t column,
                     const char *what, const char *why)
{
    fprintf(messages, "%s:%zu:%zu: error: %s: %s\n", file->name, line, column, what, why);
    return false;
}

/* One error more: its line, while there are few. */
static void blame(const rt_scene *file, FILE *messages, size_t line, size_t column,
                  const char *what, const char *why, size_t *errors)
{
    if (++*errors <= RT_ERRORS_SHOWN)
        complain(messages, file, line, column, what, why);
}

static void place_object(const rt_scene *file, size_t i, const motion *m, FILE *messages,
                         sure_object *object, size_t *errors)
{
    const rt_element *element = &file->elements[i];
    sure_field bad = place(element, &file->options, m, object);
    if (bad != SURE_FIELD_NONE)
        blame(file, messages, element->line, element->column, sure_shape_name(element->shape),
              reason(bad), errors);
}

static void place_light(const rt_scene *file, size_t i, const motion *m, FILE *messages,
                        sure_light *light, size_t *errors)
{
    *light = file->lights[i];
    light->position = moved(m, file->lights[i].position);
    sure_vec3 at = light->position;
    if (!(isfinite(at.x) && isfinite(at.y) && isfinite(at.z)))
        blame(file, messages, file->light_places[i].line, file->light_places[i].column, "light",
              out_of_range, errors);
}

/* In the order of the text, which is that of the errors. */
static bool place_all(const rt_scene *file, const motion *m, FILE *messages, sure_object *objects,
                      sure_light *lights)
{
    size_t errors = 0, object = 0, light = 0;
    while (object < file->element_count || light < file->light_count) {
        bool is_light = object == file->element_count ||
                        (light < file->light_count &&
                         file->light_places[light].line < file->elements[object].line);
        if (is_light)
            place_light(file, light, m, messages, &lights[light], &errors);
        else
            place_object(file, object, m, messages, &objects[object], &errors);
        *(is_light ? &light : &object) += 1;
    }
    if (errors > RT_ERRORS_SHOWN)
        fprintf(messages, "%s: %zu more error%s\n", file->name, errors - RT_ERRORS_SHOWN,
                errors - RT_ERRORS_SHOWN == 1 ? "" : "s");
    return errors == 0;
}

static sure_camera window(const rt_scene *file)
{
    const rt_options *options = &file->options;
    double extent = viewport_extent(focal_length, file->camera_fov);
    double aspect = (double)options->width / options->height;
    sure_camera camera = {.focal_length = focal_length};
    camera.viewport_width = options->fov == RT_FOV_HORIZONTAL ? extent : extent * aspect;
    camera.viewport_height = options->fov == RT_FOV_HORIZONTAL ? extent / aspect : extent;
    return camera;
}

static bool no_memory(const rt_scene *file, FILE *messages)
{
    fprintf(messages, "%s: error: no memory for %zu objects\n", file->name, file->element_count);
    return false;
}

/* Room for `count` of them; NULL only when there is no memory. */
static void *room(size_t count, size_t size)
{
    return calloc(count > 0 ? count : 1, size);
}

/* All but the materials. */
static bool place_scene(const rt_scene *file, FILE *messages, sure_scene *scene)
{
    motion m = {.eye = file->camera_position,
                .mirrored = file->options.handedness == RT_LEFT_HANDED};
    if (sure_camera_rotation_textbook(file->camera_direction, &m.rotation) != SURE_HIT)
        return complain(messages, file, file->camera_line, file->camera_column, "camera",
                        "direction is zero");
    sure_camera camera = window(file);
    if (!(camera.viewport_width > 0 && camera.viewport_height > 0))
        return complain(messages, file, file->camera_line, file->camera_column, "camera",
                        "field of view underflows to zero; expected a larger one");
    sure_object *objects = room(file->element_count, sizeof *objects);
    sure_light *lights = room(file->light_count, sizeof *lights);
    bool ok = (objects && lights) || no_memory(file, messages);
    ok = ok && place_all(file, &m, messages, objects, lights);
    if (!ok) {
        free(objects);
        free(lights);
        return false;
    }
    double ratio = file->ambient_ratio;
    sure_vec3 ambient = file->ambient_color;
    *scene = (sure_scene){
        .objects = objects,
        .object_count = file->element_count,
        .lights = lights,
        .light_count = file->light_count,
        .ambient = {ratio * ambient.x, ratio * ambient.y, ratio * ambient.z},
        .falloff = file->options.falloff,
        .camera = camera,
        .width = file->options.width,
        .height = file->options.height,
        .depth = mirror_depth,
    };
    return true;
}

bool placement(const rt_scene *file, FILE *messages, sure_scene *scene)
{
    sure_material *materials = room(file->element_count, sizeof *materials);
    bool ok = (materials || no_memory(file, messages)) && place_scene(file, messages, scene);
    if (!ok) {
        free(materials);
        return false;
    }
    for (size_t i = 0; i < file->element_count; i++)
        materials[i] = file->materials[i];
    scene->materials = materials;
    return true;
}

bool placement_taking(rt_scene *file, FILE *messages, sure_scene *scene)
{
    if (!place_scene(file, messages, scene))
        return false;
    scene->materials = file->materials;
    file->materials = NULL;
    return true;
}

void placement_free(sure_scene *scene)
{
    free((void *)scene->objects);
    free((void *)scene->materials);
    free((void *)scene->lights);
    *scene = (sure_scene){0};
}
