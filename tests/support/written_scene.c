/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "written_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shapes/rt_shape.h"

static void put_vector(FILE *out, sure_vec3 v)
{
    fprintf(out, " %a,%a,%a", v.x, v.y, v.z);
}

static bool is_whole(double part)
{
    return round(255 * part) / 255 == part;
}

/* Parts that the reader made by a division by 255; or of 1, which dialect 42 alone has. */
static void put_color(FILE *out, sure_vec3 c)
{
    if (is_whole(c.x) && is_whole(c.y) && is_whole(c.z))
        fprintf(out, " %.0f,%.0f,%.0f", 255 * c.x, 255 * c.y, 255 * c.z);
    else
        put_vector(out, c);
}

static void put_options(FILE *out, const rt_options *o)
{
    for (int i = 0; i < RT_CHOICES; i++)
        fprintf(out, "#! %s %s\n", rt_option_name((rt_option)i), rt_option_word(o, (rt_option)i));
    fprintf(out, "#! size %dx%d\n%s", o->width, o->height,
            o->skip_unknown ? "#! skip-unknown\n" : "");
}

static void put_light(FILE *out, const sure_light *light)
{
    fputc('L', out);
    put_vector(out, light->position);
    fprintf(out, " %a", light->brightness);
    put_color(out, light->color);
    fputc('\n', out);
}

static void put_element(FILE *out, const rt_element *e, const sure_material *m)
{
    const rt_shape *row = rt_shapes[e->shape];
    fputs(row->words[0], out);
    for (const rt_field *f = row->fields; f->name; f++) {
        const void *value = rt_value(e, f);
        if (f->kind == RT_NUMBER)
            fprintf(out, " %a", *(const double *)value);
        else
            put_vector(out, *(const sure_vec3 *)value);
    }
    put_color(out, m->color);
    fprintf(out, " spec:%a shine:%d refl:%a", m->specular, m->shine, m->mirror);
    if (m->refract != 0)
        fprintf(out, " refr:%a", m->refract);
    fputc('\n', out);
}

static FILE *opened(char **text, size_t *size)
{
    FILE *out = open_memstream(text, size);
    if (!out)
        abort();
    return out;
}

char *written_scene(const rt_scene *scene)
{
    char *text;
    size_t size;
    FILE *out = opened(&text, &size);
    put_options(out, &scene->options);
    fprintf(out, "A %a", scene->ambient_ratio);
    put_color(out, scene->ambient_color);
    fputs("\nC", out);
    put_vector(out, scene->camera_position);
    put_vector(out, scene->camera_direction);
    fprintf(out, " %a\n", scene->camera_fov);
    for (size_t i = 0; i < scene->light_count; i++)
        put_light(out, &scene->lights[i].light);
    for (size_t i = 0; i < scene->element_count; i++)
        put_element(out, &scene->elements[i], &scene->materials[i]);
    fclose(out);
    return text;
}

outcome outcome_of_text(const char *text, size_t size, const char *name, const rt_options *options,
                        rt_options_set set)
{
    outcome o = {.good = false};
    size_t said;
    FILE *messages = opened(&o.messages, &said);
    char *copy = malloc(size);
    if (size > 0)
        memcpy(copy, text, size);
    memset(&o.scene, 0x5a, sizeof o.scene);
    o.good = rt_read_text(copy, size, name, options, set, messages, &o.scene);
    fclose(messages);
    free(copy);
    return o;
}

outcome outcome_of_file(const char *path, const rt_options *options, rt_options_set set)
{
    outcome o = {.good = false};
    size_t said;
    FILE *messages = opened(&o.messages, &said);
    o.good = rt_read(path, options, set, messages, &o.scene);
    fclose(messages);
    return o;
}

outcome outcome_of_placement(const rt_scene *scene)
{
    outcome o = {.good = false};
    size_t said;
    FILE *messages = opened(&o.messages, &said);
    rt_scene copy = *scene;
    copy.materials = malloc((scene->element_count + 1) * sizeof *copy.materials);
    if (!copy.materials)
        abort();
    if (scene->element_count > 0)
        memcpy(copy.materials, scene->materials, scene->element_count * sizeof *copy.materials);
    o.good = placement(&copy, messages, &o.placed);
    free(copy.materials);
    fclose(messages);
    return o;
}

void outcome_free(outcome *o)
{
    if (o->good) {
        rt_scene_free(&o->scene);
        placement_free(&o->placed);
    }
    free(o->messages);
}
