/* The camera: the world's rotation, the window's extent and the rays through its pixels. */
#include "fuzz.h"
#include "tiers.h"

#include "placement.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "reference.h"
#endif

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <surehit/camera.h>
#include <surehit/pixel_ray.h>
#include <surehit/viewport.h>

const char fuzz_name[] = "camera";
size_t (*const fuzz_mutator)(uint8_t *, size_t, size_t, unsigned) = fuzz_mutate_doubles;

enum { ROWS = 3 };

static bool same_matrix(const sure_mat3 *m, const sure_mat3 *n)
{
    return same_vector(m->row[0], n->row[0]) && same_vector(m->row[1], n->row[1]) &&
           same_vector(m->row[2], n->row[2]);
}

/* The rotation. */

static sure_status (*const rotation[TIERS])(sure_vec3, sure_mat3 *) = {
    sure_camera_rotation_float32, sure_camera_rotation_textbook, sure_camera_rotation_stable};

static bool is_view(sure_vec3 v)
{
    return all_finite(v) && (v.x != 0 || v.y != 0 || v.z != 0);
}

static void check_status(sure_vec3 view, sure_tier tier, sure_status status, const sure_mat3 *world)
{
    sure_mat3 before;
    memset(&before, 0xa5, sizeof before);
    expect(status == (is_view(rounded_vector(tier, view)) ? SURE_HIT : SURE_INVALID),
           "a wrong status");
    if (status == SURE_INVALID)
        expect(memcmp(world, &before, sizeof before) == 0, "written for an invalid view");
}

/* Straight along an axis every entry is exact: the notes' cases 1 to 6. */
static void check_axes(sure_vec3 view, sure_tier tier, const sure_mat3 *world)
{
    const sure_vec3 right = {1, 0, 0}, up = {0, 1, 0}, back = {0, 0, 1};
    const sure_vec3 left = {-1, 0, 0}, down = {0, -1, 0}, ahead = {0, 0, -1};
    sure_vec3 v = rounded_vector(tier, view);
    sure_mat3 m;
    if ((v.x != 0) + (v.y != 0) + (v.z != 0) != 1)
        return;
    if (v.x != 0)
        m = v.x > 0 ? (sure_mat3){{back, up, left}} : (sure_mat3){{ahead, up, right}};
    else if (v.y != 0)
        m = v.y > 0 ? (sure_mat3){{right, back, down}} : (sure_mat3){{right, ahead, up}};
    else
        m = v.z > 0 ? (sure_mat3){{left, up, ahead}} : (sure_mat3){{right, up, back}};
    expect(same_matrix(world, &m), "Law 1: an axis' matrix is not exact");
}

/* What makes it that rotation and no other: it takes the view to (0,0,-1); its rows are at right
 * angles and of length 1, and turn right; verticals stay vertical and up stays up. Each entry is
 * off by at most 11 u: 7 u a cosine (two squares, their sum, its root, 2 u, twice over, the
 * quotient), 3 u the other factor, u the product. */
#define ENTRY_ROUNDINGS 11

typedef struct {
    long double x, y, z;
} wide;

/* Of length 1. */
static wide direction_of(sure_vec3 v)
{
    int exponent;
    (void)frexp(fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z))), &exponent);
    wide w = {ldexpl(v.x, -exponent), ldexpl(v.y, -exponent), ldexpl(v.z, -exponent)};
    long double length = sqrtl(w.x * w.x + w.y * w.y + w.z * w.z);
    return (wide){w.x / length, w.y / length, w.z / length};
}

static wide widened(sure_vec3 v)
{
    return (wide){v.x, v.y, v.z};
}

