/* SPDX-License-Identifier: MIT */
#include "test_shape.h"

/* A coordinate of a hit is a root of a polynomial of degree at most 2 in it whose coefficients are
 * sums of products of at most 16 doubles, that is multiples of 2^-(16 * 1074) below 2^(16 * 1026):
 * what is not 0 is above 2^-ZERO in magnitude. Discriminants, of degree 12 to 14, are exact. */
enum { POINT_BITS = 80000, ZERO = 40000, ROUNDED = 8000 };

void true_vector_init(true_vector v, mpfr_prec_t bits)
{
    mpfr_inits2(bits, v[0], v[1], v[2], (mpfr_ptr)NULL);
}

void true_vector_clear(true_vector v)
{
    mpfr_clears(v[0], v[1], v[2], (mpfr_ptr)NULL);
}

void true_vector_between(true_vector v, sure_vec3 from, sure_vec3 to)
{
    const double ends[3][2] = {{from.x, to.x}, {from.y, to.y}, {from.z, to.z}};
    for (int i = 0; i < 3; i++) {
        mpfr_set_d(v[i], ends[i][1], MPFR_RNDN);
        mpfr_sub_d(v[i], v[i], ends[i][0], MPFR_RNDN);
    }
}

void true_dot(mpfr_t dot, true_vector v, true_vector w)
{
    mpfr_mul(dot, v[0], w[0], MPFR_RNDN);
    mpfr_fma(dot, v[1], w[1], dot, MPFR_RNDN);
    mpfr_fma(dot, v[2], w[2], dot, MPFR_RNDN);
}

void true_line_init(true_line *line, mpfr_prec_t bits)
{
    memset(&line->of, 0, sizeof line->of); /* no valid case */
    line->bits = bits;
    mpfr_inits2(bits, line->height, line->slope, line->level, line->dd, line->md, line->mm, line->a,
                line->b, line->c, line->discriminant, line->t[0], line->t[1], (mpfr_ptr)NULL);
}

void true_line_clear(true_line *line)
{
    mpfr_clears(line->height, line->slope, line->level, line->dd, line->md, line->mm, line->a,
                line->b, line->c, line->discriminant, line->t[0], line->t[1], (mpfr_ptr)NULL);
}

true_frame true_frame_of(const sure_object *object)
{
    return test_shape_of(object->shape)->frame(object);
}

/* x becomes f x - k v w. */
static void lessen(mpfr_t x, mpfr_t f, mpfr_t k, mpfr_t v, mpfr_t w)
{
    TRUE_NUMBERS(mpfr_get_prec(x), kv);
    mpfr_mul(kv, k, v, MPFR_RNDN);
    mpfr_fmms(x, f, x, kv, w, MPFR_RNDN);
}

/* From the squares of distances from a point to those from an axis, with k = 1 times A.A, or to a
 * cone's, with k = A.A + r^2 times (A.A)^2. */
static void about_axis(true_line *line, mpfr_t rr)
{
    TRUE_NUMBERS(line->bits, f, k);
    mpfr_set(f, line->height, MPFR_RNDN);
    mpfr_set_ui(k, 1, MPFR_RNDN);
    if (line->tapers) {
        mpfr_sqr(f, line->height, MPFR_RNDN);
        mpfr_add(k, line->height, rr, MPFR_RNDN);
    }
    lessen(line->a, f, k, line->slope, line->slope);
    lessen(line->b, f, k, line->slope, line->level);
    lessen(line->c, f, k, line->level, line->level);
}

void true_line_coefficients(true_line *line, const sure_case *c)
{
    const sure_vec3 zero = {0, 0, 0};
    true_frame of = true_frame_of(&c->object);
    true_vector axis, m, d;
    true_vector_init(axis, line->bits);
    true_vector_init(m, line->bits);
    true_vector_init(d, line->bits);
    TRUE_NUMBERS(line->bits, rr);
    line->flat = of.flat;
    line->round = of.round;
    line->capped = of.capped;
    line->tapers = of.tapers;
    true_vector_between(axis, of.back, of.to);
    true_vector_between(m, of.from, c->ray.origin);
    true_vector_between(d, zero, c->ray.direction);
    true_dot(line->height, axis, axis);
    true_dot(line->slope, axis, d);
    true_dot(line->level, axis, m);
    true_dot(line->dd, d, d);
    true_dot(line->md, m, d);
    true_dot(line->mm, m, m);
    mpfr_set(line->a, line->dd, MPFR_RNDN);
    mpfr_set(line->b, line->md, MPFR_RNDN);
    mpfr_set(line->c, line->mm, MPFR_RNDN);
    mpfr_set_d(rr, of.radius, MPFR_RNDN);
    mpfr_sqr(rr, rr, MPFR_RNDN);
    if (!line->tapers)
        mpfr_sub(line->c, line->c, rr, MPFR_RNDN);
    if (line->capped)
        about_axis(line, rr);
    mpfr_fmms(line->discriminant, line->b, line->b, line->a, line->c, MPFR_RNDN);
    true_vector_clear(axis);
    true_vector_clear(m);
    true_vector_clear(d);
}

