/* SPDX-License-Identifier: MIT */
#include "rt_reader.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#define VIEW "field of view", "degrees above 0 and below 180", 0, 180, true, .inside = 1
#define COLOR(of, member)                                                                          \
    RT_FIELD(COLOR, of, member, "colour", "R,G,B, whole numbers from 0 to 255", 0, 255)

static const rt_field ambient_ratio =
    RT_FIELD(NUMBER, rt_scene, ambient_ratio, "ambient ratio", "a number from 0 to 1", 0, 1);
static const rt_field ambient_color = COLOR(rt_scene, ambient_color);
static const rt_field camera[] = {
    RT_FIELD(POINT, rt_scene, camera_position, "position", "x,y,z"),
    RT_FIELD(DIRECTION, rt_scene, camera_direction, "direction", "x,y,z, not all zero",
             .usual = {0, 0, 1}),
    RT_FIELD(NUMBER, rt_scene, camera_fov, VIEW),
    {0},
};
static const sure_vec3 white = {1, 1, 1}, grey = {128 / 255.0, 128 / 255.0, 128 / 255.0};

static const rt_field light_position = RT_FIELD(POINT, sure_light, position, "position", "x,y,z");
static const rt_field light_ratio =
    RT_FIELD(NUMBER, sure_light, brightness, "light ratio", "a number from 0 to 1", 0, INFINITY);
static const rt_field light_color = COLOR(sure_light, color);
static const rt_field surface_color = COLOR(sure_material, color);

/* Materials: words behind the colour. */

#define SHARE "a number from 0 to 1", 0, 1
#define SHINE "a whole number from 0 to 65535", 0, RT_WHOLE_MAX
#define INDEX "an index of refraction from 1", 1, INFINITY

static const rt_field labels[] = {
    RT_FIELD(NUMBER, sure_material, specular, "spec", SHARE),
    RT_FIELD(WHOLE, sure_material, shine, "shine", SHINE),
    RT_FIELD(NUMBER, sure_material, mirror, "refl", SHARE),
    RT_FIELD(NUMBER, sure_material, refract, "refr", INDEX),
};

enum { LABELS = sizeof labels / sizeof *labels };

static int find_label(rt_word w)
{
    int i = 0;
    while (i < LABELS && !rt_is_word(w, labels[i].name))
        i++;
    return i;
}

/* In dialect 42, where the words of others stand among them. */
static void read_label(rt_reader *r, const char *colon, int which, bool *seen,
                       sure_material *material)
{
    const char *start = r->at;
    sure_material further = *material;
    r->at = colon ? colon + 1 : start;
    if (which < LABELS && !seen[which] && rt_try_field(r, &labels[which], &further)) {
        seen[which] = true;
        *material = further;
        return;
    }
    r->at = start;
    rt_leave_out(r, "what stands behind the colour and is not known is left out");
}

/* spec:0.5 shine:32 refl:0.3 refr:1.5, any of them in any order. */
static bool read_material(rt_reader *r, sure_material *material)
{
    bool seen[LABELS] = {false};
    while (rt_more_fields(r)) {
        rt_word w = rt_word_at(r, r->at);
        const char *colon = memchr(w.start, ':', (size_t)(w.end - w.start));
        rt_word label = {w.start, colon ? colon : w.end};
        int which = colon ? find_label(label) : LABELS;
        if (r->lenient) {
            read_label(r, colon, which, seen, material);
            continue;
        }
        if (which == LABELS)
            return rt_may(r, w.start, NULL,
                          "%s after the colour; expected spec:, shine:, refl:, refr: or the end of "
                          "the line",
                          rt_quote(rt_run_at(r, w.start)).text);
        if (seen[which]) {
            rt_fault(r, w.start, "a second %s; expected it once", rt_quote(label).text);
            return false;
        }
        seen[which] = true;
        r->at = colon + 1;
        if (!rt_read_field(r, &labels[which], material))
            return false;
    }
    return true;
}

/* Elements: one function each. */

/* The array with room for one item more; NULL, with the array kept, if there is none. It grows when
 * the count is a power of two. */
