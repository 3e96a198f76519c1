#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "written_scene.h"

#include "shapes/rt_shape.h"

static void put_vector(FILE *out, sure_vec3 v)
{
    fprintf(out, " %a,%a,%a", v.x, v.y, v.z);
}

/* Parts that the reader made by a division by 255. */
static void put_color(FILE *out, sure_vec3 c)
{
    fprintf(out, " %.0f,%.0f,%.0f", 255 * c.x, 255 * c.y, 255 * c.z);
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
    const rt_shape *row = rt_shape_of(e->shape);
    fputs(row->words[0], out);
    for (const rt_shape_field *f = row->fields; f->field.name; f++) {
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

char *written_scene(const rt_scene *scene)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return NULL;
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
    return fclose(out) == 0 ? text : NULL;
}
