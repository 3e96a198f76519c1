/* interval, midpoint: a hit at the very end of the range, or between two doubles. */
#include "regimes_makers.h"

#include <math.h>

/* One end of the range, or both, within `steps` doubles of t. */
static void range_within(layout *lay, draws *d, double t, int steps)
{
    double end = step_ulps(t, draw_integer(d, -steps, steps));
    lay->t_min = 0;
    lay->t_max = HUGE_VAL;
    int which = draw_integer(d, 0, 8);
    if (which >= 4)
        lay->t_min = end;
    if (which <= 4)
        lay->t_max = end;
}

/* t* in whole numbers: the placed t is exact. */
static sure_case interval_at_whole_t(sure_shape shape, draws *d)
{
    layout lay = surface_layout(shape, d);
    lay.d = draw_whole_vector(d, WAY_BITS);
    lay.t = draw_whole(d, TIME_BITS);
    range_within(&lay, d, lay.t, 1);
    pose where = pose_exact(d);
    return place(&lay, &where);
}

/* The values of t at which the ray may cross the boundary, as double finds them. */
typedef struct {
    double t[4];
    int count;
} crossings;

static void add_crossing(crossings *all, double t)
{
    if (t > 0)
        all->t[all->count++] = t;
}

/* Of the plane z = height, within r of the axis; here and below the ray starts at lay->p. */
static void cross_flat(crossings *all, const layout *lay, double height)
{
    if (lay->d.z == 0)
        return;
    double t = (height - lay->p.z) / lay->d.z;
    sure_vec3 at = along(lay->p, t, lay->d);
    if (lay->shape == SURE_SHAPE_PLANE || at.x * at.x + at.y * at.y <= lay->r * lay->r)
        add_crossing(all, t);
}

static void cross_wall(crossings *all, const layout *lay, double t)
{
    double z = lay->p.z + t * lay->d.z;
    if (lay->shape == SURE_SHAPE_SPHERE || (z >= 0 && z <= lay->h))
        add_crossing(all, t);
}

/* Of a t^2 + 2 half_b t + c = 0, within the height. */
static void cross_round(crossings *all, const layout *lay, double a, double half_b, double c)
{
    double discriminant = half_b * half_b - a * c;
    if (discriminant < 0)
        return;
    double far = half_b < 0 ? sqrt(discriminant) - half_b : -sqrt(discriminant) - half_b;
    if (a != 0)
        cross_wall(all, lay, far / a);
    cross_wall(all, lay, c / far);
}

static crossings cross(const layout *lay)
{
    crossings all = {.count = 0};
    sure_vec3 o = lay->p, d = lay->d;
    double rr = lay->r * lay->r, hh = lay->h * lay->h, z = lay->h - o.z;
    double a = d.x * d.x + d.y * d.y;
    double half_b = o.x * d.x + o.y * d.y;
    double c = o.x * o.x + o.y * o.y;
    if (lay->shape != SURE_SHAPE_SPHERE)
        cross_flat(&all, lay, 0);
    if (lay->shape == SURE_SHAPE_CYLINDER)
        cross_flat(&all, lay, lay->h);
    if (lay->shape == SURE_SHAPE_SPHERE)
        cross_round(&all, lay, a + d.z * d.z, half_b + o.z * d.z, c + o.z * o.z - rr);
    else if (lay->shape == SURE_SHAPE_CYLINDER)
        cross_round(&all, lay, a, half_b, c - rr);
    else if (lay->shape == SURE_SHAPE_CONE)
        cross_round(&all, lay, hh * a - rr * d.z * d.z, hh * half_b + rr * z * d.z,
                    hh * c - rr * z * z);
    return all;
}

/* t* mostly irrational, within an ulp or two of what double finds: the numbers are so small that
 * all but the last steps are exact. */
