#include "line.h"

#include "../numbers/bits.h"

static chord object_chord(context *c, const sure_ray *ray, const sure_object *object, line *l)
{
    switch (object->shape) {
    case SURE_SHAPE_PLANE: return STAGE(plane_chord)(c, ray, &object->as.plane, l);
    case SURE_SHAPE_DISC: return STAGE(disc_chord)(c, ray, &object->as.disc, l);
    case SURE_SHAPE_SPHERE: return STAGE(sphere_chord)(c, ray, &object->as.sphere, l);
    case SURE_SHAPE_CYLINDER: return STAGE(cylinder_chord)(c, ray, &object->as.cylinder, l);
    case SURE_SHAPE_CONE: break;
    }
    return STAGE(cone_chord)(c, ray, &object->as.cone, l);
}

/* The root of 2 b t + c: 2 b n/d + c has the sign of b (n/d - t). */
static int compare_only_root(context *c, const line *l, number n, number d)
{
    number twice = number_add(c, l->b, l->b);
    number value = number_add(c, number_mul(c, twice, n), number_mul(c, l->c, d));
    return -number_sign(c, value) * number_sign(c, d) * number_sign(c, l->b);
}

static int compare_root(context *c, const line *l, point at, number n, number d)
{
    int leading = number_sign(c, l->a);
    if (leading == 0)
        return compare_only_root(c, l, n, d);
    /* d^2 times the body at n/d */
    number bd = number_mul(c, l->b, d), rising = number_add(c, number_mul(c, l->a, n), bd);
    number value = number_add(c, number_mul(c, number_add(c, rising, bd), n),
                              number_mul(c, l->c, number_square(c, d)));
    int outside = leading * number_sign(c, value);
    int side = outside < 0 ? 0 : leading * number_sign(c, rising) * number_sign(c, d);
    return root_from_signs(at, outside, side);
}

void STAGE(line_rational)(context *c, const line *l, point at, number *n, number *d)
{
    *n = at == POINT_TOUCH ? number_negate(c, l->b) : at == POINT_BASE ? l->base : l->top;
    *d = at == POINT_TOUCH ? l->a : l->speed;
}

int STAGE(line_compare)(context *c, const line *l, point at, number n, number d)
{
    if (at == POINT_LESS || at == POINT_MORE)
        return compare_root(c, l, at, n, d);
    number own_n, own_d;
    STAGE(line_rational)(c, l, at, &own_n, &own_d);
    number ahead = number_sub(c, number_mul(c, own_n, d), number_mul(c, n, own_d));
    return number_sign(c, ahead) * number_sign(c, own_d) * number_sign(c, d);
}

/* The same for t - 0. */
static int compare_with_zero(context *c, const line *l, point at)
{
    if (at == POINT_LESS || at == POINT_MORE) {
        int leading = number_sign(c, l->a), sign = number_sign(c, l->c);
        int side = leading * sign < 0 ? 0 : number_sign(c, l->b);
        return leading == 0 ? -sign * side : root_from_signs(at, leading * sign, leading * side);
    }
    number n, d;
    STAGE(line_rational)(c, l, at, &n, &d);
    return number_sign(c, n) * number_sign(c, d);
}

static int compare_with(context *c, const line *l, point at, double x)
{
    return is_zero_bits(x) ? compare_with_zero(c, l, at)
                           : STAGE(line_compare)(c, l, at, number_of(c, x), number_of(c, 1));
}

#ifdef NUMBER_RANGE
/* Within the stage's range, or beyond the other of its limits? What lies outside can't be told. */
static int compare_beyond(context *c, const line *l, point at, bool large)
{
    int within = large ? -1 : 1;
    if (compare_with(c, l, at, large ? NUMBER_RANGE : 1 / NUMBER_RANGE) == within)
        return within;
    if (large || compare_with_zero(c, l, at) > 0)
        c->uncertain = true;
    return -1;
}
#endif

/* Sign of the end's t - x for a bound x of the range, where `endless` stands for an end without
 * t. */
static int compare_end(context *c, const line *l, chord_end end, double x, int endless)
{
    if (end.at == POINT_ENDLESS)
        return endless;
    if (!is_finite_bits(x))
        return -1;
#ifdef NUMBER_RANGE
    bool large = magnitude_bits(x) > bits_of(NUMBER_RANGE);
    if (large || magnitude_bits(x) - 1 < bits_of(1 / NUMBER_RANGE) - 1)
        return compare_beyond(c, l, end.at, large);
#endif
    return compare_with(c, l, end.at, x);
}

sure_status STAGE(line_hit)(context *c, const sure_ray *ray, const sure_object *object, line *l,
                            chord_end *first)
{
    chord ends = object_chord(c, ray, object, l);
    if (ends.empty || c->uncertain)
        return SURE_MISS;
    *first = ends.enter;
    if (compare_end(c, l, ends.enter, ray->t_min, -1) >= 0)
        return compare_end(c, l, *first, ray->t_max, -1) <= 0 ? SURE_HIT : SURE_MISS;
    int left = compare_end(c, l, ends.leave, ray->t_min, 1);
    if (ends.boundary && left > 0) {
        *first = (chord_end){POINT_START, ends.inner_part};
        return SURE_HIT;
    }
    *first = ends.leave;
    return left >= 0 && compare_end(c, l, *first, ray->t_max, 1) <= 0 ? SURE_HIT : SURE_MISS;
}

sure_status STAGE(line_interval)(context *c, const sure_ray *ray, const sure_object *object,
                                 line *l, chord *ends)
{
    *ends = object_chord(c, ray, object, l);
    if (ends->empty || c->uncertain || compare_end(c, l, ends->enter, ray->t_max, -1) > 0 ||
        compare_end(c, l, ends->leave, ray->t_min, 1) < 0)
        return SURE_MISS;
    return SURE_HIT;
}
