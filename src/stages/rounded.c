/* A point's t* is rational (n/d) or a root of a t^2 + 2 b t + c, and that is never computed. Every
 * number of an answer is rounded by asking on which side of it lie the midpoints of neighbouring
 * doubles, and each of these questions becomes one about t*:
 *
 *     (alpha + beta t*) / rho > m       t* against (m rho - alpha) / beta
 *     a quadratic's sign at t*          reduced by the point's own quadratic it is linear
 *     t* > another quadratic's root     that quadratic's sign at t*, and which side of its vertex
 */
#include "rounded.h"

#include "../numbers/wide.h"
#include "line.h"

/* What a number to be rounded is asked: the sign of (it - x). */
typedef struct number_to_round number_to_round;
struct number_to_round {
    int (*compare)(context *, const number_to_round *, exact x);
    const line *l;
    point at;
    exact alpha, beta;  /* the number is (alpha + beta t*) / rho, rho > 0, ... */
    exact gamma, delta; /* ... or (alpha + beta t*) / ((gamma + delta t*) sqrt(rho)) */
    exact rho;
};

/* Doubles in their order, as integers: 0 for both zeros. */
static int64_t place_of(double x)
{
    int64_t magnitude = (int64_t)magnitude_bits(x);
    return is_negative_bits(x) ? -magnitude : magnitude;
}

static double at_place(int64_t place)
{
    return place < 0 ? double_of((uint64_t)-place | BITS_SIGN) : double_of((uint64_t)place);
}

/* Infinity rounds as 2^1024 would. */
static exact exact_at_place(context *c, int64_t place)
{
    double x = at_place(place);
    return is_finite_bits(x) ? exact_of(c, x) : exact_scaled(c, place < 0 ? -1 : 1, 1024);
}

/* Sign of the number - the midpoint between a place and the next one. */
static int above_middle(context *c, const number_to_round *z, int64_t place)
{
    size_t mark = exact_mark(c);
    exact both = exact_add(c, exact_at_place(c, place), exact_at_place(c, place + 1));
    int sign = z->compare(c, z, exact_mul(c, both, exact_scaled(c, 1, -1)));
    exact_release(c, mark);
    return sign;
}

/* Between low and high; their distance may exceed the integers' range. */
static int64_t between(int64_t low, int64_t high)
{
    return low + (int64_t)(((uint64_t)high - (uint64_t)low) / 2);
}

/* The place that the number rounds to is the least one whose upper middle is not below it: from a
 * guess in doubling steps to both sides of that, then by halves. */
static double round_number(context *c, const number_to_round *z, double guess)
{
    const int64_t last = (int64_t)BITS_INFINITY, stride = last / 4;
    int64_t high = place_of(guess), low = high, step = 1;
    if (above_middle(c, z, high) > 0) {
        do {
            low = high + 1;
            high = high > last - step ? last : high + step;
            step = step < stride ? 2 * step : step;
        } while (high < last && above_middle(c, z, high) > 0);
    } else {
        low = high - 1;
        while (low >= -last && above_middle(c, z, low) <= 0) {
            high = low;
            low = low < -last + step ? -last - 1 : low - step;
            step = step < stride ? 2 * step : step;
        }
        low++;
    }
    while (low < high) {
        int64_t middle = between(low, high);
        if (above_middle(c, z, middle) > 0)
            low = middle + 1;
        else
            high = middle;
    }
    if (high < last && high % 2 != 0 && above_middle(c, z, high) == 0)
        high++; /* a tie goes to the even one */
    return high == 0 ? 0 : at_place(high);
}

static bool is_root(point at)
{
    return at == POINT_LESS || at == POINT_MORE;
}

/* Sign of alpha + beta t*, t* a root. */
static int sign_of_linear(context *c, const line *l, point at, exact alpha, exact beta)
{
    int rising = exact_sign(c, beta);
    if (rising == 0)
        return exact_sign(c, alpha);
    return rising * line_compare_exact(c, l, at, exact_negate(c, alpha), beta);
}

