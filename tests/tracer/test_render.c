/* SPDX-License-Identifier: MIT */
/* The render loop with a stand-in for the tracer: every pixel once, the right way up, whatever the
 * number of threads; and from linear colours to bytes. */
#include "../../src/tracer/render.h"
#include "../support/suite.h"

#include <limits.h>

#ifdef _OPENMP
#include <omp.h>
#endif

#define PIXELS_MOST 100000

static int asked[PIXELS_MOST]; /* how often each pixel was, rows from below */
static sure_vec3 (*color_of)(int column, int row);
static sure_tier tier_asked;
static int threads_used;

sure_vec3 sure_backward_pixel_told(const sure_scene *scene, sure_tier tier, int column, int row,
                                   sure_statistics *statistics)
{
    (void)statistics;
    if (column < 0 || column >= scene->width || row < 0 || row >= scene->height)
        abort(); /* Check may not be called from several threads */
    int pixel = row * scene->width + column;
#ifdef _OPENMP
#pragma omp atomic
#endif
    asked[pixel]++;
    if (pixel == 0) {
        tier_asked = tier;
#ifdef _OPENMP
        threads_used = omp_get_num_threads();
#endif
    }
    return color_of(column, row);
}

void sure_backward_pixels(const sure_scene *scene, sure_tier tier, size_t count, const int *column,
                          const int *row, sure_vec3 *color)
{
    for (size_t i = 0; i < count; i++)
        color[i] = sure_backward_pixel_told(scene, tier, column[i], row[i], NULL);
}

/* A thread has sixteen squares to draw, or is not asked to help. */
static int expected_threads(int asked_for, int64_t squares)
{
#ifdef _OPENMP
    const int most = (int)(1 + squares / 16);
    const int wanted = asked_for > 0 ? asked_for : omp_get_num_procs();
    return wanted < most ? wanted : most;
#else
    (void)asked_for;
    (void)squares;
    return 1;
#endif
}

static picture rendered(int width, int height, render_options how)
{
    const sure_scene scene = {.width = width, .height = height};
    picture image = {0};
    ck_assert(render_size(&scene, &how, &image.width, &image.height));
    image.rgb = malloc(3 * (size_t)image.width * (size_t)image.height);
    ck_assert_ptr_nonnull(image.rgb);
    memset(asked, 0, sizeof asked);
    render(&scene, &how, &image);
    return image;
}

static double level(int byte)
{
    return byte / 255.0;
}

static sure_vec3 coordinates(int column, int row)
{
    int far = 16 * (column / 256) + row / 256;
    return (sure_vec3){level(column % 256), level(row % 256), level(far)};
}

static const int sizes[][2] = {{1, 1},    {255, 1}, {256, 1},  {257, 1},
                               {1, 1000}, {37, 29}, {300, 280}};

LOOP_TEST(every_pixel_once_and_the_right_way_up, (int)(sizeof sizes / sizeof *sizes))
{
    const int width = sizes[_i][0], height = sizes[_i][1];
    color_of = coordinates;
    for (int threads = 0; threads <= 5; threads++) {
        tier_asked = SURE_TIER_FLOAT32;
        threads_used = 1;
        picture image =
            rendered(width, height, (render_options){SURE_TIER_TEXTBOOK, .threads = threads});
        ck_assert_int_eq(tier_asked, SURE_TIER_TEXTBOOK);
        ck_assert_int_eq(threads_used, expected_threads(threads, render_squares(width, height)));
        for (int i = 0; i < width * height; i++) {
            const int column = i % width, row = height - 1 - i / width;
            const uint8_t *rgb = image.rgb + 3 * i;
            if (asked[i] != 1 || rgb[0] != column % 256 || rgb[1] != row % 256 ||
                rgb[2] != 16 * (column / 256) + row / 256)
                ck_abort_msg("%d threads: pixel (%d, %d) asked %d times: %d, %d, %d", threads,
                             column, row, asked[i], rgb[0], rgb[1], rgb[2]);
        }
        free(image.rgb);
    }
}

