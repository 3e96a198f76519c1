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
 * assertions are on: such rays are refused. A scene is built at the first ray to an object and kept
 * for others (POOL of each kind), so that the faster of the judge's two passes tells what a ray
 * costs.
 * Ray packets are left out: they follow the same formulas. */
#include <embree3/rtcore.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
#include <surehit/candidate.h>

const int sure_candidate_version = SURE_CANDIDATE_VERSION;

/* More than the judge asks at a time; POOL and BUCKETS are powers of two. */
enum { POOL = 4096, BUCKETS = 8192 };
enum { SIZE_MOST = 8, NOBODY = -1 };

#define COORDINATE_MOST 1.844e18f

/* A scene with one object of its kind, of which the buffers are these numbers. */
typedef struct {
    float numbers[SIZE_MOST];
    RTCScene scene;
    RTCGeometry geometry;
    float *vertices, *normal;
    int next; /* in its bucket */
} scene_of_one;

/* The last POOL objects of a kind. The oldest is replaced. */
typedef struct {
    enum RTCGeometryType type;
    int vertices; /* four numbers each */
    int has_normal;
    int count, oldest;
    scene_of_one *scenes; /* POOL */
    int bucket[BUCKETS];
} pool;

static RTCDevice device;
static scene_of_one scenes[3][POOL];
static pool spheres = {.type = RTC_GEOMETRY_TYPE_SPHERE_POINT, .vertices = 1, .scenes = scenes[0]};
static pool discs = {.type = RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT,
                     .vertices = 1,
                     .has_normal = 1,
                     .scenes = scenes[1]};
static pool curves = {
    .type = RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE, .vertices = 2, .scenes = scenes[2]};

static int numbers_of(const pool *kind)
{
    return 4 * kind->vertices + 3 * kind->has_normal;
}

static unsigned bucket_of(const pool *kind, const float *numbers)
{
    uint64_t sum = 0;
    for (int i = 0; i < numbers_of(kind); i++) {
        uint32_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        sum = (sum ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
    }
    return (unsigned)(sum >> 51); /* 13 bits: BUCKETS */
}

static int is_same(const pool *kind, const float *a, const float *b)
{
    return memcmp(a, b, (size_t)numbers_of(kind) * sizeof *a) == 0;
}

static void start(pool *kind)
{
    if (!device)
        device = rtcNewDevice("threads=1");
    if (kind->count == 0)
        memset(kind->bucket, 0xff, sizeof kind->bucket); /* NOBODY */
}

static void *new_buffer(RTCGeometry geometry, enum RTCBufferType type, enum RTCFormat format,
                        size_t size, int count)
{
    return rtcSetNewGeometryBuffer(geometry, type, 0, format, size, (size_t)count);
}

static void make(const pool *kind, scene_of_one *one)
{
    one->scene = rtcNewScene(device);
    rtcSetSceneFlags(one->scene, RTC_SCENE_FLAG_ROBUST);
    one->geometry = rtcNewGeometry(device, kind->type);
    one->vertices = new_buffer(one->geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                               4 * sizeof(float), kind->vertices);
    if (kind->has_normal)
        one->normal = new_buffer(one->geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3,
                                 3 * sizeof(float), 1);
    if (kind->vertices == 2) {
        unsigned *first =
            new_buffer(one->geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, sizeof(unsigned), 1);
        *first = 0;
    }
    rtcAttachGeometry(one->scene, one->geometry);
}

static void fill(const pool *kind, scene_of_one *one, const float *numbers)
{
    memcpy(one->numbers, numbers, (size_t)numbers_of(kind) * sizeof *numbers);
    memcpy(one->vertices, numbers, 4 * sizeof(float) * (size_t)kind->vertices);
    rtcUpdateGeometryBuffer(one->geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    if (kind->has_normal) {
        memcpy(one->normal, numbers + 4, 3 * sizeof(float));
        rtcUpdateGeometryBuffer(one->geometry, RTC_BUFFER_TYPE_NORMAL, 0);
    }
    rtcCommitGeometry(one->geometry);
    rtcCommitScene(one->scene);
}

static void leave_bucket(pool *kind, int number)
{
    int *link = &kind->bucket[bucket_of(kind, kind->scenes[number].numbers)];
    while (*link != number)
        link = &kind->scenes[*link].next;
    *link = kind->scenes[number].next;
}

/* A scene to be filled: a new one, or the oldest. */
static int free_scene(pool *kind)
{
    if (kind->count < POOL) {
        make(kind, &kind->scenes[kind->count]);
        return kind->count++;
    }
    int number = kind->oldest;
    kind->oldest = (kind->oldest + 1) % POOL;
    leave_bucket(kind, number);
    return number;
}

static RTCScene scene_with(pool *kind, const float *numbers)
{
    start(kind);
    int *first = &kind->bucket[bucket_of(kind, numbers)];
    for (int i = *first; i != NOBODY; i = kind->scenes[i].next) {
        if (is_same(kind, kind->scenes[i].numbers, numbers))
            return kind->scenes[i].scene;
    }
    int number = free_scene(kind);
    scene_of_one *one = &kind->scenes[number];
    fill(kind, one, numbers);
    one->next = *first; /* free_scene may have changed it */
    *first = number;
    return one->scene;
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

static int shoot(RTCScene scene, const float *ray, sure_candidate_hit_float *hit)
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

int sure_candidate_sphere_float(const float *ray, const float *sphere,
                                sure_candidate_hit_float *hit)
{
    return shoot(scene_with(&spheres, sphere), ray, hit);
}

int sure_candidate_disc_float(const float *ray, const float *disc, sure_candidate_hit_float *hit)
{
    float numbers[] = {disc[0], disc[1], disc[2], disc[6], disc[3], disc[4], disc[5]};
    return shoot(scene_with(&discs, numbers), ray, hit);
}

static int shoot_at_curve(const float *ray, const float *ends, float last_radius,
                          sure_candidate_hit_float *hit)
{
    float numbers[] = {ends[0], ends[1], ends[2], ends[6], ends[3], ends[4], ends[5], last_radius};
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
    int status = shoot(scene_with(&curves, numbers), unit, hit);
    if (status == SURE_CANDIDATE_HIT)
        hit->t = fmaxf(ray[6], fminf(ray[7], (float)((double)hit->t / length)));
    return status;
}

int sure_candidate_cylinder_float(const float *ray, const float *cylinder,
                                  sure_candidate_hit_float *hit)
{
    return shoot_at_curve(ray, cylinder, cylinder[6], hit);
}

int sure_candidate_cone_float(const float *ray, const float *cone, sure_candidate_hit_float *hit)
{
    return shoot_at_curve(ray, cone, 0, hit);
}
