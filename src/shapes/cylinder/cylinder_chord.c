/* A = top - base, m = o - base, H = A.A, X = A x d, w = d x m. A point m + t d is as far from the
 * axis as |A x (m + t d)| / |A|:
 *
 *     wall   |A x m + t X|^2 <= r^2 H:   a = X.X,  b = X.(A x m) = H m.d - (A.m)(A.d),
 *            c = |A x m|^2 - r^2 H
 *            b^2 - a c = H (r^2 X.X - (X.m)^2),  since X x (A x m) = A (A.w), A.w = X.m
 *     planes A.(m + t d) = 0 and H:      speed = A.d,  base = -A.m,  top = H - A.m
 *     caps   at t = -A.m / A.d the point is A x (d x m) / A.d = A x w / A.d:
 *            in the cap when |A x w|^2 <= r^2 speed^2;  for the top d x (m - A) = w + X
 *            and it is beyond the wall's vertex -b/a as -d.(A x w) speed says
 */
#include "../../stages/line.h"

typedef struct {
    chord_end end;
    int within; /* the crossing of its plane is inside, at, outside the wall: 1, 0, -1 */
    int beyond; /* sign of its t - vertex; not set when within */
} cap;

static cap cap_at(context *c, chord_end end, vector a, vector d, vector w, number reach, int speed)
{
    vector foot = vector_cross(c, a, w);
    int within = number_sign(c, number_sub(c, reach, vector_square(c, foot)));
    int beyond = within > 0 ? 0 : -number_sign(c, vector_dot(c, d, foot)) * speed;
    return (cap){end, within, beyond};
}

/* The body's end or the slab's, whichever leaves less. Where the slab ends before the body begins
 * there is nothing; at the body's other end there is that point alone. */
static chord within_slab(cap first, cap second)
{
    if ((first.within < 0 && first.beyond > 0) || (second.within < 0 && second.beyond < 0))
        return chord_empty();
    if (first.within == 0 && first.beyond > 0)
        return chord_point(first.end);
    if (second.within == 0 && second.beyond < 0)
        return chord_point(second.end);
    return chord_between(first.within < 0 ? (chord_end){POINT_LESS, SURE_PART_WALL} : first.end,
                         second.within < 0 ? (chord_end){POINT_MORE, SURE_PART_WALL} : second.end);
}

/* The wall touched in one point, at the height H sunk / a, sunk = (A.m)(d.d) - (A.d)(m.d); on a rim
 * it counts as the cap's. */
static chord touch(context *c, const line *l, number sunk)
{
    int above_base = number_sign(c, sunk), below_top = number_sign(c, number_sub(c, l->a, sunk));
    if (above_base < 0 || below_top < 0)
        return chord_empty();
    return chord_point((chord_end){POINT_TOUCH, above_base == 0  ? SURE_PART_BASE
                                                : below_top == 0 ? SURE_PART_TOP
                                                                 : SURE_PART_WALL});
}

/* The line crosses the axis's direction at right angles, at one height. */
static chord level(context *c, const line *l)
{
    int above_base = -number_sign(c, l->base), below_top = number_sign(c, l->top);
    if (above_base < 0 || below_top < 0)
        return chord_empty();
    sure_part part = above_base == 0  ? SURE_PART_BASE
                     : below_top == 0 ? SURE_PART_TOP
                                      : SURE_PART_WALL;
    chord_end enter = {POINT_LESS, part}, leave = {POINT_MORE, part};
    return part != SURE_PART_WALL ? chord_along(enter, leave, part) : chord_between(enter, leave);
}

/* Everything as the comment above has it; sets a and quarter of the line. */
typedef struct {
    vector axis, m, d, across;
    number rr;
} view;

static view view_of(context *c, const sure_ray *ray, const sure_cylinder *cylinder, line *l)
{
    view v = {.axis = vector_between(c, cylinder->base, cylinder->top),
              .m = vector_between(c, cylinder->base, ray->origin),
              .d = vector_of(c, ray->direction),
              .rr = number_square(c, number_of(c, cylinder->radius))};
    v.across = vector_cross(c, v.axis, v.d);
    l->a = vector_square(c, v.across);
    number miss = number_square(c, vector_dot(c, v.across, v.m));
    l->quarter = number_sub(c, number_mul(c, v.rr, l->a), miss);
    return v;
}

chord STAGE(cylinder_chord)(context *c, const sure_ray *ray, const sure_cylinder *cylinder, line *l)
{
    const chord_end base = {POINT_BASE, SURE_PART_BASE}, top = {POINT_TOP, SURE_PART_TOP};
    view v = view_of(c, ray, cylinder, l);
    int crosses = number_sign(c, l->quarter);
    if (crosses < 0 || c->uncertain)
        return chord_empty();

    number along = vector_dot(c, v.axis, v.m), m_d = vector_dot(c, v.m, v.d);
    l->factor = vector_square(c, v.axis);
    l->speed = vector_dot(c, v.axis, v.d);
    l->b = number_minor(c, l->factor, along, l->speed, m_d);
    int leading = number_sign(c, l->a);
    if (crosses == 0 && leading > 0)
        return touch(c, l, number_minor(c, along, l->speed, m_d, vector_square(c, v.d)));

    l->c = number_sub(c, vector_square(c, vector_cross(c, v.axis, v.m)),
                      number_mul(c, v.rr, l->factor));
    l->base = number_negate(c, along);
    l->top = number_add(c, l->factor, l->base);
    int speed = number_sign(c, l->speed);
    if (leading == 0) { /* parallel to the axis */
        int side = number_sign(c, l->c);
        chord_end enter = speed > 0 ? base : top, leave = speed > 0 ? top : base;
        return side > 0    ? chord_empty()
               : side == 0 ? chord_along(enter, leave, SURE_PART_WALL)
                           : chord_between(enter, leave);
    }
    if (speed == 0)
        return level(c, l);
    number reach = number_mul(c, v.rr, number_square(c, l->speed));
    vector w = vector_cross(c, v.d, v.m);
    cap at_base = cap_at(c, base, v.axis, v.d, w, reach, speed);
    cap at_top = cap_at(c, top, v.axis, v.d, vector_add(c, w, v.across), reach, speed);
    return speed > 0 ? within_slab(at_base, at_top) : within_slab(at_top, at_base);
}
