/* SPDX-License-Identifier: MIT */
#include "render.h"

#include "../numbers/sums.h"
#include "../support/openmp.h"
#include "../support/progress.h"

#include <limits.h>
#include <stdlib.h>
#include <surehit/backward.h>

/* The side of the square of pixels that a thread takes at a time: their rays meet much the same
 * objects, and to draw them takes long beside taking them. */
#define SIDE 16

#define PART_MOST 1000000000 /* an int */

/* A frame while it is drawn. */
typedef struct {
    sure_scene fine; /* the scene in pixels as fine as the samples */
    const render_options *options;
    int samples;
    picture_part part;
} frame;

static sure_vec3 sample(const frame *f, int64_t column, int64_t row, sure_statistics *statistics)
{
    int from_below = (int)(f->fine.height - 1 - row);
    return sure_backward_pixel_told(&f->fine, f->options->tier, (int)column, from_below,
                                    statistics);
}

/* The mean of a square of samples. Each is added to its mirror image first, so that a mirrored
 * scene gives the mirrored picture. */
static sure_vec3 mean(const frame *f, int64_t column, int64_t row, sure_statistics *statistics)
{
    const int n = f->samples;
    sure_vec3 all = {0, 0, 0};
    if (n == 1)
        return sample(f, column, row, statistics);
    for (int j = 0; j < n; j++) {
        for (int i = 0; i <= n - 1 - i; i++) {
            sure_vec3 left = sample(f, column * n + i, row * n + j, statistics);
            sure_vec3 right = {0, 0, 0};
            if (i < n - 1 - i)
                right = sample(f, column * n + (n - 1 - i), row * n + j, statistics);
            all = add(all, add(left, right));
        }
    }
    double per = (double)n * n;
    return (sure_vec3){all.x / per, all.y / per, all.z / per};
}

static pixel_record record_of(const sure_statistics *told, double seconds)
{
    pixel_record record = {.microseconds = (float)(1e6 * seconds), .seen = (uint8_t)told->seen};
    if (told->seen == SURE_HIT) {
        record.t = told->nearest.hit.t;
        record.t_error = told->nearest.hit.t_error;
        record.object = (uint32_t)told->nearest.object;
        record.part = (uint8_t)told->nearest.hit.part;
        record.stage = (uint8_t)told->stage;
    }
    return record;
}

static void draw_pixel(const frame *f, int row, int column, picture *image,
                       sure_statistics *statistics)
{
    const bool recorded = f->options->records != NULL;
    const bool told = f->options->statistics || (recorded && !f->options->clocked);
    const int64_t i = (int64_t)row * f->part.width + column;
    double started = recorded ? progress_clock() : 0;
    sure_vec3 color = mean(f, f->part.x + column, f->part.y + row, told ? statistics : NULL);
    if (recorded)
        f->options->records[i] = record_of(statistics, progress_clock() - started);
    image->rgb[3 * i] = picture_level(color.x);
    image->rgb[3 * i + 1] = picture_level(color.y);
    image->rgb[3 * i + 2] = picture_level(color.z);
}

int64_t render_squares(int width, int height)
{
    return ((width - 1) / SIDE + INT64_C(1)) * ((height - 1) / SIDE + 1);
}

picture_part render_square(int width, int height, int64_t number)
{
    const int64_t columns = (width - 1) / SIDE + 1;
    const int x = (int)(number % columns) * SIDE, y = (int)(number / columns) * SIDE;
    return (picture_part){x, y, width - x < SIDE ? width - x : SIDE,
                          height - y < SIDE ? height - y : SIDE};
}