static sure_case interval_at_rounded_t(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole(d, 4)};
    if (has_axis(shape))
        lay.h = draw_whole(d, 4);
    sure_vec3 through = {0, 0, floor(lay.h / 2)};
    through.x = trunc(draw_between(d, -lay.r, lay.r) / 2); /* inside the cone, too */
    lay.p.x = draw_offset(d, 6);
    lay.p.y = draw_offset(d, 6);
    lay.p.z = draw_signed(d, 6); /* off the plane and the disc */
    lay.d = along(through, -1, lay.p);
    if (lay.d.x == 0 && lay.d.y == 0 && lay.d.z == 0)
        lay.d.z = 1;
    crossings all = cross(&lay);
    double t = all.count == 0 ? 1 : all.t[draw_integer(d, 0, all.count - 1)];
    range_within(&lay, d, t, 2);
    pose where = pose_exact(d);
    return place(&lay, &where);
}

sure_case make_interval(sure_shape shape, draws *d)
{
    return draw_chance(d, 1, 2) ? interval_at_whole_t(shape, d) : interval_at_rounded_t(shape, d);
}

/* A point p of the boundary in whole numbers, with a direction that enters there. The height is a
 * multiple of 2^LOW_BITS. */
#define LOW_BITS 10

static double draw_step_height(draws *d)
{
    return ldexp(draw_whole(d, 6), LOW_BITS);
}

static sure_vec3 draw_entering(draws *d, sure_vec3 outwards)
{
    for (;;) {
        sure_vec3 v = draw_whole_vector(d, 2);
        double along_normal = v.x * outwards.x + v.y * outwards.y + v.z * outwards.z;
        if (along_normal != 0) {
            double sign = along_normal < 0 ? 1 : -1;
            return (sure_vec3){sign * v.x, sign * v.y, sign * v.z};
        }
    }
}

/* On a plane, a disc or a cap; in a quarter of draws off the disc. */
static void enter_flat(layout *lay, draws *d)
{
    bool top = lay->shape == SURE_SHAPE_CYLINDER && draw_chance(d, 1, 2);
    lay->p.x = floor(draw_between(d, 0, lay->r));
    if (lay->shape == SURE_SHAPE_DISC && draw_chance(d, 1, 4))
        lay->p.x += lay->r;
    lay->p.z = top ? lay->h : 0;
    lay->d = draw_entering(d, (sure_vec3){0, 0, top ? 1 : -1});
}

static void enter_cone_wall(layout *lay, draws *d)
{
    double parts = draw_integer(d, 1, 8), part = draw_integer(d, 0, 8);
    double r_step = draw_whole(d, 10), h_step = draw_step_height(d);
    lay->r = parts * r_step;
    lay->h = parts * h_step;
    part = part > parts ? parts : part;
    lay->p = (sure_vec3){(parts - part) * r_step, 0, part * h_step};
    lay->d = draw_entering(d, (sure_vec3){h_step, 0, r_step});
}

static layout entering_layout(sure_shape shape, draws *d)
{
    layout lay = {.shape = shape, .r = draw_whole_size(d)};
    if (has_axis(shape))
        lay.h = draw_step_height(d);
    bool wall = shape == SURE_SHAPE_SPHERE || (has_axis(shape) && draw_chance(d, 1, 2));
    if (!wall) {
        enter_flat(&lay, d);
    } else if (shape == SURE_SHAPE_CONE) {
        enter_cone_wall(&lay, d);
    } else {
        lay.p.x = lay.r;
        lay.p.z = floor(draw_between(d, 0, lay.h));
        lay.d = draw_entering(d, (sure_vec3){1, 0, 0});
    }
    return lay;
}

/* t* = odd 2^exponent, where doubles are multiples of 2^(exponent + 1). */
typedef struct {
    int64_t odd;
    int exponent;
} midpoint;

