/* SPDX-License-Identifier: MIT */
#include "capped_stages.h"

#include "../../numbers/mod128_value.h"

/* How much A.d, A.m and A.m - A.A may be where they may be zero, as shares of |A| |d| and |A|
 * sqrt(size): more than their rounding errors, 4, 5 and 10 2^-52 (docs/proofs/axial_filter.md). */
#define SPEED_SHARE 0x1p-49
#define PLACE_SHARE 0x1p-47

/* A.d, and A.m and A.m - A.A, which are counted in one unit. */
typedef struct {
    mod128 speed, from, to;
} axis_line;

static axis_line axis_line_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to)
{
    vector_mod128 axis = vector_between_mod128(NULL, from, to);
    vector_mod128 m = vector_between_mod128(NULL, from, ray->origin);
    mod128 along = vector_dot_mod128(NULL, axis, m), height = vector_square_mod128(NULL, axis);
    return (axis_line){vector_dot_mod128(NULL, axis, vector_of_mod128(NULL, ray->direction)), along,
                       mod128_sub(NULL, along, height)};
}

static axial_plane plane_of(const axis_line *line, const axial_terms *of)
{
    double f = vector_dot_f64(NULL, of->axis, of->m);
    double most = PLACE_SHARE * sqrt(of->height * of->size);
    if (mod128_is_zero(line->from) && fabs(f) <= most && mod128_is_whole(2 * most, line->from))
        return AXIAL_PLANE_FROM;
    return mod128_is_zero(line->to) && fabs(f - of->height) <= most &&
                   mod128_is_whole(2 * most, line->to)
               ? AXIAL_PLANE_TO
               : AXIAL_PLANE_UNKNOWN;
}

/* The end that may be at 0, or NULL. Both can't be: they are farther apart than uncertain. */
static filter_end *end_near_start(filter_interval *found)
{
    if (fabs(found->enter.t) <= found->enter.error)
        return &found->enter;
    return fabs(found->leave.t) <= found->leave.error ? &found->leave : NULL;
}

bool axial_starts(const sure_ray *ray, sure_vec3 from, sure_vec3 to, const axial_terms *of,
                  end_kind of_from, end_kind of_to, filter_interval *found)
{
    filter_end *end = bits_of(ray->t_min) == 0 ? end_near_start(found) : NULL;
    if (end == NULL || (end->end.at != of_from && end->end.at != of_to))
        return false;
    axis_line line = axis_line_of(ray, from, to);
    if (plane_of(&line, of) != (end->end.at == of_from ? AXIAL_PLANE_FROM : AXIAL_PLANE_TO))
        return false;
    end->t = end->error = 0;
    return true;
}

/* The sign of a height; false where it can't be told. */
static bool height_sign(double nearly, double error, mod128 whole, int *sign)
{
    *sign = nearly > 0 ? 1 : -1;
    return fabs(nearly) > error || mod128_sign(2 * error, whole, sign);
}

filter_verdict capped_touch(const capped_touching *of, const sure_ray *ray, const void *shape,
                            const double error[2], filter_interval *found)
{
    two_terms_f64 nearly = of->nearly(ray, shape);
    two_terms_mod128 whole = {0};
    int first, second;
    if (!(fabs(nearly.more) > error[0] && fabs(nearly.less) > error[1]))
        whole = of->whole(ray, shape);
    if (!height_sign(nearly.more, error[0], whole.more, &first) ||
        !height_sign(nearly.less, error[1], whole.less, &second))
        return FILTER_UNCERTAIN;
    if (first < 0 || second < 0)
        return filter_miss_if(true, ray);
    sure_part part = first == 0 ? of->parts[0] : second == 0 ? of->parts[1] : SURE_PART_WALL;
    found->enter.end.part = found->leave.end.part = part;
    return FILTER_INTERVAL;
}

axial_plane axial_plane_of(const sure_ray *ray, sure_vec3 from, sure_vec3 to, const axial_terms *of)
{
    double e = vector_dot_f64(NULL, of->axis, of->d), f = vector_dot_f64(NULL, of->axis, of->m);
    double away = fmin(fabs(f), fabs(f - of->height));
    if (e * e > SPEED_SHARE * SPEED_SHARE * (of->height * of->d_d) ||
        away * away > PLACE_SHARE * PLACE_SHARE * (of->height * of->size))
        return AXIAL_PLANE_UNKNOWN;
    axis_line line = axis_line_of(ray, from, to);
    double speed_most = SPEED_SHARE * sqrt(of->height * of->d_d);
    if (!mod128_is_zero(line.speed) || !mod128_is_whole(2 * speed_most, line.speed))
        return AXIAL_PLANE_UNKNOWN;
    return plane_of(&line, of);
}
