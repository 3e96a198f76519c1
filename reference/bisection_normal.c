/* SPDX-License-Identifier: MIT */
/* The normal of an object: its body's gradient, read off values, or a plane's; each component of
 * the unit vector is rounded by bisection. */
#include "bisection_line.h"

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

/* component / sqrt(whole) at t, which are polynomials there. */
typedef struct {
    const polynomial *component;
    const polynomial *square; /* component^2 */
    const polynomial *whole;
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

/* Where component and y are of one sign, that of component^2 - y^2 whole, which is a quadratic. */
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
    mpz_mul(weight, y->den, y->den);
    for (int i = 0; i < 3; i++)
        mpz_mul(difference.term[i], u->square->term[i], weight);
    mpz_mul(weight, y->num, y->num);
    for (int i = 0; i < 3; i++)
        mpz_submul(difference.term[i], weight, u->whole->term[i]);
    sign *= location_sign(u->t, &difference);
    mpz_clear(weight);
    polynomial_clear(&difference);
    return sign;
}

static sure_vec3 unit_vector(const moving_vector *v, const location *t)
{
    polynomial whole, square[3];
    double x[3];
    polynomial_init(&whole);
    for (int i = 0; i < 3; i++) {
        polynomial_init(&square[i]);
        add_square(&square[i], &v->x[i]);
        add_square(&whole, &v->x[i]);
    }
    for (int i = 0; i < 3; i++) {
        unit_component u = {&v->x[i], &square[i], &whole, t};
        x[i] = nearest_double(compare_unit_component, &u);
        polynomial_clear(&square[i]);
    }
    polynomial_clear(&whole);
    return (sure_vec3){x[0], x[1], x[2]};
}

sure_vec3 normal_at(const world *w, const line *l, const location *t)
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
