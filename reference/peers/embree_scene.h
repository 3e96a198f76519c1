/* SPDX-License-Identifier: MIT */
/* A scene for Embree's frame (embree_frame.c): what tests/bench/frame_scenes.py writes, of the .rt
 * format no more: R, A, C, L, pl, sp, cy and co with white light, in this order. */
#pragma once

#include <embree3/rtcore.h>
#include <math.h>
#include <stdbool.h>

enum { SPHERES, CURVES, KINDS };
enum { PLANES_MOST = 8, LIGHTS_MOST = 8 };

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
    bool packets; /* rays go eight at once */
} world;

static inline vec3 add(vec3 a, vec3 b)
{
    return (vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vec3 sub(vec3 a, vec3 b)
{
    return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vec3 scaled(float s, vec3 a)
{
    return (vec3){s * a.x, s * a.y, s * a.z};
}

static inline float dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 unit(vec3 a)
{
    return scaled(1 / sqrtf(dot(a, a)), a);
}

/* Ends the program after a message. */
void stop(const char *what, const char *where);

/* The file's, or it stops. */
void read_scene(world *w, const char *path);

/* w->traced, by so many threads, or it stops. */
void build(world *w, int threads);
