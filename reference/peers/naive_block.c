/* SPDX-License-Identifier: MIT */
/* FROZEN (naive.h). The formulas are those of the peers for one ray; compiled once for each width
 * of vectors. */
#include "naive_block.h"
#include "naive_vector.h"

#include <math.h>

static inline sure_vec3 vector_at(const double *const column[3], size_t i)
{
    return (sure_vec3){column[0][i], column[1][i], column[2][i]};
}

static inline uint8_t status_of(int hit)
{
    return (uint8_t)(hit ? SURE_HIT : SURE_MISS);
}

static void plane_hits(size_t count, const double *const ray[8], const void *object,
                       uint8_t *restrict status, uint8_t *restrict part, double *restrict t)
{
    const sure_plane plane = *(const sure_plane *)object;
    const double *t_min = ray[6], *t_max = ray[7];
    (void)part;
    for (size_t i = 0; i < count; i++) {
        double n_rc = dot(plane.normal, sub(plane.point, vector_at(ray, i)));
        double at = n_rc / dot(plane.normal, vector_at(ray + 3, i));
        t[i] = at;
        status[i] = status_of((at >= t_min[i]) & (at <= t_max[i]));
    }
}

static void disc_hits(size_t count, const double *const ray[8], const void *object,
                      uint8_t *restrict status, uint8_t *restrict part, double *restrict t)
{
    const sure_disc disc = *(const sure_disc *)object;
    const double *t_min = ray[6], *t_max = ray[7];
    (void)part;
    for (size_t i = 0; i < count; i++) {
        sure_vec3 d = vector_at(ray + 3, i), rc = sub(disc.centre, vector_at(ray, i));
        double at = dot(disc.normal, rc) / dot(disc.normal, d);
        sure_vec3 p = {at * d.x - rc.x, at * d.y - rc.y, at * d.z - rc.z};
        t[i] = at;
        status[i] = status_of((at >= t_min[i]) & (at <= t_max[i]) &
                              (dot(p, p) <= disc.radius * disc.radius));
    }
}

static void sphere_hits(size_t count, const double *const ray[8], const void *object,
                        uint8_t *restrict status, uint8_t *restrict part, double *restrict t)
{
    const sure_sphere sphere = *(const sure_sphere *)object;
    const double *t_min = ray[6], *t_max = ray[7];
    (void)part;
    for (size_t i = 0; i < count; i++) {
        sure_vec3 d = vector_at(ray + 3, i), rc = sub(sphere.centre, vector_at(ray, i));
        double a = dot(d, d), b = dot(rc, d);
        double c = dot(rc, rc) - sphere.radius * sphere.radius;
        double quarter = b * b - a * c, root = sqrt(quarter); /* a NaN hits nothing */
        double near = (b - root) / a, far = (b + root) / a;
        double at = near >= t_min[i] ? near : far;
        t[i] = at;
        status[i] = status_of((at >= t_min[i]) & (at <= t_max[i]));
    }
}

/* A chord in two slabs, or in a wall and a slab. */
static inline double later(double x, double y)
{
    return x > y ? x : y;
}

static inline double earlier(double x, double y)
{
    return x < y ? x : y;
}

static void cylinder_hits(size_t count, const double *const ray[8], const void *object,
                          uint8_t *restrict status, uint8_t *restrict part, double *restrict t)
{
    const sure_cylinder cylinder = *(const sure_cylinder *)object;
    const sure_vec3 n = sub(cylinder.top, cylinder.base);
    const double *t_min = ray[6], *t_max = ray[7], n_n = dot(n, n);
    for (size_t i = 0; i < count; i++) {
        sure_vec3 d = vector_at(ray + 3, i), rc = sub(cylinder.base, vector_at(ray, i));
        double n_d = dot(n, d), n_rc = dot(n, rc);
        double a = n_n * dot(d, d) - n_d * n_d;
        double b = n_n * dot(rc, d) - n_d * n_rc;
        double c = n_n * (dot(rc, rc) - cylinder.radius * cylinder.radius) - n_rc * n_rc;
        double quarter = b * b - a * c, root = sqrt(quarter), over_a = 1 / a, over_n_d = 1 / n_d;
        double wall_enter = (b - root) * over_a, wall_leave = (b + root) * over_a;
        double base = n_rc * over_n_d, top = (n_rc + n_n) * over_n_d;
        double slab_enter = earlier(base, top), slab_leave = later(base, top);
        double enter = later(wall_enter, slab_enter), leave = earlier(wall_leave, slab_leave);
        double at = enter >= t_min[i] ? enter : leave;
        uint8_t cap = (uint8_t)(at == base ? SURE_PART_BASE : SURE_PART_TOP);
        t[i] = at;
        part[i] = ((at == base) | (at == top)) ? cap : (uint8_t)SURE_PART_WALL;
        status[i] =
            status_of((quarter >= 0) & (enter <= leave) & (at >= t_min[i]) & (at <= t_max[i]));
    }
}

