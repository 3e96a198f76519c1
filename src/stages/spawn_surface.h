/* The function whose zeros are the surface at a hit, at the point of its t and around: that of the
 * part that is hit as where.h has it, in twice the precision, with its gradient and how it may
 * change; and how far the solid's other functions are from 0. docs/proofs/spawn.md counts the
 * bounds, which take 2^-53 for an operation: round to nearest. Vectors are measured by their
 * components' magnitudes, summed. */
#ifndef STAGES_SPAWN_SURFACE_H
#define STAGES_SPAWN_SURFACE_H

#include "../shapes/capped/axial_filter.h"
#include "../shapes/capped/axial_polish.h"
#include "../shapes/plane/plane_filter.h"
#include "../shapes/sphere/sphere_filter.h"

#include <surehit/object.h>

/* n, n.v, A.p and H are off by less than this times their terms, besides what is said of them, and
 * candidates from P by this times |p|. */
#define QUICK_SPAWN_SHARE 0x1p-50
/* The normal that spawn.c takes is off by less than this times its terms. */
#define QUICK_SPAWN_OUTWARD 0x1p-48

static inline double dot_of(sure_vec3 v, sure_vec3 w)
{
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

static inline sure_vec3 cross_of(sure_vec3 v, sure_vec3 w)
{
    return (sure_vec3){v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}

/* |v|, here as in the filters the sum of magnitudes. */
static inline double measure_of(sure_vec3 v)
{
    return sum_of_magnitudes(v.x, v.y, v.z);
}

/* 0 where 2^-64 <= x < 2^64. */
static inline uint64_t beyond(double x)
{
    return (bits_of(x) - bits_of(0x1p-64)) >> 59;
}

/* o + t d */
typedef struct {
    double_pair x, y, z;
    double most; /* |o| + |t d| */
} line_point;

static inline double_pair line_coordinate(double o, double d, double t, double *most)
{
    double_pair way = two_product(t, d), x = two_sum(o, way.head);
    *most += fabs(o) + fabs(way.head);
    return (double_pair){x.head, x.tail + way.tail};
}

static inline line_point line_point_of(const sure_ray *ray, double t)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    line_point at = {.most = 0};
    at.x = line_coordinate(o->x, d->x, t, &at.most);
    at.y = line_coordinate(o->y, d->y, t, &at.most);
    at.z = line_coordinate(o->z, d->z, t, &at.most);
    return at;
}

static inline polish_component seen_coordinate(double_pair at, double from)
{
    double_pair x = two_sum(at.head, -from);
    return (polish_component){x.head, x.tail + at.tail, fabs(x.head)};
}

/* As well known as polish.h says, with a `most` of its own. */
static inline polish_point seen_from(const sure_vec3 *from, const line_point *at)
{
    polish_component x = seen_coordinate(at->x, from->x), y = seen_coordinate(at->y, from->y);
    polish_component z = seen_coordinate(at->z, from->z);
    return (polish_point){x, y, z, x.most + y.most + z.most + at->most};
}

static inline sure_vec3 heads_of(const polish_point *p)
{
    return (sure_vec3){p->x.head, p->y.head, p->z.head};
}

/* Of a plane across a coordinate axis all points have that coordinate, exactly. */
typedef struct {
    int axis; /* 0, 1, 2; -1 for no such plane */
    double at, up;
} level;

/* x, y, z: is that component of the normal n other than 0? */
static inline level level_of(bool x, bool y, bool z, sure_vec3 n, const sure_vec3 *at)
{
    if (x + y + z != 1)
        return (level){.axis = -1};
    return x ? (level){0, at->x, n.x} : y ? (level){1, at->y, n.y} : (level){2, at->z, n.z};
}

/* F at the point of the hit's t, and around. */
typedef struct {
    double f, f_error;
    sure_vec3 n;          /* its gradient there, */
    double grain, bend;   /* off by grain at most, and by bend for each 1 that one goes */
    double outward_error; /* what spawn.c's normal is off by, when as long as n */
    double room, steep;   /* the other functions are -room at most, and rise by steep */
    uint64_t beyond;      /* 0: all is in range */
    level level;
} surface;

/* x + y where they all but cancel, so that the sum of their heads is as good as exact. */
static inline double remainder_of(double_pair x, double_pair y)
{
    return (x.head + y.head) + (x.tail + y.tail);
}

static inline double_pair flat_product(double n, polish_component x)
{
    double_pair product = two_product(n, x.head);
    product.tail += n * x.tail;
    return product;
}

/* F = N.p */
static inline surface flat_surface(const line_point *line, const sure_vec3 *place,
                                   const sure_vec3 *normal)
{
    polish_point p = seen_from(place, line);
    double size = measure_of(*normal);
    double_pair xy = axial_sum(flat_product(normal->x, p.x), flat_product(normal->y, p.y));
    return (surface){.f = remainder_of(xy, flat_product(normal->z, p.z)),
                     .f_error = SURE_CROSSING_RESIDUAL_BOUND * size * p.most,
                     .n = *normal,
                     .beyond = beyond(size) | beyond(p.most),
                     .level = level_of(!is_zero_bits(normal->x), !is_zero_bits(normal->y),
                                       !is_zero_bits(normal->z), *normal, place)};
}

/* 2 F = |p|^2 - r^2 */
static inline surface sphere_surface(const line_point *line, const sure_sphere *sphere)
{
    polish_point p = seen_from(&sphere->centre, line);
    double_pair xy = axial_sum(sphere_square(p.x), sphere_square(p.y));
    double_pair rr = two_product(sphere->radius, sphere->radius);
    double f = remainder_of(axial_sum(xy, sphere_square(p.z)), axial_negative(rr));
    sure_vec3 n = heads_of(&p);
    double size = measure_of(n) + QUICK_SPAWN_SHARE * p.most;
    return (surface){.f = 0.5 * f,
                     .f_error = 0.5 * SURE_SPHERE_RESIDUAL_BOUND * size * p.most,
                     .n = n,
                     .grain = QUICK_SPAWN_SHARE * p.most,
                     .bend = 1,
                     .beyond = beyond(size) | beyond(p.most),
                     .level = {.axis = -1}};
}

static inline axial_point axial_at(const line_point *line, const sure_vec3 *from,
                                   const sure_vec3 *to, const sure_vec3 *place)
{
    axial_point at = {.ax = two_sum(to->x, -from->x),
                      .ay = two_sum(to->y, -from->y),
                      .az = two_sum(to->z, -from->z),
                      .p = seen_from(place, line)};
    at.a_most = sum_of_magnitudes(at.ax.head, at.ay.head, at.az.head);
    return at;
}

static inline uint64_t axial_beyond(const axial_point *at, double r)
{
    return beyond(at->a_most) | beyond(at->p.most) | beyond(r);
}

static inline sure_vec3 axis_of(const axial_point *at)
{
    return (sure_vec3){at->ax.head, at->ay.head, at->az.head};
}

/* (A x p) x A */
static inline sure_vec3 radial_of(const axial_point *at)
{
    sure_vec3 arm = {axial_value(axial_minor(at->ay, at->az, at->p.y, at->p.z)),
                     axial_value(axial_minor(at->az, at->ax, at->p.z, at->p.x)),
                     axial_value(axial_minor(at->ax, at->ay, at->p.x, at->p.y))};
    return cross_of(arm, axis_of(at));
}

/* What both walls have, F's terms being of |A| |p| size. The other functions are -A.p and A.p - H.
 */
static inline surface wall_surface(const axial_point *at, double f, double size, double bend,
                                   double height, double depth)
{
    double a = at->a_most, most = at->p.most;
    return (surface){.f = f,
                     .f_error = 0.5 * SURE_AXIAL_RESIDUAL_BOUND * (a * size) * most,
                     .grain = QUICK_SPAWN_SHARE * (a * size + QUICK_SPAWN_SHARE * (bend * most)),
                     .bend = bend,
                     .outward_error = QUICK_SPAWN_OUTWARD * (bend * most),
                     .room = filter_lesser(depth, height - depth) -
                             QUICK_SPAWN_SHARE * (a * (a + most)),
                     .steep = a,
                     .level = {.axis = -1}};
}

/* 2 F = |A x p|^2 - r^2 H, p seen from the base */
static inline surface cylinder_surface(const line_point *line, const sure_cylinder *s)
{
    axial_point at = axial_at(line, &s->base, &s->top, &s->base);
    axial_radius radius = axial_radius_of(&at);
    double_pair height = axial_height(&at), rr = two_product(s->radius, s->radius);
    double f = remainder_of(radius.square, axial_negative(axial_product(rr, height)));
    double a = at.a_most, depth = dot_of(axis_of(&at), heads_of(&at.p));
    surface wall =
        wall_surface(&at, 0.5 * f, radius.most + s->radius * a, a * a, height.head, depth);
    wall.n = radial_of(&at);
    wall.beyond = axial_beyond(&at, s->radius);
    return wall;
}

/* 2 F = H |A x p|^2 - r^2 (A.p)^2, p seen from the apex */
static inline surface cone_surface(const line_point *line, const sure_cone *s)
{
    axial_point at = axial_at(line, &s->apex, &s->base, &s->apex);
    axial_radius radius = axial_radius_of(&at);
    double_pair height = axial_height(&at), along = axial_along(&at);
    double_pair rr = two_product(s->radius, s->radius);
    double_pair across = axial_product(height, radius.square);
    double f = remainder_of(across, axial_negative(axial_product(rr, axial_square(along))));
    double a = at.a_most, h = height.head, depth = axial_value(along), inward = rr.head * depth;
    surface wall = wall_surface(&at, 0.5 * f, h * radius.most + fabs(inward),
                                (h + rr.head) * (a * a), h, depth);
    sure_vec3 out = radial_of(&at), axis = axis_of(&at);
    wall.n = (sure_vec3){h * out.x - inward * axis.x, h * out.y - inward * axis.y,
                         h * out.z - inward * axis.z};
    wall.beyond = axial_beyond(&at, s->radius);
    return wall;
}

/* As numbers, whatever is flushed. */
static inline bool differ(double x, double y)
{
    return bits_of(x) != bits_of(y) && !(is_zero_bits(x) && is_zero_bits(y));
}

/* F = A.p, with A pointing out of the plane at `place` and p seen from there. The other functions
 * are the other plane's and the wall's: |A x p|^2 - r^2 H, or for the cone, with p seen from the
 * apex, |A x p|^2 - r^2 (A.p)^2 / H. */
static inline surface cap_surface(const line_point *line, const sure_vec3 *from,
                                  const sure_vec3 *place, double r)
{
    axial_point at = axial_at(line, from, place, place);
    double_pair x = axial_product(at.ax, axial_pair(at.p.x));
    double_pair y = axial_product(at.ay, axial_pair(at.p.y));
    double_pair z = axial_product(at.az, axial_pair(at.p.z));
    sure_vec3 n = axis_of(&at), arm = cross_of(n, heads_of(&at.p));
    double a = at.a_most, rr = r * r, steep = a * (2 * measure_of(arm) + r * a + 2 * rr);
    double gap = (1 - 4 * QUICK_SPAWN_SHARE) * (rr * dot_of(n, n)) - dot_of(arm, arm);
    return (surface){.f = remainder_of(axial_sum(x, y), z),
                     .f_error = SURE_AXIAL_PLANE_RESIDUAL_BOUND * a * at.p.most,
                     .n = n,
                     .room = gap - QUICK_SPAWN_SHARE * (steep * at.p.most),
                     .steep = steep,
                     .beyond = axial_beyond(&at, r),
                     .level = level_of(differ(from->x, place->x), differ(from->y, place->y),
                                       differ(from->z, place->z), n, place)};
}

#endif
