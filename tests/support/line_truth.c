#include "line_truth.h"

#include <assert.h>
#include <limits.h>
#include <math.h>

/* Exact integers. All that a case needs are taken from one pool, emptied when the next case begins. */
typedef mpz_ptr whole;

static struct {
    __mpz_struct number[256];
    int made, used;
} pool;

static whole fresh(void)
{
    assert(pool.used < 256);
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

static whole neg(whole a)
{
    whole r = fresh();
    mpz_neg(r, a);
    return r;
}

static whole of_int(long n)
{
    whole r = fresh();
    mpz_set_si(r, n);
    return r;
}

static whole square(whole a)
{
    return mul(a, a);
}

static int sign(whole a)
{
    return mpz_sgn(a);
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

/* Zero exactly when a and b are parallel (or one is zero): a.a b.b - (a.b)^2. */
static whole not_parallel(whole_vec a, whole_vec b)
{
    return sub(mul(dot(a, a), dot(b, b)), square(dot(a, b)));
}

/* Doubles as integers. */

/* x = m 2^e with integer m, |m| < 2^53. */
static int exponent_of(double x)
{
    int e;
    return x == 0 || !isfinite(x) ? INT_MAX : (frexp(x, &e), e - 53);
}

static int least_exponent(const double *x, int count, int least)
{
    for (int i = 0; i < count; i++)
        if (exponent_of(x[i]) < least)
            least = exponent_of(x[i]);
    return least;
}

/* x / 2^unit, an integer. */
static whole in_units(double x, int unit)
{
    whole r = fresh();
    int e = 0;
    mpz_set_d(r, frexp(x, &e) * 0x1p53);
    if (mpz_sgn(r) != 0) {
        assert(e - 53 >= unit);
        mpz_mul_2exp(r, r, (mp_bitcnt_t)(e - 53 - unit));
    }
    return r;
}

static whole_vec vec_in_units(const double v[3], int unit)
{
    return (whole_vec){in_units(v[0], unit), in_units(v[1], unit), in_units(v[2], unit)};
}

/* A case in integers: lengths in one unit, d in another, normals in a third, t in that of lengths over that of d. */
typedef struct {
    sure_shape shape;
    whole_vec w; /* o - place */
    whole_vec d;
    whole_vec n; /* the normal, or from the base to the other end */
    whole r, t_min, t_max;
    bool unbounded; /* t_max = +inf */
    int t_unit;
} exact_case;

static bool has_axis(sure_shape shape)
{
    return shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
}

static bool has_radius(sure_shape shape)
{
    return shape != SURE_SHAPE_PLANE;
}

static exact_case exact_case_of(sure_shape shape, const double number[CASE_NUMBERS_MAX])
{
    const double *o = number, *d = number + 3, *t = number + 6, *place = number + 8;
    const double *second = number + 11;
    double r = has_radius(shape) ? number[case_numbers(shape) - 1] : 0;
    int d_unit = least_exponent(d, 3, INT_MAX);
    int unit = least_exponent(place, 3, least_exponent(o, 3, least_exponent(&r, 1, 1023)));
    if (has_axis(shape))
        unit = least_exponent(second, 3, unit);
    /* Fine enough for the ends of the range, too. */
    int t_least = least_exponent(t, 2, INT_MAX);
    if (t_least != INT_MAX && t_least + d_unit < unit)
        unit = t_least + d_unit;
    exact_case x = {.shape = shape, .t_unit = unit - d_unit, .unbounded = isinf(t[1])};
    x.w = vec_sub(vec_in_units(o, unit), vec_in_units(place, unit));
    x.d = vec_in_units(d, d_unit);
    if (has_axis(shape))
        x.n = vec_sub(vec_in_units(second, unit), vec_in_units(place, unit));
    else if (shape != SURE_SHAPE_SPHERE)
        x.n = vec_in_units(second, least_exponent(second, 3, INT_MAX));
    else
        x.n = (whole_vec){of_int(0), of_int(0), of_int(1)};
    x.r = in_units(r, unit);
    x.t_min = in_units(t[0], x.t_unit);
    x.t_max = x.unbounded ? of_int(0) : in_units(t[1], x.t_unit);
    return x;
}

/* Where the line is in a convex set: two ends, each a rational n / m, a root of the quadratic or without limit. */

typedef struct {
    whole a, half_b, c, discriminant;
} quadratic;

typedef enum { BELOW_ALL, RATIONAL, ROOT, ABOVE_ALL } end_kind;

typedef struct {
    end_kind kind;
    whole n, m;   /* n / m, m > 0 */
    quadratic q;  /* (-half_b + side sqrt(discriminant)) / a */
    int side;
} end;

typedef struct {
    bool empty;
    end low, high;
} part_of_line;

static const part_of_line nothing = {.empty = true};
static const part_of_line everything = {.low = {.kind = BELOW_ALL}, .high = {.kind = ABOVE_ALL}};

static end rational(whole n, whole m)
{
    return sign(m) < 0 ? (end){.kind = RATIONAL, .n = neg(n), .m = neg(m)}
                       : (end){.kind = RATIONAL, .n = n, .m = m};
}

/* The sign of u + v sqrt(root), root >= 0. */
static int surd_sign(whole u, whole v, whole root)
{
    int su = sign(u), sv = sign(root) == 0 ? 0 : sign(v);
    if (su == 0 || sv == 0 || su == sv)
        return su != 0 ? su : sv;
    return su * sign(sub(square(u), mul(square(v), root)));
}

/* The sign of e - n / m, m > 0. */
static int against(const end *e, whole n, whole m)
{
    switch (e->kind) {
    case BELOW_ALL:
        return -1;
    case ABOVE_ALL:
        return 1;
    case RATIONAL:
        return sign(sub(mul(e->n, m), mul(n, e->m)));
    default:
        break;
    }
    whole u = neg(add(mul(e->q.half_b, m), mul(n, e->q.a)));
    whole v = mul(of_int(e->side), m);
    return sign(e->q.a) * surd_sign(u, v, e->q.discriminant);
}

/* The sign of a - b, of which one at least is not a root. */
static int order(const end *a, const end *b)
{
    if (b->kind == BELOW_ALL)
        return a->kind == BELOW_ALL ? 0 : 1;
    if (b->kind == ABOVE_ALL)
        return a->kind == ABOVE_ALL ? 0 : -1;
    if (b->kind == RATIONAL)
        return against(a, b->n, b->m);
    return -order(b, a);
}

/* n + t m >= 0 */
static part_of_line half_line(whole n, whole m)
{
    if (sign(m) == 0)
        return sign(n) >= 0 ? everything : nothing;
    part_of_line part = everything;
    *(sign(m) > 0 ? &part.low : &part.high) = rational(neg(n), m);
    return part;
}

/* Between the planes of base and top: 0 <= height + t slope <= full. */
static part_of_line between_planes(whole height, whole slope, whole full)
{
    part_of_line above = half_line(height, slope);
    part_of_line below = half_line(sub(full, height), neg(slope));
    if (above.empty || below.empty)
        return nothing;
    if (sign(slope) > 0)
        return (part_of_line){.low = above.low, .high = below.high};
    return (part_of_line){.low = below.low, .high = above.high};
}

/* a t^2 + 2 half_b t + c <= 0; of the two parts of a double cone (a < 0) the one that lies where the height
 * falls below that of the apex. */
static part_of_line in_round_body(const quadratic *q, int slope)
{
    if (sign(q->a) == 0 && sign(q->half_b) == 0)
        return sign(q->c) <= 0 ? everything : nothing;
    if (sign(q->a) == 0)
        return half_line(neg(q->c), mul(of_int(-2), q->half_b));
    if (sign(q->discriminant) < 0)
        return nothing;
    end low = {.kind = ROOT, .q = *q, .side = -sign(q->a)};
    end high = {.kind = ROOT, .q = *q, .side = sign(q->a)};
    if (sign(q->a) > 0)
        return (part_of_line){.low = low, .high = high};
    part_of_line part = everything;
    *(slope > 0 ? &part.high : &part.low) = slope > 0 ? low : high;
    return part;
}

static quadratic quadratic_of(whole a, whole half_b, whole c)
{
    return (quadratic){a, half_b, c, sub(square(half_b), mul(a, c))};
}

/* The products of which all is made. */
typedef struct {
    whole dd, wd, ww, slope, height, full, rr;
} products;

static products products_of(const exact_case *x)
{
    return (products){dot(x->d, x->d), dot(x->w, x->d), dot(x->w, x->w), dot(x->d, x->n),
                      dot(x->w, x->n), dot(x->n, x->n), square(x->r)};
}

static quadratic ball(const products *p)
{
    return quadratic_of(p->dd, p->wd, sub(p->ww, p->rr));
}

/* Square of the distance from the axis <= r^2, times the axis's own square. */
static quadratic infinite_cylinder(const products *p)
{
    return quadratic_of(sub(mul(p->dd, p->full), square(p->slope)),
                        sub(mul(p->wd, p->full), mul(p->height, p->slope)),
                        sub(mul(sub(p->ww, p->rr), p->full), square(p->height)));
}

/* The same against r^2 (1 - height / full)^2, times the axis's square once more. */
static quadratic double_cone(const products *p)
{
    whole left = sub(p->full, p->height);
    quadratic axis = infinite_cylinder(
        &(products){p->dd, p->wd, p->ww, p->slope, p->height, p->full, of_int(0)});
    return quadratic_of(sub(mul(axis.a, p->full), mul(p->rr, square(p->slope))),
                        add(mul(axis.half_b, p->full), mul(p->rr, mul(left, p->slope))),
                        sub(mul(axis.c, p->full), mul(p->rr, square(left))));
}

static quadratic round_body(sure_shape shape, const products *p)
{
    switch (shape) {
    case SURE_SHAPE_CYLINDER:
        return infinite_cylinder(p);
    case SURE_SHAPE_CONE:
        return double_cone(p);
    default:
        return ball(p);
    }
}

/* The object's part of the line: the overlap of two, of which at most one has roots for ends. */
typedef struct {
    part_of_line round, flat;
} overlap;

static overlap overlap_of(sure_shape shape, const products *p, const quadratic *q)
{
    overlap both = {everything, everything};
    if (has_radius(shape))
        both.round = in_round_body(q, sign(p->slope));
    if (has_axis(shape))
        both.flat = between_planes(p->height, p->slope, p->full);
    else if (shape != SURE_SHAPE_SPHERE)
        both.flat = between_planes(p->height, p->slope, of_int(0));
    return both;
}

static bool no_overlap(const overlap *x)
{
    return x->round.empty || x->flat.empty || order(&x->flat.low, &x->flat.high) > 0 ||
           order(&x->round.low, &x->flat.high) > 0 || order(&x->flat.low, &x->round.high) > 0;
}

/* Does the line run inside the object, or only along its boundary? */
static bool meets_interior(const overlap *x, sure_shape shape, const products *p,
                           const quadratic *q)
{
    if (shape == SURE_SHAPE_PLANE || shape == SURE_SHAPE_DISC)
        return false;
    bool point = sign(q->a) > 0 && sign(q->discriminant) == 0;
    bool on_wall = sign(q->a) == 0 && sign(q->half_b) == 0 && sign(q->c) == 0;
    if (point || on_wall)
        return false;
    if (shape == SURE_SHAPE_SPHERE)
        return true;
    bool in_cap = sign(p->slope) == 0 &&
                  (sign(p->height) == 0 || sign(sub(p->height, p->full)) == 0);
    return !in_cap && order(&x->flat.low, &x->flat.high) < 0 &&
           order(&x->round.low, &x->flat.high) < 0 && order(&x->flat.low, &x->round.high) < 0;
}

static bool hit(const exact_case *x, const overlap *o, bool interior)
{
    whole one = of_int(1);
    bool low_from = against(&o->round.low, x->t_min, one) >= 0 ||
                    against(&o->flat.low, x->t_min, one) >= 0;
    bool low_to = x->unbounded || (against(&o->round.low, x->t_max, one) <= 0 &&
                                   against(&o->flat.low, x->t_max, one) <= 0);
    bool high_from = against(&o->round.high, x->t_min, one) >= 0 &&
                     against(&o->flat.high, x->t_min, one) >= 0;
    bool high_to = x->unbounded || against(&o->round.high, x->t_max, one) <= 0 ||
                   against(&o->flat.high, x->t_max, one) <= 0;
    return interior ? (low_from && low_to) || (high_from && high_to) : low_to && high_from;
}

/* Does the line meet the circle of radius r in the plane height + t slope = 0 around the point from which
 * the start is w away? */
static bool meets_circle(whole_vec w, const exact_case *x, whole slope, whole height)
{
    if (sign(slope) != 0) {
        whole_vec at = vec_sub(vec_mul(slope, w), vec_mul(height, x->d));
        return sign(sub(dot(at, at), mul(square(x->r), square(slope)))) == 0;
    }
    if (sign(height) != 0)
        return false;
    quadratic circle =
        quadratic_of(dot(x->d, x->d), dot(w, x->d), sub(dot(w, w), square(x->r)));
    return sign(circle.discriminant) >= 0;
}

static bool finite(const double *v)
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

static bool zero(const double *v)
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

static sure_field first_bad_field(sure_shape shape, const double number[CASE_NUMBERS_MAX])
{
    static const sure_field place[SURE_SHAPES] = {SURE_FIELD_POINT, SURE_FIELD_CENTRE,
                                                  SURE_FIELD_CENTRE, SURE_FIELD_BASE,
                                                  SURE_FIELD_BASE};
    static const sure_field second[SURE_SHAPES] = {SURE_FIELD_NORMAL, SURE_FIELD_NORMAL,
                                                   SURE_FIELD_NONE, SURE_FIELD_TOP,
                                                   SURE_FIELD_APEX};
    const double *p = number + 8, *q = number + 11;
    if (!finite(number))
        return SURE_FIELD_O;
    if (!finite(number + 3) || zero(number + 3))
        return SURE_FIELD_D;
    if (!isfinite(number[6]) || number[6] < 0)
        return SURE_FIELD_T_MIN;
    if (!(number[6] <= number[7]))
        return SURE_FIELD_T_MAX;
    if (!finite(p))
        return place[shape];
    if (second[shape] == SURE_FIELD_NORMAL && (!finite(q) || zero(q)))
        return SURE_FIELD_NORMAL;
    if (has_axis(shape) && (!finite(q) || (p[0] == q[0] && p[1] == q[1] && p[2] == q[2])))
        return second[shape];
    double r = number[case_numbers(shape) - 1];
    return has_radius(shape) && !(isfinite(r) && r >= 0) ? SURE_FIELD_RADIUS : SURE_FIELD_NONE;
}

static void set_signs(line_truth *truth, const exact_case *x, const products *p,
                      const quadratic *q)
{
    whole over = sub(p->height, p->full);
    truth->a = sign(q->a);
    truth->half_b = sign(q->half_b);
    truth->c = sign(q->c);
    truth->discriminant = sign(q->discriminant);
    truth->slope = sign(p->slope);
    truth->height = sign(p->height);
    truth->height_over_end = sign(over);
    whole_vec from_end = vec_sub(x->w, x->n);
    truth->meets_base_rim = meets_circle(x->w, x, p->slope, p->height);
    truth->meets_end_rim = has_axis(x->shape) && meets_circle(from_end, x, p->slope, over);
    truth->meets_apex = has_axis(x->shape) && sign(not_parallel(from_end, x->d)) == 0;
    truth->along_axis = sign(not_parallel(x->n, x->d)) == 0;
}

line_truth line_truth_of(const sure_case *question)
{
    sure_shape shape = question->object.shape;
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(question, number);
    line_truth truth = {.invalid = first_bad_field(shape, number), .status = SURE_INVALID};
    if (truth.invalid != SURE_FIELD_NONE)
        return truth;
    pool.used = 0;
    exact_case x = exact_case_of(shape, number);
    products p = products_of(&x);
    quadratic q = round_body(shape, &p);
    overlap both = overlap_of(shape, &p, &q);
    truth.status = SURE_MISS;
    if (!no_overlap(&both) && hit(&x, &both, meets_interior(&both, shape, &p, &q)))
        truth.status = SURE_HIT;
    set_signs(&truth, &x, &p, &q);
    return truth;
}

/* A rational end's n / m; a root becomes one where its discriminant is a square. */
static int rational_value(const end *e, mpq_t value)
{
    whole n = e->n, m = e->m;
    if (e->kind == ROOT) {
        if (!mpz_perfect_square_p(e->q.discriminant))
            return 0;
        whole root = fresh();
        mpz_sqrt(root, e->q.discriminant);
        n = sub(mul(of_int(e->side), root), e->q.half_b);
        m = e->q.a;
    } else if (e->kind != RATIONAL) {
        return 0;
    }
    mpq_set_num(value, n);
    mpq_set_den(value, m);
    mpq_canonicalize(value);
    return 1;
}

int line_truth_entry(const sure_case *question, mpq_t t)
{
    sure_shape shape = question->object.shape;
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(question, number);
    pool.used = 0;
    exact_case x = exact_case_of(shape, number);
    products p = products_of(&x);
    quadratic q = round_body(shape, &p);
    overlap both = overlap_of(shape, &p, &q);
    if (no_overlap(&both))
        return 0;
    const end *first = both.flat.low.kind == BELOW_ALL ||
                               order(&both.round.low, &both.flat.low) > 0
                           ? &both.round.low
                           : &both.flat.low;
    if (!rational_value(first, t))
        return 0;
    if (x.t_unit >= 0)
        mpq_mul_2exp(t, t, (mp_bitcnt_t)x.t_unit);
    else
        mpq_div_2exp(t, t, (mp_bitcnt_t)-x.t_unit);
    return 1;
}
