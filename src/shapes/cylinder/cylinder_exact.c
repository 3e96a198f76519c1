/* SPDX-License-Identifier: MIT */
/* The cylinder in exact numbers (cylinder_tmpl.h has its polynomials). */
#include "../capped/capped_stages.h"

#define NUMBER exact
#include "cylinder_tmpl.h"

#define NUMBER exact

typedef struct {
    tagged_end end;
    int within; /* the crossing of its plane is inside, at, outside the wall: 1, 0, -1 */
    int beyond; /* sign of its t - vertex; not set when within */
} cap;

/* m is seen from the cap's centre, h = A.m. The crossing is at t = -h / e, and t - vertex has the
 * sign of (e m.d - h d.d) e. */
static cap cap_at(number_context *c, tagged_end end, const line_coefficients *l, vector m, vector d,
                  number h, number r)
{
    int within = capped_within(c, l->speed, h, m, d, r);
    number ahead = number_minor(c, h, l->speed, vector_dot(c, m, d), vector_square(c, d));
    int beyond = within > 0 ? 0 : -number_sign(c, ahead) * number_sign(c, l->speed);
    return (cap){end, within, beyond};
}

/* The body's end or the slab's, whichever leaves less. Where the slab ends before the body begins
 * there is nothing; at the body's other end there is that point alone. */
static tagged_interval within_slab(cap first, cap second)
{
    if ((first.within < 0 && first.beyond > 0) || (second.within < 0 && second.beyond < 0))
        return interval_empty();
    if (first.within == 0 && first.beyond > 0)
        return interval_point(first.end);
    if (second.within == 0 && second.beyond < 0)
        return interval_point(second.end);
    return interval_between(first.within < 0 ? (tagged_end){END_LESS, SURE_PART_WALL} : first.end,
                            second.within < 0 ? (tagged_end){END_MORE, SURE_PART_WALL}
                                              : second.end);
}

/* The wall touched in one point; on a rim it counts as the cap's. */
static tagged_interval touch(number_context *c, two_terms_exact at)
{
    int above_base = number_sign(c, at.more), below_top = number_sign(c, at.less);
    if (above_base < 0 || below_top < 0)
        return interval_empty();
    return interval_point((tagged_end){END_TANGENT, above_base == 0  ? SURE_PART_BASE
                                                    : below_top == 0 ? SURE_PART_TOP
                                                                     : SURE_PART_WALL});
}

/* The line crosses the axis's direction at right angles, at one height. */
static tagged_interval level(number_context *c, const line_coefficients *l)
{
    int above_base = -number_sign(c, l->base), below_top = number_sign(c, l->top);
    if (above_base < 0 || below_top < 0)
        return interval_empty();
    sure_part part = above_base == 0  ? SURE_PART_BASE
                     : below_top == 0 ? SURE_PART_TOP
                                      : SURE_PART_WALL;
    tagged_end enter = {END_LESS, part}, leave = {END_MORE, part};
    return part != SURE_PART_WALL ? interval_along(enter, leave, part)
                                  : interval_between(enter, leave);
}

/* Ray and cylinder seen from the base. */
typedef struct {
    vector axis, m, d;
    number r, along, m_d;
} view;

/* And the coefficients that tell whether the line meets the body at all. */
static view view_of(number_context *c, const sure_ray *ray, const sure_cylinder *s,
                    line_coefficients *l)
{
    view v = {.axis = vector_between(c, s->base, s->top),
              .m = vector_between(c, s->base, ray->origin),
              .d = vector_of(c, ray->direction),
              .r = number_of(c, s->radius)};
    vector across = vector_cross(c, v.axis, v.d);
    l->a = vector_square(c, across);
    l->quarter = difference_exact(c, cylinder_discriminant_exact(c, l->a, across, v.m, v.r));
    return v;
}

/* The vertex; then the other coefficient. */
static void add_vertex(number_context *c, view *v, line_coefficients *l)
{
    v->along = vector_dot(c, v->axis, v->m);
    v->m_d = vector_dot(c, v->m, v->d);
    l->factor = vector_square(c, v->axis);
    l->speed = vector_dot(c, v->axis, v->d);
    l->b = cylinder_form_exact(c, l->factor, v->m_d, v->along, l->speed);
}