void true_exactly(const sure_case *c, true_use *what, void *context)
{
    bool exact = false;
    for (mpfr_prec_t bits = 800; !exact; bits *= 4) {
        TRUE_LINE(bits, line);
        mpfr_clear_inexflag();
        true_line_coefficients(&line, c);
        what(&line, context);
        exact = mpfr_inexflag_p() == 0;
    }
}

static void set_end(true_line *line, int which, mpfr_t t, true_end at)
{
    mpfr_set(line->t[which], t, MPFR_RNDN);
    line->at[which] = at;
}

/* In order, without cancellation. Entry: a is not 0, D is not below 0. */
static void set_roots(const true_line *line, mpfr_t less, mpfr_t more)
{
    mpfr_sqrt(more, line->discriminant, MPFR_RNDN);
    if (mpfr_sgn(line->b) > 0)
        mpfr_neg(more, more, MPFR_RNDN);
    mpfr_sub(more, more, line->b, MPFR_RNDN);
    mpfr_set_zero(less, 1);
    if (!mpfr_zero_p(more))
        mpfr_div(less, line->c, more, MPFR_RNDN);
    mpfr_div(more, more, line->a, MPFR_RNDN);
    if (mpfr_cmp(less, more) > 0)
        mpfr_swap(less, more);
}

/* Of a quadratic with a < 0 the body is outside the roots, a cone's two nappes: it is cut where the
 * line comes into the nappe that is kept, or leaves it. */
bool true_in_body(true_line *line)
{
    bool rises = mpfr_sgn(line->slope) > 0, real = mpfr_sgn(line->discriminant) >= 0;
    line->at[0] = line->at[1] = TRUE_ENDLESS;
    mpfr_set_inf(line->t[0], -1);
    mpfr_set_inf(line->t[1], 1);
    if (mpfr_zero_p(line->a) && mpfr_zero_p(line->b))
        return mpfr_sgn(line->c) <= 0;
    TRUE_NUMBERS(line->bits, less, more);
    if (mpfr_zero_p(line->a)) {
        mpfr_div(less, line->c, line->b, MPFR_RNDN);
        mpfr_div_si(less, less, -2, MPFR_RNDN);
        set_end(line, mpfr_sgn(line->b) > 0, less, TRUE_LESS);
    } else if (real) {
        set_roots(line, less, more);
        if (mpfr_sgn(line->a) > 0 || rises)
            set_end(line, 0, mpfr_sgn(line->a) > 0 ? less : more,
                    mpfr_sgn(line->a) > 0 ? TRUE_LESS : TRUE_MORE);
        if (mpfr_sgn(line->a) > 0 || !rises)
            set_end(line, 1, mpfr_sgn(line->a) > 0 ? more : less,
                    mpfr_sgn(line->a) > 0 ? TRUE_MORE : TRUE_LESS);
    }
    return real || mpfr_zero_p(line->a);
}

double true_largest_root(true_line *line)
{
    double largest = 0;
    TRUE_NUMBERS(line->bits, less, more);
    if (!mpfr_zero_p(line->a) && mpfr_sgn(line->discriminant) >= 0) {
        set_roots(line, less, more);
        largest = fmax(fabs(mpfr_get_d(less, MPFR_RNDN)), fabs(mpfr_get_d(more, MPFR_RNDN)));
    } else if (mpfr_zero_p(line->a) && !mpfr_zero_p(line->b)) {
        mpfr_div(less, line->c, line->b, MPFR_RNDN);
        largest = fabs(mpfr_get_d(less, MPFR_RNDN)) / 2;
    }
    return largest;
}

/* Cuts off what is before t, or beyond it. */
static void cut(true_line *line, int end, mpfr_t t, true_end at)
{
    int order = mpfr_cmp(t, line->t[end]);
    if (end == 0 ? order >= 0 : order <= 0)
        set_end(line, end, t, at);
}

/* Between the planes of A.(m + t d) = 0 and A.A; a cone's base is the second one. */
static bool between_planes(true_line *line)
{
    bool rises = mpfr_sgn(line->slope) > 0;
    if (mpfr_zero_p(line->slope))
        return mpfr_sgn(line->level) >= 0 && mpfr_cmp(line->level, line->height) <= 0;
    TRUE_NUMBERS(line->bits, first, second);
    mpfr_neg(first, line->level, MPFR_RNDN);
    mpfr_add(second, first, line->height, MPFR_RNDN);
    mpfr_div(first, first, line->slope, MPFR_RNDN);
    mpfr_div(second, second, line->slope, MPFR_RNDN);
    cut(line, !rises, first, line->tapers ? TRUE_TOP : TRUE_BASE);
    cut(line, rises, second, line->tapers ? TRUE_BASE : TRUE_TOP);
    return true;
}

