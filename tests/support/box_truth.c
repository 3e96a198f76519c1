/* Exact fractions. */
#include "box_truth.h"

#include "objects.h"
#include "test_shape.h"

#include <gmp.h>
#include <math.h>

/* to - from */
static void set_way(mpq_t way, double from, double to)
{
    mpq_t start;
    mpq_init(start);
    mpq_set_d(start, from);
    mpq_set_d(way, to);
    mpq_sub(way, way, start);
    mpq_clear(start);
}

/* sum += x^2 */
static void add_square(mpq_t sum, const mpq_t x)
{
    mpq_t square;
    mpq_init(square);
    mpq_mul(square, x, x);
    mpq_add(sum, sum, square);
    mpq_clear(square);
}

/* Of A.A what coordinate i has no part in, and all of it. */
static void set_shares(mpq_t across, mpq_t whole, const hull_piece *piece, int i)
{
    mpq_t along;
    mpq_init(along);
    for (int k = 0; k < 3; k++) {
        set_way(along, coordinate(piece->from, k), coordinate(piece->to, k));
        add_square(whole, along);
        if (k != i)
            add_square(across, along);
    }
    mpq_clear(along);
}

/* A ball reaches r beyond its centre; a disc across A reaches r sqrt((A.A - A_i^2) / A.A): by
 * squares. */
static int piece_room(const hull_piece *piece, int axis, bool upwards, double face)
{
    mpq_t gap, left, right, across, whole;
    mpq_inits(gap, left, right, across, whole, NULL);
    set_way(gap, coordinate(piece->centre, axis), face);
    if (!upwards)
        mpq_neg(gap, gap);
    add_square(left, gap);
    mpq_set_d(whole, piece->radius);
    add_square(right, whole);
    if (piece->disc) {
        mpq_set_ui(whole, 0, 1);
        set_shares(across, whole, piece, axis);
        mpq_mul(left, left, whole);
        mpq_mul(right, right, across);
    }
    int sign = mpq_sgn(gap) < 0 ? -1 : mpq_cmp(left, right);
    mpq_clears(gap, left, right, across, whole, NULL);
    return (sign > 0) - (sign < 0);
}

int box_truth_room(const sure_object *object, int axis, bool upwards, double face)
{
    hull_piece pieces[2];
    int room = 1;
    if (!isfinite(face))
        return (face > 0) == upwards ? 1 : -1;
    for (int i = test_shape_of(object->shape)->hull(object, pieces); i > 0; i--) {
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

static void raise_least(range *r, const mpq_t t)
{
    if (mpq_cmp(t, r->least) > 0)
        mpq_set(r->least, t);
}

static void lower_most(range *r, const mpq_t t)
{
    if (r->unlimited || mpq_cmp(t, r->most) < 0)
        mpq_set(r->most, t);
    r->unlimited = false;
}

/* Where o + t d is at the face. Entry: d is not 0. */
static void set_crossing(mpq_t t, double o, double d, double face)
{
    mpq_t speed;
    mpq_init(speed);
    set_way(t, o, face);
    mpq_set_d(speed, d);
    mpq_div(t, t, speed);
    mpq_clear(speed);
}

/* False where the ray doesn't move along the axis and is outside. */
static bool limit(range *r, double low, double high, double o, double d)
{
    double near = d < 0 ? high : low, far = d < 0 ? low : high;
    mpq_t t;
    if (d == 0)
        return low <= o && o <= high;
    mpq_init(t);
    if (isfinite(near)) {
        set_crossing(t, o, d, near);
        raise_least(r, t);
    }
    if (isfinite(far)) {
        set_crossing(t, o, d, far);
        lower_most(r, t);
    }
    mpq_clear(t);
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
