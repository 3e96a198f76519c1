#include "placement.h"

#include "shapes/rt_shape.h"

#include <math.h>
#include <mpfr.h>
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

/* The element as the camera sees it. */
static rt_element seen(const rt_element *element, const rt_shape *row, const motion *m)
{
    rt_element e = *element;
    for (const rt_field *f = row->fields; f->name; f++) {
        sure_vec3 *value = rt_value(&e, f);
        if (f->kind == RT_POINT)
            *value = moved(m, *value);
        else if (f->kind == RT_DIRECTION)
            *value = turned(m, *value);
    }
    return e;
}

static void place_object(const rt_scene *file, size_t i, const motion *m, rt_notes *notes,
                         sure_object *object)
{
    const sure_ray forward = {{0, 0, 0}, {0, 0, -1}, 0, 0};
    const rt_placing how = {&file->options, &m->rotation};
    const rt_shape *row = rt_shapes[file->elements[i].shape];
    const rt_element e = seen(&file->elements[i], row, m);
    object->shape = e.shape;
    const char *why = row->place(&e, &how, object);
    if (!why)
        why = rt_wrong(sure_object_check(&forward, object));
    if (why)
        rt_complain(notes, RT_ERROR, e.at, "%s: %s", sure_shape_name(e.shape), why);
}

static void place_light(const rt_scene *file, size_t i, const motion *m, rt_notes *notes,
                        sure_light *light)
{
    const rt_light *given = &file->lights[i];
    *light = given->light;
    light->position = moved(m, light->position);
    sure_vec3 at = light->position;
    if (!(isfinite(at.x) && isfinite(at.y) && isfinite(at.z)))
        rt_complain(notes, RT_ERROR, given->at, "light: %s", rt_wrong(SURE_FIELD_CENTRE));
}

/* In the order of the text, which is that of the errors. */
static void place_all(const rt_scene *file, const motion *m, rt_notes *notes, sure_object *objects,
                      sure_light *lights)
{
    size_t object = 0, light = 0;
    while (object < file->element_count || light < file->light_count) {
        bool is_light = object == file->element_count ||
                        (light < file->light_count &&
                         file->lights[light].at.line < file->elements[object].at.line);
        if (is_light)
            place_light(file, light, m, notes, &lights[light]);
        else
            place_object(file, object, m, notes, &objects[object]);
        *(is_light ? &light : &object) += 1;
    }
}

double viewport_extent(double focal, double fov)
{
    mpfr_t tangent;
    mpfr_init2(tangent, 53);
    mpfr_set_d(tangent, fov, MPFR_RNDN);
    mpfr_tanu(tangent, tangent, 720, MPFR_RNDN); /* tan(2 pi fov / 720) */
    double extent = 2 * focal * mpfr_get_d(tangent, MPFR_RNDN);
    mpfr_clear(tangent);
    return extent;
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

bool placement(rt_scene *file, FILE *messages, sure_scene *scene)
{
    rt_notes notes = {.name = file->name, .messages = messages};
    motion m = {.eye = file->camera_position,
                .mirrored = file->options.handedness == RT_LEFT_HANDED};
    sure_camera camera = window(file);
    sure_object *objects = calloc(file->element_count + 1, sizeof *objects);
    sure_light *lights = calloc(file->light_count + 1, sizeof *lights);
    bool ok = objects && lights;
    if (!ok)
        fprintf(messages, "%s: error: no memory for %zu objects\n", file->name,
                file->element_count);
    if (sure_camera_rotation_textbook(file->camera_direction, &m.rotation) != SURE_HIT)
        rt_complain(&notes, RT_ERROR, file->camera_at, "camera: direction is zero");
    else if (!(camera.viewport_width > 0 && camera.viewport_height > 0))
        rt_complain(&notes, RT_ERROR, file->camera_at,
                    "camera: field of view underflows to zero; expected a larger one");
    else if (ok)
        place_all(file, &m, &notes, objects, lights);
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
        .width = file->options.width,
        .height = file->options.height,
        .depth = mirror_depth,
    };
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
