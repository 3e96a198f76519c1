/* SPDX-License-Identifier: MIT */
#include "world.h"

#include "test_shape.h"
#include "../../src/geometry/coordinate.h"

enum {
    PLACES = 5 * 5 * 5, /* origins -2..2 */
    STEPS = 26,         /* directions -1..1 but zero */
    RADII = 3           /* 0, 1, 2 */
};

static const struct {
    int axes;
    double axis[6][3];
    sure_vec3 place, place_without_axis;
} worlds[] = {
    [WORLD_EXACT] = {6,
                     {{1, 0, 0}, {0, 0, -1}, {0, 2, 0}, {1, 1, 0}, {0, -1, 1}, {2, 0, 2}},
                     {0, -1, 0},
                     {0, -1, 0}},
    [WORLD_LATTICE] = {5,
                       {{0, 0, 1}, {0, 2, 0}, {1, 0, -1}, {1, 1, 1}, {2, -1, 0}},
                       {0, 0, 0},
                       {0, 1, 0}},
};

static bool has_axis(sure_shape shape)
{
    return sure_shape_info_of(shape)->fields[1].kind != SURE_KIND_RADIUS;
}

static int axes_of(world of, sure_shape shape)
{
    return has_axis(shape) ? worlds[of].axes : 1;
}

static int radii_of(sure_shape shape)
{
    return shape_has(shape, SURE_KIND_RADIUS) ? RADII : 1;
}

uint64_t world_count(world of, sure_shape shape)
{
    return (uint64_t)(PLACES * STEPS * axes_of(of, shape) * radii_of(shape));
}

/* The next digit of a mixed-radix number. */
static int digit(uint64_t *index, int radix)
{
    int value = (int)(*index % (uint64_t)radix);
    *index /= (uint64_t)radix;
    return value;
}

static sure_vec3 step(uint64_t *index)
{
    int n = digit(index, STEPS);
    n += n >= 13; /* 13 is (0, 0, 0) */
    return (sure_vec3){n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
}

sure_case world_case(world of, sure_shape shape, uint64_t index)
{
    sure_vec3 place = has_axis(shape) ? worlds[of].place : worlds[of].place_without_axis;
    sure_case made = {.ray = {.direction = step(&index), .t_max = INFINITY}};
    for (int i = 0; i < 3; i++)
        *coordinate_of(&made.ray.origin, i) = digit(&index, 5) - 2;
    const double *a = worlds[of].axis[digit(&index, axes_of(of, shape))];
    double radius = digit(&index, radii_of(shape));
    sure_vec3 axis = {a[0], a[1], a[2]};
    made.object = object_made(shape, place, axis, vector_sum(1, place, 1, axis), radius);
    return made;
}