static void *with_room(rt_reader *r, void *array, size_t count, size_t size)
{
    enum { FIRST = 64 };
    if (count > 0 && (count < FIRST || (count & (count - 1)) != 0))
        return array;
    size_t capacity = count > 0 ? 2 * count : FIRST;
    void *larger = capacity > SIZE_MAX / size ? NULL : realloc(array, capacity * size);
    if (!larger) {
        r->out_of_memory = true;
        rt_fault(r, r->notes.line_start, "no memory for more; expected a smaller scene");
    }
    return larger;
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

#define SECOND "a second %c; expected one, it is on line %zu"

void rt_read_ambient(rt_reader *r, rt_word identifier)
{
    rt_scene *scene = &r->scene;
    if (r->ambient_at.line)
        rt_fault(r, identifier.start, SECOND, *identifier.start, r->ambient_at.line);
    else
        r->ambient_at = rt_place_of(&r->notes, identifier.start);
    rt_skip_blanks(r);
    scene->ambient_color = white;
    if (rt_read_field(r, &ambient_ratio, scene) && rt_read_color(r, &ambient_color, scene))
        rt_expect_end(r);
}

/* Scenes have C and L, or c and l; or an l that is of some other kind than their L. */
static void note_old_and_new(rt_reader *r, rt_word identifier)
{
    r->has_old_light |= *identifier.start == 'l';
    r->has_new_camera |= *identifier.start == 'C';
    if (r->has_old_light && r->has_new_camera)
        rt_complain(&r->notes, RT_LIBERTY, rt_place_of(&r->notes, identifier.start),
                    "'l' beside 'C' is taken for a light like 'L'");
}

void rt_read_camera(rt_reader *r, rt_word identifier)
{
    rt_scene unused = {.camera_fov = 0};
    rt_place at = rt_place_of(&r->notes, identifier.start);
    bool counts = ++r->camera_count == r->camera;
    note_old_and_new(r, identifier);
    if (r->camera_count == 1)
        r->first_camera_at = at;
    else
        rt_may(r, identifier.start, NULL, SECOND, *identifier.start, r->first_camera_at.line);
    if (counts)
        r->scene.camera_at = at;
    else if (r->lenient)
        rt_complain(&r->notes, RT_LIBERTY, at,
                    "a further camera is left out; the option camera chooses one");
    if (rt_read_fields(r, camera, counts ? &r->scene : &unused))
        rt_expect_end(r);
}

void rt_read_light(rt_reader *r, rt_word identifier)
{
    rt_light given = {{.color = white}, rt_place_of(&r->notes, identifier.start)};
    sure_light *light = &given.light;
    r->has_light = true;
    note_old_and_new(r, identifier);
    rt_skip_blanks(r);
    if (!rt_read_field(r, &light_position, light))
        return;
    rt_skip_blanks(r);
    const char *ratio = r->at;
    if (!rt_read_field(r, &light_ratio, light))
        return;
    if (light->brightness > 1)
        rt_complain(&r->notes, RT_BRIGHT_LIGHT, rt_place_of(&r->notes, ratio),
                    "light ratio %s is out of range; expected a number from 0 to 1 (with falloff "
                    "inverse-square, from 0)",
                    rt_quote(rt_word_at(r, ratio)).text);
    if (rt_more_fields(r) && !rt_read_color(r, &light_color, light))
        return;
    rt_expect_end(r);
    add_light(r, &given);
}

/* In the form of the line that stands there; false where it makes no element. */
static bool read_element(rt_reader *r, rt_word identifier, rt_element *element)
{
    const rt_form *form = rt_form_of(r, identifier, element->shape);
    if (!form || !r->lenient) {
        r->helps = form;
        bool read = rt_read_fields(r, rt_shapes[element->shape]->fields, element);
        r->helps = false;
        return read;
    }
    size_t errors = rt_errors(r);
    if (!rt_read_fields(r, form->fields, element))
        return false;
    bool taken = form->take && rt_errors(r) == errors; /* a fault has been named already */
    const char *why = taken ? form->take(element) : NULL;
    rt_complain(&r->notes, RT_LIBERTY, element->at, "%s", why ? why : form->guess);
    return !why;
}

void rt_read_shape(rt_reader *r, rt_word identifier, sure_shape shape)
{
    rt_element element = {.shape = shape, .at = rt_place_of(&r->notes, identifier.start)};
    sure_material material = {.color = grey, .shine = 32};
    if (r->lenient)
        rt_leave_out_name(r);
    if (!read_element(r, identifier, &element) || !rt_read_color(r, &surface_color, &material) ||
        !read_material(r, &material))
        return;
    rt_expect_end(r);
    add_element(r, &element, &material);
}
