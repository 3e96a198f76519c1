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
 * Reads what tests/bench/frame_scenes.py writes, of the .rt format no more: R, A, C, L, pl, sp, cy
 * and co with white light, in this order. Writes its times to standard output as
 * `surehit render --time` does; "frame" is from the first ray to the last pixel. */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */

#include <embree3/rtcore.h>
#include <math.h>
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

enum { SPHERES, CURVES, KINDS };
enum { PLANES = KINDS, NOTHING }; /* what else a ray meets */
enum { PLANES_MOST = 8, LIGHTS_MOST = 8 };
enum { TILE = 16 }; /* pixels a side that a thread takes at a time */

typedef struct {
    float x, y, z;
} vec3;

typedef struct {
    vec3 point, normal, colour;
} plane;

typedef struct {
    vec3 position;
    float brightness;
} lamp;

/* Objects of a kind: `size` vertices x, y, z, r and a colour each. */
typedef struct {
    enum RTCGeometryType type;
    unsigned size, count, capacity;
    float *vertices;
    vec3 *colours;
} objects;

/* The world about the eye. */
typedef struct {
    int width, height;
    float ambient;
    double eye[3];
    vec3 forward, right, up; /* right and up as long as half the picture at distance 1 */
    lamp lights[LIGHTS_MOST];
    plane planes[PLANES_MOST];
    int light_count, plane_count;
    objects of[KINDS];
    RTCScene traced;
} world;

typedef struct {
    int kind;
    unsigned index;
    float t;
    vec3 normal; /* of length 1, to the eye */
} sight;

static vec3 add(vec3 a, vec3 b)
{
    return (vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static vec3 sub(vec3 a, vec3 b)
{
    return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static vec3 scaled(float s, vec3 a)
{
    return (vec3){s * a.x, s * a.y, s * a.z};
}

static float dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static vec3 unit(vec3 a)
{
    return scaled(1 / sqrtf(dot(a, a)), a);
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void stop(const char *what, const char *where)
{
    fprintf(stderr, "embree_frame: %s: %s\n", where, what);
    exit(2);
}

/* Reading. */

static vec3 from_eye(const world *w, const double *p)
{
    return (vec3){(float)(p[0] - w->eye[0]), (float)(p[1] - w->eye[1]), (float)(p[2] - w->eye[2])};
}

static vec3 to_vec3(const double *v)
{
    return (vec3){(float)v[0], (float)v[1], (float)v[2]};
}

static void *grown(void *old, size_t count, size_t size)
{
    void *larger = realloc(old, count * size);
    if (!larger)
        stop("no memory", "scene");
    return larger;
}

static void add_object(objects *of, vec3 colour, const float *vertices)
{
    if (of->count == of->capacity) {
        of->capacity = of->capacity ? 2 * of->capacity : 1024;
        of->vertices = grown(of->vertices, of->capacity, of->size * 4 * sizeof(float));
        of->colours = grown(of->colours, of->capacity, sizeof(vec3));
    }
    memcpy(of->vertices + 4 * of->size * of->count, vertices, of->size * 4 * sizeof(float));
    of->colours[of->count++] = colour;
}

/* As surehit has it: right is level, and up is at right angles to it and the view. */
static void aim(world *w, const double *view, double fov)
{
    const double pi = 3.14159265358979323846;
    double level = hypot(view[0], view[2]), length = hypot(level, view[1]);
    double side = tan(pi / 360 * fov), rise = side * w->height / w->width;
    double right[] = {-view[2] / level, 0, view[0] / level};
    double forward[] = {view[0] / length, view[1] / length, view[2] / length};
    w->forward = to_vec3(forward);
    w->right = scaled((float)side, to_vec3(right));
    w->up = scaled((float)rise, (vec3){(float)(right[1] * forward[2] - right[2] * forward[1]),
                                       (float)(right[2] * forward[0] - right[0] * forward[2]),
                                       (float)(right[0] * forward[1] - right[1] * forward[0])});
}

#define THREE "%lf,%lf,%lf"

static bool read_sphere(world *w, const char *line)
{
    double p[3], d, c[3];
    if (sscanf(line, "sp " THREE " %lf " THREE, p, p + 1, p + 2, &d, c, c + 1, c + 2) != 7)
        return false;
    vec3 centre = from_eye(w, p);
    float vertex[] = {centre.x, centre.y, centre.z, (float)(d / 2)};
    add_object(&w->of[SPHERES], scaled(1 / 255.0f, to_vec3(c)), vertex);
    return true;
}

static bool read_curve(world *w, const char *line)
{
    double p[3], a[3], d, h, c[3];
    if (sscanf(line + 2, THREE THREE " %lf %lf " THREE, p, p + 1, p + 2, a, a + 1, a + 2, &d, &h, c,
               c + 1, c + 2) != 11)
        return false;
    double share = h / 2 / sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    double low[3], high[3];
    for (int i = 0; i < 3; i++) {
        low[i] = p[i] - share * a[i];
        high[i] = p[i] + share * a[i];
    }
    vec3 base = from_eye(w, low), top = from_eye(w, high);
    float r = (float)(d / 2);
    float vertices[] = {base.x, base.y, base.z, r, top.x, top.y, top.z, line[1] == 'y' ? r : 0};
    add_object(&w->of[CURVES], scaled(1 / 255.0f, to_vec3(c)), vertices);
    return true;
}

static bool read_plane(world *w, const char *line)
{
    double p[3], n[3], c[3];
    if (w->plane_count == PLANES_MOST || sscanf(line, "pl " THREE THREE THREE, p, p + 1, p + 2, n,
                                                n + 1, n + 2, c, c + 1, c + 2) != 9)
        return false;
    w->planes[w->plane_count++] =
        (plane){from_eye(w, p), unit(to_vec3(n)), scaled(1 / 255.0f, to_vec3(c))};
    return true;
}

static bool read_camera(world *w, const char *line)
{
    double view[3], fov;
    if (w->width < 1 || sscanf(line, "C " THREE THREE " %lf", w->eye, w->eye + 1, w->eye + 2, view,
                               view + 1, view + 2, &fov) != 7)
        return false;
    aim(w, view, fov);
    return true;
}

static bool read_light(world *w, const char *line)
{
    double p[3], ratio;
    if (w->light_count == LIGHTS_MOST ||
        sscanf(line, "L " THREE " %lf 255,255,255", p, p + 1, p + 2, &ratio) != 4)
        return false;
    w->lights[w->light_count++] = (lamp){from_eye(w, p), (float)ratio};
    return true;
}

static bool read_line(world *w, const char *line)
{
    switch (line[0]) {
    case 'R': return sscanf(line, "R %d %d", &w->width, &w->height) == 2;
    case 'A': return sscanf(line, "A %f 255,255,255", &w->ambient) == 1;
    case 'C': return read_camera(w, line);
    case 'L': return read_light(w, line);
    case 'p': return read_plane(w, line);
    case 's': return read_sphere(w, line);
    case 'c': return read_curve(w, line);
    default: return false;
    }
}

static void read_scene(world *w, const char *path)
{
    char line[256];
    FILE *file = fopen(path, "r");
    if (!file)
        stop("can't be read", path);
    while (fgets(line, sizeof line, file)) {
        if (!read_line(w, line))
            stop("not a line that is understood", line);
    }
    fclose(file);
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
