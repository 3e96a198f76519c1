#include "world.h"

#include <math.h>

/* Squared lengths 1, 2, 4 and 8. */
static const double axes[][3] = {{1, 0, 0}, {0, 0, -1}, {0, 2, 0},
                                 {1, 1, 0}, {0, -1, 1}, {2, 0, 2}};
static const double ranges[][2] = {{0, INFINITY}, {1, 2}, {0, 1}};

enum {
    AXES = sizeof axes / sizeof *axes,
    RANGES = sizeof ranges / sizeof *ranges,
    PLACES = 5 * 5 * 5, /* origins -2..2 */
    STEPS = 26,         /* directions -1..1 but zero */
    RADII = 3           /* 0, 1, 2 */
};

uint64_t world_count(sure_shape shape)
{
    uint64_t axis_count = shape == SURE_SHAPE_SPHERE ? 1 : AXES;
    uint64_t radius_count = shape == SURE_SHAPE_PLANE ? 1 : RADII;
    return PLACES * STEPS * RANGES * axis_count * radius_count;
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

sure_case world_case(sure_shape shape, uint64_t index)
{
    const double *range = ranges[digit(&index, RANGES)];
    sure_case made = {.object.shape = shape};
    made.ray.direction = step(&index);
    made.ray.origin.x = digit(&index, 5) - 2;
    made.ray.origin.y = digit(&index, 5) - 2;
    made.ray.origin.z = digit(&index, 5) - 2;
    made.ray.t_min = range[0];
    made.ray.t_max = range[1];
    const double *a = axes[shape == SURE_SHAPE_SPHERE ? 0 : digit(&index, AXES)];
    double radius = shape == SURE_SHAPE_PLANE ? 0 : digit(&index, RADII);
    sure_vec3 axis = {a[0], a[1], a[2]}, low = {0, -1, 0};
    sure_vec3 high = {low.x + axis.x, low.y + axis.y, low.z + axis.z};
    switch (shape) {
    case SURE_SHAPE_PLANE: made.object.as.plane = (sure_plane){low, axis}; break;
    case SURE_SHAPE_DISC: made.object.as.disc = (sure_disc){low, axis, radius}; break;
    case SURE_SHAPE_SPHERE: made.object.as.sphere = (sure_sphere){low, radius}; break;
    case SURE_SHAPE_CYLINDER: made.object.as.cylinder = (sure_cylinder){low, high, radius}; break;
    case SURE_SHAPE_CONE: made.object.as.cone = (sure_cone){low, high, radius}; break;
    }
    return made;
}
