/* SPDX-License-Identifier: MIT */
#include "query.h"

#include "../numbers/environment.h"
#include "../numbers/mod128_value.h"
#include "../numbers/places.h"
#include "close.h"
#include "hits/surface.h"
#include "whole_point.h"

/* Magnitudes as bits: the largest of some numbers, and the least that is not zero, less one. */
typedef struct {
    uint64_t largest, least_less_one;
} extent;

/* Those of lengths, of the direction and of a normal. */
typedef struct {
    extent lengths, steps, normals;
} extents;

static inline void extend(extent *e, double x)
{
    uint64_t bits = magnitude_bits(x), less_one = bits - 1;
    e->largest = bits > e->largest ? bits : e->largest;
    e->least_less_one = less_one < e->least_less_one ? less_one : e->least_less_one;
}

static inline void extend_to(extent *e, sure_vec3 v)
{
    extend(e, v.x);
    extend(e, v.y);
    extend(e, v.z);
}

static extents extents_of(const sure_ray *ray, const shape_row *row, const void *shape)
{
    const extent none = {0, UINT64_MAX};
    extents e = {none, none, none};
    extend_to(&e.lengths, ray->origin);
    extend_to(&e.steps, ray->direction);
    for (int i = 0; i < row->info.field_count; i++) {
        const sure_shape_field *field = &row->info.fields[i];
        const double *place = (const double *)shape + field->at;
        if (field->kind == SURE_KIND_RADIUS)
            extend(&e.lengths, *place);
        else
            extend_to(field->kind == SURE_KIND_NORMAL ? &e.normals : &e.lengths,
                      *(const sure_vec3 *)place);
    }
    return e;
}

static bool is_ordinary(extent e)
{
    return e.largest == 0 ||
           (e.least_less_one + 1 >= bits_of(0x1p-30) && e.largest <= bits_of(0x1p30));
}

/* e with 2^e <= |x| < 2^(e+1), subnormal x too. */
static int true_exponent(double x)
{
    if (exponent_of(x) > -1023)
        return exponent_of(x);
    magnitude_parts parts = parts_of(x);
    return exponent_of((double)parts.mantissa) + parts.exponent;
}

/* x 2^k, the result in the normal range unless x is zero. */
static inline double shifted(double x, int k)
{
    if (!is_subnormal_bits(x))
        return double_of(bits_of(x) + (((uint64_t)k << 52) & -(uint64_t)!is_zero_bits(x)));
    magnitude_parts parts = parts_of(x);
    uint64_t bits = bits_of((double)parts.mantissa);
    bits += (uint64_t)(parts.exponent + k) << 52;
    return double_of(bits | (bits_of(x) & BITS_SIGN));
}

/* To its place at once: what is written in parts and then copied as a whole has to wait. */
static inline void shift(const sure_vec3 *v, int k, sure_vec3 *to)
{
    to->x = shifted(v->x, k);
    to->y = shifted(v->y, k);
    to->z = shifted(v->z, k);
}

/* The exponent of the largest, 0 when there is none; false when the least is too far from it. */
static bool exponent_of_extent(extent e, int *exponent)
{
    *exponent = e.largest == 0 ? 0 : true_exponent(double_of(e.largest));
    return e.largest == 0 ||
           true_exponent(double_of(e.least_less_one + 1)) - *exponent >= -QUERY_SPREAD;
}

/* What is out of any stage's range stays so. */
static double scaled_t(double t, int k)
{
    const int beyond = 400;
    if (is_zero_bits(t) || !is_finite_bits(t))
        return t;
    int exponent = true_exponent(t) + k;
    if (exponent > beyond || exponent < -beyond)
        return power_of_two(exponent > 0 ? beyond : -beyond);
    return shifted(t, k);
}

static void shift_shape(const shape_row *row, const void *shape, int length, int normal, void *to)
{
    for (int i = 0; i < row->info.field_count; i++) {
        const sure_shape_field *field = &row->info.fields[i];
        const double *from = (const double *)shape + field->at;
        double *place = (double *)to + field->at;
        if (field->kind == SURE_KIND_RADIUS)
            *place = shifted(*from, length);
        else
            shift((const sure_vec3 *)from, field->kind == SURE_KIND_NORMAL ? normal : length,
                  (sure_vec3 *)place);
    }
}

bool query_of(const sure_ray *ray, const shape_row *row, const void *shape, query *q)
{
    extents e = extents_of(ray, row, shape);
    query_unscaled(ray, shape, q);
    if (is_ordinary(e.lengths) && is_ordinary(e.steps) && is_ordinary(e.normals))
        return true;
    int unit, step, normal;
    if (!exponent_of_extent(e.lengths, &unit) || !exponent_of_extent(e.steps, &step) ||
        !exponent_of_extent(e.normals, &normal))
        return false;
    q->t_exponent = unit - step;
    q->length_exponent = unit;
    sure_ray *scaled = &q->scaled_ray;
    shift(&ray->origin, -unit, &scaled->origin);
    shift(&ray->direction, -step, &scaled->direction);
    scaled->t_min = scaled_t(ray->t_min, -q->t_exponent);
    scaled->t_max = scaled_t(ray->t_max, -q->t_exponent);
    shift_shape(row, shape, -unit, -normal, q->scaled_shape);
    q->ray = &q->scaled_ray;
    q->shape = q->scaled_shape;
    return true;
}

