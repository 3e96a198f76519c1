/* SPDX-License-Identifier: MIT */
/* The search. It knows no shape: what an object is, its row says (bisection_shape.h).
 *
 *   P(tau) = O + tau D    the ray in integers; t = tau * 2^shift
 */
#include "bisection.h"

#include "bisection_shape.h"

#include <math.h>
#include <stdlib.h>

static void ray_point(const world *w, int tau, vector *out)
{
    for (int i = 0; i < 3; i++) {
        mpz_mul_si(out->x[i], w->direction.x[i], tau);
        mpz_add(out->x[i], out->x[i], w->origin.x[i]);
    }
}

/* From a polynomial in tau to a positive multiple of it in t. */
static void substitute_t(const world *w, polynomial *p, unsigned degree)
{
    for (unsigned i = 0; i <= degree; i++) {
        mp_bitcnt_t power =
            w->shift > 0 ? (mp_bitcnt_t)w->shift * (degree - i) : (mp_bitcnt_t)-w->shift * i;
        mpz_mul_2exp(p->term[i], p->term[i], power);
    }
}

/* The quadratic that has the values of `body` at tau = -1, 0 and 1, doubled. */
static void body_on_line(const world *w, polynomial *out)
{
    vector p;
    mpz_t before, here, after;
    vector_init(&p);
    mpz_inits(before, here, after, (mpz_ptr)NULL);
    ray_point(w, -1, &p);
    w->row->body(w, &p, before);
    ray_point(w, 0, &p);
    w->row->body(w, &p, here);
    ray_point(w, 1, &p);
    w->row->body(w, &p, after);

    mpz_mul_si(out->term[0], here, 2);
    mpz_sub(out->term[1], after, before);
    mpz_add(out->term[2], after, before);
    mpz_sub(out->term[2], out->term[2], out->term[0]);
    substitute_t(w, out, 2);
    mpz_clears(before, here, after, (mpz_ptr)NULL);
    vector_clear(&p);
}

/* How far P is on the inner side of each plane. */
static void planes_on_line(const world *w, polynomial *inner)
{
    plane side;
    vector offset;
    vector_init(&side.outward);
    vector_init(&offset);
    mpz_init(side.reach);
    vector_subtract(&offset, &w->origin, &w->anchor);
    for (int i = 0; i < w->row->planes; i++) {
        w->row->plane(w, i, &side);
        dot(inner[i].term[0], &side.outward, &offset);
        mpz_sub(inner[i].term[0], side.reach, inner[i].term[0]);
        dot(inner[i].term[1], &side.outward, &w->direction);
        mpz_neg(inner[i].term[1], inner[i].term[1]);
        substitute_t(w, &inner[i], 1);
    }
    vector_clear(&side.outward);
    vector_clear(&offset);
    mpz_clear(side.reach);
}

/* What of the ray's line belongs to the object. */
typedef struct {
    bool empty;
    bool endless; /* a line in a plane: no ends */
    bool solid;   /* meets the interior, so that its ends alone are boundary */
    location enter, leave;
} chord;

typedef struct {
    polynomial body, inner[PLANES_MOST];
    int planes;
    chord chord;
} line;

static void line_init(line *l, int planes)
{
    l->planes = planes;
    polynomial_init(&l->body);
    for (int i = 0; i < planes; i++)
        polynomial_init(&l->inner[i]);
    location_init(&l->chord.enter);
    location_init(&l->chord.leave);
    l->chord.empty = l->chord.endless = l->chord.solid = false;
}

static void line_clear(line *l)
{
    polynomial_clear(&l->body);
    for (int i = 0; i < l->planes; i++)
        polynomial_clear(&l->inner[i]);
    location_clear(&l->chord.enter);
    location_clear(&l->chord.leave);
}

/* The root of a linear polynomial. */
static void crossing(fraction *t, const polynomial *p)
{
    fraction_set_quotient(t, p->term[0], p->term[1]);
    mpz_neg(t->num, t->num);
}

/* +-2^k, beyond every root of a quadratic: those are less than 1 + max |p0/p2|, |p1/p2|. */
static void far_points(fraction *low, fraction *high, const polynomial *p)
{
    long leading = (long)mpz_sizeinbase(p->term[2], 2);
    long power = 0;
    for (int i = 0; i < 2; i++) {
        long excess = (long)mpz_sizeinbase(p->term[i], 2) - leading + 1;
        power = excess > power ? excess : power;
    }
    fraction_set_integer(high, 1);
    mpz_mul_2exp(high->num, high->num, (mp_bitcnt_t)power + 1);
    fraction_set(low, high);
    mpz_neg(low->num, low->num);
}