static void draw_square(const frame *f, int64_t number, picture *image, progress *bar)
{
    const render_options *options = f->options;
    const picture_part square = render_square(image->width, image->height, number);
    sure_statistics statistics = {0};
    if (!options->records && !options->statistics && f->samples == 1) {
        int x[SIDE * SIDE], y[SIDE * SIDE];
        sure_vec3 color[SIDE * SIDE];
        size_t n = 0;
        for (int r = 0; r < square.height; r += 2)
            for (int c = 0; c < square.width; c += 4)
                for (int j = r; j < r + 2 && j < square.height; j++)
                    for (int i = c; i < c + 4 && i < square.width; i++) {
                        x[n] = f->part.x + square.x + i;
                        y[n++] = f->fine.height - 1 - (f->part.y + square.y + j);
                    }
        sure_backward_pixels(&f->fine, options->tier, n, x, y, color);
        for (size_t k = 0; k < n; k++) {
            int64_t at = 3 * ((int64_t)(f->fine.height - 1 - y[k] - f->part.y) * f->part.width + x[k] - f->part.x);
            image->rgb[at] = picture_level(color[k].x);
            image->rgb[at + 1] = picture_level(color[k].y);
            image->rgb[at + 2] = picture_level(color[k].z);
        }
    } else
    for (int row = square.y; row < square.y + square.height; row++) {
        for (int column = square.x; column < square.x + square.width; column++)
            draw_pixel(f, row, column, image, &statistics);
    }
    if (!options->statistics && !options->progress)
        return;
    OPENMP(omp critical)
    {
        if (options->statistics)
            sure_statistics_add(options->statistics, &statistics);
        if (options->progress)
            progress_step(bar, 1);
    }
}

/* Between these nobody draws, and what is drawn can be kept. */
static int64_t batch_of(const render_options *options, int64_t squares)
{
    return options->goes_on ? 16 * (int64_t)render_threads(options) : squares;
}

static void draw(const frame *f, picture *image)
{
    const render_options *options = f->options;
    const int64_t first = options->first_square;
    const int64_t end =
        options->end_square > 0 ? options->end_square : render_squares(image->width, image->height);
    progress bar = progress_start(stderr, end - first);
    bool more = true;
    for (int64_t begin = first, next; more && begin < end; begin = next) {
        int64_t batch = batch_of(options, end - first);
        next = end - begin > batch ? begin + batch : end;
        OPENMP(omp parallel for schedule(dynamic) num_threads(openmp_threads(options->threads)))
        for (int64_t i = begin; i < next; i++)
            draw_square(f, i, image, &bar);
        more = !options->goes_on || options->goes_on((uint64_t)next);
    }
    progress_finish(&bar);
}

int render_threads(const render_options *how)
{
    return openmp_threads(how->threads);
}

bool render_part_from(const char *text, picture_part *part)
{
    static const char behind[4] = {',', ',', 'x', '\0'};
    int read[4];
    for (int i = 0; i < 4; i++) {
        char *end;
        unsigned long number = *text >= '0' && *text <= '9' ? strtoul(text, &end, 10) : PART_MOST;
        if (number >= PART_MOST || *end != behind[i])
            return false;
        read[i] = (int)number;
        text = end + 1;
    }
    if (read[2] > 0 && read[3] > 0)
        *part = (picture_part){read[0], read[1], read[2], read[3]};
    return read[2] > 0 && read[3] > 0;
}

bool render_part_fits(const picture_part *part, int width, int height)
{
    return part->x >= 0 && part->width > 0 && part->width <= width - part->x && part->y >= 0 &&
           part->height > 0 && part->height <= height - part->y;
}

bool render_size(const sure_scene *scene, const render_options *options, int *width, int *height)
{
    const picture_part *part = &options->part;
    const int samples = options->samples > 0 ? options->samples : 1;
    if (scene->width > INT_MAX / samples || scene->height > INT_MAX / samples)
        return false;
    *width = part->width != 0 ? part->width : scene->width;
    *height = part->width != 0 ? part->height : scene->height;
    return render_part_fits(&(picture_part){part->x, part->y, *width, *height}, scene->width,
                            scene->height);
}

void render(const sure_scene *scene, const render_options *options, picture *image)
{
    frame f = {.fine = *scene,
               .options = options,
               .samples = options->samples > 0 ? options->samples : 1,
               .part = {options->part.x, options->part.y, image->width, image->height}};
    f.fine.width *= f.samples;
    f.fine.height *= f.samples;
    draw(&f, image);
}