/* Sign of p t*^2 + 2 q t* + s: less p/a times the point's own quadratic it is linear. */
static int sign_of_quadratic(context *c, const line *l, point at, exact p, exact q, exact s)
{
    int leading = exact_sign(c, l->a);
    if (leading == 0) { /* t* = n/d = -c / 2b */
        exact n = exact_negate(c, l->c), d = exact_add(c, l->b, l->b);
        exact mixed = exact_mul(c, exact_mul(c, exact_add(c, q, q), n), d);
        return exact_sign(c, exact_add(c, exact_add(c, exact_mul(c, p, number_square(c, n)), mixed),
                                       exact_mul(c, s, number_square(c, d))));
    }
    exact half = number_minor(c, q, p, l->b, l->a); /* q a - p b */
    exact constant = number_minor(c, s, p, l->c, l->a);
    return leading * sign_of_linear(c, l, at, constant, exact_add(c, half, half));
}

/* (alpha + beta t*) / rho */
static int compare_linear(context *c, const number_to_round *z, exact x)
{
    exact rest = exact_sub(c, z->alpha, exact_mul(c, x, z->rho));
    return sign_of_linear(c, z->l, z->at, rest, z->beta);
}

/* u / (v sqrt(rho)) for u = alpha + beta t*, v = gamma + delta t* > 0: against x by signs, then by
 * squares, u^2 - x^2 rho v^2. */
static int compare_over_root(context *c, const number_to_round *z, exact x)
{
    int sign = sign_of_linear(c, z->l, z->at, z->alpha, z->beta);
    if (sign != x.sign || sign == 0)
        return sign > x.sign ? 1 : sign < x.sign ? -1 : 0;
    exact k = exact_mul(c, number_square(c, x), z->rho);
    exact kd = exact_mul(c, k, z->delta), kg = exact_mul(c, k, z->gamma);
    return sign * sign_of_quadratic(c, z->l, z->at, number_minor(c, z->beta, kd, z->delta, z->beta),
                                    number_minor(c, z->alpha, kg, z->delta, z->beta),
                                    number_minor(c, z->alpha, kg, z->gamma, z->alpha));
}

/* The same for rational u / sqrt(rho): gamma = 1, delta = 0, t* does not matter. */
static int compare_rational_over_root(context *c, const number_to_round *z, exact x)
{
    int sign = exact_sign(c, z->alpha);
    if (sign != x.sign || sign == 0)
        return sign > x.sign ? 1 : sign < x.sign ? -1 : 0;
    exact square = exact_mul(c, number_square(c, x), z->rho);
    return sign * exact_compare(c, number_square(c, z->alpha), square);
}

/* t* to some 50 bits, by the form without cancellation (solve.c). */
static wide guess_root(context *c, const line *l, point at)
{
    wide a = wide_of(l->a), b = wide_of(l->b);
    wide root = wide_sqrt(wide_of(exact_mul(c, l->factor, l->quarter)));
    bool falling = b.m < 0;
    wide q = falling ? wide_add(root, wide_negate(b)) : wide_negate(wide_add(root, b));
    point direct = (a.m > 0) == falling ? POINT_MORE : POINT_LESS;
    if (q.m == 0)
        return (wide){0, 0};
    return a.m != 0 && (at == direct || root.m == 0) ? wide_div(q, a) : wide_div(wide_of(l->c), q);
}

/* t* = n/d of a point that is no root. */
static void rational_t(context *c, const sure_ray *ray, const line *l, point at, exact *n, exact *d)
{
    *n = exact_of(c, ray->t_min);
    *d = exact_of(c, 1);
    if (at != POINT_START)
        line_rational_exact(c, l, at, n, d);
}

