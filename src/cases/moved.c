/* SPDX-License-Identifier: MIT */
#include "moved.h"

#include "shapes/case_shape.h"

#include <math.h>

/* A point's three coordinates are rounded after a few operations on the way, each to 2^-53 of
 * itself: it is off by less than this share of the largest number. */
#define ROUNDING 0x1p-50
#define ROUNDING_LEAST 0x1p-1000 /* in place of what underflows */

/* The axis has a length between these: its square does not leave the doubles. */
#define AXIS_LEAST 0x1p-400
#define AXIS_MOST 0x1p400

/* Roundings may tilt an axis by so much at most. */
#define TILT_MOST 0x1p-4

static double largest_of(const double *numbers, int count)
{
    double most = 0;
    for (int i = 0; i < count; i++)
        most = fmax(most, fabs(numbers[i]));
    return most;
}

bool moved_axis_of(const double *numbers, int count, const double vector[3], double most,
                   moved_axis *axis)
{
    double square = 0;
    int components = 0;
    for (int i = 0; i < 3; i++) {
        square += vector[i] * vector[i];
        components += vector[i] != 0;
    }
    double length = sqrt(square);
    if (!(length > AXIS_LEAST && length < AXIS_MOST))
        return false;
    for (int i = 0; i < 3; i++)
        axis->unit[i] = vector[i] / length;
    axis->height = length;
    axis->rounding = ROUNDING * (largest_of(numbers, count) + fabs(most)) + ROUNDING_LEAST;
    axis->aligned = components == 1;
    return true;
}

/* A tilt moves a face by itself times the distance from the axis. Second orders are within the
 * factor. */
double moved_allowance(const moved_axis *axis, double height, double radius)
{
    double tilt = axis->aligned ? 0 : 2 * axis->rounding / height;
    return height > 0 && tilt < TILT_MOST ? 2 * (axis->rounding + tilt * radius) : -1;
}

double moved_farther(double by, double allowance)
{
    return by < 0 ? by - allowance : by + allowance;
}

void moved_point(const double point[3], double by, const double unit[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = point[i] + by * unit[i];
}

movement movement_of_all(double by)
{
    movement all = {.along = 0};
    for (int i = 0; i < SURE_SHAPE_PARTS; i++)
        all.by[i] = by;
    return all;
}

movement movement_times(const movement *how, double by)
{
    movement all = {.along = by * how->along};
    for (int i = 0; i < SURE_SHAPE_PARTS; i++)
        all.by[i] = by * how->by[i];
    return all;
}

static bool is_possible(const sure_object *object)
{
    static const sure_ray any = {{0, 0, 0}, {1, 0, 0}, 0, 0};
    return sure_object_check(&any, object) == SURE_FIELD_NONE;
}

bool object_moved(const sure_object *object, const movement *how, sure_object *moved)
{
    const double *from = (const double *)(const void *)&object->as;
    *moved = *object;
    return case_shape_of(object->shape)->moved(from, how, (double *)(void *)&moved->as) &&
           is_possible(moved);
}

bool object_slab(const sure_object *flat, double by, sure_object *slab)
{
    bool (*make)(const double *, double, sure_object *) = case_shape_of(flat->shape)->slab;
    return make && make((const double *)(const void *)&flat->as, by, slab) && is_possible(slab);
}

bool wall_moved(const sure_object *object, const movement *how, sure_object *moved)
{
    const case_shape *row = case_shape_of(object->shape);
    return row->wall_moved && row->wall_moved(object, how, moved);
}

/* By the fields: a radius, half of what lies between two points of an axis, and of two corners. */
typedef struct {
    double radius, half_length, half[3];
} extents;

static extents extents_of(const sure_object *object)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    const double *numbers = (const double *)(const void *)&object->as;
    extents all = {0};
    for (int i = 0; i < info->field_count; i++) {
        const double *at = numbers + info->fields[i].at;
        sure_kind kind = info->fields[i].kind;
        if (kind == SURE_KIND_RADIUS)
            all.radius = at[0];
        if (kind == SURE_KIND_OTHER_POINT)
            all.half_length =
                hypot(hypot(at[0] - numbers[0], at[1] - numbers[1]), at[2] - numbers[2]) / 2;
        for (int j = 0; j < 3 && kind == SURE_KIND_HIGH; j++)
            all.half[j] = (at[j] - numbers[j]) / 2;
    }
    return all;
}

double object_size(const sure_object *object)
{
    const extents all = extents_of(object);
    double corner = fmax(fmax(all.half[0], all.half[1]), all.half[2]);
    return fmax(fmax(all.radius, all.half_length), corner);
}

/* A wall that ends in an apex is half of the height times the sine of its angle away. */
static double way_to(const sure_object *object, sure_part part)
{
    const extents all = extents_of(object);
    switch (part) {
    case SURE_PART_BASE:
    case SURE_PART_TOP: return all.half_length;
    case SURE_PART_X_MIN:
    case SURE_PART_X_MAX: return all.half[0];
    case SURE_PART_Y_MIN:
    case SURE_PART_Y_MAX: return all.half[1];
    case SURE_PART_Z_MIN:
    case SURE_PART_Z_MAX: return all.half[2];
    default: break;
    }
    if (!(case_shape_of(object->shape)->has & CASE_HAS_APEX))
        return all.radius;
    return all.half_length * (all.radius / hypot(all.radius, 2 * all.half_length));
}

movement movement_of_growth(const sure_object *object)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    movement all = {.along = 0};
    for (int i = 0; i < info->part_count; i++)
        all.by[i] = way_to(object, info->parts[i]);
    return all;
}
