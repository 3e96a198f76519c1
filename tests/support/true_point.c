/* All points of the line that can be a hit (the ray's start, the crossings of the end planes, the
 * roots of the body's quadratic) are computed; those whose t rounds as the reference's does are
 * taken, and have to agree. */
#include "true_point.h"

#include "../../reference/reference.h"

#include <mpfr.h>

/* A coordinate of a hit is a root of a polynomial of degree at most 2 in it whose coefficients are
 * sums of products of at most 16 doubles, that is multiples of 2^-(16 * 1074) below 2^(16 * 1026):
 * what is not 0 is above 2^-ZERO in magnitude. Discriminants, of degree 12 to 14, are exact. */
enum { BITS = 80000, ZERO = 40000, ROUNDED = 8000, CANDIDATES = 5 };

typedef mpfr_t triple[3];

static void triple_init(triple v)
{
    for (int i = 0; i < 3; i++)
        mpfr_init2(v[i], BITS);
}

static void triple_clear(triple v)
{
    for (int i = 0; i < 3; i++)
        mpfr_clear(v[i]);
}

/* to - from */
static void between(triple v, sure_vec3 from, sure_vec3 to)
{
    const double a[3] = {from.x, from.y, from.z}, b[3] = {to.x, to.y, to.z};
    for (int i = 0; i < 3; i++) {
        mpfr_set_d(v[i], b[i], MPFR_RNDN);
        mpfr_sub_d(v[i], v[i], a[i], MPFR_RNDN);
    }
}

static void dot(mpfr_t out, triple v, triple w)
{
    mpfr_t term;
    mpfr_init2(term, BITS);
    mpfr_mul(out, v[0], w[0], MPFR_RNDN);
    for (int i = 1; i < 3; i++) {
        mpfr_mul(term, v[i], w[i], MPFR_RNDN);
        mpfr_add(out, out, term, MPFR_RNDN);
    }
    mpfr_clear(term);
}

static void cross(triple out, triple v, triple w)
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpfr_fmms(out[i], v[j], w[k], v[k], w[j], MPFR_RNDN);
    }
}

/* The points of the line that may be the hit. */
typedef struct {
    mpfr_t t[CANDIDATES];
    int count;
} candidates;

static void add_quotient(candidates *found, mpfr_t n, mpfr_t d)
{
    if (mpfr_zero_p(d) == 0)
        mpfr_div(found->t[found->count++], n, d, MPFR_RNDN);
}

/* The roots of a t^2 + 2 b t + c. */
static void add_roots(candidates *found, mpfr_t a, mpfr_t b, mpfr_t c)
{
    mpfr_t x, root;
    mpfr_inits2(BITS, x, root, (mpfr_ptr)NULL);
    if (mpfr_zero_p(a)) {
        mpfr_neg(x, c, MPFR_RNDN);
        mpfr_mul_2ui(root, b, 1, MPFR_RNDN);
        add_quotient(found, x, root);
    } else {
        mpfr_fmms(root, b, b, a, c, MPFR_RNDN);
        if (mpfr_sgn(root) >= 0) {
            mpfr_sqrt(root, root, MPFR_RNDN);
            mpfr_sub(x, root, b, MPFR_RNDN);
            add_quotient(found, x, a);
            mpfr_add(x, root, b, MPFR_RNDN);
            mpfr_neg(x, x, MPFR_RNDN);
            add_quotient(found, x, a);
        }
    }
    mpfr_clears(x, root, (mpfr_ptr)NULL);
}

/* N.(q - o) / N.d */
static void add_plane(candidates *found, const sure_ray *ray, triple normal, sure_vec3 q)
{
    triple d, m;
    mpfr_t n, speed;
    const sure_vec3 zero = {0, 0, 0};
    triple_init(d);
    triple_init(m);
    mpfr_inits2(BITS, n, speed, (mpfr_ptr)NULL);
    between(d, zero, ray->direction);
    between(m, ray->origin, q);
    dot(n, normal, m);
    dot(speed, normal, d);
    add_quotient(found, n, speed);
    mpfr_clears(n, speed, (mpfr_ptr)NULL);
    triple_clear(d);
    triple_clear(m);
}

