#include "line_signs.h"

#include <assert.h>
#include <limits.h>
#include <math.h>

#include <gmp.h>

/* Exact integers. All that a case needs are taken from one pool, emptied when the next case
 * begins. */
typedef mpz_ptr whole;

static struct {
    __mpz_struct number[192];
    int made, used;
} pool;

static whole fresh(void)
{
    assert(pool.used < 192);
    if (pool.used == pool.made)
        mpz_init(&pool.number[pool.made++]);
    return &pool.number[pool.used++];
}

static whole add(whole a, whole b)
{
    whole r = fresh();
    mpz_add(r, a, b);
    return r;
}

static whole sub(whole a, whole b)
{
    whole r = fresh();
    mpz_sub(r, a, b);
    return r;
}

static whole mul(whole a, whole b)
{
    whole r = fresh();
    mpz_mul(r, a, b);
    return r;
}

static whole square(whole a)
{
    return mul(a, a);
}

typedef struct {
    whole x, y, z;
} whole_vec;

static whole_vec vec_sub(whole_vec a, whole_vec b)
{
    return (whole_vec){sub(a.x, b.x), sub(a.y, b.y), sub(a.z, b.z)};
}

static whole_vec vec_mul(whole k, whole_vec a)
{
    return (whole_vec){mul(k, a.x), mul(k, a.y), mul(k, a.z)};
}

static whole dot(whole_vec a, whole_vec b)
{
    return add(add(mul(a.x, b.x), mul(a.y, b.y)), mul(a.z, b.z));
}

static bool parallel(whole_vec a, whole_vec b)
{
    return mpz_cmp(mul(dot(a, a), dot(b, b)), square(dot(a, b))) == 0;
}

/* An e with all numbers multiples of 2^e, no more than `most`. */
static int common_exponent(const double *x, int count, int most)
{
    for (int i = 0; i < count; i++) {
        int e;
        if (frexp(x[i], &e) != 0 && e - 53 < most)
            most = e - 53;
    }
    return most;
}

/* m 2^exponent / 2^unit, an integer. */
static whole in_units(double m, int exponent, int unit)
{
    whole r = fresh();
    assert(m == 0 || exponent >= unit);
    mpz_set_d(r, m);
    if (m != 0)
        mpz_mul_2exp(r, r, (mp_bitcnt_t)(exponent - unit));
    return r;
}

static whole double_in_units(double x, int unit)
{
    int e;
    double m = frexp(x, &e);
    return in_units(m * 0x1p53, e - 53, unit);
}

static whole_vec vec_in_units(const double v[3], int unit)
{
    return (whole_vec){double_in_units(v[0], unit), double_in_units(v[1], unit),
                       double_in_units(v[2], unit)};
}

/* A case in integers: lengths in one unit, d in another, normals in a third, t in that of lengths
 * over that of d. */
typedef struct {
    sure_shape shape;
    whole_vec w; /* o - place */
    whole_vec d;
    whole_vec n; /* the normal, or the way from the base to the other end; of a sphere zero */
    whole r;
    int t_unit;
} exact_case;

static bool has_axis(sure_shape shape)
{
    return shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
}

/* So that t = m 2^t_exponent is an integer, too. */
static exact_case exact_case_of(const sure_case *valid, int t_exponent)
{
    static const double none[3] = {0, 0, 0};
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(valid, number);
    sure_shape shape = valid->object.shape;
    const double *o = number, *d = number + 3, *place = number + 8;
    const double *second = shape == SURE_SHAPE_SPHERE ? none : number + 11;
    const double *r = shape == SURE_SHAPE_PLANE ? none : number + case_numbers(shape) - 1;
    int d_unit = common_exponent(d, 3, INT_MAX);
    int unit = common_exponent(r, 1, t_exponent + d_unit);
    unit = common_exponent(place, 3, common_exponent(o, 3, unit));
    if (has_axis(shape))
        unit = common_exponent(second, 3, unit);
    pool.used = 0;
    exact_case x = {.shape = shape, .t_unit = unit - d_unit};
    x.w = vec_sub(vec_in_units(o, unit), vec_in_units(place, unit));
    x.d = vec_in_units(d, d_unit);
    x.r = double_in_units(*r, unit);
    if (has_axis(shape))
        x.n = vec_sub(vec_in_units(second, unit), vec_in_units(place, unit));
    else
        x.n = vec_in_units(second, common_exponent(second, 3, 0));
    return x;
}

