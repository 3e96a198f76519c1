/* SPDX-License-Identifier: MIT */
#include "bisection_shape.h"

#include <limits.h>
#include <stdlib.h>

static const bisection_row *row_of(sure_shape shape)
{
#define ROW(shape, SHAPE) &bisection_##shape,
    static const bisection_row *const rows[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};
#undef ROW
    if ((unsigned)shape >= SURE_SHAPES)
        abort();
    return rows[shape];
}

void vector_init(vector *v)
{
    mpz_inits(v->x[0], v->x[1], v->x[2], (mpz_ptr)NULL);
}

void vector_clear(vector *v)
{
    mpz_clears(v->x[0], v->x[1], v->x[2], (mpz_ptr)NULL);
}

void vector_subtract(vector *out, const vector *v, const vector *w)
{
    for (int i = 0; i < 3; i++)
        mpz_sub(out->x[i], v->x[i], w->x[i]);
}

void dot(mpz_t out, const vector *v, const vector *w)
{
    mpz_set_ui(out, 0);
    for (int i = 0; i < 3; i++)
        mpz_addmul(out, v->x[i], w->x[i]);
}

static bool not_negative(double x)
{
    return double_is_zero(x) || !(double_bits(x) & SIGN_BIT);
}

static bool all_zero(const double *v)
{
    return double_is_zero(v[0]) && double_is_zero(v[1]) && double_is_zero(v[2]);
}

bool valid_point(const double *v, const double *anchor)
{
    (void)anchor;
    return double_is_finite(v[0]) && double_is_finite(v[1]) && double_is_finite(v[2]);
}

bool valid_normal(const double *v, const double *anchor)
{
    return valid_point(v, anchor) && !all_zero(v);
}

bool valid_end(const double *v, const double *anchor)
{
    bool same = true;
    for (int i = 0; i < 3; i++)
        same = same && ((double_is_zero(v[i]) && double_is_zero(anchor[i])) ||
                        double_bits(v[i]) == double_bits(anchor[i]));
    return valid_point(v, anchor) && !same;
}

bool valid_radius(const double *x, const double *anchor)
{
    (void)anchor;
    return double_is_finite(*x) && not_negative(*x);
}

/* The bits of numbers that are not negative are in the numbers' order; those of a NaN come after
 * infinity's. */
static bool is_t_max(double x, double t_min)
{
    if (double_is_zero(x)) /* -0 too */
        return double_is_zero(t_min);
    return double_bits(x) <= INFINITY_BITS &&
           (double_is_zero(t_min) || double_bits(t_min) <= double_bits(x));
}

static sure_field invalid_ray_field(const sure_ray *ray)
{
    if (!valid_point(&ray->origin.x, NULL))
        return SURE_FIELD_O;
    if (!valid_normal(&ray->direction.x, NULL))
        return SURE_FIELD_D;
    if (!double_is_finite(ray->t_min) || !not_negative(ray->t_min))
        return SURE_FIELD_T_MIN;
    return is_t_max(ray->t_max, ray->t_min) ? SURE_FIELD_NONE : SURE_FIELD_T_MAX;
}

static int width(field_kind kind)
{
    return kind == NO_FIELD ? 0 : kind == RADIUS ? 1 : 3;
}

/* A shape's struct is its fields' doubles. */
static const double *numbers_of(const sure_object *object)
{
    return (const double *)(const void *)&object->as;
}

static sure_field invalid_field(const sure_ray *ray, const bisection_row *row,
                                const double *numbers)
{
    sure_field bad = invalid_ray_field(ray);
    const double *value = numbers;
    for (int i = 0; i < FIELDS_MOST && bad == SURE_FIELD_NONE; i++) {
        const row_field *f = &row->fields[i];
        if (f->kind != NO_FIELD && !f->valid(value, numbers))
            bad = f->name;
        value += width(f->kind);
    }
    return bad;
}

static void lower_exponents(long *least, const double *values, int count)
{
    for (int i = 0; i < count; i++) {
        long exponent;
        if (double_split(values[i], &exponent) != 0 && exponent < *least)
            *least = exponent;
    }
}

static void vector_from(vector *out, const double *v, long exponent)
{
    for (int i = 0; i < 3; i++)
        integer_from(out->x[i], v[i], exponent);
}

