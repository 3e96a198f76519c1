#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "scene_text.h"

#include "placement.h"
#include "written_scene.h"

#include <check.h>

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

char *scene_text(const rt_scene *file)
{
    char *text = written_scene(file);
    ck_assert_ptr_nonnull(text);
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