/* The products of w and d from which all follows. */
typedef struct {
    whole dd, wd, ww, slope, height, full, rr;
} products;

static products products_of(const exact_case *x)
{
    return (products){dot(x->d, x->d), dot(x->w, x->d), dot(x->w, x->w), dot(x->d, x->n),
                      dot(x->w, x->n), dot(x->n, x->n), square(x->r)};
}

typedef struct {
    whole a, half_b, c;
} quadratic;

/* |w + t d|^2 - r^2 */
static quadratic ball(const products *p)
{
    return (quadratic){p->dd, p->wd, sub(p->ww, p->rr)};
}

/* The square of the distance from the axis, without r^2, times n^2. */
static quadratic around_axis(const products *p)
{
    return (quadratic){sub(mul(p->dd, p->full), square(p->slope)),
                       sub(mul(p->wd, p->full), mul(p->height, p->slope)),
                       sub(mul(p->ww, p->full), square(p->height))};
}

static quadratic cylinder(const products *p)
{
    quadratic q = around_axis(p);
    return (quadratic){q.a, q.half_b, sub(q.c, mul(p->rr, p->full))};
}

/* That times n^2 once more, against r^2 (n^2 - height)^2. */
static quadratic cone(const products *p)
{
    quadratic q = around_axis(p);
    whole left = sub(p->full, p->height);
    return (quadratic){sub(mul(q.a, p->full), mul(p->rr, square(p->slope))),
                       add(mul(q.half_b, p->full), mul(p->rr, mul(left, p->slope))),
                       sub(mul(q.c, p->full), mul(p->rr, square(left)))};
}

static quadratic round_body(sure_shape shape, const products *p)
{
    return shape == SURE_SHAPE_CYLINDER ? cylinder(p)
           : shape == SURE_SHAPE_CONE   ? cone(p)
                                        : ball(p);
}

static whole discriminant(const quadratic *q)
{
    return sub(square(q->half_b), mul(q->a, q->c));
}

/* Does the line meet the circle of radius r in the plane height + t slope = 0, around the point
 * from which the start is w away? */
static bool meets_circle(const exact_case *x, whole_vec w, whole slope, whole height)
{
    if (mpz_sgn(slope) != 0) {
        whole_vec at = vec_sub(vec_mul(slope, w), vec_mul(height, x->d));
        return mpz_cmp(dot(at, at), square(mul(x->r, slope))) == 0;
    }
    quadratic circle = {dot(x->d, x->d), dot(w, x->d), sub(dot(w, w), square(x->r))};
    return mpz_sgn(height) == 0 && mpz_sgn(discriminant(&circle)) >= 0;
}

line_signs line_signs_of(const sure_case *valid)
{
    exact_case x = exact_case_of(valid, 0);
    products p = products_of(&x);
    quadratic q = round_body(x.shape, &p);
    line_signs signs = {
        .a = mpz_sgn(q.a),
        .discriminant = mpz_sgn(discriminant(&q)),
        .slope = mpz_sgn(p.slope),
        .along_axis = parallel(x.n, x.d),
        .meets_base_rim = meets_circle(&x, x.w, p.slope, p.height),
    };
    if (has_axis(x.shape)) {
        whole_vec from_end = vec_sub(x.w, x.n);
        signs.meets_end_rim = meets_circle(&x, from_end, p.slope, sub(p.height, p.full));
        signs.meets_apex = parallel(from_end, x.d);
    }
    return signs;
}

point_signs point_signs_at(const sure_case *valid, int64_t m, int exponent)
{
    exact_case x = exact_case_of(valid, exponent);
    products p = products_of(&x);
    quadratic q = round_body(x.shape, &p);
    assert(m >= -(INT64_C(1) << 54) && m <= INT64_C(1) << 54);
    /* In two halves, since a double holds 53 digits only. */
    whole t = add(in_units((double)(m / 2), exponent + 1, x.t_unit),
                  in_units((double)(m % 2), exponent, x.t_unit));
    whole height = add(p.height, mul(t, p.slope));
    return (point_signs){
        .round = mpz_sgn(add(mul(t, add(mul(t, q.a), add(q.half_b, q.half_b))), q.c)),
        .height = mpz_sgn(height),
        .over_end = mpz_sgn(sub(height, p.full)),
    };
}
