#define _POSIX_C_SOURCE 200809L /* locale_t */

#include "rt_elements.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "shapes/rt_shape.h"

static const rt_field position = {.name = "position", .expected = "x,y,z"};
static const rt_field direction = {.name = "direction", .expected = "x,y,z, not all zero"};
static const rt_field ambient_ratio = {"ambient ratio", "a number from 0 to 1", 0, 1, false};
static const rt_field light_ratio = {"light ratio", "a number from 0 to 1", 0, INFINITY, false};
static const rt_field view = {"field of view", "degrees above 0 and below 180", 0, 180, true};

/* Materials: words behind the colour. */

static const struct {
    rt_field field;
    size_t at; /* of its value in a material */
    bool whole;
} labels[] = {
    {{"spec", "a number from 0 to 1", 0, 1, false}, offsetof(sure_material, specular), false},
    {{"shine", "a whole number from 0 to 65535", 0, RT_WHOLE_MAX, false},
     offsetof(sure_material, shine),
     true},
    {{"refl", "a number from 0 to 1", 0, 1, false}, offsetof(sure_material, mirror), false},
    {{"refr", "an index of refraction from 1", 1, INFINITY, false},
     offsetof(sure_material, refract),
     false},
};

enum { LABELS = sizeof labels / sizeof *labels };

static int find_label(rt_word w)
{
    int i = 0;
    while (i < LABELS && !rt_is_word(w, labels[i].field.name))
        i++;
    return i;
}

static bool read_label(rt_reader *r, int i, sure_material *material)
{
    void *value = (char *)material + labels[i].at;
    return labels[i].whole ? rt_read_integer(&r->line, &labels[i].field, value)
                           : rt_read_value(&r->line, &labels[i].field, value);
}

/* spec:0.5 shine:32 refl:0.3 refr:1.5, any of them in any order. */
static bool read_material(rt_reader *r, sure_material *material)
{
    bool seen[LABELS] = {false};
    while (rt_more_fields(&r->line)) {
        rt_word w = rt_word_at(&r->line, r->line.at);
        const char *colon = memchr(w.start, ':', (size_t)(w.end - w.start));
        rt_word label = {w.start, colon ? colon : w.end};
        int which = colon ? find_label(label) : LABELS;
        if (which == LABELS) {
            rt_complain(&r->notes, RT_ERROR, w.start,
                        "%s after the colour; expected spec:, shine:, refl:, refr: or the end of "
                        "the line",
                        rt_quote(rt_run_at(&r->line, w.start)).text);
            return false;
        }
        if (seen[which]) {
            rt_complain(&r->notes, RT_ERROR, w.start, "a second %s; expected it once",
                        rt_quote(label).text);
            return false;
        }
        seen[which] = true;
        r->line.at = colon + 1;
        if (!read_label(r, which, material))
            return false;
    }
    return true;
}

/* Elements: one function each. */

static void run_out_of_memory(rt_reader *r)
{
    r->out_of_memory = true;
    rt_complain(&r->notes, RT_ERROR, r->notes.line_start,
                "no memory for more; expected a smaller scene");
}

/* The array with room for one item more; NULL, with the array kept, if there is none. It grows when
 * the count is a power of two. */
static void *with_room(rt_reader *r, void *array, size_t count, size_t size)
{
    enum { FIRST = 64 };
    if (count > 0 && (count < FIRST || (count & (count - 1)) != 0))
        return array;
    size_t capacity = count > 0 ? 2 * count : FIRST;
    void *larger = capacity > SIZE_MAX / size ? NULL : realloc(array, capacity * size);
    if (!larger)
        run_out_of_memory(r);
    return larger;
}

static size_t column_of(const rt_reader *r, rt_word identifier)
{
    return (size_t)(identifier.start - r->notes.line_start) + 1;
}

static void add_light(rt_reader *r, const rt_light *light)
{
    rt_light *lights = with_room(r, r->scene.lights, r->scene.light_count, sizeof *lights);
    if (!lights)
        return;
    r->scene.lights = lights;
    lights[r->scene.light_count++] = *light;
}

static void add_element(rt_reader *r, const rt_element *element, const sure_material *material)
{
    rt_scene *scene = &r->scene;
    rt_element *elements = with_room(r, scene->elements, scene->element_count, sizeof *elements);
    if (!elements)
        return;
    scene->elements = elements;
    sure_material *materials =
        with_room(r, scene->materials, scene->element_count, sizeof *materials);
    if (!materials)
        return;
    scene->materials = materials;
    elements[scene->element_count] = *element;
    materials[scene->element_count++] = *material;
}

/* Notes where the only one of its kind is, in *line; or that it is a second one. */
static void read_once(rt_reader *r, rt_word identifier, size_t *line)
{
    if (*line)
        rt_complain(&r->notes, RT_ERROR, identifier.start,
                    "a second %c; expected one, it is on line %zu", *identifier.start, *line);
    else
        *line = r->notes.line_number;
}

void rt_read_ambient(rt_reader *r, rt_word identifier)
{
    read_once(r, identifier, &r->ambient_line);
    if (rt_read_scalar(&r->line, &ambient_ratio, &r->scene.ambient_ratio) &&
        rt_read_color(&r->line, &r->scene.ambient_color))
        rt_expect_end(&r->line);
}

void rt_read_camera(rt_reader *r, rt_word identifier)
{
    rt_scene *scene = &r->scene;
    if (!scene->camera_line)
        scene->camera_column = column_of(r, identifier);
    read_once(r, identifier, &scene->camera_line);
    if (rt_read_vector(&r->line, &position, &scene->camera_position) &&
        rt_read_direction(&r->line, &direction, &scene->camera_direction) &&
        rt_read_scalar(&r->line, &view, &scene->camera_fov))
        rt_expect_end(&r->line);
}

void rt_read_light(rt_reader *r, rt_word identifier)
{
    rt_light given = {{.color = {1, 1, 1}}, r->notes.line_number, column_of(r, identifier)};
    sure_light *light = &given.light;
    r->has_light = true;
    if (!rt_read_vector(&r->line, &position, &light->position))
        return;
    rt_skip_blanks(&r->line);
    const char *ratio = r->line.at;
    if (!rt_read_scalar(&r->line, &light_ratio, &light->brightness))
        return;
    if (light->brightness > 1)
        rt_complain(&r->notes, RT_BRIGHT_LIGHT, ratio,
                    "light ratio %s is out of range; expected a number from 0 to 1 (with falloff "
                    "inverse-square, from 0)",
                    rt_quote(rt_word_at(&r->line, ratio)).text);
    if (rt_more_fields(&r->line) && !rt_read_color(&r->line, &light->color))
        return;
    rt_expect_end(&r->line);
    add_light(r, &given);
}

static bool read_field(rt_line *line, const rt_shape_field *f, void *value)
{
    switch (f->kind) {
    case RT_POINT: return rt_read_vector(line, &f->field, value);
    case RT_DIRECTION: return rt_read_direction(line, &f->field, value);
    default: return rt_read_scalar(line, &f->field, value);
    }
}

void rt_read_shape(rt_reader *r, rt_word identifier, sure_shape shape)
{
    rt_element element = {
        .shape = shape, .line = r->notes.line_number, .column = column_of(r, identifier)};
    sure_material material = {.shine = 32};
    for (const rt_shape_field *f = rt_shape_of(shape)->fields; f->field.name; f++) {
        if (!read_field(&r->line, f, rt_value(&element, f)))
            return;
    }
    if (!rt_read_color(&r->line, &material.color) || !read_material(r, &material))
        return;
    rt_expect_end(&r->line);
    add_element(r, &element, &material);
}
