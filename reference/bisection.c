/* SPDX-License-Identifier: MIT */
/* The search. It knows no shape: what an object is, its row says (bisection_shape.h). */
#include "bisection.h"

#include "bisection_line.h"

#include <math.h>
#include <stdlib.h>

/* The ray's range of t. */
typedef struct {
    fraction low, high;
    bool bounded;
} range;

static void range_init(range *r, const sure_ray *ray)
{
    fraction_init(&r->low);
    fraction_init(&r->high);
    fraction_set_double(&r->low, ray->t_min);
    r->bounded = double_is_finite(ray->t_max);
    if (r->bounded)
        fraction_set_double(&r->high, ray->t_max);
}

static void range_clear(range *r)
{
    fraction_clear(&r->low);
    fraction_clear(&r->high);
}

static bool not_after(const location *x, const range *r)
{
    return !r->bounded || location_compare_fraction(x, &r->high) <= 0;
}

static bool not_before(const location *x, const range *r)
{
    return location_compare_fraction(x, &r->low) >= 0;
}

static bool meets(const chord *c, const range *r)
{
    return !c->empty && (c->endless || (not_after(&c->enter, r) && not_before(&c->leave, r)));
}

/* The first point of the boundary in the range, if there is one. */
static bool first_hit(const chord *c, const range *r, location *hit)
{
    if (!meets(c, r))
        return false;
    if (!c->endless && not_before(&c->enter, r)) {
        location_set(hit, &c->enter);
        return true;
    }
    if (c->solid) {
        location_set(hit, &c->leave);
        return not_after(hit, r);
    }
    location_set_fraction(hit, &r->low);
    return true;
}

static sure_part part_at(const world *w, const line *l, const location *t)
{
    int at = plane_at(l, t);
    return at < 0 ? w->row->body_part : w->row->plane_part[at];
}

static sure_interval interval_of(const world *w, line *l)
{
    if (l->chord.endless)
        return (sure_interval){-INFINITY, INFINITY, SURE_PART_SURFACE, SURE_PART_SURFACE};
    return (sure_interval){.t_enter = location_nearest(&l->chord.enter),
                           .t_leave = location_nearest(&l->chord.leave),
                           .enter_part = part_at(w, l, &l->chord.enter),
                           .leave_part = part_at(w, l, &l->chord.leave)};
}

/* One question in integers. */
typedef struct {
    world world;
    line line;
    range range;
} question;

static sure_field question_init(question *q, const sure_ray *ray, const sure_object *object)
{
    sure_field field = world_init(&q->world, ray, object);
    if (field != SURE_FIELD_NONE)
        return field;
    line_init(&q->line, q->world.row->planes);
    range_init(&q->range, ray);
    body_on_line(&q->world, &q->line.body);
    planes_on_line(&q->world, q->line.inner);
    find_chord(&q->line);
    return SURE_FIELD_NONE;
}

static void question_clear(question *q)
{
    world_clear(&q->world);
    line_clear(&q->line);
    range_clear(&q->range);
}

sure_status bisection_answer(const sure_ray *ray, const sure_object *object,
                             bisection_result *result)
{
    question q;
    location hit;
    *result = (bisection_result){.status = SURE_INVALID, .interval_status = SURE_INVALID};
    result->field = question_init(&q, ray, object);
    if (result->field != SURE_FIELD_NONE)
        return SURE_INVALID;

    result->interval_status = meets(&q.line.chord, &q.range) ? SURE_HIT : SURE_MISS;
    if (result->interval_status == SURE_HIT)
        result->interval = interval_of(&q.world, &q.line);
    location_init(&hit);
    result->status = first_hit(&q.line.chord, &q.range, &hit) ? SURE_HIT : SURE_MISS;
    if (result->status == SURE_HIT) {
        result->t = location_nearest(&hit);
        result->part = part_at(&q.world, &q.line, &hit);
        result->normal = normal_at(&q.world, &q.line, &hit);
    }
    location_clear(&hit);
    question_clear(&q);
    return result->status;
}

/* Entry: a hit. */
static void find_hit(const sure_ray *ray, const sure_object *object, location *hit)
{
    question q;
    location_init(hit);
    if (question_init(&q, ray, object) != SURE_FIELD_NONE ||
        !first_hit(&q.line.chord, &q.range, hit))
        abort();
    question_clear(&q);
}

int bisection_compare(const sure_ray *ray, const sure_object *object, double x)
{
    location hit;
    fraction other;
    int order = double_bits(x) & SIGN_BIT ? 1 : -1;
    find_hit(ray, object, &hit);
    if (double_is_finite(x)) {
        fraction_init(&other);
        fraction_set_double(&other, x);
        order = location_compare_fraction(&hit, &other);
        fraction_clear(&other);
    }
    location_clear(&hit);
    return order;
}

int bisection_order(const sure_ray *ray, const sure_object *first, const sure_object *second)
{
    location x, y;
    find_hit(ray, first, &x);
    find_hit(ray, second, &y);
    int order = location_compare(&x, &y);
    location_clear(&x);
    location_clear(&y);
    return order;
}
