/* SPDX-License-Identifier: MIT */
/* The cone in exact numbers (cone_tmpl.h has its polynomials). The base is crossed in its disc as
 * capped_within says; the vertex t = -b/a is at the depth
 *
 *     A.p = H^2 ((A.m)(d.d) - (A.d)(m.d)) / a */
#include "../capped/capped_stages.h"

#define NUMBER exact
#include "cone_tmpl.h"

#define NUMBER exact

static const tagged_end base = {END_BASE, SURE_PART_BASE};
static const tagged_end less = {END_LESS, SURE_PART_WALL};
static const tagged_end more = {END_MORE, SURE_PART_WALL};

/* From the wall down to the base, in whichever order the line has them; nothing if the line leaves
 * the base's plane outside the disc (`within` < 0). */
static tagged_interval down_to_base(tagged_end wall, int within, int speed)
{
    if (within < 0)
        return interval_empty();
    if (within == 0)
        return interval_point(base);
    return speed > 0 ? interval_between(wall, base) : interval_between(base, wall);
}

/* Parallel to a generator: the body lies to one side of its only root, and goes on for ever. */
static tagged_interval along_generator(number_context *c, const line_coefficients *l, int within,
                                       int speed)
{
    const tagged_end apex = {END_TOP, SURE_PART_WALL};
    int rising = number_sign(c, l->b);
    if (rising == 0) {
        if (number_sign(c, l->c) > 0)
            return interval_empty();
        return speed > 0 ? interval_along(apex, base, SURE_PART_WALL)
                         : interval_along(base, apex, SURE_PART_WALL);
    }
    return rising == speed ? interval_empty() : down_to_base(less, within, speed);
}

/* Across the axis at one depth, which is not 0. */
static tagged_interval level(number_context *c, const line_coefficients *l)
{
    int side = number_sign(c, l->base);
    if (side < 0)
        return interval_empty();
    if (side > 0)
        return interval_between(less, more);
    return interval_along((tagged_end){END_LESS, SURE_PART_BASE},
                          (tagged_end){END_MORE, SURE_PART_BASE}, SURE_PART_BASE);
}

/* The wall touched in one point, above the base, on its rim or below; where both roots are at the
 * depth of the apex they are the apex. */
static tagged_interval touch(int above)
{
    if (above < 0)
        return interval_empty();
    return interval_point((tagged_end){END_TANGENT, above == 0 ? SURE_PART_BASE : SURE_PART_WALL});
}

/* Both roots on the kept nappe; `beyond` is the sign of the base's t - vertex. */
static tagged_interval above_base(int within, int beyond, int speed)
{
    if (within < 0)
        return beyond == speed ? interval_between(less, more) : interval_empty();
    if (within == 0 && beyond != speed)
        return interval_point(base);
    return speed > 0 ? interval_between(less, base) : interval_between(base, more);
}

/* Ray and cone seen from the apex. */
typedef struct {
    vector axis, m, d;
    number r, height, slant, depth;
} view;

/* And the coefficients that tell whether the line meets the body at all. */
static view view_of(number_context *c, const sure_ray *ray, const sure_cone *s,
                    line_coefficients *l)
{
    view v = {.axis = vector_between(c, s->apex, s->base),
              .m = vector_between(c, s->apex, ray->origin),
              .d = vector_of(c, ray->direction),
              .r = number_of(c, s->radius)};
    v.height = vector_square(c, v.axis);
    v.slant = number_add(c, v.height, number_square(c, v.r));
    v.depth = vector_dot(c, v.axis, v.m);
    l->speed = vector_dot(c, v.axis, v.d);
    l->quarter = difference_exact(c, cone_discriminant_exact(c, v.axis, v.height, v.d, v.m, v.r));
    l->a = difference_exact(
        c, cone_form_exact(c, v.height, v.slant, vector_square(c, v.d), l->speed, l->speed));
    return v;
}

/* The others. */
static void add_rest(number_context *c, const view *v, line_coefficients *l)
{
    l->b = difference_exact(
        c, cone_form_exact(c, v->height, v->slant, vector_dot(c, v->m, v->d), v->depth, l->speed));
    l->factor = number_square(c, v->height);
    l->c = difference_exact(
        c, cone_form_exact(c, v->height, v->slant, vector_square(c, v->m), v->depth, v->depth));
}

