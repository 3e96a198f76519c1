/* SPDX-License-Identifier: MIT */
/* Stands for a well-known physically based renderer, pbrt, as its book has it: single precision in
 * intervals, and a hit is rejected unless its whole interval is behind the ray's start and before
 * its end, a root unless its discriminant's whole interval is positive.
 *
 *     M. Pharr, W. Jakob, G. Humphreys: Physically Based Rendering. 4th edition, MIT Press 2023,
 *     https://pbr-book.org/4ed/Shapes: 6.2.2 (sphere), 6.3 (cylinder), 6.4 (disc), 6.8 (rounding)
 *     3rd edition, Morgan Kaufmann 2016, https://pbr-book.org/3ed-2018/Shapes: 3.5 (cone)
 *
 *     v = o - b / (2 a) d,  discriminant = 4 a (r + |v|) (r - |v|),
 *     q = -1/2 (b + sign(b) sqrt(discriminant)),  t = q / a, c / q
 *
 * with v across the axis for the cylinder; the cone's discriminant is b^2 - 4 a c. Its shapes are
 * open: cylinder and cone are closed by its discs here, the least t is the answer. Its rays start
 * at 0: here at t_min. It keeps shapes about the z axis: the frame is found in each call. */
#define PEER_FLOAT
#include "axis_frame.h"
#include "peer.h"

#include <stdint.h>
#include <string.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

typedef struct {
    float low, high;
} interval;

typedef struct {
    interval x, y, z;
} interval3;

