/* SPDX-License-Identifier: MIT */
/* A frame by Embree 3 (embree.c says whose it is), for tests/bench/frames.py to lay beside
 * surehit's:
 *
 *     embree_frame [--packets] SCENE.rt OUT.ppm [THREADS]
 *     embree_frame --version
 *
 * What a renderer on Embree would do that traces one ray at a time, or with --packets those of 4 by
 * 2 pixels, and their shadows' to one light, at once: spheres and curves (as in
 * embree.c) in a robust scene, all numbers in single precision, subnormals off as its manual
 * advises, directions of length 1, which curves need. Planes are kept out of the scene and met by
 * the usual formula: 5 to 15 per cent faster than a large quad in it. Shadow rays start a little
 * above their surface. The picture is surehit's: the same camera and light, matte surfaces.
 *
 * Writes its times to standard output as `surehit render --time` does; "frame" is from the first
 * ray to the last pixel. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "embree_scene.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef _OPENMP
#include <omp.h>
#define OPENMP(directive) _Pragma(#directive)
#else
#define OPENMP(directive)
#endif
#ifdef __SSE__
#include <xmmintrin.h>
#endif

enum { PLANES = KINDS, NOTHING }; /* what else a ray meets */
enum { TILE = 16 };               /* pixels a side that a thread takes at a time */
enum { PACKET = 8, ACROSS = 4, DOWN = PACKET / ACROSS };

typedef struct {
    int kind;
    unsigned index;
    float t;
    vec3 normal; /* of length 1, to the eye */
} sight;

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Tracing. */

static void set_ray(struct RTCRay *ray, vec3 origin, vec3 direction, float to)
{
    *ray = (struct RTCRay){.org_x = origin.x,
                           .org_y = origin.y,
                           .org_z = origin.z,
                           .dir_x = direction.x,
                           .dir_y = direction.y,
                           .dir_z = direction.z,
                           .tfar = to,
                           .mask = ~0u};
}

/* t of the plane, or infinity. */
static float plane_met(const plane *p, vec3 origin, vec3 direction)
{
    float t = dot(p->normal, sub(p->point, origin)) / dot(p->normal, direction);
    return t > 0 ? t : INFINITY;
}

static sight look_at_planes(const world *w, vec3 direction)
{
    const vec3 eye = {0, 0, 0};
    sight seen = {.kind = NOTHING, .t = INFINITY};
    for (int i = 0; i < w->plane_count; i++) {
        float t = plane_met(&w->planes[i], eye, direction);
        if (t < seen.t)
            seen = (sight){PLANES, (unsigned)i, t, w->planes[i].normal};
    }
    return seen;
}

static void turn_to_eye(sight *seen, vec3 direction)
{
    if (dot(seen->normal, direction) > 0)
        seen->normal = scaled(-1, seen->normal);
}

