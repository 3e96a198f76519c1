/* In integers, at a point P whose offset from the anchor (centre, point or base) is W, with the
 * axis A (normal, or from the base to the other end):
 *
 *   sphere    W^2 - r^2 <= 0
 *   disc      the same, where 0 <= A.W <= 0
 *   plane     0 <= 0, where 0 <= A.W <= 0
 *   cylinder  (A^2 W^2 - (A.W)^2) - A^2 r^2 <= 0, where 0 <= A.W <= A^2
 *   cone      A^2 (A^2 W^2 - (A.W)^2) - (r (A^2 - A.W))^2 <= 0, where 0 <= A.W <= A^2
 *
 * A^2 W^2 - (A.W)^2 is A^2 times the squared distance from the axis, and the cone's radius at
 * P's height is r (A^2 - A.W) / A^2. Nothing else is known of a shape: its quadratic along the
 * ray and its normals are read off the values of these functions.
 *
 *   P(tau) = O + tau D    the ray in integers; t = tau * 2^shift
 */
#include "bisection.h"

#include "bisection_number.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

typedef struct {
    mpz_t x[3];
} vector;

static void vector_init(vector *v)
{
    mpz_inits(v->x[0], v->x[1], v->x[2], (mpz_ptr)NULL);
}

static void vector_clear(vector *v)
{
    mpz_clears(v->x[0], v->x[1], v->x[2], (mpz_ptr)NULL);
}

static void vector_subtract(vector *out, const vector *v, const vector *w)
{
    for (int i = 0; i < 3; i++)
        mpz_sub(out->x[i], v->x[i], w->x[i]);
}

/* out must not be a component of v or w. */
static void dot(mpz_t out, const vector *v, const vector *w)
{
    mpz_set_ui(out, 0);
    for (int i = 0; i < 3; i++)
        mpz_addmul(out, v->x[i], w->x[i]);
}

static bool vector_finite(const sure_vec3 *v)
{
    return double_is_finite(v->x) && double_is_finite(v->y) && double_is_finite(v->z);
}

static bool vector_zero(const sure_vec3 *v)
{
    return double_is_zero(v->x) && double_is_zero(v->y) && double_is_zero(v->z);
}

static bool same_number(double x, double y)
{
    return (double_is_zero(x) && double_is_zero(y)) || double_bits(x) == double_bits(y);
}

static bool vector_same(const sure_vec3 *v, const sure_vec3 *w)
{
    return same_number(v->x, w->x) && same_number(v->y, w->y) && same_number(v->z, w->z);
}

