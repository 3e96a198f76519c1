#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "scene_text.h"

#include "placement.h"

#include <check.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the reader says goes here; warnings are as good as silence. */
typedef struct {
    FILE *stream;
    char *text;
    size_t size;
} messages;

static void listen(messages *m)
{
    m->stream = open_memstream(&m->text, &m->size);
    ck_assert_ptr_nonnull(m->stream);
}

static void expect(messages *m, bool ok)
{
    fclose(m->stream);
    ck_assert_msg(ok, "%s", m->text);
    free(m->text);
}

rt_scene scene_from_file(const char *path)
{
    const rt_options options = rt_default_options();
    rt_scene file;
    messages m;
    listen(&m);
    expect(&m, rt_read(path, &options, 0, m.stream, &file));
    return file;
}

rt_scene scene_from_text(const char *text, const char *name)
{
    const rt_options options = rt_default_options();
    rt_scene file;
    messages m;
    listen(&m);
    expect(&m, rt_read_text(text, strlen(text), name, &options, 0, m.stream, &file));
    return file;
}

static void write_options(FILE *out, const rt_options *options)
{
    static const char *const positions[] = {
        [RT_POSITION_MIDDLE] = "middle", [RT_POSITION_BASE] = "base", [RT_POSITION_APEX] = "apex"};
    fprintf(out, "#! handedness %s\n#! fov %s\n#! cylinder-position %s\n#! cone-position %s\n",
            options->handedness == RT_LEFT_HANDED ? "left" : "right",
            options->fov == RT_FOV_VERTICAL ? "vertical" : "horizontal",
            positions[options->cylinder_position], positions[options->cone_position]);
    fprintf(out, "falloff %s\nR %d %d\n",
            options->falloff == SURE_FALLOFF_INVERSE_SQUARE ? "inverse-square" : "none",
            options->width, options->height);
}

static void write_vector(FILE *out, sure_vec3 v)
{
    fprintf(out, " %a,%a,%a", v.x, v.y, v.z);
}

/* Parts that the reader made by a division by 255. */
static void write_color(FILE *out, sure_vec3 linear)
{
    fprintf(out, " %ld,%ld,%ld", lround(255 * linear.x), lround(255 * linear.y),
            lround(255 * linear.z));
}

static void write_element(FILE *out, const rt_element *element, const sure_material *material)
{
    static const char *const names[] = {[SURE_SHAPE_PLANE] = "pl",
                                        [SURE_SHAPE_SPHERE] = "sp",
                                        [SURE_SHAPE_CYLINDER] = "cy",
                                        [SURE_SHAPE_CONE] = "co"};
    const sure_shape shape = element->shape;
    fputs(names[shape], out);
    write_vector(out, element->position);
    if (shape != SURE_SHAPE_SPHERE)
        write_vector(out, element->axis);
    if (shape != SURE_SHAPE_PLANE)
        fprintf(out, " %a", element->diameter);
    if (shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE)
        fprintf(out, " %a", element->height);
    write_color(out, material->color);
    fprintf(out, " spec:%a shine:%d refl:%a", material->specular, material->shine,
            material->mirror);
    if (material->refract > 0)
        fprintf(out, " refr:%a", material->refract);
    fputc('\n', out);
}

char *scene_text(const rt_scene *file)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    ck_assert_ptr_nonnull(out);
    write_options(out, &file->options);
    fprintf(out, "A %a", file->ambient_ratio);
    write_color(out, file->ambient_color);
    fputs("\nC", out);
    write_vector(out, file->camera_position);
    write_vector(out, file->camera_direction);
    fprintf(out, " %a\n", file->camera_fov);
    for (size_t i = 0; i < file->light_count; i++) {
        fputc('L', out);
        write_vector(out, file->lights[i].position);
        fprintf(out, " %a", file->lights[i].brightness);
        write_color(out, file->lights[i].color);
        fputc('\n', out);
    }
    for (size_t i = 0; i < file->element_count; i++)
        write_element(out, &file->elements[i], &file->materials[i]);
    ck_assert_int_eq(fclose(out), 0);
    return text;
}

sure_scene scene_placed(const rt_scene *file)
{
    sure_scene scene;
    messages m;
    listen(&m);
    expect(&m, placement(file, m.stream, &scene));
    return scene;
}

picture scene_drawn(const rt_scene *file, const render_settings *settings)
{
    char *text = scene_text(file);
    rt_scene again = scene_from_text(text, file->name);
    sure_scene scene = scene_placed(&again);
    picture image;
    int width, height;
    ck_assert(render_size(&scene, &settings->how, &width, &height));
    ck_assert(picture_new(width, height, &image));
    render_scene(&scene, settings, &image);
    placement_free(&scene);
    rt_scene_free(&again);
    free(text);
    return image;
}