/* What the planes leave of the line: from the last crossing inwards to the first outwards. `open`
 * is false where no point is strictly within all. */
typedef struct {
    bool empty, bounded, open, low_known, high_known;
    fraction low, high;
} stretch;

static void narrow(stretch *s, const polynomial *inner)
{
    int rising = mpz_sgn(inner->term[1]), start = mpz_sgn(inner->term[0]);
    if (rising == 0) {
        s->empty = s->empty || start < 0;
        s->open = s->open && start > 0;
        return;
    }
    fraction at;
    fraction_init(&at);
    crossing(&at, inner);
    fraction *end = rising > 0 ? &s->low : &s->high;
    bool *known = rising > 0 ? &s->low_known : &s->high_known;
    if (!*known || fraction_compare(&at, end) * rising > 0)
        fraction_set(end, &at);
    *known = true;
    fraction_clear(&at);
}

/* Planes come in pairs, so that a line that crosses one crosses one the other way. */
static void between_planes(const line *l, stretch *s)
{
    for (int i = 0; i < l->planes; i++)
        narrow(s, &l->inner[i]);
    s->bounded = s->low_known && s->high_known;
    if (!s->bounded)
        return;
    int order = fraction_compare(&s->low, &s->high);
    s->empty = s->empty || order > 0;
    s->open = s->open && order < 0;
}

/* The outer samples. A line that no plane bounds is endless where its body is constant (both
 * false); otherwise two points beyond the roots of its body, which is convex along it, do. */
static bool outer_samples(line *l, stretch *s)
{
    between_planes(l, s);
    l->chord.empty = s->empty;
    l->chord.endless = !s->empty && !s->bounded && mpz_sgn(l->body.term[2]) == 0;
    if (!s->bounded && !s->empty && !l->chord.endless)
        far_points(&s->low, &s->high, &l->body);
    return !(l->chord.empty || l->chord.endless);
}

/* -p1/(2 p2), where a quadratic turns, if that is between the outer samples; else `low`. */
static void middle_sample(const polynomial *p, const fraction *low, const fraction *high,
                          fraction *middle)
{
    fraction_set(middle, low);
    if (mpz_sgn(p->term[2]) == 0)
        return;
    mpz_t twice;
    mpz_init(twice);
    mpz_mul_si(twice, p->term[2], -2);
    fraction vertex;
    fraction_init(&vertex);
    fraction_set_quotient(&vertex, p->term[1], twice);
    if (fraction_compare(low, &vertex) < 0 && fraction_compare(&vertex, high) < 0)
        fraction_set(middle, &vertex);
    fraction_clear(&vertex);
    mpz_clear(twice);
}

/* From an outer sample inwards: the outer one itself if it is not outside the body; otherwise
 * the root before the first sample that is not. False if all are outside. */
static bool find_end(location *end, const polynomial *p, const fraction sample[3],
                     const int sign[3], int outer, int step)
{
    for (int i = outer; i >= 0 && i < 3; i += step) {
        if (sign[i] > 0)
            continue;
        if (i == outer)
            location_set_fraction(end, &sample[i]);
        else
            location_set_root(end, p, &sample[i - step], &sample[i]);
        return true;
    }
    return false;
}

/* Between consecutive samples the body's function is monotone, so its sign changes once at most. */
static void find_ends(line *l, const stretch *s)
{
    fraction sample[3];
    int sign[3];
    for (int i = 0; i < 3; i++)
        fraction_init(&sample[i]);
    fraction_set(&sample[0], &s->low);
    fraction_set(&sample[2], &s->high);
    middle_sample(&l->body, &sample[0], &sample[2], &sample[1]);
    for (int i = 0; i < 3; i++) {
        sign[i] = polynomial_sign(&l->body, &sample[i]);
        l->chord.solid = l->chord.solid || (sign[i] < 0 && s->open);
    }
    l->chord.empty = !find_end(&l->chord.enter, &l->body, sample, sign, 0, 1) ||
                     !find_end(&l->chord.leave, &l->body, sample, sign, 2, -1);
    for (int i = 0; i < 3; i++)
        fraction_clear(&sample[i]);
}

static void find_chord(line *l)
{
    stretch s = {.open = true};
    fraction_init(&s.low);
    fraction_init(&s.high);
    if (outer_samples(l, &s))
        find_ends(l, &s);
    fraction_clear(&s.low);
    fraction_clear(&s.high);
}

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

/* The first plane that t is on; -1 for none. */
static int plane_at(const line *l, const location *t)
{
    for (int i = 0; i < l->planes; i++) {
        if (location_sign(t, &l->inner[i]) == 0)
            return i;
    }
    return -1;
}