static void direction_from(vector *out, const double *v, long *exponent)
{
    *exponent = LONG_MAX;
    lower_exponents(exponent, v, 3);
    vector_from(out, v, *exponent);
}

static long unit_of_length(const sure_ray *ray, const bisection_row *row, const double *numbers)
{
    long unit = LONG_MAX;
    lower_exponents(&unit, &ray->origin.x, 3);
    for (int i = 0; i < FIELDS_MOST; i++) {
        field_kind kind = row->fields[i].kind;
        if (kind != NORMAL)
            lower_exponents(&unit, numbers, width(kind));
        numbers += width(kind);
    }
    return unit == LONG_MAX ? 0 : unit;
}

static void set_field(world *w, field_kind kind, const double *value, long unit)
{
    long ignored;
    switch (kind) {
    case NO_FIELD: break;
    case ANCHOR: vector_from(&w->anchor, value, unit); break;
    case NORMAL: direction_from(&w->axis, value, &ignored); break;
    case RADIUS: integer_from(w->radius, *value, unit); break;
    case OTHER_END:
        vector_from(&w->axis, value, unit);
        vector_subtract(&w->axis, &w->axis, &w->anchor);
        break;
    }
}

sure_field world_init(world *w, const sure_ray *ray, const sure_object *object)
{
    const double *numbers = numbers_of(object);
    w->row = row_of(object->shape);
    sure_field bad = invalid_field(ray, w->row, numbers);
    if (bad != SURE_FIELD_NONE)
        return bad;
    vector_init(&w->origin);
    vector_init(&w->direction);
    vector_init(&w->anchor);
    vector_init(&w->axis);
    mpz_inits(w->radius, w->axis_square, (mpz_ptr)NULL);

    long unit = unit_of_length(ray, w->row, numbers), unit_of_direction;
    vector_from(&w->origin, &ray->origin.x, unit);
    direction_from(&w->direction, &ray->direction.x, &unit_of_direction);
    w->shift = unit - unit_of_direction;
    for (int i = 0; i < FIELDS_MOST; i++) {
        set_field(w, w->row->fields[i].kind, numbers, unit);
        numbers += width(w->row->fields[i].kind);
    }
    dot(w->axis_square, &w->axis, &w->axis);
    return SURE_FIELD_NONE;
}

void world_clear(world *w)
{
    vector_clear(&w->origin);
    vector_clear(&w->direction);
    vector_clear(&w->anchor);
    vector_clear(&w->axis);
    mpz_clears(w->radius, w->axis_square, (mpz_ptr)NULL);
}

void height(const world *w, const vector *p, mpz_t out)
{
    vector offset;
    vector_init(&offset);
    vector_subtract(&offset, p, &w->anchor);
    dot(out, &w->axis, &offset);
    vector_clear(&offset);
}

void distance_square(const world *w, const vector *p, mpz_t out)
{
    vector offset;
    vector_init(&offset);
    vector_subtract(&offset, p, &w->anchor);
    dot(out, &offset, &offset);
    vector_clear(&offset);
}

void axis_distance(const world *w, const vector *p, mpz_t out)
{
    mpz_t along;
    mpz_init(along);
    height(w, p, along);
    distance_square(w, p, out);
    mpz_mul(out, out, w->axis_square);
    mpz_submul(out, along, along);
    mpz_clear(along);
}

void ball(const world *w, const vector *p, mpz_t out)
{
    distance_square(w, p, out);
    mpz_submul(out, w->radius, w->radius);
}

/* sign A.W <= reach */
static void across_axis(const world *w, int sign, const mpz_t reach, plane *out)
{
    for (int i = 0; i < 3; i++)
        mpz_mul_si(out->outward.x[i], w->axis.x[i], sign);
    mpz_set(out->reach, reach);
}

void flat_planes(const world *w, int index, plane *out)
{
    mpz_t zero;
    mpz_init(zero);
    across_axis(w, index == 0 ? 1 : -1, zero, out);
    mpz_clear(zero);
}

void end_planes(const world *w, int index, plane *out)
{
    across_axis(w, index == 0 ? -1 : 1, w->axis_square, out);
    if (index == 0)
        mpz_set_ui(out->reach, 0);
}
