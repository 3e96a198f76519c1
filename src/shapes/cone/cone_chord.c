/* Q the apex, A = base - Q, m = o - Q, H = A.A, X = A x d, Y = A x m, w = d x m. A point p seen
 * from Q is in the double cone when its distance from the axis, |A x p| / |A|, is at most r |A.p| /
 * H, that of the wall at its depth:
 *
 *     body   H |A x p|^2 - r^2 (A.p)^2 <= 0 with p = m + t d:
 *            a = H X.X - r^2 (A.d)^2,  b = H X.Y - r^2 (A.d)(A.m),  c = H Y.Y - r^2 (A.m)^2
 *            b^2 - a c = H^2 (r^2 H w.w - (H + r^2)(A.w)^2)
 *     planes A.p = H and 0:  speed = A.d,  base = H - A.m,  top = -A.m
 *     disc   seen from the base d x (m - A) = w + X, so the plane is crossed in the disc when
 *            |A x (w + X)|^2 <= r^2 speed^2
 *     depth  of the vertex t = -b/a:  A.p = H^2 ((A.m)(d.d) - (A.d)(m.d)) / a
 *
 * The kept nappe is that of depth A.p >= 0. */
#include "../../stages/line.h"

static const chord_end base = {POINT_BASE, SURE_PART_BASE};
static const chord_end less = {POINT_LESS, SURE_PART_WALL};
static const chord_end more = {POINT_MORE, SURE_PART_WALL};

/* From the wall down to the base, in whichever order the line has them; nothing if the line leaves
 * the base's plane outside the disc (`within` < 0). */
static chord down_to_base(chord_end wall, int within, int speed)
{
    if (within < 0)
        return chord_empty();
    if (within == 0)
        return chord_point(base);
    return speed > 0 ? chord_between(wall, base) : chord_between(base, wall);
}

/* Parallel to a generator: the body lies to one side of its only root, and goes on for ever. */
static chord along_generator(context *c, const line *l, int within, int speed)
{
    const chord_end apex = {POINT_TOP, SURE_PART_WALL};
    int rising = number_sign(c, l->b);
    if (rising == 0) {
        if (number_sign(c, l->c) > 0)
            return chord_empty();
        return speed > 0 ? chord_along(apex, base, SURE_PART_WALL)
                         : chord_along(base, apex, SURE_PART_WALL);
    }
    return rising == speed ? chord_empty() : down_to_base(less, within, speed);
}

/* Across the axis at one depth, which is not 0. */
static chord level(context *c, const line *l)
{
    int side = number_sign(c, l->base);
    if (side < 0)
        return chord_empty();
    if (side > 0)
        return chord_between(less, more);
    return chord_along((chord_end){POINT_LESS, SURE_PART_BASE},
                       (chord_end){POINT_MORE, SURE_PART_BASE}, SURE_PART_BASE);
}

/* The wall touched in one point, above the base, on its rim or below; where both roots are at the
 * depth of the apex they are the apex. */
static chord touch(int above)
{
    if (above < 0)
        return chord_empty();
    return chord_point((chord_end){POINT_TOUCH, above == 0 ? SURE_PART_BASE : SURE_PART_WALL});
}

/* Both roots on the kept nappe; `beyond` is the sign of the base's t - vertex. */
static chord above_base(int within, int beyond, int speed)
{
    if (within < 0)
        return beyond == speed ? chord_between(less, more) : chord_empty();
    if (within == 0 && beyond != speed)
        return chord_point(base);
    return speed > 0 ? chord_between(less, base) : chord_between(base, more);
}

typedef struct {
    vector axis, m, d, w;
    number rr, height;
} view;

/* Everything as the comment above has it; sets the line's quarter. */
static view view_of(context *c, const sure_ray *ray, const sure_cone *cone, line *l)
{
    view v = {.axis = vector_between(c, cone->apex, cone->base),
              .m = vector_between(c, cone->apex, ray->origin),
              .d = vector_of(c, ray->direction),
              .rr = number_square(c, number_of(c, cone->radius))};
    v.w = vector_cross(c, v.d, v.m);
    v.height = vector_square(c, v.axis);
    number bent = number_mul(c, number_mul(c, v.rr, v.height), vector_square(c, v.w));
    number miss = number_square(c, vector_dot(c, v.axis, v.w));
    l->quarter = number_sub(c, bent, number_mul(c, number_add(c, v.height, v.rr), miss));
    return v;
}

chord STAGE(cone_chord)(context *c, const sure_ray *ray, const sure_cone *cone, line *l)
{
    view v = view_of(c, ray, cone, l);
    vector across = vector_cross(c, v.axis, v.d);
    l->speed = vector_dot(c, v.axis, v.d);
    number reach = number_mul(c, v.rr, number_square(c, l->speed));
    l->a = number_sub(c, number_mul(c, v.height, vector_square(c, across)), reach);
    int leading = number_sign(c, l->a), crosses = leading <= 0 ? 1 : number_sign(c, l->quarter);
    if (crosses < 0 || c->uncertain)
        return chord_empty();

    number depth = vector_dot(c, v.axis, v.m), m_d = vector_dot(c, v.m, v.d);
    number across_b = number_minor(c, v.height, depth, l->speed, m_d);
    l->b = number_sub(c, number_mul(c, v.height, across_b),
                      number_mul(c, number_mul(c, v.rr, l->speed), depth));
    number sunk = number_minor(c, depth, l->speed, m_d, vector_square(c, v.d));
    number above = number_sub(c, l->a, number_mul(c, v.height, sunk));
    int nappe = leading > 0 ? number_sign(c, sunk) : 1;
    if (nappe < 0)
        return chord_empty();
    if (leading > 0 && (nappe == 0 || crosses == 0))
        return touch(nappe == 0 ? 1 : number_sign(c, above));

    l->factor = number_square(c, v.height);
    l->c = number_sub(c, number_mul(c, v.height, vector_square(c, vector_cross(c, v.axis, v.m))),
                      number_mul(c, v.rr, number_square(c, depth)));
    l->base = number_sub(c, v.height, depth);
    l->top = number_negate(c, depth);
    int speed = number_sign(c, l->speed);
    if (speed == 0)
        return level(c, l);
    vector foot = vector_cross(c, v.axis, vector_add(c, v.w, across));
    int within = number_sign(c, number_sub(c, reach, vector_square(c, foot)));
    if (leading == 0)
        return along_generator(c, l, within, speed);
    if (leading < 0)
        return down_to_base(speed > 0 ? more : less, within, speed);
    return above_base(within, within > 0 ? 0 : speed * number_sign(c, above), speed);
}