static void cone_hits(size_t count, const double *const ray[8], const void *object,
                      uint8_t *restrict status, uint8_t *restrict part, double *restrict t)
{
    const sure_cone cone = *(const sure_cone *)object;
    const sure_vec3 n = sub(cone.apex, cone.base);
    const double *t_min = ray[6], *t_max = ray[7], n_n = dot(n, n), n_4 = n_n * n_n;
    const double k = n_n + cone.radius * cone.radius;
    for (size_t i = 0; i < count; i++) {
        sure_vec3 d = vector_at(ray + 3, i), rq = sub(cone.apex, vector_at(ray, i));
        double n_d = dot(n, d), n_rq = dot(n, rq);
        double a = n_4 * dot(d, d) - k * n_d * n_d;
        double b = n_4 * dot(rq, d) - k * n_rq * n_d;
        double c = n_4 * dot(rq, rq) - k * n_rq * n_rq;
        double quarter = b * b - a * c, root = sqrt(quarter), over_a = 1 / a, over_n_d = 1 / n_d;
        double less = (b - root) * over_a, more = (b + root) * over_a;
        double t_apex = n_rq * over_n_d, t_base = (n_rq - n_n) * over_n_d;
        double wall_enter = ((a < 0) & (n_d > 0)) ? -(double)INFINITY : less;
        double wall_leave = ((a < 0) & (n_d <= 0)) ? (double)INFINITY : more;
        double enter = later(wall_enter, earlier(t_base, t_apex));
        double leave = earlier(wall_leave, later(t_base, t_apex));
        double at = enter >= t_min[i] ? enter : leave;
        t[i] = at;
        part[i] = (uint8_t)(at == t_base ? SURE_PART_BASE : SURE_PART_WALL);
        status[i] =
            status_of((quarter >= 0) & (enter <= leave) & (at >= t_min[i]) & (at <= t_max[i]));
    }
}

static void box_hits(size_t count, const double *const ray[8], const void *object,
                     uint8_t *restrict status, uint8_t *restrict part, double *restrict t)
{
    const sure_box box = *(const sure_box *)object;
    const double *t_min = ray[6], *t_max = ray[7];
    for (size_t i = 0; i < count; i++) {
        sure_vec3 o = vector_at(ray, i), d = vector_at(ray + 3, i);
        double over_x = 1 / d.x, over_y = 1 / d.y, over_z = 1 / d.z;
        double x_low = (box.low.x - o.x) * over_x, x_high = (box.high.x - o.x) * over_x;
        double y_low = (box.low.y - o.y) * over_y, y_high = (box.high.y - o.y) * over_y;
        double z_low = (box.low.z - o.z) * over_z, z_high = (box.high.z - o.z) * over_z;
        double enter =
            later(later(earlier(x_low, x_high), earlier(y_low, y_high)), earlier(z_low, z_high));
        double leave =
            earlier(earlier(later(x_low, x_high), later(y_low, y_high)), later(z_low, z_high));
        double at = enter >= t_min[i] ? enter : leave;
        int face = at == x_low ? SURE_PART_X_MIN : SURE_PART_X_MAX;
        face = at == y_low ? SURE_PART_Y_MIN : face;
        face = at == y_high ? SURE_PART_Y_MAX : face;
        face = at == z_low ? SURE_PART_Z_MIN : face;
        face = at == z_high ? SURE_PART_Z_MAX : face;
        t[i] = at;
        part[i] = (uint8_t)face;
        status[i] = status_of((enter <= leave) & (at >= t_min[i]) & (at <= t_max[i]));
    }
}

#define NAME_OF(width) naive_hits_##width
#define NAME(width) NAME_OF(width)
#define ROW(shape, SHAPE) shape##_hits,
extern naive_hits *const NAME(NAIVE_WIDTH)[SURE_SHAPES];
naive_hits *const NAME(NAIVE_WIDTH)[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};