static bool not_negative(double x)
{
    return double_is_zero(x) || !(double_bits(x) & SIGN_BIT);
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

static bool is_radius(double x)
{
    return double_is_finite(x) && not_negative(x);
}

static sure_field invalid_ray_field(const sure_ray *ray)
{
    if (!vector_finite(&ray->origin))
        return SURE_FIELD_O;
    if (!vector_finite(&ray->direction) || vector_zero(&ray->direction))
        return SURE_FIELD_D;
    if (!double_is_finite(ray->t_min) || !not_negative(ray->t_min))
        return SURE_FIELD_T_MIN;
    return is_t_max(ray->t_max, ray->t_min) ? SURE_FIELD_NONE : SURE_FIELD_T_MAX;
}

/* Every shape is an anchor, then an axis, a second end or neither, then a radius or none. */
typedef struct {
    const sure_vec3 *anchor, *axis, *end;
    const double *radius;
    sure_field anchor_field, end_field;
} shape_parts;

static shape_parts parts_of(const sure_object *object)
{
    switch (object->shape) {
    case SURE_SHAPE_PLANE:
        return (shape_parts){.anchor = &object->as.plane.point,
                             .axis = &object->as.plane.normal,
                             .anchor_field = SURE_FIELD_POINT};
    case SURE_SHAPE_DISC:
        return (shape_parts){.anchor = &object->as.disc.centre,
                             .axis = &object->as.disc.normal,
                             .radius = &object->as.disc.radius,
                             .anchor_field = SURE_FIELD_CENTRE};
    case SURE_SHAPE_SPHERE:
        return (shape_parts){.anchor = &object->as.sphere.centre,
                             .radius = &object->as.sphere.radius,
                             .anchor_field = SURE_FIELD_CENTRE};
    case SURE_SHAPE_CYLINDER:
        return (shape_parts){.anchor = &object->as.cylinder.base,
                             .end = &object->as.cylinder.top,
                             .radius = &object->as.cylinder.radius,
                             .anchor_field = SURE_FIELD_BASE,
                             .end_field = SURE_FIELD_TOP};
    case SURE_SHAPE_CONE:
        return (shape_parts){.anchor = &object->as.cone.base,
                             .end = &object->as.cone.apex,
                             .radius = &object->as.cone.radius,
                             .anchor_field = SURE_FIELD_BASE,
                             .end_field = SURE_FIELD_APEX};
    }
    abort();
}

static sure_field invalid_field(const sure_ray *ray, const shape_parts *parts)
{
    sure_field field = invalid_ray_field(ray);
    if (field != SURE_FIELD_NONE)
        return field;
    if (!vector_finite(parts->anchor))
        return parts->anchor_field;
    if (parts->axis && (!vector_finite(parts->axis) || vector_zero(parts->axis)))
        return SURE_FIELD_NORMAL;
    if (parts->end && (!vector_finite(parts->end) || vector_same(parts->end, parts->anchor)))
        return parts->end_field;
    return parts->radius && !is_radius(*parts->radius) ? SURE_FIELD_RADIUS : SURE_FIELD_NONE;
}

/* The ray and the object in integers: lengths count one power of two, the direction another and a
 * plane's or disc's normal a third. */
typedef struct {
    sure_shape shape;
    vector origin, direction, anchor, axis;
    mpz_t radius, axis_square;
    long shift;
} world;

static void lower_exponent(long *least, double value)
{
    long exponent;
    if (double_split(value, &exponent) != 0 && exponent < *least)
        *least = exponent;
}

static void lower_exponents(long *least, const sure_vec3 *v)
{
    lower_exponent(least, v->x);
    lower_exponent(least, v->y);
    lower_exponent(least, v->z);
}

static void vector_from(vector *out, const sure_vec3 *v, long exponent)
{
    integer_from(out->x[0], v->x, exponent);
    integer_from(out->x[1], v->y, exponent);
    integer_from(out->x[2], v->z, exponent);
}

static void direction_from(vector *out, const sure_vec3 *v, long *exponent)
{
    *exponent = LONG_MAX;
    lower_exponents(exponent, v);
    vector_from(out, v, *exponent);
}

static long unit_of_length(const sure_ray *ray, const shape_parts *parts)
{
    long unit = LONG_MAX;
    lower_exponents(&unit, &ray->origin);
    lower_exponents(&unit, parts->anchor);
    if (parts->end)
        lower_exponents(&unit, parts->end);
    if (parts->radius)
        lower_exponent(&unit, *parts->radius);
    return unit == LONG_MAX ? 0 : unit;
}

static void world_init(world *w, const sure_ray *ray, sure_shape shape, const shape_parts *parts)
{
    long unit = unit_of_length(ray, parts), unit_of_direction, ignored;
    vector_init(&w->origin);
    vector_init(&w->direction);
    vector_init(&w->anchor);
    vector_init(&w->axis);
    mpz_inits(w->radius, w->axis_square, (mpz_ptr)NULL);

    w->shape = shape;
    vector_from(&w->origin, &ray->origin, unit);
    direction_from(&w->direction, &ray->direction, &unit_of_direction);
    w->shift = unit - unit_of_direction;
    vector_from(&w->anchor, parts->anchor, unit);
    if (parts->radius)
        integer_from(w->radius, *parts->radius, unit);
    if (parts->axis)
        direction_from(&w->axis, parts->axis, &ignored);
    if (parts->end) {
        vector_from(&w->axis, parts->end, unit);
        vector_subtract(&w->axis, &w->axis, &w->anchor);
    }
    dot(w->axis_square, &w->axis, &w->axis);
}

static void world_clear(world *w)
{
    vector_clear(&w->origin);
    vector_clear(&w->direction);
    vector_clear(&w->anchor);
    vector_clear(&w->axis);
    mpz_clears(w->radius, w->axis_square, (mpz_ptr)NULL);
}

static bool is_flat(const world *w)
{
    return w->shape == SURE_SHAPE_PLANE || w->shape == SURE_SHAPE_DISC;
}

/* A.W, from 0 at the base to A^2 at the other end. */
static void height(const world *w, const vector *p, mpz_t out)
{
    vector offset;
    vector_init(&offset);
    vector_subtract(&offset, p, &w->anchor);
    dot(out, &w->axis, &offset);
    vector_clear(&offset);
}

static void distance_square(const vector *p, const vector *q, mpz_t out)
{
    vector offset;
    vector_init(&offset);
    vector_subtract(&offset, p, q);
    dot(out, &offset, &offset);
    vector_clear(&offset);
}

/* The function of the infinite body: not positive inside. */
static void body(const world *w, const vector *p, mpz_t out)
{
    mpz_t along, reach;
    mpz_inits(along, reach, (mpz_ptr)NULL);
    height(w, p, along);
    distance_square(p, &w->anchor, out);
    mpz_set(reach, w->radius);
    if (w->shape == SURE_SHAPE_CYLINDER || w->shape == SURE_SHAPE_CONE) {
        mpz_mul(out, out, w->axis_square);
        mpz_submul(out, along, along);
    }
    if (w->shape == SURE_SHAPE_CONE) {
        mpz_mul(out, out, w->axis_square);
        mpz_sub(along, w->axis_square, along);
        mpz_mul(reach, reach, along);
    }
    mpz_mul(reach, reach, reach);
    if (w->shape == SURE_SHAPE_CYLINDER)
        mpz_mul(reach, reach, w->axis_square);
    mpz_sub(out, out, reach);
    if (w->shape == SURE_SHAPE_PLANE)
        mpz_set_ui(out, 0);
    mpz_clears(along, reach, (mpz_ptr)NULL);
}

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
        mp_bitcnt_t power = w->shift > 0 ? (mp_bitcnt_t)w->shift * (degree - i)
                                         : (mp_bitcnt_t)-w->shift * i;
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
    body(w, &p, before);
    ray_point(w, 0, &p);
    body(w, &p, here);
    ray_point(w, 1, &p);
    body(w, &p, after);

    mpz_mul_si(out->term[0], here, 2);
    mpz_sub(out->term[1], after, before);
    mpz_add(out->term[2], after, before);
    mpz_sub(out->term[2], out->term[2], out->term[0]);
    substitute_t(w, out, 2);
    mpz_clears(before, here, after, (mpz_ptr)NULL);
    vector_clear(&p);
}