/* |v + t w|^2 scale = bound, the body that every curved surface and circle is: with extra terms
 * -k (p + t q)^2 for a cone. */
typedef struct {
    triple v, w;
    mpfr_t scale, bound, k, p, q;
} body;

static void body_init(body *f)
{
    triple_init(f->v);
    triple_init(f->w);
    mpfr_inits2(BITS, f->scale, f->bound, f->k, f->p, f->q, (mpfr_ptr)NULL);
    mpfr_set_ui(f->scale, 1, MPFR_RNDN);
    mpfr_set_zero(f->bound, 1);
    mpfr_set_zero(f->k, 1);
    mpfr_set_zero(f->p, 1);
    mpfr_set_zero(f->q, 1);
}

static void body_clear(body *f)
{
    triple_clear(f->v);
    triple_clear(f->w);
    mpfr_clears(f->scale, f->bound, f->k, f->p, f->q, (mpfr_ptr)NULL);
}

/* scale v.w - k p q */
static void coefficient(mpfr_t out, body *f, triple v, triple w, mpfr_t p, mpfr_t q)
{
    mpfr_t term;
    mpfr_init2(term, BITS);
    dot(out, v, w);
    mpfr_mul(term, p, q, MPFR_RNDN);
    mpfr_fmms(out, out, f->scale, f->k, term, MPFR_RNDN);
    mpfr_clear(term);
}

static void add_body(candidates *found, body *f)
{
    mpfr_t a, b, c;
    mpfr_inits2(BITS, a, b, c, (mpfr_ptr)NULL);
    coefficient(a, f, f->w, f->w, f->q, f->q);
    coefficient(b, f, f->v, f->w, f->p, f->q);
    coefficient(c, f, f->v, f->v, f->p, f->p);
    mpfr_sub(c, c, f->bound, MPFR_RNDN);
    add_roots(found, a, b, c);
    mpfr_clears(a, b, c, (mpfr_ptr)NULL);
}

static void square_of(mpfr_t out, double x)
{
    mpfr_set_d(out, x, MPFR_RNDN);
    mpfr_sqr(out, out, MPFR_RNDN);
}

static void add_ball(candidates *found, const sure_ray *ray, sure_vec3 centre, double radius)
{
    const sure_vec3 zero = {0, 0, 0};
    body f;
    body_init(&f);
    between(f.v, centre, ray->origin);
    between(f.w, zero, ray->direction);
    square_of(f.bound, radius);
    add_body(found, &f);
    body_clear(&f);
}

/* |A x (m + t d)|^2 = r^2 H, or H |A x (m + t d)|^2 = r^2 (A.(m + t d))^2 */
static void add_wall(candidates *found, const sure_ray *ray, sure_vec3 from, sure_vec3 to,
                     double radius, bool tapers)
{
    const sure_vec3 zero = {0, 0, 0};
    triple axis, m, d;
    body f;
    triple_init(axis);
    triple_init(m);
    triple_init(d);
    body_init(&f);
    between(axis, from, to);
    between(m, from, ray->origin);
    between(d, zero, ray->direction);
    cross(f.v, axis, m);
    cross(f.w, axis, d);
    square_of(f.k, radius);
    if (tapers) {
        dot(f.scale, axis, axis);
        dot(f.p, axis, m);
        dot(f.q, axis, d);
    } else {
        dot(f.bound, axis, axis);
        mpfr_mul(f.bound, f.bound, f.k, MPFR_RNDN);
        mpfr_set_zero(f.k, 1);
    }
    add_body(found, &f);
    body_clear(&f);
    triple_clear(axis);
    triple_clear(m);
    triple_clear(d);
}

static void add_flat(candidates *found, const sure_ray *ray, sure_vec3 normal, sure_vec3 q)
{
    const sure_vec3 zero = {0, 0, 0};
    triple n;
    triple_init(n);
    between(n, zero, normal);
    add_plane(found, ray, n, q);
    triple_clear(n);
}