static sure_part part_at(const world *w, const line *l, const location *t)
{
    int at = plane_at(l, t);
    return at < 0 ? w->row->body_part : w->row->plane_part[at];
}

/* A vector along the ray, each component linear in t. */
typedef struct {
    polynomial x[3];
} moving_vector;

static void set_constant(moving_vector *out, const vector *v, int sign)
{
    for (int i = 0; i < 3; i++)
        mpz_mul_si(out->x[i].term[0], v->x[i], sign);
}

/* body(P + e) - body(P - e) for the unit vector e along one axis: twice the derivative, exactly,
 * since body is quadratic. */
static void body_slope(const world *w, int tau, int axis, mpz_t out)
{
    vector p;
    mpz_t behind;
    vector_init(&p);
    mpz_init(behind);
    ray_point(w, tau, &p);
    mpz_sub_ui(p.x[axis], p.x[axis], 1);
    w->row->body(w, &p, behind);
    mpz_add_ui(p.x[axis], p.x[axis], 2);
    w->row->body(w, &p, out);
    mpz_sub(out, out, behind);
    mpz_clear(behind);
    vector_clear(&p);
}

static void set_gradient(moving_vector *out, const world *w)
{
    for (int i = 0; i < 3; i++) {
        polynomial *p = &out->x[i];
        body_slope(w, 0, i, p->term[0]);
        body_slope(w, 1, i, p->term[1]);
        mpz_sub(p->term[1], p->term[1], p->term[0]);
        substitute_t(w, p, 1);
    }
}

/* Body grows outwards, so its gradient is the outward normal of sphere and wall; where it
 * vanishes are the apex and what has radius 0. */
static void outward(const world *w, const line *l, const location *t, moving_vector *out)
{
    int at = plane_at(l, t);
    if (at >= 0) {
        plane side;
        vector_init(&side.outward);
        mpz_init(side.reach);
        w->row->plane(w, at, &side);
        set_constant(out, &side.outward, 1);
        vector_clear(&side.outward);
        mpz_clear(side.reach);
    } else if (mpz_sgn(w->radius) == 0) {
        set_constant(out, &w->direction, -1);
    } else {
        set_gradient(out, w);
    }
}

/* component / sqrt(square) at t, which are polynomials there. */
typedef struct {
    const polynomial *component;
    const polynomial *square;
    const location *t;
} unit_component;

/* out += factor * p^2 for a linear p */
static void add_square(polynomial *out, const polynomial *p)
{
    mpz_addmul(out->term[0], p->term[0], p->term[0]);
    mpz_addmul(out->term[1], p->term[0], p->term[1]);
    mpz_addmul(out->term[1], p->term[0], p->term[1]);
    mpz_addmul(out->term[2], p->term[1], p->term[1]);
}

/* Where component and y are of one sign, that of component^2 - y^2 square, which is a quadratic. */
static int compare_unit_component(void *number, const fraction *y)
{
    const unit_component *u = number;
    int sign = location_sign(u->t, u->component);
    int sign_y = mpz_sgn(y->num);
    if (sign != sign_y)
        return (sign > sign_y) - (sign < sign_y);

    polynomial difference;
    mpz_t weight;
    polynomial_init(&difference);
    mpz_init(weight);
    add_square(&difference, u->component);
    mpz_mul(weight, y->den, y->den);
    for (int i = 0; i < 3; i++)
        mpz_mul(difference.term[i], difference.term[i], weight);
    mpz_mul(weight, y->num, y->num);
    for (int i = 0; i < 3; i++)
        mpz_submul(difference.term[i], weight, u->square->term[i]);
    sign *= location_sign(u->t, &difference);
    mpz_clear(weight);
    polynomial_clear(&difference);
    return sign;
}

static sure_vec3 unit_vector(const moving_vector *v, const location *t)
{
    polynomial square;
    double x[3];
    polynomial_init(&square);
    for (int i = 0; i < 3; i++)
        add_square(&square, &v->x[i]);
    for (int i = 0; i < 3; i++) {
        unit_component u = {&v->x[i], &square, t};
        x[i] = nearest_double(compare_unit_component, &u);
    }
    polynomial_clear(&square);
    return (sure_vec3){x[0], x[1], x[2]};
}

static sure_vec3 normal_at(const world *w, const line *l, const location *t)
{
    moving_vector v;
    for (int i = 0; i < 3; i++)
        polynomial_init(&v.x[i]);
    outward(w, l, t, &v);
    sure_vec3 unit = unit_vector(&v, t);
    for (int i = 0; i < 3; i++)
        polynomial_clear(&v.x[i]);
    return unit;
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
