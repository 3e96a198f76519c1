/* SPDX-License-Identifier: MIT */
/* The camera: the world's rotation, the window's extent and the rays through its pixels. */
#include "fuzz.h"
#include "camera_laws.h"
#include "tiers.h"

#include "placement.h"
#ifndef FUZZ_WITHOUT_REFERENCE
#include "reference.h"
#endif

#include <float.h>
#include <limits.h>

#include <surehit/viewport.h>

FUZZ_TARGET("camera", fuzz_mutate_doubles)

/* The rotation. */

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
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++)
        fuzz_promised(tier, rotation_law_broken(tier, view, k));
    return true;
}

/* The window. */

static double (*const extent[TIERS])(double, double) = OF_TIERS(sure_viewport_extent);

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
    long double right = reference_viewport_extent(focal, fov);
    if (is_well_told(tier, fov))
        expect(fabsl(given - right) <= EXTENT_ROUNDINGS * unit(tier) * fabsl(right),
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
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++)
        fuzz_promised(tier, is_camera(&p.camera, tier) ? pixel_law_broken(tier, &p) : NULL);
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
