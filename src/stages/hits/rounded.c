/* SPDX-License-Identifier: MIT */
#include "beyond.h"

#include <assert.h>

#define NUMBER exact

/* The ray's first boundary point, and its line. Entry: there is one, which is asserted; unasserted
 * who asks all the same gets a number of zeros. */
static tagged_end first_of(number_context *c, const sure_ray *ray, const shape_row *row,
                           const void *shape, line_coefficients *l)
{
    assert(shape_check(row, ray, shape) == SURE_FIELD_NONE);
    tagged_end first = {.at = END_BASE};
    bool leaves;
    const sure_status status = line_hit(c, ray, row, shape, l, &first, &leaves);
    assert(status == SURE_HIT);
    (void)status;
    return first;
}

static sure_vec3 normal_of(const sure_ray *ray, const shape_row *row, const void *shape,
                           bool to_odd)
{
    exact_arena room;
    number_context c = exact_start(&room);
    line_coefficients l = {.a = {0}};
    tagged_end first = first_of(&c, ray, row, shape, &l);
    c.to_odd = to_odd;
    return row->round_normal(&c, ray, shape, &l, first);
}

sure_vec3 rounded_normal(const sure_ray *ray, const shape_row *row, const void *shape)
{
    return normal_of(ray, row, shape, false);
}

sure_vec3 odd_normal(const sure_ray *ray, const shape_row *row, const void *shape)
{
    return normal_of(ray, row, shape, true);
}

double odd_t(const sure_ray *ray, const shape_row *row, const void *shape)
{
    exact_arena room;
    number_context c = exact_start(&room);
    line_coefficients l = {.a = {0}};
    tagged_end first = first_of(&c, ray, row, shape, &l);
    c.to_odd = true;
    return round_t(&c, ray, &l, first.at);
}

sure_vec3 rounded_point(const sure_ray *ray, const shape_row *row, const void *shape)
{
    exact_arena room;
    number_context c = exact_start(&room);
    line_coefficients l = {.a = {0}};
    tagged_end first = first_of(&c, ray, row, shape, &l);
    vector o = vector_of(&c, ray->origin), d = vector_of(&c, ray->direction);
    return round_linear_vector(&c, ray, &l, first.at, o, d, exact_of(&c, 1));
}

/* Sign of t - t' for two points on the ray. */
static int order_of(number_context *c, const sure_ray *ray, const line_coefficients *l, end_kind at,
                    const line_coefficients *other, end_kind other_at)
{
    exact n, d;
    if (!is_root(at)) {
        rational_t(c, ray, l, at, &n, &d);
        if (other_at != END_START)
            return -line_compare(c, other, other_at, n, d);
        exact ahead = exact_sub(c, n, exact_mul(c, d, exact_of(c, ray->t_min)));
        return exact_sign(c, ahead) * exact_sign(c, d);
    }
    if (!is_root(other_at)) {
        rational_t(c, ray, other, other_at, &n, &d);
        return line_compare(c, l, at, n, d);
    }
    int leading = exact_sign(c, other->a);
    if (leading == 0)
        return line_compare(c, l, at, exact_negate(c, other->c), exact_add(c, other->b, other->b));
    int outside = leading * sign_of_quadratic(c, l, at, other->a, other->b, other->c);
    int side = leading * sign_of_linear(c, l, at, other->b, other->a);
    return -root_from_signs(other_at, outside, side);
}

int rounded_order(const sure_ray *ray, const shape_row *first_row, const void *first,
                  const shape_row *second_row, const void *second)
{
    exact_arena room;
    number_context c = exact_start(&room);
    line_coefficients lines[2] = {{.a = {0}}, {.a = {0}}};
    end_kind at = first_of(&c, ray, first_row, first, &lines[0]).at;
    end_kind other_at = first_of(&c, ray, second_row, second, &lines[1]).at;
    return order_of(&c, ray, &lines[0], at, &lines[1], other_at);
}