static sight look(const world *w, vec3 direction)
{
    const vec3 eye = {0, 0, 0};
    sight seen = look_at_planes(w, direction);
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit asked;
    set_ray(&asked.ray, eye, direction, seen.t);
    asked.hit.geomID = asked.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(w->traced, &context, &asked);
    if (asked.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        seen = (sight){(int)asked.hit.geomID, asked.hit.primID, asked.ray.tfar,
                       unit((vec3){asked.hit.Ng_x, asked.hit.Ng_y, asked.hit.Ng_z})};
    turn_to_eye(&seen, direction);
    return seen;
}

static bool shaded_by_planes(const world *w, vec3 from, vec3 direction, float distance)
{
    for (int i = 0; i < w->plane_count; i++) {
        if (plane_met(&w->planes[i], from, direction) < distance)
            return true;
    }
    return false;
}

static bool is_shaded(const world *w, vec3 from, vec3 direction, float distance)
{
    if (shaded_by_planes(w, from, direction, distance))
        return true;
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRay asked;
    set_ray(&asked, from, direction, distance);
    rtcOccluded1(w->traced, &context, &asked);
    return asked.tfar < 0;
}

/* From a little above the surface to a light. */
typedef struct {
    vec3 start, direction;
    float distance, cosine;
} way;

static way way_to(const lamp *light, const sight *at, vec3 eye_direction)
{
    vec3 point = scaled(at->t, eye_direction);
    way to = {.start = add(point, scaled(0x1p-19f * at->t, at->normal))};
    vec3 all = sub(light->position, to.start);
    to.distance = sqrtf(dot(all, all));
    to.direction = scaled(1 / to.distance, all);
    to.cosine = dot(at->normal, to.direction);
    return to;
}

/* Cosine times brightness, of all lights that reach the point. */
static float light_at(const world *w, vec3 eye_direction, const sight *at, int64_t *rays)
{
    float sum = 0;
    for (int i = 0; i < w->light_count; i++) {
        way to = way_to(&w->lights[i], at, eye_direction);
        if (!(to.cosine > 0))
            continue;
        ++*rays;
        if (!is_shaded(w, to.start, to.direction, to.distance))
            sum += w->lights[i].brightness * to.cosine;
    }
    return sum;
}

static vec3 colour_of(const world *w, const sight *seen)
{
    return seen->kind == PLANES ? w->planes[seen->index].colour
                                : w->of[seen->kind].colours[seen->index];
}

static vec3 direction_of(const world *w, int column, int row)
{
    float u = (float)(2 * column + 1 - w->width) / (float)w->width;
    float v = (float)(w->height - 1 - 2 * row) / (float)w->height;
    return unit(add(w->forward, add(scaled(u, w->right), scaled(v, w->up))));
}

static vec3 shown(const world *w, const sight *seen, float light)
{
    if (seen->kind == NOTHING)
        return (vec3){0, 0, 0};
    return scaled(w->ambient + light, colour_of(w, seen));
}

static vec3 pixel(const world *w, int column, int row, int64_t *rays)
{
    vec3 direction = direction_of(w, column, row);
    ++*rays;
    sight seen = look(w, direction);
    return shown(w, &seen, seen.kind == NOTHING ? 0 : light_at(w, direction, &seen, rays));
}

/* Eight at once. */

static void set_ray8(struct RTCRay8 *rays, int i, vec3 origin, vec3 direction, float to)
{
    rays->org_x[i] = origin.x;
    rays->org_y[i] = origin.y;
    rays->org_z[i] = origin.z;
    rays->dir_x[i] = direction.x;
    rays->dir_y[i] = direction.y;
    rays->dir_z[i] = direction.z;
    rays->tnear[i] = rays->time[i] = 0;
    rays->tfar[i] = to;
    rays->mask[i] = ~0u;
    rays->id[i] = rays->flags[i] = 0;
}

static struct RTCIntersectContext coherent(void)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

static void packet_look(const world *w, int count, const vec3 *direction, sight *seen)
{
    struct RTCIntersectContext context = coherent();
    struct RTCRayHit8 asked;
    _Alignas(32) int valid[PACKET];
    for (int i = 0; i < PACKET; i++) {
        valid[i] = i < count ? -1 : 0;
        if (i >= count)
            continue;
        seen[i] = look_at_planes(w, direction[i]);
        set_ray8(&asked.ray, i, (vec3){0, 0, 0}, direction[i], seen[i].t);
        asked.hit.geomID[i] = asked.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, w->traced, &context, &asked);
    for (int i = 0; i < count; i++) {
        if (asked.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID)
            seen[i] =
                (sight){(int)asked.hit.geomID[i], asked.hit.primID[i], asked.ray.tfar[i],
                        unit((vec3){asked.hit.Ng_x[i], asked.hit.Ng_y[i], asked.hit.Ng_z[i]})};
        turn_to_eye(&seen[i], direction[i]);
    }
}

/* Adds one light's cosine times brightness where it reaches. */
static void packet_light(const world *w, const lamp *light, int count, const vec3 *direction,
                         const sight *seen, float *sum, int64_t *rays)
{
    struct RTCIntersectContext context = coherent();
    struct RTCRay8 asked;
    _Alignas(32) int valid[PACKET] = {0};
    way to[PACKET];
    for (int i = 0; i < count; i++) {
        if (seen[i].kind == NOTHING)
            continue;
        to[i] = way_to(light, &seen[i], direction[i]);
        if (!(to[i].cosine > 0))
            continue;
        ++*rays;
        if (shaded_by_planes(w, to[i].start, to[i].direction, to[i].distance))
            continue;
        valid[i] = -1;
        set_ray8(&asked, i, to[i].start, to[i].direction, to[i].distance);
    }
    rtcOccluded8(valid, w->traced, &context, &asked);
    for (int i = 0; i < count; i++) {
        if (valid[i] && asked.tfar[i] >= 0)
            sum[i] += light->brightness * to[i].cosine;
    }
}

static void packet_pixels(const world *w, int count, const int *column, const int *row,
                          vec3 *colour, int64_t *rays)
{
    vec3 direction[PACKET];
    sight seen[PACKET];
    float sum[PACKET] = {0};
    for (int i = 0; i < count; i++)
        direction[i] = direction_of(w, column[i], row[i]);
    *rays += count;
    packet_look(w, count, direction, seen);
    for (int i = 0; i < w->light_count; i++)
        packet_light(w, &w->lights[i], count, direction, seen, sum, rays);
    for (int i = 0; i < count; i++)
        colour[i] = shown(w, &seen[i], sum[i]);
}

static uint8_t to_byte(float linear)
{
    return linear < 1 ? (uint8_t)(255 * linear + 0.5f) : 255;
}

static void put(const world *w, uint8_t *rgb, int column, int row, vec3 colour)
{
    uint8_t *to = rgb + 3 * ((size_t)row * (size_t)w->width + (size_t)column);
    to[0] = to_byte(colour.x);
    to[1] = to_byte(colour.y);
    to[2] = to_byte(colour.z);
}

/* Those from (left, top) on that are in the picture. */
static void render_packet(const world *w, int left, int top, uint8_t *rgb, int64_t *rays)
{
    int column[PACKET], row[PACKET], count = 0;
    vec3 colour[PACKET];
    for (int i = 0; i < PACKET; i++) {
        column[count] = left + i % ACROSS;
        row[count] = top + i / ACROSS;
        count += column[count] < w->width && row[count] < w->height;
    }
    packet_pixels(w, count, column, row, colour, rays);
    for (int i = 0; i < count; i++)
        put(w, rgb, column[i], row[i], colour[i]);
}

static void render_tile(const world *w, int left, int top, uint8_t *rgb, int64_t *rays)
{
    int right = left + TILE < w->width ? left + TILE : w->width;
    int bottom = top + TILE < w->height ? top + TILE : w->height;
    int across = w->packets ? ACROSS : 1, down = w->packets ? DOWN : 1;
    for (int row = top; row < bottom; row += down) {
        for (int column = left; column < right; column += across) {
            if (w->packets)
                render_packet(w, column, row, rgb, rays);
            else
                put(w, rgb, column, row, pixel(w, column, row, rays));
        }
    }
}

static void flush_subnormals(void)
{
#ifdef __SSE__
    _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}

/* Returns the number of rays. */
static int64_t render(const world *w, int threads, uint8_t *rgb)
{
    const int across = (w->width + TILE - 1) / TILE, down = (w->height + TILE - 1) / TILE;
    int64_t rays = 0;
    (void)threads;
    OPENMP(omp parallel num_threads(threads) reduction(+ : rays))
    {
        flush_subnormals();
        OPENMP(omp for schedule(dynamic))
        for (int tile = 0; tile < across * down; tile++)
            render_tile(w, TILE * (tile % across), TILE * (tile / across), rgb, &rays);
    }
    return rays;
}

static void write_picture(const world *w, const uint8_t *rgb, const char *path)
{
    size_t size = 3 * (size_t)w->width * (size_t)w->height;
    FILE *file = fopen(path, "wb");
    if (!file || fprintf(file, "P6\n%d %d\n255\n", w->width, w->height) < 0 ||
        fwrite(rgb, 1, size, file) != size || fclose(file) != 0)
        stop("can't be written", path);
}

static int cores(void)
{
#ifdef _OPENMP
    return omp_get_num_procs();
#else
    return 1;
#endif
}

int main(int count, char **words)
{
    static world w = {.of = {{.type = RTC_GEOMETRY_TYPE_SPHERE_POINT, .size = 1},
                             {.type = RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE, .size = 2}}};
    const char *program = words[0];
    if (count == 2 && strcmp(words[1], "--version") == 0)
        return puts(RTC_VERSION_STRING) < 0;
    w.packets = count > 1 && strcmp(words[1], "--packets") == 0;
    words += w.packets;
    count -= w.packets;
    int threads = count == 4 ? atoi(words[3]) : cores();
    if (count < 3 || count > 4 || threads < 1) {
        fprintf(stderr, "usage: %s [--packets] SCENE.rt OUT.ppm [THREADS]\n", program);
        return 2;
    }
    double started = seconds();
    read_scene(&w, words[1]);
    double read = seconds();
    build(&w, threads);
    double built = seconds();
    uint8_t *rgb = malloc(3 * (size_t)w.width * (size_t)w.height);
    if (!rgb)
        stop("no memory", "picture");
    int64_t rays = render(&w, threads, rgb);
    double rendered = seconds();
    write_picture(&w, rgb, words[2]);
    printf("{\"read\": %.6f, \"build\": %.6f, \"frame\": %.6f, \"write\": %.6f, \"objects\": %u, "
           "\"threads\": %d, \"rays\": %lld}\n",
           read - started, built - read, rendered - built, seconds() - rendered,
           w.of[SPHERES].count + w.of[CURVES].count + (unsigned)w.plane_count, threads,
           (long long)rays);
    return 0;
}