static midpoint draw_midpoint(draws *d)
{
    uint64_t random = draw_bits(d);
    int64_t normal = (int64_t)(random >> 11 | (uint64_t)1 << 53 | 1);
    switch (draw_integer(d, 0, 7)) {
    case 0: /* subnormal, of any number of digits */
        return (midpoint){(int64_t)draw_whole(d, 53) | 1, -1075};
    case 1: /* between 0 and the least; between the largest subnormal and the least normal */
        return (midpoint){draw_chance(d, 1, 2) ? 1 : ((int64_t)1 << 53) - 1, -1075};
    case 2: /* between the largest double and infinity */
        return (midpoint){((int64_t)1 << 54) - 1, 970};
    case 3: /* between a power of two and the double below or above it */
        return (midpoint){((int64_t)1 << 53) + (draw_chance(d, 1, 2) ? 1 : ((int64_t)1 << 53) - 1),
                          draw_integer(d, -70, -40)};
    case 4:
        return (midpoint){normal, draw_integer(d, -1075, 969)};
    default:
        return (midpoint){normal, draw_integer(d, -70, -40)};
    }
}

/* The range open, or with an end at a neighbour of t*. */
static void range_at_midpoint(sure_ray *ray, draws *d, midpoint t)
{
    double below = ldexp((double)((t.odd - 1) / 2), t.exponent + 1);
    double above = ldexp((double)((t.odd + 1) / 2), t.exponent + 1);
    ray->t_min = 0;
    ray->t_max = HUGE_VAL;
    int which = draw_integer(d, 0, 9);
    if (which <= 2)
        ray->t_max = below;
    else if (which <= 4)
        ray->t_max = above;
    if (which == 4 || which == 5)
        ray->t_min = below;
    else if (which == 6 && isfinite(above))
        ray->t_min = above;
}

/* Row i of turn times v, in whole numbers. */
static int64_t whole_dot(const sure_vec3 *row, sure_vec3 v)
{
    return (int64_t)row->x * (int64_t)v.x + (int64_t)row->y * (int64_t)v.y +
           (int64_t)row->z * (int64_t)v.z;
}

/* One coordinate of the way from the ray's start to the frame's origin, of up to 62 digits, is
 * shared between the two points: its low digits go to the start, the rest to the object. */
typedef struct {
    int64_t start, object;
} ends;

static ends split(int64_t way, draws *d)
{
    int64_t unit = (int64_t)1 << LOW_BITS;
    int64_t low = (way % unit + unit) % unit;
    int64_t move = (int64_t)draw_offset(d, 40) * unit;
    return (ends){move - low, move + way - low};
}

/* Moves a case that was placed with the frame's origin in the world's, so that the ray is at lay->p
 * at t = t.odd, in the units of the layout. */
static sure_case moved_apart(const sure_case *c, draws *d, const layout *lay, const pose *where,
                             midpoint t)
{
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(c, number);
    for (int i = 0; i < 3; i++) {
        const sure_vec3 *row = &where->turn.row[i];
        ends e = split(t.odd * whole_dot(row, lay->d) - whole_dot(row, lay->p), d);
        number[AT_O + i] = ldexp((double)e.start, where->scale);
        number[AT_PLACE + i] = ldexp((double)e.object, where->scale);
        if (has_axis(lay->shape))
            number[AT_END + i] += number[AT_PLACE + i];
    }
    return case_from_numbers(lay->shape, number);
}

sure_case make_midpoint(sure_shape shape, draws *d)
{
    layout lay = entering_layout(shape, d);
    double q[4] = {draw_integer(d, 1, 2)};
    for (int i = 1; i < 4; i++)
        q[i] = draw_integer(d, -2, 2);
    midpoint t = draw_midpoint(d);
    pose where = pose_turned(q);
    where.scale = t.exponent / 2 - draw_integer(d, 20, 40);
    where.d_scale = where.scale - t.exponent;
    where.n_scale = draw_integer(d, -20, 20);
    sure_case c = place(&lay, &where);
    c = moved_apart(&c, d, &lay, &where, t);
    range_at_midpoint(&c.ray, d, t);
    if (draw_chance(d, 1, 2)) {
        /* To one side by as little as there is: the start's coordinates are the small ones. */
        double *o[3] = {&c.ray.origin.x, &c.ray.origin.y, &c.ray.origin.z};
        double *moved = o[draw_integer(d, 0, 2)];
        *moved = step_ulps(*moved, draw_chance(d, 1, 2) ? 1 : -1);
    }
    return c;
}
