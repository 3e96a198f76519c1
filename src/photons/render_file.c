#include "render_file.h"

#include "../hierarchy/bvh_build.h"
#include "../scene/placement.h"
#include "../support/progress.h"
#include "map/caustics.h"

#include <stdlib.h>

render_settings render_defaults(void)
{
    return (render_settings){.reading = rt_default_options(), .how.tier = SURE_TIER_CERTAIN};
}

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
    placed->read = read - started;
    placed->place = progress_clock() - read;
    rt_scene_free(&file);
    return done;
}

void placed_scene_free(placed_scene *placed)
{
    placement_free(&placed->scene);
}

void rendering_free(rendering *drawn)
{
    picture_free(&drawn->image);
    free(drawn->records);
    drawn->records = NULL;
}

static bool size_of(const char *path, const sure_scene *scene, const render_options *how,
                    FILE *messages, int *width, int *height)
{
    const picture_part *part = &how->part;
    if (render_size(scene, how, width, height))
        return true;
    fprintf(messages, "%s: error: the tile %d,%d,%dx%d is not within its picture of %dx%d\n", path,
            part->x, part->y, part->width, part->height, scene->width, scene->height);
    return false;
}

static bool make_room(const char *path, int width, int height, const render_settings *settings,
                      FILE *messages, rendering *drawn)
{
    *drawn = (rendering){.records = NULL};
    bool made = picture_new(width, height, &drawn->image);
    if (made && settings->recorded) {
        drawn->records = calloc((size_t)height, (size_t)width * sizeof *drawn->records);
        made = drawn->records != NULL;
    }
    if (made)
        return true;
    fprintf(messages, "%s: error: no memory for %dx%d pixels\n", path, width, height);
    rendering_free(drawn);
    return false;
}

/* Of a scene that has its hierarchy, or none. */
static caustics_statistics forward_pass(const sure_scene *scene, const render_settings *settings,
                                        sure_photon_map *map)
{
    const caustics_options how = {.tier = settings->how.tier,
                                  .threads = settings->how.threads,
                                  .insists = settings->integrator == INTEGRATOR_MIXED,
                                  .photons = settings->photons,
                                  .seed = settings->seed};
    if (settings->integrator != INTEGRATOR_AUTO && settings->integrator != INTEGRATOR_MIXED)
        return (caustics_statistics){.state = CAUSTICS_NOT_ASKED};
    return caustics_build(scene, &how, map);
}

scene_times render_scene(const sure_scene *scene, const render_settings *settings, picture *image)
{
    const render_options *how = &settings->how;
    sure_scene lit = *scene;
    sure_bvh bvh;
    sure_photon_map map;
    double started = progress_clock();
    lit.bvh = bvh_for(scene, !how->without_bvh, how->threads, &bvh);
    double ready = progress_clock();
    caustics_statistics caustics = forward_pass(&lit, settings, &map);
    lit.caustics = caustics.state == CAUSTICS_ON ? &map : NULL;
    double traced = progress_clock();
    render_times drawn = render(&lit, how, image);
    if (lit.caustics)
        photon_map_free(&map);
    bvh_free(&bvh);
    return (scene_times){ready - started, traced - ready, drawn.frame, caustics};
}

bool render_file_draw(const char *path, const placed_scene *placed, const render_settings *settings,
                      FILE *messages, rendering *drawn)
{
    int width, height;
    if (!size_of(path, &placed->scene, &settings->how, messages, &width, &height) ||
        !make_room(path, width, height, settings, messages, drawn))
        return false;
    render_settings recording = *settings;
    recording.how.statistics = settings->counted ? &drawn->statistics : NULL;
    recording.how.records = drawn->records;
    drawn->times = render_scene(&placed->scene, &recording, &drawn->image);
    if (drawn->times.caustics.state != CAUSTICS_NO_MEMORY)
        return true;
    fprintf(messages, "%s: error: no memory for the photons\n", path);
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
    placed_scene_free(&placed);
    if (!done)
        return false;
    *image = drawn.image;
    free(drawn.records);
    return true;
}