static void add_end_planes(candidates *found, const sure_ray *ray, sure_vec3 from, sure_vec3 to)
{
    triple axis;
    triple_init(axis);
    between(axis, from, to);
    add_plane(found, ray, axis, from);
    add_plane(found, ray, axis, to);
    triple_clear(axis);
}

static void add_points(candidates *found, const sure_ray *ray, const sure_object *object)
{
    const sure_cylinder *cylinder = &object->as.cylinder;
    const sure_cone *cone = &object->as.cone;
    switch (object->shape) {
    case SURE_SHAPE_PLANE:
        add_flat(found, ray, object->as.plane.normal, object->as.plane.point);
        break;
    case SURE_SHAPE_DISC:
        add_flat(found, ray, object->as.disc.normal, object->as.disc.centre);
        if (found->count == 0)
            add_ball(found, ray, object->as.disc.centre, object->as.disc.radius);
        break;
    case SURE_SHAPE_SPHERE:
        add_ball(found, ray, object->as.sphere.centre, object->as.sphere.radius);
        break;
    case SURE_SHAPE_CYLINDER:
        add_end_planes(found, ray, cylinder->base, cylinder->top);
        add_wall(found, ray, cylinder->base, cylinder->top, cylinder->radius, false);
        break;
    case SURE_SHAPE_CONE:
        add_end_planes(found, ray, cone->apex, cone->base);
        add_wall(found, ray, cone->apex, cone->base, cone->radius, true);
        break;
    }
}

/* To nearest, ties to even, also where the result is subnormal; what is below 2^-ZERO is the
 * rounding of 0, and what is within 2^-ROUNDED of a midpoint of doubles that of the midpoint. */
static double nearest(mpfr_t x)
{
    if (mpfr_zero_p(x) || mpfr_get_exp(x) < -ZERO)
        return 0;
    mpfr_prec_round(x, ROUNDED, MPFR_RNDN);
    double rounded = mpfr_get_d(x, MPFR_RNDN);
    return rounded == 0 ? 0 : rounded;
}

static void place(double p[3], const sure_ray *ray, mpfr_t t)
{
    const double o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    for (int i = 0; i < 3; i++) {
        mpfr_t x;
        mpfr_init2(x, BITS);
        mpfr_mul_d(x, t, d[i], MPFR_RNDN);
        mpfr_add_d(x, x, o[i], MPFR_RNDN);
        p[i] = nearest(x);
        mpfr_clear(x);
    }
}

static double rounded_t(mpfr_t t)
{
    mpfr_t copy;
    mpfr_init2(copy, BITS);
    mpfr_set(copy, t, MPFR_RNDN);
    double result = nearest(copy);
    mpfr_clear(copy);
    return result;
}

/* True when all that round to t give one point. */
static bool agreed(const sure_ray *ray, candidates *found, double t, double point[3])
{
    int count = 0;
    bool same = true;
    for (int i = 0; i < found->count; i++) {
        double p[3];
        if (rounded_t(found->t[i]) != t)
            continue;
        place(p, ray, found->t[i]);
        for (int k = 0; k < 3; k++) {
            same = same && (count == 0 || p[k] == point[k]);
            point[k] = p[k];
        }
        count++;
    }
    return same && count > 0;
}

bool true_point(const sure_case *question, double t, double point[3])
{
    const sure_ray *ray = &question->ray;
    candidates found = {.count = 0};
    int at_start = 1;
    for (int i = 0; i < CANDIDATES; i++)
        mpfr_init2(found.t[i], BITS);
    (void)reference_compare_hit(ray, &question->object, ray->t_min, &at_start);
    if (at_start == 0)
        mpfr_set_d(found.t[found.count++], ray->t_min, MPFR_RNDN);
    else
        add_points(&found, ray, &question->object);
    bool told = agreed(ray, &found, t, point);
    for (int i = 0; i < CANDIDATES; i++)
        mpfr_clear(found.t[i]);
    return told;
}
