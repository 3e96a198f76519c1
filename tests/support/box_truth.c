/* SPDX-License-Identifier: MIT */
/* Exact fractions. */
#include "box_truth.h"

#include "objects.h"
#include "test_shape.h"

/* A ball, or a disc across the way from `from` to `to`. */
typedef struct {
    sure_vec3 centre, from, to;
    double radius;
    bool disc;
} hull_piece;

/* The object is the smallest convex body around so many pieces, one at each of its points. */
static int hull_of(const sure_object *object, hull_piece pieces[2])
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    const true_frame f = true_frame_of(object);
    int count = 0;
    for (int i = 0; i < info->field_count; i++) {
        const double *x = (const double *)(const void *)&object->as + info->fields[i].at;
        bool point = !f.round || (f.tapers && count == 1);
        if (info->fields[i].kind != SURE_KIND_RADIUS && info->fields[i].kind != SURE_KIND_NORMAL)
            pieces[count++] = (hull_piece){{x[0], x[1], x[2]},
                                           f.back,
                                           f.to,
                                           point ? 0 : f.radius,
                                           !point && (f.flat || f.capped)};
    }
    return count;
}

/* to - from */
static void set_way(mpq_t way, double from, double to)
{
    TRUE_RATIONALS(start);
    mpq_set_d(start, from);
    mpq_set_d(way, to);
    mpq_sub(way, way, start);
}

/* A ball reaches r beyond its centre; a disc across A reaches r sqrt((A.A - A_i^2) / A.A): by
 * squares. */
static int piece_room(const hull_piece *piece, int axis, bool upwards, double face)
{
    TRUE_RATIONALS(gap, left, right);
    TRUE_RATIONALS(x, across, whole);
    set_way(gap, coordinate(piece->centre, axis), face);
    if (!upwards)
        mpq_neg(gap, gap);
    mpq_mul(left, gap, gap);
    mpq_set_d(x, piece->radius);
    mpq_mul(right, x, x);
    for (int k = 0; k < 3 && piece->disc; k++) {
        set_way(x, coordinate(piece->from, k), coordinate(piece->to, k));
        mpq_mul(x, x, x);
        mpq_add(whole, whole, x);
        if (k != axis)
            mpq_add(across, across, x);
    }
    if (piece->disc) {
        mpq_mul(left, left, whole);
        mpq_mul(right, right, across);
    }
    int sign = mpq_sgn(gap) < 0 ? -1 : mpq_cmp(left, right);
    return (sign > 0) - (sign < 0);
}

int box_truth_room(const sure_object *object, int axis, bool upwards, double face)
{
    hull_piece pieces[2];
    int room = 1;
    if (!isfinite(face))
        return (face > 0) == upwards ? 1 : -1;
    for (int i = hull_of(object, pieces); i > 0; i--) {
        int of_piece = piece_room(&pieces[i - 1], axis, upwards, face);
        room = of_piece < room ? of_piece : room;
    }
    return room;
}

/* t is at least and at most. */
typedef struct {
    mpq_t least, most;
    bool unlimited; /* above */
} range;

/* False where the ray doesn't move along the axis and is outside. */
static bool limit(range *r, double low, double high, double o, double d)
{
    if (d == 0)
        return low <= o && o <= high;
    TRUE_RATIONALS(t, speed);
    mpq_set_d(speed, d);
    for (int far = 0; far < 2; far++) {
        double face = (d < 0) == far ? low : high;
        if (!isfinite(face))
            continue;
        set_way(t, o, face);
        mpq_div(t, t, speed);
        if (!far && mpq_cmp(t, r->least) > 0)
            mpq_set(r->least, t);
        if (far && (r->unlimited || mpq_cmp(t, r->most) < 0)) {
            mpq_set(r->most, t);
            r->unlimited = false;
        }
    }
    return true;
}

bool box_truth_meets(const sure_bounds *box, const sure_ray *ray)
{
    range r = {.unlimited = !isfinite(ray->t_max)};
    bool possible = true;
    mpq_inits(r.least, r.most, NULL);
    mpq_set_d(r.least, ray->t_min);
    if (!r.unlimited)
        mpq_set_d(r.most, ray->t_max);
    for (int i = 0; i < 3; i++)
        possible = possible && limit(&r, box->low[i], box->high[i], coordinate(ray->origin, i),
                                     coordinate(ray->direction, i));
    possible = possible && (r.unlimited || mpq_cmp(r.least, r.most) <= 0);
    mpq_clears(r.least, r.most, NULL);
    return possible;
}
