/* SPDX-License-Identifier: MIT */
#include "scene_text.h"

#include "suite.h"
#include "written_scene.h"

const glob_t *scene_files(bool all)
{
    static glob_t files;
    if (files.gl_pathv)
        return &files;
    int status = all ? glob(suite_file("scenes/*.rt"), 0, NULL, &files) : 0;
    if (status != 0 ||
        glob(suite_file("scenes/extreme/*.rt"), all ? GLOB_APPEND : 0, NULL, &files) != 0)
        abort();
    return &files;
}

/* Warnings are as good as silence. */
static outcome good(outcome o)
{
    ck_assert_msg(o.good, "%s", o.messages);
    free(o.messages);
    return o;
}

rt_scene scene_from_file(const char *path)
{
    const rt_options options = rt_default_options();
    return good(outcome_of_file(path, &options, 0)).scene;
}

rt_scene scene_of_size(const char *path, int width, int height)
{
    rt_scene file = scene_from_file(path);
    file.options.width = width;
    file.options.height = height;
    return file;
}

rt_scene scene_from_text(const char *text, const char *name)
{
    const rt_options options = rt_default_options();
    return good(outcome_of_text(text, strlen(text), name, &options, 0)).scene;
}

sure_scene scene_placed(const rt_scene *file)
{
    return good(outcome_of_placement(file)).placed;
}

picture scene_drawn(const rt_scene *file, const render_settings *settings)
{
    FREED_BY(free_text) char *text = written_scene(file);
    FREED_BY(rt_scene_free) rt_scene again = scene_from_text(text, file->name);
    FREED_BY(placement_free) sure_scene scene = scene_placed(&again);
    picture image;
    int width, height;
    ck_assert(render_size(&scene, &settings->how, &width, &height));
    ck_assert(picture_new(width, height, &image));
    render_scene(&scene, settings, &image);
    return image;
}
