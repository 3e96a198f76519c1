/* Every finite double is a whole number of 2^-1074: of these all numbers here are made. */
#include "box_truth.h"

#include "../../src/numbers/bits.h"

#include <gmp.h>

static void set(mpz_t whole, double x)
{
    magnitude_parts parts = parts_of(x);
    mpz_set_ui(whole, 1);
    mpz_mul_2exp(whole, whole, (mp_bitcnt_t)(parts.exponent + 1074));
    mpz_mul_ui(whole, whole, parts.mantissa);
    if (is_negative_bits(x))
        mpz_neg(whole, whole);
}

/* to - from */
static void set_way(mpz_t way, double from, double to)
{
    mpz_t start;
    mpz_init(start);
    set(start, from);
    set(way, to);
    mpz_sub(way, way, start);
    mpz_clear(start);
}

static void set_between(mpz_t between[3], sure_vec3 from, sure_vec3 to)
{
    set_way(between[0], from.x, to.x);
    set_way(between[1], from.y, to.y);
    set_way(between[2], from.z, to.z);
}

/* a^2 + b^2 */
static void set_squares(mpz_t sum, const mpz_t a, const mpz_t b)
{
    mpz_mul(sum, a, a);
    mpz_addmul(sum, b, b);
}

static double coordinate(sure_vec3 p, int axis)
{
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

typedef struct {
    int axis;
    bool upwards;
    double face;
} side;

/* Outwards from the point to the face. */
static void set_gap(mpz_t gap, const side *of, sure_vec3 p)
{
    set_way(gap, coordinate(p, of->axis), of->face);
    if (!of->upwards)
        mpz_neg(gap, gap);
}

/* Beyond a ball. */
static int ball_room(const side *of, sure_vec3 centre, double radius)
{
    mpz_t gap, reach;
    mpz_inits(gap, reach, NULL);
    set_gap(gap, of, centre);
    set(reach, radius);
    int sign = mpz_cmp(gap, reach);
    mpz_clears(gap, reach, NULL);
    return (sign > 0) - (sign < 0);
}

/* Beyond a disc across A, which reaches r sqrt((A.A - A_i^2) / A.A): by squares. */
static int disc_room(const side *of, sure_vec3 centre, mpz_t axis[3], double radius)
{
    mpz_t gap, across, whole, left, right;
    mpz_inits(gap, across, whole, left, right, NULL);
    int i = of->axis;
    set_gap(gap, of, centre);
    set_squares(across, axis[(i + 1) % 3], axis[(i + 2) % 3]);
    mpz_set(whole, across);
    mpz_addmul(whole, axis[i], axis[i]);
    mpz_mul(left, gap, gap);
    mpz_mul(left, left, whole);
    set(right, radius);
    mpz_mul(right, right, right);
    mpz_mul(right, right, across);
    int sign = mpz_sgn(gap) < 0 ? -1 : mpz_cmp(left, right);
    mpz_clears(gap, across, whole, left, right, NULL);
    return (sign > 0) - (sign < 0);
}

static int lesser(int a, int b)
{
    return a < b ? a : b;
}

int box_truth_room(const sure_object *object, int axis, bool upwards, double face)
{
    const side of = {axis, upwards, face};
    const sure_vec3 zero = {0, 0, 0};
    mpz_t along[3];
    int room;
    if (!is_finite_bits(face))
        return (face > 0) == upwards ? 1 : -1;
    for (int i = 0; i < 3; i++)
        mpz_init(along[i]);
    if (object->shape == SURE_SHAPE_SPHERE) {
        room = ball_room(&of, object->as.sphere.centre, object->as.sphere.radius);
    } else if (object->shape == SURE_SHAPE_DISC) {
        const sure_disc *s = &object->as.disc;
        set_between(along, zero, s->normal);
        room = disc_room(&of, s->centre, along, s->radius);
    } else if (object->shape == SURE_SHAPE_CYLINDER) {
        const sure_cylinder *s = &object->as.cylinder;
        set_between(along, s->base, s->top);
        room = lesser(disc_room(&of, s->base, along, s->radius),
                      disc_room(&of, s->top, along, s->radius));
    } else {
        const sure_cone *s = &object->as.cone;
        set_between(along, s->base, s->apex);
        room = lesser(disc_room(&of, s->base, along, s->radius), ball_room(&of, s->apex, 0));
    }
    for (int i = 0; i < 3; i++)
        mpz_clear(along[i]);
    return room;
}

/* t as a fraction of whole numbers, the lower one positive. */
typedef struct {
    mpz_t above, below;
} fraction;

static void fraction_init(fraction *t)
{
    mpz_inits(t->above, t->below, NULL);
}

static void fraction_clear(fraction *t)
{
    mpz_clears(t->above, t->below, NULL);
}

static bool at_most(const fraction *a, const fraction *b)
{
    mpz_t left, right;
    mpz_inits(left, right, NULL);
    mpz_mul(left, a->above, b->below);
    mpz_mul(right, b->above, a->below);
    bool holds = mpz_cmp(left, right) <= 0;
    mpz_clears(left, right, NULL);
    return holds;
}

/* What t has to be at least and at most, of the ray itself and of each axis that it moves along. */
typedef struct {
    fraction least[4], most[4];
    int lower, upper;
} range;

static void set_number(fraction *t, double x)
{
    set(t->above, x);
    set(t->below, 1);
}

/* Where o + t d is at the face. */
static void set_crossing(fraction *t, double o, double d, double face)
{
    set_way(t->above, o, face);
    set(t->below, d);
    if (d < 0) {
        mpz_neg(t->above, t->above);
        mpz_neg(t->below, t->below);
    }
}

/* False where the ray doesn't move along the axis and is outside. */
static bool limit(range *r, double low, double high, double o, double d)
{
    double near = d < 0 ? high : low, far = d < 0 ? low : high;
    if (is_zero_bits(d))
        return low <= o && o <= high;
    if (is_finite_bits(near))
        set_crossing(&r->least[r->lower++], o, d, near);
    if (is_finite_bits(far))
        set_crossing(&r->most[r->upper++], o, d, far);
    return true;
}

/* Intervals have a point in common where every two of them have. */
static bool is_empty(const range *r)
{
    for (int i = 0; i < r->lower; i++) {
        for (int k = 0; k < r->upper; k++) {
            if (!at_most(&r->least[i], &r->most[k]))
                return true;
        }
    }
    return false;
}

bool box_truth_meets(const sure_box *box, const sure_ray *ray)
{
    range r = {.lower = 0, .upper = 0};
    bool possible = true;
    for (int i = 0; i < 4; i++) {
        fraction_init(&r.least[i]);
        fraction_init(&r.most[i]);
    }
    set_number(&r.least[r.lower++], ray->t_min);
    if (is_finite_bits(ray->t_max))
        set_number(&r.most[r.upper++], ray->t_max);
    for (int i = 0; i < 3; i++)
        possible = possible && limit(&r, box->low[i], box->high[i], coordinate(ray->origin, i),
                                     coordinate(ray->direction, i));
    possible = possible && !is_empty(&r);
    for (int i = 0; i < 4; i++) {
        fraction_clear(&r.least[i]);
        fraction_clear(&r.most[i]);
    }
    return possible;
}