/* Each sample once, of who counts, too; the mean of a colour that grows evenly is the middle's. */
LOOP_TEST(samples_have_the_middle_for_their_mean, 2)
{
    sure_statistics told = {0}, *counted = _i ? &told : NULL;
    color_of = coordinates;
    for (int samples = 1; samples <= 5; samples++) {
        picture image =
            rendered(23, 11, (render_options){.samples = samples, .statistics = counted});
        for (int i = 0; i < 23 * 11 * samples * samples; i++) {
            if (asked[i] != 1)
                ck_abort_msg("%d samples: %d asked %d times", samples, i, asked[i]);
        }
        for (int i = 0; i < 23 * 11 && samples % 2 == 1; i++) {
            ck_assert_int_eq(image.rgb[3 * i], samples * (i % 23) + samples / 2);
            ck_assert_int_eq(image.rgb[3 * i + 1], samples * (10 - i / 23) + samples / 2);
        }
        free(image.rgb);
    }
}

/* A part is cut out of the whole picture. */
LOOP_TEST(parts_are_cut_out, 2)
{
    sure_statistics told = {0}, *counted = _i ? &told : NULL;
    color_of = coordinates;
    const picture_part parts[] = {
        {0, 0, 300, 280}, {0, 0, 1, 1}, {299, 279, 1, 1}, {7, 30, 290, 3}};
    for (int k = 0; k < 4; k++) {
        const picture_part *part = &parts[k];
        picture image = rendered(300, 280, (render_options){.part = *part, .statistics = counted});
        ck_assert(image.width == part->width && image.height == part->height);
        for (int i = 0; i < part->width * part->height; i++) {
            int column = part->x + i % part->width, row = 279 - (part->y + i / part->width);
            if (image.rgb[3 * i] != column % 256 || image.rgb[3 * i + 1] != row % 256)
                ck_abort_msg("part %d: pixel %d is (%d, %d)", k, i, image.rgb[3 * i],
                             image.rgb[3 * i + 1]);
        }
        free(image.rgb);
    }
}

TEST(parts_outside_are_refused)
{
    const sure_scene scene = {.width = 300, .height = 280};
    const picture_part parts[] = {{-1, 0, 2, 2},  {0, -1, 2, 2},     {299, 0, 2, 2},
                                  {0, 279, 2, 2}, {300, 0, 1, 1},    {0, 0, 1, 0},
                                  {0, 0, -1, 1},  {5, 5, INT_MAX, 1}};
    int width = 7, height = 7;
    for (int k = 0; k < 8; k++)
        ck_assert(!render_size(&scene, &(render_options){.part = parts[k]}, &width, &height));
    const sure_scene upright = {.width = 280, .height = 300};
    const render_options fine = {.samples = INT_MAX / 299};
    ck_assert(!render_size(&scene, &fine, &width, &height));
    ck_assert(!render_size(&upright, &fine, &width, &height));
}

static double linear;

static sure_vec3 linear_in_every_part(int column, int row)
{
    (void)column;
    (void)row;
    return (sure_vec3){linear, linear, linear};
}

static void assert_becomes(double color, int byte)
{
    linear = color;
    picture image = rendered(1, 1, (render_options){.threads = 1});
    for (int part = 0; part < 3; part++)
        ck_assert_msg(image.rgb[part] == byte, "%a becomes %d, not %d", color, image.rgb[part],
                      byte);
    free(image.rgb);
}

/* Each level comes back; and beside the middle of two levels, by more than the middle and its
 * product with 255 round by. */
TEST(colors_go_to_the_nearest_level)
{
    color_of = linear_in_every_part;
    for (int byte = 0; byte <= 255; byte++)
        assert_becomes(level(byte), byte);
    for (int byte = 0; byte < 255; byte++) {
        double middle = (2 * byte + 1) / 510.0;
        assert_becomes(middle * (1 - 2 * DBL_EPSILON), byte);
        assert_becomes(middle * (1 + 2 * DBL_EPSILON), byte + 1);
    }
}

TEST(colors_out_of_range_are_clamped)
{
    color_of = linear_in_every_part;
    static const double none[] = {0.0,      -0.0, -DBL_TRUE_MIN, DBL_TRUE_MIN, -1,
                                  -DBL_MAX, NAN,  -INFINITY,     -NAN};
    static const double full[] = {1 - DBL_EPSILON, 1, 1 + DBL_EPSILON, 1.01, DBL_MAX, INFINITY};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_becomes(none[i], 0);
    for (size_t i = 0; i < sizeof full / sizeof *full; i++)
        assert_becomes(full[i], 255);
}

SUITE("render")
