/* SPDX-License-Identifier: MIT */
#include "../../numbers/places.h"
#include "../../geometry/coordinate.h"
#include "../shapes/case_shape.h"

#include <math.h>

double largest(sure_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

static sure_vec3 turned(const pose *where, sure_vec3 v)
{
    const sure_vec3 *row = where->turn.row;
    return (sure_vec3){dot(row[0], v), dot(row[1], v), dot(row[2], v)};
}

static sure_vec3 placed(const pose *where, double size, sure_vec3 p)
{
    return scaled(size, add(where->move, turned(where, p)));
}

static void place_object(const layout *lay, const pose *where, double size, sure_case *c)
{
    const sure_shape_info *info = sure_shape_info_of(lay->shape);
    sure_vec3 points[2], *point = points;
    case_shape_of(lay->shape)->points(lay, points);
    for (int i = 0; i < info->field_count; i++) {
        const int at = AT_OBJECT + info->fields[i].at;
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            *case_number(c, at) = times_two_to(where->stretch * lay->r, where->scale);
        else if (info->fields[i].kind == SURE_KIND_NORMAL)
            *case_vector(c, at) =
                scaled(times_two_to(1, where->n_scale), turned(where, (sure_vec3){0, 0, 1}));
        else
            *case_vector(c, at) = placed(where, size, *point++);
    }
}

sure_case place(const layout *lay, const pose *where)
{
    sure_vec3 start = sum_of(lay->p, -lay->t, lay->d);
    int t_scale = where->scale - where->d_scale;
    double size = times_two_to(1, where->scale);
    sure_case c = {.object.shape = lay->shape};
    c.ray = (sure_ray){placed(where, size, start),
                       scaled(times_two_to(1, where->d_scale), turned(where, lay->d)),
                       times_two_to(lay->t_min, t_scale), times_two_to(lay->t_max, t_scale)};
    place_object(lay, where, size, &c);
    return c;
}

static double square_of(const double q[4])
{
    return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
}

pose pose_turned(sure_shape shape, const double q[4])
{
    return (pose){.turn = case_shape_of(shape)->turn(q), .stretch = square_of(q)};
}

double random_whole_size(rng *g)
{
    return rng_chance(g, 1, 4) ? 1 : rng_whole(g, SIZE_BITS);
}

double random_t(rng *g)
{
    double t = rng_whole(g, TIME_BITS);
    return rng_chance(g, 1, 10) ? -t : t;
}

static pose pose_as_in_scenes(sure_shape shape, rng *g)
{
    double q[4] = {1, 0, 0, 0};
    if (rng_chance(g, 1, 2)) {
        q[0] = rng_integer(g, 0, 3);
        int axis = rng_integer(g, 1, 3);
        q[axis] = rng_integer(g, 1, 3);
    }
    pose where = pose_turned(shape, q);
    where.move = rng_offsets(g, 4);
    where.scale = rng_chance(g, 1, 2) ? 0 : rng_integer(g, -4, 1);
    return where;
}

void scale_anyhow(pose *where, int most, rng *g)
{
    where->scale = rng_integer(g, -most, most);
    where->d_scale = rng_integer(g, -most, most);
    where->n_scale = rng_integer(g, -most, most);
}

pose pose_exact(sure_shape shape, rng *g)
{
    if (rng_chance(g, 1, 4))
        return pose_as_in_scenes(shape, g);
    double q[4];
    int bits = rng_integer(g, 4, 6);
    do {
        for (int i = 0; i < 4; i++)
            q[i] = rng_offset(g, bits);
    } while (square_of(q) == 0);
    pose where = pose_turned(shape, q);
    if (!rng_chance(g, 1, 4))
        where.move = rng_offsets(g, 46);
    scale_anyhow(&where, 60, g);
    return where;
}

pose pose_exact_far(sure_shape shape, rng *g)
{
    double q[4];
    do {
        for (int i = 0; i < 4; i++)
            q[i] = rng_integer(g, -3, 3);
    } while (square_of(q) == 0);
    pose where = pose_turned(shape, q);
    where.move = rng_offsets(g, 36);
    scale_anyhow(&where, 60, g);
    return where;
}

static double random_move(rng *g, int bits)
{
    double sign = rng_sign(g);
    return sign * rng_magnitude(g, -10, bits);
}

pose pose_general(sure_shape shape, rng *g, int move_bits)
{
    double q[4];
    do {
        for (int i = 0; i < 4; i++)
            q[i] = rng_between(g, -1, 1);
    } while (square_of(q) < 0x1p-4);
    pose where = pose_turned(shape, q);
    for (int i = 0; i < 3; i++)
        where.turn.row[i] = scaled(1 / where.stretch, where.turn.row[i]);
    where.stretch = 1;
    bool moves = !rng_chance(g, 1, 4);
    for (int i = 0; i < 3 && moves; i++)
        *coordinate_of(&where.move, i) = random_move(g, move_bits);
    return where;
}

sure_case place_exactly(const layout *lay, rng *g)
{
    pose where = pose_exact(lay->shape, g);
    return place(lay, &where);
}

sure_case place_generally(const layout *lay, rng *g, int move_bits)
{
    pose where = pose_general(lay->shape, g, move_bits);
    return place(lay, &where);
}

sure_case place_at_t(layout *lay, pose (*how)(sure_shape, rng *), int one_in, rng *g)
{
    range_at_t(lay, g);
    pose where = how(lay->shape, g);
    sure_case c = place(lay, &where);
    if (rng_chance(g, 1, one_in))
        nudge(&c, g);
    return c;
}

layout whole_layout(sure_shape shape, rng *g)
{
    layout lay = {.shape = shape, .r = random_whole_size(g)};
    if (case_shape_has(shape, CASE_HAS_HEIGHT))
        lay.h = random_whole_size(g);
    return lay;
}

layout random_body(sure_shape shape, rng *g, int low, int high)
{
    layout lay = {.shape = shape, .r = rng_magnitude(g, low, high)};
    if (case_shape_has(shape, CASE_HAS_HEIGHT))
        lay.h = rng_magnitude(g, low, high);
    return lay;
}

bool is_coordinate(sure_shape shape, int number)
{
    const sure_shape_field *field = field_at(shape, number);
    return field && field->kind != SURE_KIND_NORMAL && field->kind != SURE_KIND_RADIUS;
}

void range_usual(layout *lay, rng *g, double about)
{
    lay->t_min = 0;
    lay->t_max = HUGE_VAL;
    if (rng_chance(g, 3, 4))
        return;
    if (rng_chance(g, 1, 2))
        lay->t_min = about * rng_between(g, 0, 1);
    if (lay->t_min == 0 || rng_chance(g, 1, 2))
        lay->t_max = lay->t_min + about * rng_between(g, 0, 4);
}

void range_at_t(layout *lay, rng *g)
{
    const double t = lay->t, inf = HUGE_VAL;
    const double below = t > 0 ? step_ulps(t, -1) : 0, above = step_ulps(t, 1);
    const double ranges[12][2] = {{0, t},     {t, inf},   {t, t},       {t / 2, t * 2},
                                  {0, below}, {0, below}, {above, inf}, {above, inf},
                                  {0, inf},   {0, inf},   {0, inf},     {0, inf}};
    const double *range = ranges[t < 0 ? 11 : rng_integer(g, 0, 11)];
    lay->t_min = range[0];
    lay->t_max = range[1];
}

void step_start(sure_case *c, rng *g)
{
    double *moved = case_number(c, AT_O + rng_integer(g, 0, 2));
    *moved = step_ulps(*moved, (int)rng_sign(g));
}

void nudge(sure_case *c, rng *g)
{
    int count = case_numbers(c->object.shape);
    double *moved;
    do
        moved = case_number(c, rng_integer(g, 0, count - 1));
    while (!isfinite(*moved));
    int steps = rng_integer(g, 1, 4);
    *moved = step_ulps(*moved, rng_chance(g, 1, 2) ? steps : -steps);
    /* What may not be negative moves up from 0 instead. */
    c->ray.t_min = fabs(c->ray.t_min);
    object_mend(c->object.shape, case_number(c, AT_OBJECT));
    if (c->ray.t_max < c->ray.t_min)
        c->ray.t_max = c->ray.t_min;
}
