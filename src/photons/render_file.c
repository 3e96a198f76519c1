/* SPDX-License-Identifier: MIT */
#include "render_file.h"

#include "../hierarchy/bvh_build.h"
#include "../support/complain.h"
#include "../support/progress.h"
#include "map/caustics.h"

#include <stdlib.h>

bool render_file_place(const char *path, const render_settings *settings, FILE *messages,
                       placed_scene *placed)
{
    rt_scene file;
    double started = progress_clock();
    if (!rt_read(path, &settings->reading, settings->reading_set, messages, &file))
        return false;
    double read = progress_clock();
    bool done = placement(&file, messages, &placed->scene);
    placed->options = file.options;
    placed->hash = file.hash;
    placed->read = read - started;
    placed->place = progress_clock() - read;
    rt_scene_free(&file);
    return done;
}

void rendering_free(rendering *drawn)
{
    picture_free(&drawn->image);
    free(drawn->records);
    drawn->records = NULL;
}

bool rendering_room(const char *path, const placed_scene *placed, const render_settings *settings,
                    FILE *messages, rendering *drawn)
{
    const sure_scene *scene = &placed->scene;
    const picture_part *part = &settings->how.part;
    int width, height;
    *drawn = (rendering){.records = NULL};
    if (!render_size(scene, &settings->how, &width, &height))
        return complain(messages, path, "the tile %d,%d,%dx%d is not within its picture of %dx%d",
                        part->x, part->y, part->width, part->height, scene->width, scene->height);
    bool made = picture_new(width, height, &drawn->image);
    if (made && settings->recorded) {
        drawn->records = calloc((size_t)height, (size_t)width * sizeof *drawn->records);
        made = drawn->records != NULL;
    }
    if (made)
        return true;
    rendering_free(drawn);
    return complain(messages, path, "no memory for %dx%d pixels", width, height);
}

size_t scene_bytes(const sure_scene *scene, sure_tier tier)
{
    size_t floats = tier == SURE_TIER_FLOAT32 ? sizeof *scene->floats : 0;
    return scene->object_count * (sizeof *scene->objects + sizeof *scene->materials + floats) +
           scene->light_count * sizeof *scene->lights;
}

scene_times render_scene(const sure_scene *scene, const render_settings *settings, picture *image)
{
    sure_scene lit = *scene;
    sure_bvh bvh;
    sure_photon_map map;
    double started = progress_clock();
    sure_float_object *floats = placement_floats(scene, settings->how.tier);
    lit.floats = floats;
    lit.bvh = bvh_for(scene, !settings->how.without_bvh, settings->how.threads, &bvh);
    double ready = progress_clock();
    caustics_statistics caustics = caustics_build(&lit, settings, &map);
    lit.caustics = caustics.state == CAUSTICS_ON ? &map : NULL;
    double traced = progress_clock();
    render(&lit, &settings->how, image);
    double drawn = progress_clock();
    size_t bytes = lit.bvh ? bvh_bytes(&bvh, scene->object_count) : 0;
    if (lit.caustics)
        photon_map_free(&map);
    bvh_free(&bvh);
    free(floats);
    return (scene_times){ready - started, traced - ready, drawn - traced, bytes, caustics};
}

bool rendering_draw(const char *path, const placed_scene *placed, const render_settings *settings,
                    FILE *messages, rendering *drawn)
{
    render_settings recording = *settings;
    recording.how.statistics = settings->counted ? &drawn->statistics : NULL;
    recording.how.records = drawn->records;
    drawn->times = render_scene(&placed->scene, &recording, &drawn->image);
    return drawn->times.caustics.state != CAUSTICS_NO_MEMORY ||
           complain(messages, path, "no memory for the photons");
}

bool render_file_draw(const char *path, const placed_scene *placed, const render_settings *settings,
                      FILE *messages, rendering *drawn)
{
    if (!rendering_room(path, placed, settings, messages, drawn))
        return false;
    if (rendering_draw(path, placed, settings, messages, drawn))
        return true;
    rendering_free(drawn);
    return false;
}

bool render_file(const char *path, const render_settings *settings, FILE *messages, picture *image)
{
    placed_scene placed;
    rendering drawn;
    if (!render_file_place(path, settings, messages, &placed))
        return false;
    bool done = render_file_draw(path, &placed, settings, messages, &drawn);
    placement_free(&placed.scene);
    if (!done)
        return false;
    *image = drawn.image;
    free(drawn.records);
    return true;
}
