/* SPDX-License-Identifier: MIT */
#include "render.h"

#include "../numbers/sums.h"
#include "../support/openmp.h"
#include "../support/progress.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <surehit/backward.h>

/* The side of the square of pixels that a thread takes at a time: their rays meet much the same
 * objects, and to draw them takes long beside taking them. */
#define SIDE 16

/* The pixels of it whose rays go together. */
#define BLOCK_WIDTH 4
#define BLOCK_HEIGHT 2

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

static void put_pixel(const frame *f, int row, int column, sure_vec3 color, picture *image)
{
    uint8_t *rgb = image->rgb + 3 * ((int64_t)row * f->part.width + column);
    rgb[0] = picture_level(color.x);
    rgb[1] = picture_level(color.y);
    rgb[2] = picture_level(color.z);
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
    put_pixel(f, row, column, color, image);
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

/* A square's pixels, by small blocks, whose rays go together. */
typedef struct {
    size_t count;
    int column[SIDE * SIDE], row[SIDE * SIDE]; /* of the part */
} plot;

static void plot_block(plot *pixels, const picture_part *square, int x, int y)
{
    for (int row = y; row < y + BLOCK_HEIGHT && row < square->height; row++) {
        for (int column = x; column < x + BLOCK_WIDTH && column < square->width; column++) {
            pixels->column[pixels->count] = square->x + column;
            pixels->row[pixels->count++] = square->y + row;
        }
    }
}

static void plot_square(plot *pixels, const picture_part *square)
{
    pixels->count = 0;
    for (int y = 0; y < square->height; y += BLOCK_HEIGHT) {
        for (int x = 0; x < square->width; x += BLOCK_WIDTH)
            plot_block(pixels, square, x, y);
    }
}

/* sample (i, j) of each pixel. */
static void samples_of(const frame *f, const plot *pixels, int i, int j, sure_vec3 *color)
{
    int column[SIDE * SIDE], row[SIDE * SIDE];
    for (size_t k = 0; k < pixels->count; k++) {
        column[k] = (f->part.x + pixels->column[k]) * f->samples + i;
        row[k] = f->fine.height - 1 - ((f->part.y + pixels->row[k]) * f->samples + j);
    }
    sure_backward_pixels(&f->fine, f->options->tier, pixels->count, column, row, color);
}

/* mean, of each pixel. */
static void means(const frame *f, const plot *pixels, sure_vec3 *all)
{
    const int n = f->samples;
    sure_vec3 left[SIDE * SIDE], right[SIDE * SIDE];
    double per = (double)n * n;
    if (n == 1) {
        samples_of(f, pixels, 0, 0, all);
        return;
    }
    memset(all, 0, pixels->count * sizeof *all);
    for (int j = 0; j < n; j++) {
        for (int i = 0; i <= n - 1 - i; i++) {
            samples_of(f, pixels, i, j, left);
            memset(right, 0, sizeof right);
            if (i < n - 1 - i)
                samples_of(f, pixels, n - 1 - i, j, right);
            for (size_t k = 0; k < pixels->count; k++)
                all[k] = add(all[k], add(left[k], right[k]));
        }
    }
    for (size_t k = 0; k < pixels->count; k++)
        all[k] = (sure_vec3){all[k].x / per, all[k].y / per, all[k].z / per};
}

/* Where nobody asks about single pixels. */
static void draw_together(const frame *f, const picture_part *square, picture *image)
{
    plot pixels;
    sure_vec3 color[SIDE * SIDE];
    plot_square(&pixels, square);
    means(f, &pixels, color);
    for (size_t k = 0; k < pixels.count; k++)
        put_pixel(f, pixels.row[k], pixels.column[k], color[k], image);
}

static void draw_one_by_one(const frame *f, const picture_part *square, picture *image,
                            sure_statistics *statistics)
{
    for (int row = square->y; row < square->y + square->height; row++) {
        for (int column = square->x; column < square->x + square->width; column++)
            draw_pixel(f, row, column, image, statistics);
    }
}

static void draw_square(const frame *f, int64_t number, picture *image, progress *bar)
{
    const render_options *options = f->options;
    const picture_part square = render_square(image->width, image->height, number);
    sure_statistics statistics = {0};
    if (options->records || options->statistics)
        draw_one_by_one(f, &square, image, &statistics);
    else
        draw_together(f, &square, image);
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

/* Threads that wait take more of their processors than a few squares do. */
static int threads_for(const render_options *options, int64_t squares)
{
    const int64_t most = 1 + squares / 16, threads = render_threads(options);
    return (int)(threads < most ? threads : most);
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
        const int threads = threads_for(options, next - begin);
        (void)threads; /* where there is no OpenMP */
        OPENMP(omp parallel for schedule(dynamic) num_threads(threads))
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