int true_side(true_line *line, mpfr_t n, mpfr_t k)
{
    TRUE_NUMBERS(line->bits, value, term);
    mpfr_mul(value, line->a, n, MPFR_RNDN);
    mpfr_mul(term, line->b, k, MPFR_RNDN);
    mpfr_mul_2ui(term, term, 1, MPFR_RNDN);
    mpfr_add(value, value, term, MPFR_RNDN);
    mpfr_mul(value, value, n, MPFR_RNDN);
    mpfr_sqr(term, k, MPFR_RNDN);
    mpfr_fma(value, line->c, term, value, MPFR_RNDN);
    return mpfr_sgn(value);
}

/* Of a plane, or of the disc in it. */
bool true_in_plane(true_line *line)
{
    if (mpfr_zero_p(line->slope)) {
        line->at[0] = line->at[1] = TRUE_ENDLESS;
        mpfr_set_inf(line->t[0], -1);
        mpfr_set_inf(line->t[1], 1);
        return mpfr_zero_p(line->level) && (!line->round || true_in_body(line));
    }
    mpfr_neg(line->t[0], line->level, MPFR_RNDN);
    bool within = !line->round || true_side(line, line->t[0], line->slope) <= 0;
    mpfr_div(line->t[0], line->t[0], line->slope, MPFR_RNDN);
    line->at[0] = TRUE_BASE;
    set_end(line, 1, line->t[0], TRUE_BASE);
    return within;
}

static bool is_in_end_plane(const true_line *line)
{
    return mpfr_zero_p(line->slope) &&
           (mpfr_zero_p(line->level) || mpfr_equal_p(line->level, line->height));
}

/* Of a line in an end plane both ends are that plane's; a cone's other plane is its apex's. */
static sure_part part_of_end(const true_line *line, true_end at)
{
    if (is_in_end_plane(line))
        at = mpfr_zero_p(line->level) != line->tapers ? TRUE_BASE : TRUE_TOP;
    return at == TRUE_BASE                   ? SURE_PART_BASE
           : at == TRUE_TOP && !line->tapers ? SURE_PART_TOP
                                             : SURE_PART_WALL;
}

bool true_in_capped(true_line *line)
{
    bool generator = mpfr_zero_p(line->a) && mpfr_zero_p(line->b) && mpfr_zero_p(line->c);
    line->on_boundary = generator || is_in_end_plane(line);
    bool exists =
        true_in_body(line) && between_planes(line) && mpfr_lessequal_p(line->t[0], line->t[1]);
    for (int i = 0; i < 2; i++)
        line->part[i] = part_of_end(line, line->at[i]);
    line->part[2] = part_of_end(line, TRUE_LESS);
    return exists;
}

void true_line_set(true_line *line, const sure_case *c)
{
    if (memcmp(&line->of, c, sizeof *c) == 0)
        return;
    line->of = *c;
    true_line_coefficients(line, c);
    line->on_boundary = line->flat;
    line->part[0] = line->part[1] = line->part[2] = SURE_PART_SURFACE;
    line->exists = test_shape_of(c->object.shape)->in_object(line);
}

sure_part true_part(const true_line *line, mpfr_t t)
{
    bool enters = mpfr_equal_p(t, line->t[0]) != 0, leaves = mpfr_equal_p(t, line->t[1]) != 0;
    if (enters && leaves) /* one point alone */
        return line->part[0] < line->part[1] ? line->part[0] : line->part[1];
    return line->part[enters ? 0 : leaves ? 1 : 2];
}

bool true_first(const true_line *line, mpfr_t t)
{
    const sure_ray *ray = &line->of.ray;
    for (int i = 0; i < 2 && line->exists; i++) {
        bool ahead = mpfr_cmp_d(line->t[i], ray->t_min) >= 0;
        mpfr_set(t, line->t[i], MPFR_RNDN);
        if (!ahead && i == 0 && line->on_boundary && mpfr_cmp_d(line->t[1], ray->t_min) >= 0)
            mpfr_set_d(t, ray->t_min, MPFR_RNDN);
        else if (!ahead)
            continue;
        return mpfr_cmp_d(t, ray->t_max) <= 0;
    }
    return false;
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

bool true_point(const sure_case *c, double *t, double point[3])
{
    const sure_ray *ray = &c->ray;
    const double o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    TRUE_LINE(POINT_BITS, line);
    TRUE_NUMBERS(POINT_BITS, first, x);
    true_line_set(&line, c);
    bool hits = true_first(&line, first);
    for (int i = 0; i < 3 && hits; i++) {
        mpfr_set_prec(x, POINT_BITS);
        mpfr_mul_d(x, first, d[i], MPFR_RNDN);
        mpfr_add_d(x, x, o[i], MPFR_RNDN);
        point[i] = nearest(x);
    }
    *t = hits ? nearest(first) : *t;
    return hits;
}