/* (alpha + beta t*) / rho rounded. */
static double round_linear(context *c, const sure_ray *ray, const line *l, point at, exact alpha,
                           exact beta, exact rho)
{
    if (!is_root(at)) {
        exact n, d;
        rational_t(c, ray, l, at, &n, &d);
        exact top = exact_add(c, exact_mul(c, alpha, d), exact_mul(c, beta, n));
        return exact_quotient(c, top, exact_mul(c, rho, d));
    }
    number_to_round z = {
        .compare = compare_linear, .l = l, .at = at, .alpha = alpha, .beta = beta, .rho = rho};
    wide whole = wide_add(wide_of(alpha), wide_mul(wide_of(beta), guess_root(c, l, at)));
    return round_number(c, &z, wide_double(wide_div(whole, wide_of(rho))));
}

static double round_t(context *c, const sure_ray *ray, const line *l, point at)
{
    if (at == POINT_START)
        return is_zero_bits(ray->t_min) ? 0 : ray->t_min;
    return round_linear(c, ray, l, at, exact_of(c, 0), exact_of(c, 1), exact_of(c, 1));
}

sure_status rounded_hit(const sure_ray *ray, const sure_object *object, chord_end *first, double *t,
                        bool *whole)
{
    exact_arena room;
    context c = exact_start(&room);
    line l;
    sure_status status = line_hit_exact(&c, ray, object, &l, first);
    if (status != SURE_HIT)
        return status;
    *t = round_t(&c, ray, &l, first->at);
    *whole = first->at == POINT_START ||
             (is_finite_bits(*t) &&
              line_compare_exact(&c, &l, first->at, exact_of(&c, *t), exact_of(&c, 1)) == 0);
    return status;
}

sure_status rounded_interval(const sure_ray *ray, const sure_object *object,
                             sure_interval *interval)
{
    exact_arena room;
    context c = exact_start(&room);
    line l;
    chord ends;
    sure_status status = line_interval_exact(&c, ray, object, &l, &ends);
    if (status != SURE_HIT)
        return status;
    bool endless = ends.enter.at == POINT_ENDLESS;
    interval->t_enter = endless ? -INFINITY : round_t(&c, ray, &l, ends.enter.at);
    interval->t_leave = endless ? INFINITY : round_t(&c, ray, &l, ends.leave.at);
    interval->enter_part = ends.enter.part;
    interval->leave_part = ends.leave.part;
    return status;
}

/* v/|v|, v not zero. */
static sure_vec3 round_unit(context *c, vector v)
{
    exact square = vector_square(c, v);
    const exact parts[3] = {v.x, v.y, v.z};
    double unit[3];
    for (int i = 0; i < 3; i++) {
        number_to_round z = {
            .compare = compare_rational_over_root, .alpha = parts[i], .rho = square};
        wide guess = wide_div(wide_of(parts[i]), wide_sqrt(wide_of(square)));
        unit[i] = round_number(c, &z, wide_double(guess));
    }
    return (sure_vec3){unit[0], unit[1], unit[2]};
}

static vector opposite(context *c, vector v)
{
    return (vector){exact_negate(c, v.x), exact_negate(c, v.y), exact_negate(c, v.z)};
}

/* Everything is seen from `from`; the axis is as the shape's chord has it. */
typedef struct {
    const sure_ray *ray;
    const line *l;
    point at;
    vector m, d, axis;
    exact radius, height; /* height = axis.axis */
} wall_point;

static exact component(const vector *v, int i)
{
    return i == 0 ? v->x : i == 1 ? v->y : v->z;
}

/* (m + t d) / r */
static sure_vec3 sphere_normal(context *c, const wall_point *w)
{
    double n[3];
    for (int i = 0; i < 3; i++)
        n[i] = round_linear(c, w->ray, w->l, w->at, component(&w->m, i), component(&w->d, i),
                            w->radius);
    return (sure_vec3){n[0], n[1], n[2]};
}

/* (H p - (A.p) A) / (H r) */
static sure_vec3 cylinder_wall_normal(context *c, const wall_point *w)
{
    exact along = vector_dot(c, w->axis, w->m), speed = vector_dot(c, w->axis, w->d);
    exact rho = exact_mul(c, w->height, w->radius);
    double n[3];
    for (int i = 0; i < 3; i++) {
        exact axis = component(&w->axis, i);
        exact alpha = number_minor(c, w->height, along, axis, component(&w->m, i));
        exact beta = number_minor(c, w->height, speed, axis, component(&w->d, i));
        n[i] = round_linear(c, w->ray, w->l, w->at, alpha, beta, rho);
    }
    return (sure_vec3){n[0], n[1], n[2]};
}