/* How far P is above the base and below the other end: a plane and a disc have both in one, a
 * sphere has neither. */
static void heights_on_line(const world *w, polynomial *above_base, polynomial *below_top)
{
    if (w->shape == SURE_SHAPE_SPHERE) {
        mpz_set_ui(above_base->term[0], 1);
        mpz_set_ui(below_top->term[0], 1);
        return;
    }
    vector p;
    vector_init(&p);
    ray_point(w, 0, &p);
    height(w, &p, above_base->term[0]);
    ray_point(w, 1, &p);
    height(w, &p, above_base->term[1]);
    mpz_sub(above_base->term[1], above_base->term[1], above_base->term[0]);
    vector_clear(&p);

    if (!is_flat(w))
        mpz_set(below_top->term[0], w->axis_square);
    mpz_sub(below_top->term[0], below_top->term[0], above_base->term[0]);
    mpz_neg(below_top->term[1], above_base->term[1]);
    substitute_t(w, above_base, 1);
    substitute_t(w, below_top, 1);
}

/* What of the ray's line belongs to the object. */
typedef struct {
    bool empty;
    bool endless; /* a line in a plane: no ends */
    bool solid;   /* meets the interior, so that its ends alone are boundary */
    location enter, leave;
} chord;

typedef struct {
    polynomial body, above_base, below_top;
    chord chord;
} line;

static void line_init(line *l)
{
    polynomial_init(&l->body);
    polynomial_init(&l->above_base);
    polynomial_init(&l->below_top);
    location_init(&l->chord.enter);
    location_init(&l->chord.leave);
    l->chord.empty = l->chord.endless = l->chord.solid = false;
}

