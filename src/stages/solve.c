#include "solve.h"

#include "line.h"

/* t = -q/a and -c/q, q = b + sign(b) sqrt(b^2 - a c): two terms of one sign. The first is the
 * greater root when it is -q/a with -q and a of one sign. b's sign need not be certain: where it
 * isn't, either will do. */
static near root_of(near_context *c, const line *l, point at)
{
    near a = number_value(l->a), b = number_value(l->b);
    near root = near_sqrt(c, near_mul(c, number_value(l->factor), number_value(l->quarter)));
    bool falling = b.hi < 0;
    near q = falling ? near_sub(c, root, b) : near_negate(c, near_add(c, root, b));
    if (near_is_zero(root))
        return near_div(c, near_negate(c, b), a);
    bool only = near_sign(c, a) == 0;
    point direct = (a.hi > 0) == falling ? POINT_MORE : POINT_LESS;
    return !only && at == direct ? near_div(c, q, a) : near_div(c, number_value(l->c), q);
}

static near quotient_of(near_context *c, const line *l, point at)
{
    context own = {false};
    number n, d;
    STAGE(line_rational)(&own, l, at, &n, &d);
    return near_div(c, number_value(n), number_value(d));
}

static near t_of(const sure_ray *ray, const line *l, point at)
{
    near_context c = {false};
    near t = {0, 0, 0};
    switch (at) {
    case POINT_LESS:
    case POINT_MORE: t = root_of(&c, l, at); break;
    case POINT_TOUCH:
    case POINT_BASE:
    case POINT_TOP: t = quotient_of(&c, l, at); break;
    case POINT_START:
        t.hi = ray->t_min; /* or what stands for it, out of range */
        c.uncertain = t.hi > NUMBER_RANGE || (!is_zero_bits(t.hi) && t.hi < 1 / NUMBER_RANGE);
        break;
    case POINT_ENDLESS: break;
    }
    return c.uncertain ? (near){NAN, NAN, NAN} : t;
}

bool STAGE(solve_hit)(const sure_ray *ray, const sure_object *object, solved_hit *found)
{
    context c = {false};
    line l;
    found->status = STAGE(line_hit)(&c, ray, object, &l, &found->end);
    if (!c.uncertain && found->status == SURE_HIT)
        found->t = t_of(ray, &l, found->end.at);
    return !c.uncertain;
}

bool STAGE(solve_interval)(const sure_ray *ray, const sure_object *object, solved_interval *found)
{
    context c = {false};
    line l;
    found->status = STAGE(line_interval)(&c, ray, object, &l, &found->ends);
    if (!c.uncertain && found->status == SURE_HIT) {
        found->t_enter = t_of(ray, &l, found->ends.enter.at);
        found->t_leave = t_of(ray, &l, found->ends.leave.at);
    }
    return !c.uncertain;
}