tagged_interval cone_wall_exact(number_context *c, const sure_ray *ray, const void *shape,
                                line_coefficients *l)
{
    const view v = view_of(c, ray, shape, l);
    int leading = number_sign(c, l->a), crosses = number_sign(c, l->quarter);
    if (leading > 0 && crosses < 0)
        return interval_empty();
    add_rest(c, &v, l);
    if (leading != 0)
        return crosses == 0 ? interval_point((tagged_end){END_TANGENT, SURE_PART_WALL})
                            : interval_between(less, more);
    if (number_sign(c, l->b) != 0)
        return interval_point(less);
    return number_sign(c, l->c) == 0 ? interval_endless(SURE_PART_WALL) : interval_empty();
}

tagged_interval cone_exact_interval(number_context *c, const sure_ray *ray, const void *shape,
                                    line_coefficients *l)
{
    const view v = view_of(c, ray, shape, l);
    int leading = number_sign(c, l->a), crosses = leading <= 0 ? 1 : number_sign(c, l->quarter);
    if (crosses < 0)
        return interval_empty();

    add_rest(c, &v, l);
    number m_d = vector_dot(c, v.m, v.d);
    two_terms_exact at =
        cone_touch_exact(c, l->a, v.height, v.depth, l->speed, m_d, vector_square(c, v.d));
    int nappe = leading > 0 ? number_sign(c, at.more) : 1;
    if (nappe < 0)
        return interval_empty();
    if (leading > 0 && (nappe == 0 || crosses == 0))
        return touch(nappe == 0 ? 1 : number_sign(c, at.less));

    l->base = number_sub(c, v.height, v.depth);
    l->top = number_negate(c, v.depth);
    int speed = number_sign(c, l->speed);
    if (speed == 0)
        return level(c, l);
    int within =
        capped_within(c, l->speed, number_negate(c, l->base), vector_sub(c, v.m, v.axis), v.d, v.r);
    if (leading == 0)
        return along_generator(c, l, within, speed);
    if (leading < 0)
        return down_to_base(speed > 0 ? more : less, within, speed);
    return above_base(within, within > 0 ? 0 : speed * number_sign(c, at.less), speed);
}

/* Half the body's gradient; on the wall, where H^2 p.p = K (A.p)^2, its length
 * is (A.p) r sqrt(K H). */
static sure_vec3 wall_normal(number_context *c, const capped_point *w, const line_coefficients *l,
                             end_kind at)
{
    number depth = vector_dot(c, w->axis, w->m), speed = vector_dot(c, w->axis, w->d);
    number slant = number_add(c, w->height, number_square(c, w->radius));
    vector alpha = cone_gradient_exact(c, w->axis, w->height, slant, w->m, depth);
    vector beta = cone_gradient_exact(c, w->axis, w->height, slant, w->d, speed);
    return round_over_root(c, l, at, alpha, beta, number_mul(c, depth, w->radius),
                           number_mul(c, speed, w->radius), number_mul(c, slant, w->height));
}

/* The gradient at a rational t = n/d, where it has a length of its own. */
static sure_vec3 rational_normal(number_context *c, const capped_point *w, number n, number d)
{
    vector p = vector_add(c, vector_scale(c, d, w->m), vector_scale(c, n, w->d));
    number slant = number_add(c, w->height, number_square(c, w->radius));
    vector outward =
        cone_gradient_exact(c, w->axis, w->height, slant, p, vector_dot(c, w->axis, p));
    return round_unit(c, d.sign > 0 ? outward : vector_negate(c, outward));
}

static bool at_apex(number_context *c, const capped_point *w, const line_coefficients *l,
                    end_kind at, number n, number d)
{
    number depth = vector_dot(c, w->axis, w->m), speed = vector_dot(c, w->axis, w->d);
    if (is_root(at))
        return sign_of_linear(c, l, at, depth, speed) == 0;
    return number_sign(c, number_add(c, number_mul(c, depth, d), number_mul(c, speed, n))) == 0;
}

sure_vec3 cone_round_normal(number_context *c, const sure_ray *ray, const void *shape,
                            const line_coefficients *l, tagged_end at)
{
    const sure_cone *s = shape;
    capped_point w = capped_point_of(c, ray, s->apex, s->base, s->radius);
    if (at.part == SURE_PART_BASE)
        return round_unit(c, w.axis);
    number n = number_of(c, 0), d = n;
    if (!is_root(at.at))
        rational_t(c, ray, l, at.at, &n, &d);
    if (at_apex(c, &w, l, at.at, n, d))
        return round_unit(c, vector_negate(c, w.axis));
    if (w.radius.sign == 0)
        return round_unit(c, vector_negate(c, w.d));
    return is_root(at.at) ? wall_normal(c, &w, l, at.at) : rational_normal(c, &w, n, d);
}