static void line_clear(line *l)
{
    polynomial_clear(&l->body);
    polynomial_clear(&l->above_base);
    polynomial_clear(&l->below_top);
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

/* The crossings of the end planes. A line parallel to them has none: it is empty outside them
 * and endless in a plane (both false); otherwise its body is convex along it and two points
 * beyond its roots do. */
static bool outer_samples(line *l, fraction *low, fraction *high)
{
    if (mpz_sgn(l->above_base.term[1]) != 0) {
        bool rising = mpz_sgn(l->above_base.term[1]) > 0;
        crossing(rising ? low : high, &l->above_base);
        crossing(rising ? high : low, &l->below_top);
        return true;
    }
    if (mpz_sgn(l->above_base.term[0]) < 0 || mpz_sgn(l->below_top.term[0]) < 0)
        l->chord.empty = true;
    else if (mpz_sgn(l->body.term[2]) == 0)
        l->chord.endless = true;
    else
        far_points(low, high, &l->body);
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

/* The line has points strictly between the end planes. */
static bool between_ends(const world *w, const line *l)
{
    if (mpz_sgn(l->above_base.term[1]) != 0)
        return !is_flat(w);
    return mpz_sgn(l->above_base.term[0]) > 0 && mpz_sgn(l->below_top.term[0]) > 0;
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
static void find_chord(const world *w, line *l)
{
    fraction sample[3];
    int sign[3];
    for (int i = 0; i < 3; i++)
        fraction_init(&sample[i]);
    if (outer_samples(l, &sample[0], &sample[2])) {
        middle_sample(&l->body, &sample[0], &sample[2], &sample[1]);
        for (int i = 0; i < 3; i++) {
            sign[i] = polynomial_sign(&l->body, &sample[i]);
            l->chord.solid = l->chord.solid || (sign[i] < 0 && between_ends(w, l));
        }
        l->chord.empty = !find_end(&l->chord.enter, &l->body, sample, sign, 0, 1) ||
                         !find_end(&l->chord.leave, &l->body, sample, sign, 2, -1);
    }
    for (int i = 0; i < 3; i++)
        fraction_clear(&sample[i]);
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

static sure_part part_at(const world *w, const line *l, const location *t)
{
    if (w->shape != SURE_SHAPE_CYLINDER && w->shape != SURE_SHAPE_CONE)
        return SURE_PART_SURFACE;
    if (location_sign(t, &l->above_base) == 0)
        return SURE_PART_BASE;
    bool at_end = location_sign(t, &l->below_top) == 0;
    return at_end && w->shape == SURE_SHAPE_CYLINDER ? SURE_PART_TOP : SURE_PART_WALL;
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
    body(w, &p, behind);
    mpz_add_ui(p.x[axis], p.x[axis], 2);
    body(w, &p, out);
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
static void outward(const world *w, const line *l, sure_part part, const location *t,
                    moving_vector *out)
{
    bool apex = w->shape == SURE_SHAPE_CONE && location_sign(t, &l->below_top) == 0;
    if (is_flat(w) || part == SURE_PART_TOP || apex)
        set_constant(out, &w->axis, 1);
    else if (part == SURE_PART_BASE)
        set_constant(out, &w->axis, -1);
    else if (mpz_sgn(w->radius) == 0)
        set_constant(out, &w->direction, -1);
    else
        set_gradient(out, w);
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

static sure_vec3 normal_at(const world *w, const line *l, sure_part part, const location *t)
{
    moving_vector v;
    for (int i = 0; i < 3; i++)
        polynomial_init(&v.x[i]);
    outward(w, l, part, t, &v);
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
    shape_parts parts = parts_of(object);
    sure_field field = invalid_field(ray, &parts);
    if (field != SURE_FIELD_NONE)
        return field;
    world_init(&q->world, ray, object->shape, &parts);
    line_init(&q->line);
    range_init(&q->range, ray);
    body_on_line(&q->world, &q->line.body);
    heights_on_line(&q->world, &q->line.above_base, &q->line.below_top);
    find_chord(&q->world, &q->line);
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
        result->normal = normal_at(&q.world, &q.line, result->part, &hit);
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