static void add_rest(number_context *c, const view *v, line_coefficients *l)
{
    number arms = vector_square(c, vector_cross(c, v->axis, v->m));
    l->c = difference_exact(c, cylinder_body_exact(c, arms, l->factor, v->r));
}

tagged_interval cylinder_wall_exact(number_context *c, const sure_ray *ray, const void *shape,
                                    line_coefficients *l)
{
    view v = view_of(c, ray, shape, l);
    int crosses = number_sign(c, l->quarter);
    if (crosses < 0)
        return interval_empty();
    add_vertex(c, &v, l);
    add_rest(c, &v, l);
    if (number_sign(c, l->a) == 0)
        return number_sign(c, l->c) == 0 ? interval_endless(SURE_PART_WALL) : interval_empty();
    tagged_end less = {END_LESS, SURE_PART_WALL}, more = {END_MORE, SURE_PART_WALL};
    return crosses == 0 ? interval_point((tagged_end){END_TANGENT, SURE_PART_WALL})
                        : interval_between(less, more);
}

tagged_interval cylinder_exact_interval(number_context *c, const sure_ray *ray, const void *shape,
                                        line_coefficients *l)
{
    const tagged_end base = {END_BASE, SURE_PART_BASE}, top = {END_TOP, SURE_PART_TOP};
    view v = view_of(c, ray, shape, l);
    int crosses = number_sign(c, l->quarter);
    if (crosses < 0)
        return interval_empty();

    add_vertex(c, &v, l);
    int leading = number_sign(c, l->a);
    if (crosses == 0 && leading > 0)
        return touch(
            c, cylinder_touch_exact(c, l->a, v.along, l->speed, v.m_d, vector_square(c, v.d)));

    add_rest(c, &v, l);
    l->base = number_negate(c, v.along);
    l->top = number_add(c, l->factor, l->base);
    int speed = number_sign(c, l->speed);
    if (leading == 0) { /* parallel to the axis */
        int side = number_sign(c, l->c);
        tagged_end enter = speed > 0 ? base : top, leave = speed > 0 ? top : base;
        return side > 0    ? interval_empty()
               : side == 0 ? interval_along(enter, leave, SURE_PART_WALL)
                           : interval_between(enter, leave);
    }
    if (speed == 0)
        return level(c, l);
    cap at_base = cap_at(c, base, l, v.m, v.d, v.along, v.r);
    cap at_top = cap_at(c, top, l, vector_sub(c, v.m, v.axis), v.d, number_negate(c, l->top), v.r);
    return speed > 0 ? within_slab(at_base, at_top) : within_slab(at_top, at_base);
}

/* (H p - (A.p) A) / (H r) */
static sure_vec3 wall_normal(number_context *c, const sure_ray *ray, const capped_point *w,
                             const line_coefficients *l, end_kind at)
{
    number along = vector_dot(c, w->axis, w->m), speed = vector_dot(c, w->axis, w->d);
    vector alpha = cylinder_gradient_exact(c, w->axis, w->height, w->m, along);
    vector beta = cylinder_gradient_exact(c, w->axis, w->height, w->d, speed);
    return round_linear_vector(c, ray, l, at, alpha, beta, number_mul(c, w->height, w->radius));
}

sure_vec3 cylinder_round_normal(number_context *c, const sure_ray *ray, const void *shape,
                                const line_coefficients *l, tagged_end at)
{
    const sure_cylinder *s = shape;
    capped_point w = capped_point_of(c, ray, s->base, s->top, s->radius);
    if (at.part == SURE_PART_TOP)
        return round_unit(c, w.axis);
    if (at.part == SURE_PART_BASE)
        return round_unit(c, vector_negate(c, w.axis));
    if (w.radius.sign == 0)
        return round_unit(c, vector_negate(c, w.d));
    return wall_normal(c, ray, &w, l, at.at);
}
