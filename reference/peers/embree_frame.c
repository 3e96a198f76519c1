/* SPDX-License-Identifier: MIT */
/* A frame by Embree 3 (embree.c says whose it is), for tests/bench/frames.py to lay beside
 * surehit's:
 *
 *     embree_frame SCENE.rt OUT.ppm [THREADS]
 *     embree_frame --version
 *
 * What a renderer on Embree would do that traces one ray at a time: spheres and curves (as in
 * embree.c) in a robust scene, all numbers in single precision, subnormals off as its manual
 * advises, directions of length 1, which curves need. Planes are kept out of the scene and met by
 * the usual formula: 5 to 15 per cent faster than a large quad in it. Shadow rays start a little
 * above their surface. The picture is surehit's: the same camera and light, matte surfaces.
 *
 * Writes its times to standard output as `surehit render --time` does; "frame" is from the first
 * ray to the last pixel. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include "embree_scene.h"

#include <stdbool.h>
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

/* Building. */

static RTCGeometry geometry_of(RTCDevice device, const objects *of)
{
    RTCGeometry geometry = rtcNewGeometry(device, of->type);
    size_t vertices = (size_t)of->size * of->count;
    float *buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                            4 * sizeof(float), vertices);
    memcpy(buffer, of->vertices, vertices * 4 * sizeof(float));
    if (of->size == 2) {
        unsigned *first = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                  RTC_FORMAT_UINT, sizeof(unsigned), of->count);
        for (unsigned i = 0; i < of->count; i++)
            first[i] = 2 * i;
    }
    rtcCommitGeometry(geometry);
    return geometry;
}

static void build(world *w, int threads)
{
    char config[64];
    snprintf(config, sizeof config, "threads=%d", threads);
    RTCDevice device = rtcNewDevice(threads > 0 ? config : NULL);
    if (!device)
        stop("no device", "Embree");
    w->traced = rtcNewScene(device);
    rtcSetSceneFlags(w->traced, RTC_SCENE_FLAG_ROBUST);
    for (unsigned kind = 0; kind < KINDS; kind++) {
        if (w->of[kind].count > 0)
            rtcAttachGeometryByID(w->traced, geometry_of(device, &w->of[kind]), kind);
    }
    rtcCommitScene(w->traced);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
        stop("the scene can't be built", "Embree");
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

static sight look(const world *w, vec3 direction)
{
    const vec3 eye = {0, 0, 0};
    sight seen = {.kind = NOTHING, .t = INFINITY};
    for (int i = 0; i < w->plane_count; i++) {
        float t = plane_met(&w->planes[i], eye, direction);
        if (t < seen.t)
            seen = (sight){PLANES, (unsigned)i, t, w->planes[i].normal};
    }
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit asked;
    set_ray(&asked.ray, eye, direction, seen.t);
    asked.hit.geomID = asked.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(w->traced, &context, &asked);
    if (asked.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        seen = (sight){(int)asked.hit.geomID, asked.hit.primID, asked.ray.tfar,
                       unit((vec3){asked.hit.Ng_x, asked.hit.Ng_y, asked.hit.Ng_z})};
    if (dot(seen.normal, direction) > 0)
        seen.normal = scaled(-1, seen.normal);
    return seen;
}

static bool is_shaded(const world *w, vec3 from, vec3 direction, float distance)
{
    for (int i = 0; i < w->plane_count; i++) {
        if (plane_met(&w->planes[i], from, direction) < distance)
            return true;
    }
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRay asked;
    set_ray(&asked, from, direction, distance);
    rtcOccluded1(w->traced, &context, &asked);
    return asked.tfar < 0;
}

/* Cosine times brightness, of all lights that reach the point. */
static float light_at(const world *w, vec3 point, const sight *at, int64_t *rays)
{
    float sum = 0;
    vec3 start = add(point, scaled(0x1p-19f * at->t, at->normal));
    for (int i = 0; i < w->light_count; i++) {
        vec3 way = sub(w->lights[i].position, start);
        float distance = sqrtf(dot(way, way));
        vec3 direction = scaled(1 / distance, way);
        float cosine = dot(at->normal, direction);
        if (!(cosine > 0))
            continue;
        ++*rays;
        if (!is_shaded(w, start, direction, distance))
            sum += w->lights[i].brightness * cosine;
    }
    return sum;
}

static vec3 colour_of(const world *w, const sight *seen)
{
    return seen->kind == PLANES ? w->planes[seen->index].colour
                                : w->of[seen->kind].colours[seen->index];
}

static vec3 pixel(const world *w, int column, int row, int64_t *rays)
{
    float u = (float)(2 * column + 1 - w->width) / (float)w->width;
    float v = (float)(w->height - 1 - 2 * row) / (float)w->height;
    vec3 direction = unit(add(w->forward, add(scaled(u, w->right), scaled(v, w->up))));
    ++*rays;
    sight seen = look(w, direction);
    if (seen.kind == NOTHING)
        return (vec3){0, 0, 0};
    float light = w->ambient + light_at(w, scaled(seen.t, direction), &seen, rays);
    return scaled(light, colour_of(w, &seen));
}

static uint8_t to_byte(float linear)
{
    return linear < 1 ? (uint8_t)(255 * linear + 0.5f) : 255;
}

static void render_tile(const world *w, int left, int top, uint8_t *rgb, int64_t *rays)
{
    int right = left + TILE < w->width ? left + TILE : w->width;
    int bottom = top + TILE < w->height ? top + TILE : w->height;
    for (int row = top; row < bottom; row++) {
        uint8_t *to = rgb + 3 * ((size_t)row * (size_t)w->width + (size_t)left);
        for (int column = left; column < right; column++, to += 3) {
            vec3 colour = pixel(w, column, row, rays);
            to[0] = to_byte(colour.x);
            to[1] = to_byte(colour.y);
            to[2] = to_byte(colour.z);
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
    if (count == 2 && strcmp(words[1], "--version") == 0)
        return puts(RTC_VERSION_STRING) < 0;
    int threads = count == 4 ? atoi(words[3]) : cores();
    if (count < 3 || count > 4 || threads < 1) {
        fprintf(stderr, "usage: %s SCENE.rt OUT.ppm [THREADS]\n", words[0]);
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
