#include "render_file.h"
#include "../support/openmp.h"
#include "../scene/placement.h"
#include "../support/progress.h"

#include <stdlib.h>

#define PART_MOST 100000000 /* ten times that is an int */

render_settings render_defaults(void)
{
    return (render_settings){.reading = rt_default_options(), .how.tier = SURE_TIER_CERTAIN};
}

int render_threads(const render_options *how)
{
    return openmp_threads(how->threads);
}

/* The number before *text's next `end`, which it is moved behind; -1 where there is none. */
static int take_number(const char **text, char end)
{
    int value = 0;
    const char *at = *text;
    for (; *at >= '0' && *at <= '9' && value < PART_MOST; at++)
        value = 10 * value + (*at - '0');
    if (at == *text || *at != end)
        return -1;
    *text = end != '\0' ? at + 1 : at;
    return value;
}

bool render_part_from(const char *text, picture_part *part)
{
    picture_part read;
    read.x = take_number(&text, ',');
    read.y = read.x < 0 ? -1 : take_number(&text, ',');
    read.width = read.y < 0 ? -1 : take_number(&text, 'x');
    read.height = read.width <= 0 ? -1 : take_number(&text, '\0');
    if (read.height <= 0)
        return false;
    *part = read;
    return true;
}

bool render_file_place(const char *path, const render_settings *settings, FILE *messages,
                       placed_scene *placed)
{
    rt_scene file;
    double started = progress_clock();
    if (!rt_read(path, &settings->reading, &settings->reading_set, messages, &file))
        return false;
    double read = progress_clock();
    bool done = placement_taking(&file, messages, &placed->scene);
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

bool render_file_draw(const char *path, const placed_scene *placed, const render_settings *settings,
                      FILE *messages, rendering *drawn)
{
    int width, height;
    if (!size_of(path, &placed->scene, &settings->how, messages, &width, &height) ||
        !make_room(path, width, height, settings, messages, drawn))
        return false;
    render_options how = settings->how;
    how.statistics = settings->counted ? &drawn->statistics : NULL;
    how.records = drawn->records;
    drawn->times = render(&placed->scene, &how, &drawn->image);
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