RARE bool query_side(const shape_row *row, const void *shape, sure_vec3 p, int *side,
                     sure_stage *stage)
{
    const surface_row *of = row->surface;
    ddb near[3];
    mod128 whole[3];
    ddb_context c = {false};
    if (of->side) {
        *side = of->side(shape, p);
        return true;
    }
    bool known = true, by_bits = false;
    int count = of->sides_ddb(&c, shape, p, near);
    *side = -1;
    for (int i = 0; i < count && *side <= 0; i++) {
        ddb_context of_one = {false};
        int sign = ddb_sign(&of_one, near[i]);
        if (of_one.uncertain && !by_bits)
            (void)of->sides_mod128(NULL, shape, p, whole);
        by_bits |= of_one.uncertain;
        if (!of_one.uncertain || mod128_sign(ddb_most(near[i]), whole[i], &sign))
            *side = number_side(*side, sign);
        else
            known = false;
    }
    if (by_bits)
        *stage = SURE_STAGE_MOD128;
    return known || *side > 0;
}

RARE int query_side_exact(const shape_row *row, const void *shape, sure_vec3 p)
{
    const surface_row *of = row->surface;
    exact_arena room;
    exact_context c = exact_start(&room);
    exact whole[3];
    if (of->side)
        return of->side(shape, p);
    int count = of->sides_exact(&c, shape, p, whole), side = -1;
    for (int i = 0; i < count; i++)
        side = number_side(side, exact_sign(&c, whole[i]));
    return side;
}

/* On which side the ray's point at t is: by double-doubles, and where they can't tell exactly.
 * False where the point is no double's. */
static bool side_at(const shape_row *row, const query *q, double t, int *side, sure_stage *stage)
{
    sure_vec3 p = q->ray->origin;
    bool whole = true, known;
    if (!is_zero_bits(t))
        TO_NEAREST(whole, whole_point(q->ray, t, &p));
    if (!whole)
        return false;
    TO_NEAREST(known, query_side(row, q->shape, p, side, stage));
    if (known)
        return true;
    *stage = SURE_STAGE_EXACT;
    *side = query_side_exact(row, q->shape, p);
    return true;
}

/* An end of a chord, and what it is compared with. */
typedef struct {
    const shape_row *row;
    const query *q;
    const filter_interval *found;
    const filter_end *end;
} compared;

/* The sign of t* - x: within the solid x is between the ends; outside and on the boundary, as the
 * other end tells. False where that is next to x, too. */
static bool order_by_side(const compared *of, double x, int *sign, sure_stage *stage)
{
    const filter_end *enter = &of->found->enter, *leave = &of->found->leave;
    const bool enters = of->end == enter;
    const bool alone = enters ? leave->t - x > leave->error : x - enter->t > enter->error;
    int side;
    if (!side_at(of->row, of->q, x, &side, stage) || (side >= 0 && !alone))
        return false;
    *sign = enters ? side : -side;
    return true;
}

/* By a step from x to the end. */
static bool order_by_step(const compared *of, double x, int *sign)
{
    polish_step way;
    TO_NEAREST(way, close_of(of->row)->step(of->q->ray, of->q->shape, of->end->end, x));
    *sign = way.step > 0 ? 1 : -1;
    return way.certain && fabs(way.step) > way.error;
}

/* Of a touch, or of an apex from which the line goes on within: there a < 0, which turns the
 * slope's sign. */
static bool order_by_slope(const compared *of, double x, int *sign)
{
    const filter_interval *found = of->found;
    bool known, touches = found->enter.end.at == found->leave.end.at;
    TO_NEAREST(known, tangent_order(of->row, of->q->ray, of->q->shape, x, sign));
    *sign = touches ? *sign : -*sign;
    return known;
}

/* t* - x, x a bound of the range. Where t* is not after 0, it is before an x that is. */
static bool order(const compared *of, double x, int *sign, sure_stage *stage)
{
    const filter_end *end = of->end;
    bool known = fabs(end->t - x) > end->error;
    *sign = end->t > x ? 1 : -1;
    if (known)
        return true;
    if (filter_at_start(end)) { /* and x may be subnormal */
        *sign = is_zero_bits(x) ? 0 : -1;
        return true;
    }
    if (end->end.at == END_TANGENT) {
        *stage = SURE_STAGE_MOD128;
        return order_by_slope(of, x, sign);
    }
    if (order_by_step(of, x, sign) || order_by_side(of, x, sign, stage))
        return true;
    known = !is_zero_bits(x) && fabs(end->t) <= end->error && order_by_side(of, 0, sign, stage) &&
            *sign <= 0;
    *sign = -1;
    return known;
}

filter_verdict query_first(const shape_row *row, const query *q, filter_interval *found,
                           filter_end *first, sure_stage *stage)
{
    const double least = q->ray->t_min, most = q->ray->t_max;
    compared of = {row, q, found, &found->enter};
    int after, beyond;
    if (!row->info.solid || !filter_range(q->ray) || !order(&of, least, &after, stage))
        return FILTER_UNCERTAIN;
    if (after < 0) {
        of.end = &found->leave;
        if (!order(&of, least, &after, stage))
            return FILTER_UNCERTAIN;
        if (after < 0)
            return FILTER_MISS;
    }
    if (!order(&of, most, &beyond, stage))
        return FILTER_UNCERTAIN;
    filter_end *at = of.end == &found->enter ? &found->enter : &found->leave;
    if (at == &found->leave)
        found->enter.t = -INFINITY; /* it is before that, as near as both may seem */
    if (after == 0 || (beyond == 0 && at->end.at == END_TANGENT)) {
        at->t = after == 0 ? least : most;
        at->error = 0;
    }
    *first = *at;
    return beyond > 0 ? FILTER_MISS : FILTER_INTERVAL;
}
