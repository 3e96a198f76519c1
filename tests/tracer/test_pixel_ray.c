#include "suite.h"

#include <math.h>

typedef sure_ray pixel_ray(const sure_camera *, int, int, int, int);
static pixel_ray *const rays[PLAIN_TIERS] = {sure_pixel_ray_float32, sure_pixel_ray_textbook,
                                             sure_pixel_ray_stable};

static const sure_camera camera = {.focal_length = 2, .viewport_width = 16, .viewport_height = 8};

LOOP_TEST(test_known, PLAIN_TIERS)
{
    sure_ray lowest_left = rays[_i](&camera, 8, 4, 0, 0);
    ck_vector_same(lowest_left.direction, (sure_vec3){-7, -3, -2});
    ck_vector_same(rays[_i](&camera, 8, 4, 7, 3).direction, (sure_vec3){7, 3, -2});
    ck_vector_same(rays[_i](&camera, 8, 4, 4, 1).direction, (sure_vec3){1, -1, -2});
    ck_vector_same(lowest_left.origin, camera.position);
    ck_double_same(lowest_left.t_min, 0);
    ck_double_same(lowest_left.t_max, INFINITY);
}

/* The viewport goes with the eye. */
LOOP_TEST(test_elsewhere, PLAIN_TIERS)
{
    sure_camera moved = camera;
    moved.position = (sure_vec3){3, -5, 7};
    sure_ray ray = rays[_i](&moved, 8, 4, 0, 0);
    ck_vector_same(ray.origin, moved.position);
    ck_vector_same(ray.direction, (sure_vec3){-7, -3, -2});
}

/* One column or row: the printed i / (n - 1) is 0 / 0 there. */
LOOP_TEST(test_one_pixel, PLAIN_TIERS)
{
    ck_vector_same(rays[_i](&camera, 1, 1, 0, 0).direction, (sure_vec3){0, 0, -2});
}

/* Pixels are as far apart across as upwards when the viewport has the picture's shape. */
LOOP_TEST(test_square_pixels, PLAIN_TIERS)
{
    sure_vec3 a = rays[_i](&camera, 32, 16, 10, 5).direction;
    sure_vec3 b = rays[_i](&camera, 32, 16, 11, 6).direction;
    ck_double_same(b.x - a.x, b.y - a.y);
}

LOOP_TEST(test_huge_picture, PLAIN_TIERS)
{
    sure_vec3 v = rays[_i](&camera, 2147483647, 1, 2147483646, 0).direction;
    ck_assert(v.x > 7.99 && v.x <= 8);
}

LOOP_TEST(test_law_1, PLAIN_TIERS)
{
    const int width = 1279, height = 720;
    for (int i = 0; i < width; i += 13) {
        for (int j = 0; j < height; j += 7) {
            sure_vec3 v = rays[_i](&camera, width, height, i, j).direction;
            ck_vector_same(rays[_i](&camera, width, height, width - 1 - i, j).direction,
                           (sure_vec3){-v.x, v.y, v.z});
            ck_vector_same(rays[_i](&camera, width, height, i, height - 1 - j).direction,
                           (sure_vec3){v.x, -v.y, v.z});
        }
    }
}

LOOP_TEST(test_law_2, PLAIN_TIERS)
{
    ck_vector_same(rays[_i](&camera, 1279, 719, 639, 359).direction, (sure_vec3){0, 0, -2});
}

SUITE("pixel_ray")
