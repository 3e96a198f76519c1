/* SPDX-License-Identifier: MIT */
/* Stands for Intel's Embree 3, the ray tracing kernels of many renderers, as it is installed: one
 * ray at a time (rtcIntersect1) against a scene with one object, which is robust.
 *
 *     I. Wald, S. Woop, C. Benthin, G. S. Johnson, M. Ernst: Embree: A Kernel Framework for
 *     Efficient CPU Ray Tracing. ACM Transactions on Graphics 33 (2014); https://www.embree.org
 *
 *     sphere          RTC_GEOMETRY_TYPE_SPHERE_POINT
 *     disc            RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT
 *     cylinder, cone  RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE, one segment: a truncated cone between
 *                     two radii with flat caps, the same solid as ours (the round curves end in
 *                     balls). It has no part that tells the caps from the wall.
 *
 * In single precision. Asked as its documentation has it ("does not have to be normalized"), a ray
 * with |d| = 2 got t = 1.5 for 2 on such a curve: so curves are asked with |d| = 1 here; points
 * take any. Beyond COORDINATE_MOST objects are not seen, and a ray ends Debian's build, where
 * assertions are on: such rays are refused. An object is prepared: its scene.
 * Ray packets are left out: they follow the same formulas.
 *
 * As a library of the gallery it is asked unit directions and t_min=0 on, and objects of scale=1e-3
 * to 1e6. */
#include <embree3/rtcore.h>
#include <math.h>
#include <string.h>
#include <surehit/candidate.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;
#ifdef PEER_LIBRARY /* asked as its documentation has it */
const char sure_candidate_name[] = PEER_LIBRARY;
const char sure_candidate_release[] = PEER_RELEASE;
const char sure_candidate_entry[] = "unit t_min=0 scale=1e-3..1e6";
#endif

#define COORDINATE_MOST 1.844e18f

static RTCDevice the_device(void)
{
    static RTCDevice device;
    return device ? device : (device = rtcNewDevice("threads=1"));
}

static void fill(RTCGeometry geometry, enum RTCBufferType type, enum RTCFormat format,
                 const void *numbers, size_t size, size_t count)
{
    memcpy(rtcSetNewGeometryBuffer(geometry, type, 0, format, size, count), numbers, size * count);
}

static RTCGeometry new_geometry(enum RTCGeometryType type, const float *vertices, size_t count)
{
    RTCGeometry geometry = rtcNewGeometry(the_device(), type);
    fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, vertices, 4 * sizeof(float), count);
    return geometry;
}

/* A scene with this alone, which it keeps. */
static RTCScene scene_of(RTCGeometry geometry)
{
    RTCScene scene = rtcNewScene(the_device());
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

/* What it takes: nothing too large, no NaN (a direction of length 0 made one), no start behind. */
static int is_supported(const float *ray)
{
    for (int i = 0; i < 6; i++) {
        if (!(fabsf(ray[i]) <= COORDINATE_MOST))
            return 0;
    }
    return ray[6] >= 0 && !isnan(ray[7]);
}

static int shoot(const float *ray, RTCScene scene, sure_candidate_hit_float *hit)
{
    if (!is_supported(ray))
        return SURE_CANDIDATE_INVALID;
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit asked;
    memset(&asked, 0, sizeof asked);
    asked.ray.org_x = ray[0];
    asked.ray.org_y = ray[1];
    asked.ray.org_z = ray[2];
    asked.ray.dir_x = ray[3];
    asked.ray.dir_y = ray[4];
    asked.ray.dir_z = ray[5];
    asked.ray.tnear = ray[6];
    asked.ray.tfar = ray[7];
    asked.ray.mask = ~0u;
    asked.hit.geomID = asked.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &asked);
    if (asked.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return SURE_CANDIDATE_MISS;
    hit->t = asked.ray.tfar;
    return SURE_CANDIDATE_HIT;
}

void *sure_candidate_sphere_new_float(const float *sphere)
{
    return scene_of(new_geometry(RTC_GEOMETRY_TYPE_SPHERE_POINT, sphere, 1));
}

void *sure_candidate_disc_new_float(const float *disc)
{
    const float vertex[] = {disc[0], disc[1], disc[2], disc[6]};
    RTCGeometry geometry = new_geometry(RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT, vertex, 1);
    fill(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, disc + 3, 3 * sizeof(float), 1);
    return scene_of(geometry);
}

static void *new_curve(const float *ends, float last_radius)
{
    const float vertices[] = {ends[0], ends[1], ends[2], ends[6],
                              ends[3], ends[4], ends[5], last_radius};
    const unsigned first = 0;
    RTCGeometry geometry = new_geometry(RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE, vertices, 2);
    fill(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, &first, sizeof first, 1);
    return scene_of(geometry);
}

void *sure_candidate_cylinder_new_float(const float *cylinder)
{
    return new_curve(cylinder, cylinder[6]);
}

void *sure_candidate_cone_new_float(const float *cone)
{
    return new_curve(cone, 0);
}

static int shoot_at_curve(const float *ray, RTCScene curve, sure_candidate_hit_float *hit)
{
    double x = (double)ray[3], y = (double)ray[4], z = (double)ray[5];
    double length = sqrt(x * x + y * y + z * z);
    float unit[] = {ray[0],
                    ray[1],
                    ray[2],
                    (float)(x / length),
                    (float)(y / length),
                    (float)(z / length),
                    (float)((double)ray[6] * length),
                    (float)((double)ray[7] * length)};
    int status = shoot(unit, curve, hit);
    if (status == SURE_CANDIDATE_HIT)
        hit->t = fmaxf(ray[6], fminf(ray[7], (float)((double)hit->t / length)));
    return status;
}

#define ANSWER(shape, by)                                                                          \
    int sure_candidate_##shape##_prepared_float(const float *ray, void *prepared,                  \
                                                sure_candidate_hit_float *hit)                     \
    {                                                                                              \
        return by(ray, prepared, hit);                                                             \
    }                                                                                              \
    void sure_candidate_##shape##_free(void *prepared)                                             \
    {                                                                                              \
        rtcReleaseScene(prepared);                                                                 \
    }

ANSWER(sphere, shoot)
ANSWER(disc, shoot)
ANSWER(cylinder, shoot_at_curve)
ANSWER(cone, shoot_at_curve)