/* The next float above; infinity and NaN stay. */
static float up(float x)
{
    uint32_t bits;
    if (!(x < INFINITY))
        return x;
    if (x == 0)
        return 0x1p-149f;
    memcpy(&bits, &x, sizeof bits);
    bits = x > 0 ? bits + 1 : bits - 1;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* One instruction each, which fminf and fmaxf are not: theirs is another answer to a NaN. */
static float lesser(float a, float b)
{
    return a < b ? a : b;
}

static float greater(float a, float b)
{
    return a > b ? a : b;
}

static float down(float x)
{
    return -up(-x);
}

static interval exactly(float x)
{
    return (interval){x, x};
}

static float middle(interval a)
{
    return (a.low + a.high) / 2;
}

static interval plus(interval a, interval b)
{
    return (interval){down(a.low + b.low), up(a.high + b.high)};
}

static interval minus(interval a, interval b)
{
    return (interval){down(a.low - b.high), up(a.high - b.low)};
}

static interval hull(float a, float b, float c, float d)
{
    return (interval){down(lesser(lesser(a, b), lesser(c, d))),
                      up(greater(greater(a, b), greater(c, d)))};
}

static interval times(interval a, interval b)
{
    return hull(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high);
}

static interval over(interval a, interval b)
{
    if (b.low <= 0 && b.high >= 0)
        return (interval){-INFINITY, INFINITY};
    return hull(a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high);
}

static interval square(interval a)
{
    float least = lesser(fabsf(a.low), fabsf(a.high)), most = greater(fabsf(a.low), fabsf(a.high));
    if (a.low <= 0 && a.high >= 0)
        return (interval){0, up(most * most)};
    return (interval){greater(0, down(least * least)), up(most * most)};
}

static interval root_of(interval a)
{
    return (interval){greater(0, down(sqrtf(greater(0, a.low)))), up(sqrtf(greater(0, a.high)))};
}

static interval3 minus3(vec3 a, vec3 b)
{
    return (interval3){minus(exactly(a.x), exactly(b.x)), minus(exactly(a.y), exactly(b.y)),
                       minus(exactly(a.z), exactly(b.z))};
}

static interval3 exactly3(vec3 a)
{
    return (interval3){exactly(a.x), exactly(a.y), exactly(a.z)};
}

static interval dot3(interval3 a, interval3 b)
{
    return plus(plus(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z));
}

/* A matrix counts as exact. */
static interval3 turned(const axis_frame *frame, interval3 v)
{
    return (interval3){dot3(exactly3(frame->x), v), dot3(exactly3(frame->y), v),
                       dot3(exactly3(frame->z), v)};
}

/* What a shape knows of its two roots; none if low > high. */
typedef struct {
    interval near, far;
    int any;
} roots;

static const roots none = {{0, 0}, {0, 0}, 0};

static roots in_order(interval t0, interval t1)
{
    return t0.low > t1.low ? (roots){t1, t0, 1} : (roots){t0, t1, 1};
}

/* From a t^2 + b t + c and the root of its discriminant. */
static roots quadratic(interval a, interval b, interval c, interval root)
{
    interval sum = middle(b) < 0 ? minus(b, root) : plus(b, root);
    interval q = times(exactly(-0.5f), sum);
    return in_order(over(q, a), over(c, q));
}

/* Of a round body, `length` = |v|. */
static roots round_roots(interval a, interval b, interval c, interval r, interval length)
{
    interval four_a = times(exactly(4), a);
    interval discriminant = times(times(four_a, plus(r, length)), minus(r, length));
    if (!(discriminant.low >= 0))
        return none;
    return quadratic(a, b, c, root_of(discriminant));
}

static int ends_late(const peer_ray *ray, interval t)
{
    return !(t.high <= ray->t_max);
}

static int starts_early(const peer_ray *ray, interval t)
{
    return !(t.low > ray->t_min);
}

/* Is there any chance for a hit, and is the first root the one? */
static int choose(const peer_ray *ray, const roots *at, interval *t)
{
    if (!at->any || ends_late(ray, at->near) || !(at->far.low > ray->t_min))
        return 0;
    *t = at->near;
    if (starts_early(ray, *t)) {
        *t = at->far;
        return !ends_late(ray, *t);
    }
    return 1;
}

int PEER(sphere)(const real *numbers, const real *sphere, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    interval3 o = minus3(ray.o, vector(sphere)), d = exactly3(ray.d);
    interval r = exactly(sphere[3]);
    interval a = plus(plus(square(d.x), square(d.y)), square(d.z));
    interval b = times(exactly(2), dot3(d, o));
    interval c = minus(plus(plus(square(o.x), square(o.y)), square(o.z)), square(r));
    interval f = over(b, times(exactly(2), a)), t;
    interval x = minus(o.x, times(f, d.x)), y = minus(o.y, times(f, d.y)),
             z = minus(o.z, times(f, d.z));
    interval length = root_of(plus(plus(square(x), square(y)), square(z)));
    roots at = round_roots(a, b, c, r, length);
    return choose(&ray, &at, &t) ? found(hit, middle(t), SURE_CANDIDATE_SURFACE)
                                 : SURE_CANDIDATE_MISS;
}

/* A disc, in plain floats: those next to its frame's. */
static float disc_t(const peer_ray *ray, vec3 o, vec3 d, float height, float r)
{
    if (d.z == 0)
        return INFINITY;
    float t = (height - o.z) / d.z;
    float x = o.x + t * d.x, y = o.y + t * d.y;
    int is_met = t > ray->t_min && t < ray->t_max && x * x + y * y <= r * r;
    return is_met ? t : INFINITY;
}

int PEER(disc)(const real *numbers, const real *disc, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    axis_frame frame = frame_about(vector(disc + 3));
    vec3 o = in_frame(&frame, sub(ray.o, vector(disc))), d = in_frame(&frame, ray.d);
    float t = disc_t(&ray, o, d, 0, disc[6]);
    return t < INFINITY ? found(hit, t, SURE_CANDIDATE_SURFACE) : SURE_CANDIDATE_MISS;
}

/* The wall's t between 0 <= z <= h: the second root where the first is out; or infinity. */
static float wall_t(const peer_ray *ray, const roots *at, vec3 o, vec3 d, float h)
{
    interval t;
    if (!choose(ray, at, &t))
        return INFINITY;
    float z = o.z + middle(t) * d.z;
    if (z >= 0 && z <= h)
        return middle(t);
    if ((t.low == at->far.low && t.high == at->far.high) || ends_late(ray, at->far))
        return INFINITY;
    z = o.z + middle(at->far) * d.z;
    return z >= 0 && z <= h ? middle(at->far) : INFINITY;
}

static interval across(interval3 a, interval3 b)
{
    return plus(times(a.x, b.x), times(a.y, b.y));
}

static roots cylinder_roots(interval3 o, interval3 d, float radius)
{
    interval r = exactly(radius), a = plus(square(d.x), square(d.y));
    interval b = times(exactly(2), across(d, o));
    interval c = minus(plus(square(o.x), square(o.y)), square(r));
    interval f = over(b, times(exactly(2), a));
    interval x = minus(o.x, times(f, d.x)), y = minus(o.y, times(f, d.y));
    return round_roots(a, b, c, r, root_of(plus(square(x), square(y))));
}

static roots cone_roots(interval3 o, interval3 d, float radius, float h)
{
    interval k = square(over(exactly(radius), exactly(h))), z = minus(o.z, exactly(h));
    interval a = minus(plus(square(d.x), square(d.y)), times(k, square(d.z)));
    interval b = times(exactly(2), minus(across(d, o), times(k, times(d.z, z))));
    interval c = minus(plus(square(o.x), square(o.y)), times(k, square(z)));
    double a_0 = (double)middle(a), b_0 = (double)middle(b), c_0 = (double)middle(c);
    double discriminant = b_0 * b_0 - 4 * a_0 * c_0;
    if (!(discriminant >= 0))
        return none;
    float root = (float)sqrt(discriminant), error = 0x1p-24f * root;
    return quadratic(a, b, c, (interval){down(root - error), up(root + error)});
}

static int found_least(float wall, float base, float top, peer_hit *hit)
{
    float t = lesser(wall, lesser(base, top));
    if (!(t < INFINITY))
        return SURE_CANDIDATE_MISS;
    return found(hit, t,
                 t == base  ? SURE_CANDIDATE_BASE
                 : t == top ? SURE_CANDIDATE_TOP
                            : SURE_CANDIDATE_WALL);
}

int PEER(cylinder)(const real *numbers, const real *cylinder, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 base = vector(cylinder);
    axis_frame frame = frame_about(sub(vector(cylinder + 3), base));
    vec3 o = in_frame(&frame, sub(ray.o, base)), d = in_frame(&frame, ray.d);
    float r = cylinder[6], h = frame.h;
    roots at =
        cylinder_roots(turned(&frame, minus3(ray.o, base)), turned(&frame, exactly3(ray.d)), r);
    return found_least(wall_t(&ray, &at, o, d, h), disc_t(&ray, o, d, 0, r),
                       disc_t(&ray, o, d, h, r), hit);
}

int PEER(cone)(const real *numbers, const real *cone, peer_hit *hit)
{
    peer_ray ray = ray_of(numbers);
    vec3 base = vector(cone);
    axis_frame frame = frame_about(sub(vector(cone + 3), base));
    vec3 o = in_frame(&frame, sub(ray.o, base)), d = in_frame(&frame, ray.d);
    float r = cone[6], h = frame.h;
    roots at =
        cone_roots(turned(&frame, minus3(ray.o, base)), turned(&frame, exactly3(ray.d)), r, h);
    return found_least(wall_t(&ray, &at, o, d, h), disc_t(&ray, o, d, 0, r), INFINITY, hit);
}