static long double dot(wide a, wide b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static wide cross(wide a, wide b)
{
    return (wide){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static void check_rotation(sure_vec3 view, sure_tier tier, const sure_mat3 *world)
{
    /* A row's error is sqrt(3) times an entry's; a product of two rows has twice that. */
    const long double off = 2 * ENTRY_ROUNDINGS * unit(tier);
    wide f = direction_of(rounded_vector(tier, view));
    wide rows[ROWS];
    for (int i = 0; i < ROWS; i++)
        rows[i] = widened(world->row[i]);
    expect(fabsl(dot(rows[0], f)) <= off && fabsl(dot(rows[1], f)) <= off &&
               fabsl(dot(rows[2], f) + 1) <= off,
           "the view does not become (0,0,-1)");
    for (int i = 0; i < ROWS; i++) {
        for (int j = 0; j <= i; j++)
            expect(fabsl(dot(rows[i], rows[j]) - (i == j)) <= 2 * off,
                   "the rows are not a rotation's");
    }
    expect(dot(cross(rows[0], rows[1]), rows[2]) > 0, "a reflection");
    expect(world->row[0].y == 0 && world->row[1].y >= 0, "up does not stay up");
}

static void check_law_2(sure_vec3 view, sure_tier tier, const sure_mat3 *world, int k)
{
    sure_vec3 v = rounded_vector(tier, view), w = times_two_to(v, k);
    sure_vec3 of_tier = rounded_vector(tier, w);
    sure_mat3 other;
    if (!is_view(of_tier) || !same_vector(times_two_to(of_tier, -k), v))
        return;
    expect(rotation[tier](w, &other) == SURE_HIT && same_matrix(world, &other),
           "Law 2: a power of two changes the matrix");
}

static void check_law_3(sure_vec3 view, sure_tier tier, const sure_mat3 *m)
{
    const sure_vec3 *r = m->row;
    sure_mat3 other,
        mirrored = {
            {{r[0].x, -r[0].y, -r[0].z}, {-r[1].x, r[1].y, r[1].z}, {-r[2].x, r[2].y, r[2].z}}};
    sure_vec3 v = {-view.x, view.y, view.z};
    expect(rotation[tier](v, &other) == SURE_HIT && same_matrix(&mirrored, &other),
           "Law 3: a mirrored view's matrix is not mirrored");
}

static sure_vec3 read_view(fuzz_bytes *bytes, uint8_t how)
{
    sure_vec3 view = fuzz_vector(bytes, how & 1 ? fuzz_double : fuzz_shaped_double);
    if (how & 2) /* nearly straight up, down, or along an axis */
        view.x = ldexp(view.x, -1000);
    if (how & 4)
        view.z = ldexp(view.z, -60);
    return view;
}

static bool compare_rotation(fuzz_bytes *bytes, uint8_t how)
{
    int k = 8 * (int8_t)fuzz_byte(bytes);
    sure_vec3 view = read_view(bytes, how);
    fuzz_ask("view %a %a %a", view.x, view.y, view.z);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        fuzz_by(tier);
        sure_mat3 world;
        memset(&world, 0xa5, sizeof world);
        sure_status status = rotation[tier](view, &world);
        check_status(view, tier, status, &world);
        if (status != SURE_HIT)
            continue;
        check_axes(view, tier, &world);
        check_rotation(view, tier, &world);
        check_law_2(view, tier, &world, k);
        check_law_3(view, tier, &world);
    }
    return true;
}

/* The window. */

static double (*const extent[TIERS])(double, double) = {
    sure_viewport_extent_float32, sure_viewport_extent_textbook, sure_viewport_extent_stable};

/* Nothing is published: the tangent is the C library's. GNU's manual gives it 1 ulp, 2 u at most.
 * The argument is off by 3 u of itself (pi, the quotient, the product), which the tangent
 * magnifies pi/2 times at most up to 45 degrees; a product or quotient, another one, and the
 * reference's rounding make it less than: */
#define EXTENT_ROUNDINGS 10

/* Where a rounding of the angle is not magnified: up to 90 degrees, and for stable, which counts
 * from 180 beyond. */
static bool is_well_told(sure_tier tier, double fov)
{
    return fov <= 90 || tier == SURE_TIER_STABLE;
}

#ifndef FUZZ_WITHOUT_REFERENCE
static bool near_extent(sure_tier tier, double given, double right)
{
    return fabsl((long double)given - right) <=
           EXTENT_ROUNDINGS * unit(tier) * fabsl((long double)right);
}
#endif

/* Neither the angle, nor its tangent, nor the extent are subnormal or overflow. */
static bool is_ordinary(sure_tier tier, double focal, double fov, double given)
{
    double low = tier == SURE_TIER_FLOAT32 ? FLT_MIN : DBL_MIN;
    double high = tier == SURE_TIER_FLOAT32 ? FLT_MAX : DBL_MAX;
    return fov >= 0x1p10 * low && focal >= low && focal <= high && given >= low &&
           given <= high / 2;
}

static void check_extent(double focal_given, double fov_given, sure_tier tier, int k)
{
    double focal = rounded(tier, focal_given), fov = rounded(tier, fov_given);
    double given = extent[tier](focal_given, fov_given);
    double scaled = ldexp(focal, k);
    if (fov >= 180 || fov <= 0 || !is_ordinary(tier, focal, fov, given))
        return;
    if (is_well_told(tier, fov) || tier != SURE_TIER_FLOAT32)
        expect(given > 0, "an extent that is not above 0");
    if (scaled > 0 && isfinite(scaled) && ldexp(scaled, -k) == focal) {
        double other = extent[tier](scaled, fov_given);
        expect(!is_ordinary(tier, scaled, fov, other) || other == ldexp(given, k),
               "Law 1: a power of two changes the extent");
    }
#ifndef FUZZ_WITHOUT_REFERENCE
    if (is_well_told(tier, fov))
        expect(near_extent(tier, given, reference_viewport_extent(focal, fov)),
               "too far from the true extent");
#endif
}

/* Law 2, for angles that differ by more than the tangent's error. */
static void check_growth(double focal, double fov, double wider, sure_tier tier)
{
    double given = extent[tier](focal, fov), more = extent[tier](focal, wider);
    double low = rounded(tier, fov), high = rounded(tier, wider);
    bool apart = low * (1 + 2 * EXTENT_ROUNDINGS * (double)unit(tier)) < high;
    if (apart && high < 180 && is_well_told(tier, low) && is_well_told(tier, high) &&
        is_ordinary(tier, rounded(tier, focal), low, given) &&
        is_ordinary(tier, rounded(tier, focal), high, more))
        expect(given < more, "Law 2: the extent does not grow with the angle");
}

/* The tracer's, at any focal length that is a power of two; a subnormal tangent is rounded twice.
 */
static void check_tracers_extent(double fov, int k)
{
    double focal = ldexp(1, k % 64), given = viewport_extent(focal, fov);
    expect(given >= 0 && given <= DBL_MAX, "the tracer's is not an extent");
#ifndef FUZZ_WITHOUT_REFERENCE
    if (fov >= 0x1p-900)
        expect(given == reference_viewport_extent(focal, fov),
               "the tracer's extent is not correctly rounded");
#endif
}

/* Any angle, whole degrees, or some steps from 0, 90 or 180. */
static double read_angle(fuzz_bytes *bytes, uint8_t how)
{
    static const double ends[] = {0, 90, 180, 90};
    if (how % 4 == 0)
        return fuzz_double(bytes);
    if (how % 4 == 1)
        return fuzz_byte(bytes);
    if (how % 4 == 2)
        return fabs(fuzz_shaped_double(bytes));
    return fuzz_ulps(ends[how / 4 % 4], (int8_t)fuzz_byte(bytes));
}

static bool compare_extent(fuzz_bytes *bytes, uint8_t how)
{
    int k = (int8_t)fuzz_byte(bytes);
    double fov = read_angle(bytes, how), focal = fabs(fuzz_shaped_double(bytes));
    double wider = read_angle(bytes, how);
    if (!(fov > 0 && fov < 180 && focal > 0 && focal <= DBL_MAX))
        return false;
    fuzz_ask("focal_length %a fov %a, and %a", focal, fov, wider);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        fuzz_by(tier);
        check_extent(focal, fov, tier, k);
        if (wider > 0 && wider < 180)
            check_growth(focal, fov, wider, tier);
    }
    fuzz_by(SURE_TIER_TEXTBOOK);
    check_tracers_extent(fov, k);
    return true;
}

/* The rays. */

static sure_ray (*const pixel_ray[TIERS])(const sure_camera *, int, int, int, int) = {
    sure_pixel_ray_float32, sure_pixel_ray_textbook, sure_pixel_ray_stable};

typedef struct {
    sure_camera camera;
    int width, height, column, row;
} pixel;

static sure_ray ray_through(const pixel *p, sure_tier tier, int column, int row)
{
    return pixel_ray[tier](&p->camera, p->width, p->height, column, row);
}

/* From the middle of the window to the middle of the pixel. Three roundings, and in float32 those
 * of both whole numbers and of the extent. */
static bool near_offset(sure_tier tier, double given, double size, int at, int of)
{
    long double right =
        (long double)rounded(tier, size) * (2 * (long double)at + 1 - of) / (2 * (long double)of);
    return fabsl(given - right) <= 5 * unit(tier) * fabsl(right) + least(tier);
}

static void check_ray(const pixel *p, sure_tier tier)
{
    const sure_camera *camera = &p->camera;
    sure_ray ray = ray_through(p, tier, p->column, p->row);
    sure_vec3 d = ray.direction;
    expect(same_vector(ray.origin, camera->position), "the ray starts elsewhere");
    expect(ray.t_min == 0 && ray.t_max == INFINITY, "a range that is not [0, infinity]");
    expect(d.z == -rounded(tier, camera->focal_length), "the window is elsewhere");
    expect(near_offset(tier, d.x, camera->viewport_width, p->column, p->width) &&
               near_offset(tier, d.y, camera->viewport_height, p->row, p->height),
           "not through the pixel's middle");
    sure_vec3 across = ray_through(p, tier, p->width - 1 - p->column, p->row).direction;
    sure_vec3 upwards = ray_through(p, tier, p->column, p->height - 1 - p->row).direction;
    expect(same_vector(across, (sure_vec3){-d.x, d.y, d.z}) &&
               same_vector(upwards, (sure_vec3){d.x, -d.y, d.z}),
           "Law 1: mirrored pixels' rays are not mirrored");
    if (2 * (int64_t)p->column + 1 == p->width && 2 * (int64_t)p->row + 1 == p->height)
        expect(d.x == 0 && d.y == 0, "Law 2: the middle pixel is not straight ahead");
    if (p->column + 1 < p->width)
        expect(d.x <= ray_through(p, tier, p->column + 1, p->row).direction.x,
               "the next pixel is not farther right");
}

static int read_count(fuzz_bytes *bytes, uint8_t how)
{
    int low = fuzz_byte(bytes), high = fuzz_byte(bytes);
    if (how & 1)
        return 1 + low;
    return how & 2 ? INT_MAX - low : 1 + 256 * high + low;
}

static int read_place(fuzz_bytes *bytes, uint8_t how, int count)
{
    if (how & 4)
        return count / 2;
    return (int)(fuzz_u64(bytes) % (uint64_t)count);
}

static double read_length(fuzz_bytes *bytes)
{
    return fabs(fuzz_shaped_double(bytes));
}

/* What a float can't hold is no camera for float32. */
static bool is_camera(const sure_camera *c, sure_tier tier)
{
    double w = rounded(tier, c->viewport_width), h = rounded(tier, c->viewport_height);
    double f = rounded(tier, c->focal_length);
    return w > 0 && h > 0 && f > 0 && isfinite(w) && isfinite(h) && isfinite(f);
}

static bool compare_ray(fuzz_bytes *bytes, uint8_t how)
{
    pixel p;
    p.width = read_count(bytes, how);
    p.height = read_count(bytes, how);
    p.column = read_place(bytes, how, p.width);
    p.row = read_place(bytes, how, p.height);
    p.camera.focal_length = read_length(bytes);
    p.camera.viewport_width = read_length(bytes);
    p.camera.viewport_height = read_length(bytes);
    p.camera.position = fuzz_vector(bytes, fuzz_shaped_double);
    if (!all_finite(p.camera.position) || !is_camera(&p.camera, SURE_TIER_TEXTBOOK))
        return false;
    fuzz_ask("pixel %d %d of %d %d, focal length %a, window %a %a", p.column, p.row, p.width,
             p.height, p.camera.focal_length, p.camera.viewport_width, p.camera.viewport_height);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        fuzz_by(tier);
        if (is_camera(&p.camera, tier))
            check_ray(&p, tier);
    }
    return true;
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t what = fuzz_byte(&bytes), how = fuzz_byte(&bytes);
    switch (what % 3) {
    case 0: return compare_rotation(&bytes, how);
    case 1: return compare_extent(&bytes, how);
    default: return compare_ray(&bytes, how);
    }
}