/* H^2 p - K (A.p) A, the body's gradient; on the wall, where H^2 p.p = K (A.p)^2, its length is
 * (A.p) r sqrt(K H). */
static sure_vec3 cone_wall_normal(context *c, const wall_point *w)
{
    exact depth = vector_dot(c, w->axis, w->m), speed = vector_dot(c, w->axis, w->d);
    exact square = number_square(c, w->height);
    exact slant = exact_add(c, w->height, number_square(c, w->radius));
    exact slant_depth = exact_mul(c, slant, depth), slant_speed = exact_mul(c, slant, speed);
    number_to_round z = {.compare = compare_over_root,
                         .l = w->l,
                         .at = w->at,
                         .gamma = exact_mul(c, depth, w->radius),
                         .delta = exact_mul(c, speed, w->radius),
                         .rho = exact_mul(c, slant, w->height)};
    wide t = guess_root(c, w->l, w->at);
    wide sunk = wide_add(wide_of(z.gamma), wide_mul(wide_of(z.delta), t));
    wide length = wide_mul(sunk, wide_sqrt(wide_of(z.rho)));
    double n[3];
    for (int i = 0; i < 3; i++) {
        exact axis = component(&w->axis, i);
        z.alpha = number_minor(c, square, slant_depth, axis, component(&w->m, i));
        z.beta = number_minor(c, square, slant_speed, axis, component(&w->d, i));
        wide top = wide_add(wide_of(z.alpha), wide_mul(wide_of(z.beta), t));
        n[i] = round_number(c, &z, length.m == 0 ? 0 : wide_double(wide_div(top, length)));
    }
    return (sure_vec3){n[0], n[1], n[2]};
}

/* The gradient at a rational t = n/d, where it has a length of its own. */
static sure_vec3 cone_rational_normal(context *c, const wall_point *w, exact n, exact d)
{
    vector p = vector_add(c, vector_scale(c, d, w->m), vector_scale(c, n, w->d));
    exact slant = exact_add(c, w->height, number_square(c, w->radius));
    exact share = exact_mul(c, slant, vector_dot(c, w->axis, p));
    vector inward = vector_scale(c, share, w->axis);
    vector outward = vector_sub(c, vector_scale(c, number_square(c, w->height), p), inward);
    return round_unit(c, d.sign > 0 ? outward : opposite(c, outward));
}

static bool at_apex(context *c, const wall_point *w, exact n, exact d)
{
    exact depth = vector_dot(c, w->axis, w->m), speed = vector_dot(c, w->axis, w->d);
    if (is_root(w->at))
        return sign_of_linear(c, w->l, w->at, depth, speed) == 0;
    return exact_sign(c, exact_add(c, exact_mul(c, depth, d), exact_mul(c, speed, n))) == 0;
}

static sure_vec3 cone_normal(context *c, const sure_cone *cone, sure_part part, wall_point *w)
{
    w->m = vector_between(c, cone->apex, w->ray->origin);
    w->axis = vector_between(c, cone->apex, cone->base);
    w->height = vector_square(c, w->axis);
    w->radius = exact_of(c, cone->radius);
    if (part == SURE_PART_BASE)
        return round_unit(c, w->axis);
    exact n = exact_of(c, 0), d = n;
    if (!is_root(w->at))
        rational_t(c, w->ray, w->l, w->at, &n, &d);
    if (at_apex(c, w, n, d))
        return round_unit(c, opposite(c, w->axis));
    if (w->radius.sign == 0)
        return round_unit(c, opposite(c, w->d));
    return is_root(w->at) ? cone_wall_normal(c, w) : cone_rational_normal(c, w, n, d);
}

