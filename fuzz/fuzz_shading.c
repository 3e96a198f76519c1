/* SPDX-License-Identifier: MIT */
/* Light, the Phong model and refraction: their laws and formulas in every tier. */
#include "fuzz.h"

#include "refraction_truth.h"
#include "shading_laws.h"
#include "tiers.h"

#include <limits.h>

FUZZ_TARGET("shading", fuzz_mutate_doubles)

/* Whole numbers, raw ones, or of any kind; not zero where that is no vector. */
static sure_vec3 read_vector(fuzz_bytes *bytes, uint8_t how)
{
    return fuzz_vector(bytes, how & 1 ? fuzz_double : fuzz_shaped_double);
}

static bool is_of_tier(sure_tier tier, sure_vec3 v)
{
    return is_direction(rounded_vector(tier, v));
}

static bool compare_light(fuzz_bytes *bytes, uint8_t how)
{
    sure_vec3 point = read_vector(bytes, how), normal = read_vector(bytes, how);
    sure_light light = {.position = read_vector(bytes, how)};
    bool compared = false;
    light.brightness = fabs(fuzz_shaped_double(bytes));
    light.color = fuzz_vector(bytes, fuzz_share);
    fuzz_ask("point %a %a %a normal %a %a %a light %a %a %a, %a", point.x, point.y, point.z,
             normal.x, normal.y, normal.z, light.position.x, light.position.y, light.position.z,
             light.brightness);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        sure_light there = {rounded_vector(tier, light.position), rounded_vector(tier, light.color),
                            rounded(tier, light.brightness)};
        sure_vec3 at = rounded_vector(tier, point);
        if (!is_of_tier(tier, normal) || !all_finite(at) || !all_finite(there.position) ||
            !isfinite(there.brightness))
            continue;
        fuzz_promised(tier,
                      light_broken(tier, at, rounded_vector(tier, normal), &there,
                                   how & 2 ? SURE_FALLOFF_NONE : SURE_FALLOFF_INVERSE_SQUARE));
        compared = true;
    }
    return compared;
}

static bool compare_highlight(fuzz_bytes *bytes, uint8_t how)
{
    sure_vec3 normal = read_vector(bytes, how), eye = read_vector(bytes, how);
    sure_vec3 light = read_vector(bytes, how);
    int shine = how & 2 ? fuzz_byte(bytes) : (int)(fuzz_u64(bytes) & INT_MAX);
    bool compared = false;
    fuzz_ask("normal %a %a %a eye %a %a %a light %a %a %a, shine %d", normal.x, normal.y, normal.z,
             eye.x, eye.y, eye.z, light.x, light.y, light.z, shine);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        if (!is_of_tier(tier, normal) || !is_of_tier(tier, eye) || !is_of_tier(tier, light))
            continue;
        fuzz_promised(tier, highlight_broken(tier, rounded_vector(tier, normal),
                                             rounded_vector(tier, eye), rounded_vector(tier, light),
                                             shine));
        compared = true;
    }
    return compared;
}

static double read_amount(fuzz_bytes *bytes)
{
    return fabs((double)(float)fuzz_shaped_double(bytes));
}

static bool compare_mix(fuzz_bytes *bytes)
{
    sure_material material = {
        .color = rounded_vector(SURE_TIER_FLOAT32, fuzz_vector(bytes, fuzz_share))};
    material.specular = (double)(float)fuzz_share(bytes);
    material.mirror = (double)(float)fuzz_share(bytes);
    double intensity = (double)(float)fuzz_share(bytes),
           highlight = (double)(float)fuzz_share(bytes);
    sure_vec3 incoming = fuzz_vector(bytes, read_amount);
    sure_vec3 reflected = fuzz_vector(bytes, read_amount);
    if (!all_finite(incoming) || !all_finite(reflected))
        return false;
    fuzz_ask("incoming %a %a %a reflected %a %a %a, %a of %a, highlight %a", incoming.x, incoming.y,
             incoming.z, reflected.x, reflected.y, reflected.z, intensity, material.mirror,
             highlight);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++)
        fuzz_promised(tier, mix_broken(tier, &material, incoming, reflected, intensity, highlight));
    return true;
}

/* Vectors of moderate sizes, so that no tier over- or underflows; any ratio, or some steps from 1,
 * or nearly the critical one. */
static bool compare_refraction(fuzz_bytes *bytes, uint8_t how)
{
    refraction_question q = {.d = read_vector(bytes, 0), .n = read_vector(bytes, 0)};
    refraction_counts unused = {0};
    bool compared = false;
    q.ratio = how & 2 ? fuzz_ulps(1, (int8_t)fuzz_byte(bytes)) : fabs(fuzz_shaped_double(bytes));
    if (how & 4)
        q.ratio = ldexp(1 + fuzz_byte(bytes), -8) * 2;
    fuzz_ask("d %a %a %a N %a %a %a ratio %a", q.d.x, q.d.y, q.d.z, q.n.x, q.n.y, q.n.z, q.ratio);
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE; tier++) {
        refraction_question there = {rounded_vector(tier, q.d), rounded_vector(tier, q.n),
                                     rounded(tier, q.ratio)};
        if (!is_of_tier(tier, q.d) || !is_of_tier(tier, q.n) ||
            !refraction_is_moderate(tier, &there))
            continue;
        fuzz_promised(tier, refraction_broken(tier, &there, &unused));
        compared = true;
    }
    return compared;
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t what = fuzz_byte(&bytes), how = fuzz_byte(&bytes);
    switch (what % 4) {
    case 0: return compare_light(&bytes, how);
    case 1: return compare_highlight(&bytes, how);
    case 2: return compare_mix(&bytes);
    default: return compare_refraction(&bytes, how);
    }
}
