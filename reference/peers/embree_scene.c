/* SPDX-License-Identifier: MIT */
#include "embree_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void stop(const char *what, const char *where)
{
    fprintf(stderr, "embree_frame: %s: %s\n", where, what);
    exit(2);
}

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

void read_scene(world *w, const char *path)
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

void build(world *w, int threads)
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