static sure_vec3 cylinder_normal(context *c, const sure_cylinder *cylinder, sure_part part,
                                 wall_point *w)
{
    w->m = vector_between(c, cylinder->base, w->ray->origin);
    w->axis = vector_between(c, cylinder->base, cylinder->top);
    w->height = vector_square(c, w->axis);
    w->radius = exact_of(c, cylinder->radius);
    if (part == SURE_PART_TOP)
        return round_unit(c, w->axis);
    if (part == SURE_PART_BASE)
        return round_unit(c, opposite(c, w->axis));
    return w->radius.sign == 0 ? round_unit(c, opposite(c, w->d)) : cylinder_wall_normal(c, w);
}

sure_vec3 rounded_normal(const sure_ray *ray, const sure_object *object)
{
    exact_arena room;
    context c = exact_start(&room);
    if (object->shape == SURE_SHAPE_PLANE)
        return round_unit(&c, vector_of(&c, object->as.plane.normal));
    if (object->shape == SURE_SHAPE_DISC)
        return round_unit(&c, vector_of(&c, object->as.disc.normal));
    line l;
    chord_end first;
    (void)line_hit_exact(&c, ray, object, &l, &first);
    wall_point w = {.ray = ray, .l = &l, .at = first.at, .d = vector_of(&c, ray->direction)};
    if (object->shape == SURE_SHAPE_CYLINDER)
        return cylinder_normal(&c, &object->as.cylinder, first.part, &w);
    if (object->shape == SURE_SHAPE_CONE)
        return cone_normal(&c, &object->as.cone, first.part, &w);
    w.m = vector_between(&c, object->as.sphere.centre, ray->origin);
    w.radius = exact_of(&c, object->as.sphere.radius);
    return w.radius.sign == 0 ? round_unit(&c, opposite(&c, w.d)) : sphere_normal(&c, &w);
}

sure_vec3 rounded_point(const sure_ray *ray, const sure_object *object)
{
    exact_arena room;
    context c = exact_start(&room);
    line l;
    chord_end first;
    (void)line_hit_exact(&c, ray, object, &l, &first);
    vector o = vector_of(&c, ray->origin), d = vector_of(&c, ray->direction);
    double p[3];
    for (int i = 0; i < 3; i++)
        p[i] = round_linear(&c, ray, &l, first.at, component(&o, i), component(&d, i),
                            exact_of(&c, 1));
    return (sure_vec3){p[0], p[1], p[2]};
}

/* Sign of t - t' for two points on the ray. */
static int order_of(context *c, const sure_ray *ray, const line *l, point at, const line *other,
                    point other_at)
{
    exact n, d;
    if (!is_root(at)) {
        rational_t(c, ray, l, at, &n, &d);
        if (other_at != POINT_START)
            return -line_compare_exact(c, other, other_at, n, d);
        exact ahead = exact_sub(c, n, exact_mul(c, d, exact_of(c, ray->t_min)));
        return exact_sign(c, ahead) * exact_sign(c, d);
    }
    if (!is_root(other_at)) {
        rational_t(c, ray, other, other_at, &n, &d);
        return line_compare_exact(c, l, at, n, d);
    }
    int leading = exact_sign(c, other->a);
    if (leading == 0)
        return line_compare_exact(c, l, at, exact_negate(c, other->c),
                                  exact_add(c, other->b, other->b));
    int outside = leading * sign_of_quadratic(c, l, at, other->a, other->b, other->c);
    int side = leading * sign_of_linear(c, l, at, other->b, other->a);
    return -root_from_signs(other_at, outside, side);
}

int rounded_order(const sure_ray *ray, const sure_object *first, const sure_object *second)
{
    exact_arena room;
    context c = exact_start(&room);
    line lines[2];
    chord_end ends[2];
    (void)line_hit_exact(&c, ray, first, &lines[0], &ends[0]);
    (void)line_hit_exact(&c, ray, second, &lines[1], &ends[1]);
    return order_of(&c, ray, &lines[0], ends[0].at, &lines[1], ends[1].at);
}
