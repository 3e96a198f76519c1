/* SPDX-License-Identifier: MIT */
/* Stands for the tracers with absolute epsilons, which most tutorials have: what is nearer than one
 * is no hit, what is smaller than one is zero, whatever the size of the scene. In double.
 *
 *     sphere       K. Beason: smallpt, https://www.kevinbeason.com/smallpt/: directions of length
 *                  1, discriminant b^2 - m.m + r^2, a hit from a distance of 1e-4 on
 *     plane, disc  Scratchapixel: A Minimal Ray-Tracer, https://www.scratchapixel.com (ray-plane
 *                  and ray-disk intersection): parallel where |N.d| <= 1e-6, N and d of length 1
 *     cylinder     J. Buck: The Ray Tracer Challenge. Pragmatic Bookshelf 2019, 13 (cylinders):
 *     and cone     about an axis, radius 1, truncated and capped; 1e-5 for what is about zero
 *
 * The epsilon of the sphere's start is counted from t_min; the models have no range else. */
#include "axis_frame.h"
#include "peer.h"

#define SMALLPT_EPSILON 1e-4
#define PARALLEL_EPSILON 1e-6
#define CHALLENGE_EPSILON 1e-5

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

int PEER(sphere)(const real *numbers, const real *sphere, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    real length = square_root(dot(ray.d, ray.d));
    vec3 d = scaled(1 / length, ray.d), m = sub(vector(sphere), ray.o);
    real b = dot(m, d), discriminant = b * b - dot(m, m) + sphere[3] * sphere[3];
    if (discriminant < 0)
        return SURE_CANDIDATE_MISS;
    real root = square_root(discriminant), start = ray.t_min * length + SMALLPT_EPSILON;
    real distance = b - root > start ? b - root : b + root > start ? b + root : 0;
    real t = distance / length;
    return distance > 0 && t <= ray.t_max ? found(hit, t, SURE_CANDIDATE_SURFACE)
                                          : SURE_CANDIDATE_MISS;
}

/* The plane's t; 0 if it is parallel or out of the range. */
static int meets_plane(const peer_ray *ray, vec3 at, vec3 normal, real *t)
{
    real length = square_root(dot(ray->d, ray->d));
    vec3 n = scaled(1 / square_root(dot(normal, normal)), normal), d = scaled(1 / length, ray->d);
    real climb = dot(n, d);
    if (!(size_of(climb) > PARALLEL_EPSILON))
        return 0;
    *t = dot(sub(at, ray->o), n) / climb / length;
    return is_in_range(ray, *t);
}

int PEER(plane)(const real *numbers, const real *plane, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    real t;
    return meets_plane(&ray, vector(plane), vector(plane + 3), &t)
               ? found(hit, t, SURE_CANDIDATE_SURFACE)
               : SURE_CANDIDATE_MISS;
}

int PEER(disc)(const real *numbers, const real *disc, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 centre = vector(disc);
    real t;
    if (!meets_plane(&ray, centre, vector(disc + 3), &t))
        return SURE_CANDIDATE_MISS;
    vec3 p = along(sub(ray.o, centre), t, ray.d);
    return dot(p, p) <= disc[6] * disc[6] ? found(hit, t, SURE_CANDIDATE_SURFACE)
                                          : SURE_CANDIDATE_MISS;
}

/* The ray in the frame of a body about z, scaled to x^2 + y^2 = 1, or = z^2 for the cone; and the
 * least t so far. */
typedef struct {
    const peer_ray *ray;
    vec3 o, d;
    real bottom, top;
    real t;
    int part;
} body;

static void take(body *all, real t, int part)
{
    if (is_in_range(all->ray, t) && t < all->t) {
        all->t = t;
        all->part = part;
    }
}

static void take_wall(body *all, real t)
{
    real z = all->o.z + t * all->d.z;
    if (all->bottom < z && z < all->top)
        take(all, t, SURE_CANDIDATE_WALL);
}

static void take_quadratic(body *all, real a, real b, real c)
{
    if (size_of(a) < CHALLENGE_EPSILON) {
        if (size_of(b) >= CHALLENGE_EPSILON)
            take_wall(all, -c / (2 * b));
        return;
    }
    real discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return;
    take_wall(all, (-b - square_root(discriminant)) / (2 * a));
    take_wall(all, (-b + square_root(discriminant)) / (2 * a));
}

static void take_cap(body *all, real z, real r, int part)
{
    if (size_of(all->d.z) < CHALLENGE_EPSILON)
        return;
    real t = (z - all->o.z) / all->d.z;
    real x = all->o.x + t * all->d.x, y = all->o.y + t * all->d.y;
    if (x * x + y * y <= r * r)
        take(all, t, part);
}

static int found_least(const body *all, peer_hit *hit)
{
    return all->part < 0 ? SURE_CANDIDATE_MISS : found(hit, all->t, all->part);
}

int PEER(cylinder)(const real *numbers, const real *cylinder, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 base = vector(cylinder);
    axis_frame frame = frame_about(sub(vector(cylinder + 3), base));
    real unit = 1 / cylinder[6];
    vec3 o = scaled(unit, in_frame(&frame, sub(ray.o, base)));
    vec3 d = scaled(unit, in_frame(&frame, ray.d));
    body all = {&ray, o, d, 0, unit * frame.h, INFINITY, -1};
    take_cap(&all, 0, 1, SURE_CANDIDATE_BASE);
    take_cap(&all, all.top, 1, SURE_CANDIDATE_TOP);
    real a = d.x * d.x + d.y * d.y;
    if (!(size_of(a) < CHALLENGE_EPSILON)) /* a line along the axis has no linear case */
        take_quadratic(&all, a, 2 * (o.x * d.x + o.y * d.y), o.x * o.x + o.y * o.y - 1);
    return found_least(&all, hit);
}

int PEER(cone)(const real *numbers, const real *cone, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 apex = vector(cone + 3);
    axis_frame frame = frame_about(sub(apex, vector(cone)));
    real across = 1 / cone[6], upwards = 1 / frame.h;
    vec3 o = in_frame(&frame, sub(ray.o, apex)), d = in_frame(&frame, ray.d);
    o = (vec3){across * o.x, across * o.y, upwards * o.z};
    d = (vec3){across * d.x, across * d.y, upwards * d.z};
    body all = {&ray, o, d, -1, 0, INFINITY, -1};
    take_cap(&all, -1, 1, SURE_CANDIDATE_BASE);
    take_quadratic(&all, d.x * d.x + d.y * d.y - d.z * d.z, 2 * (o.x * d.x + o.y * d.y - o.z * d.z),
                   o.x * o.x + o.y * o.y - o.z * o.z);
    return found_least(&all, hit);
}
