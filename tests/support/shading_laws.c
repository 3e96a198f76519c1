/* SPDX-License-Identifier: MIT */
#include "shading_laws.h"

#include "long_vector.h"
#include "tiers.h"

#include <stddef.h>

/* Squares of it, and products of these, are in the tier's range. */
static bool is_moderate(sure_tier tier, long_vector v)
{
    return within_powers(long_dot(v, v), tier == SURE_TIER_FLOAT32 ? 60 : 480);
}

static bool is_near(long double given, long double right, long double most)
{
    return fabsl(given - right) <= most;
}

static double (*const intensity[])(sure_vec3, sure_vec3,
                                   sure_vec3) = OF_TIERS(sure_light_intensity);
static sure_vec3 (*const color[])(const sure_light *, sure_vec3,
                                  sure_falloff) = OF_TIERS(sure_light_color);

/* The way to the light is off by u of each coordinate; each unit vector by 3 1/2 of its own, for
 * its square, the root and the quotient; the product by 3. Together less than: */
#define INTENSITY_ROUNDINGS 12
/* The way 2 and its square 3, pi and two products 3, quotient 1, colour 1: */
#define COLOR_ROUNDINGS 12

static const char *intensity_broken(sure_tier tier, sure_vec3 point, sure_vec3 normal,
                                    sure_vec3 light)
{
    long_vector way = long_between(point, light), n = long_of(normal);
    double given = intensity[tier](point, normal, light);
    if (!(given >= 0 && given <= 1))
        return "an intensity that is not from 0 to 1";
    if (long_dot(way, way) == 0)
        return given == 0 ? NULL : "Law 1: light at the point itself";
    sure_vec3 far = times_two_to(point, 2), far_light = times_two_to(light, 2);
    if (is_moderate(tier, n) && intensity[tier](point, times_two_to(normal, 3), light) != given)
        return "Law 2: a longer normal";
    if (is_moderate(tier, way) && is_moderate(tier, long_of(far)) &&
        is_moderate(tier, long_of(far_light)) && intensity[tier](far, normal, far_light) != given)
        return "Law 2: all of it four times as large";
    long double right = fmaxl(0, long_dot(long_unit(way), long_unit(n)));
    bool counted = is_moderate(tier, way) && is_moderate(tier, n);
    return !counted || is_near(given, right, INTENSITY_ROUNDINGS * unit(tier)) ? NULL
                                                                               : "an intensity";
}

/* Is the number neither subnormal nor near overflow? */
static bool is_ordinary(sure_tier tier, long double x)
{
    return within_powers(x, tier == SURE_TIER_FLOAT32 ? 120 : 1000);
}

static const char *color_broken(sure_tier tier, sure_vec3 point, const sure_light *light,
                                sure_falloff falloff)
{
    const long double pi = 3.141592653589793238462643383279502884L;
    long_vector way = long_between(point, light->position);
    long double square = long_dot(way, way), share = light->brightness;
    sure_vec3 given = color[tier](light, point, falloff);
    if (falloff == SURE_FALLOFF_INVERSE_SQUARE) {
        if (square == 0)
            return given.x == 0 && given.y == 0 && given.z == 0 ? NULL : "light at the point";
        if (tier != SURE_TIER_STABLE && !is_moderate(tier, way))
            return NULL;
        share /= 4 * pi * square;
    }
    const double parts[] = {given.x, given.y, given.z};
    const double of[] = {light->color.x, light->color.y, light->color.z};
    for (int i = 0; i < 3; i++) {
        long double right = share * of[i], most = COLOR_ROUNDINGS * unit(tier) * right;
        bool counted = is_ordinary(tier, share) && is_ordinary(tier, right);
        if (counted ? !is_near(parts[i], right, most) : !(parts[i] >= 0))
            return counted ? "a light's colour" : "a light's colour that is none";
    }
    return NULL;
}

/* Law 3: at twice the way a quarter, where nothing leaves the range. */
static const char *law_3_broken(sure_tier tier, const sure_light *light)
{
    const sure_vec3 origin = {0, 0, 0};
    sure_light far = *light;
    if (!is_moderate(tier, long_of(light->position)))
        return NULL;
    far.position = times_two_to(light->position, 1);
    sure_vec3 near_color = color[tier](light, origin, SURE_FALLOFF_INVERSE_SQUARE);
    sure_vec3 far_color = color[tier](&far, origin, SURE_FALLOFF_INVERSE_SQUARE);
    if (!is_ordinary(tier, near_color.x) || !is_ordinary(tier, near_color.x / 64))
        return NULL;
    return far_color.x == near_color.x / 4 ? NULL : "Law 3";
}

const char *light_broken(sure_tier tier, sure_vec3 point, sure_vec3 normal, const sure_light *light,
                         sure_falloff falloff)
{
    const char *broken = intensity_broken(tier, point, normal, light->position);
    if (!broken)
        broken = color_broken(tier, point, light, falloff);
    return broken ? broken : law_3_broken(tier, light);
}

static double (*const specular[])(sure_vec3, sure_vec3, sure_vec3,
                                  int) = OF_TIERS(sure_phong_specular);
static sure_vec3 (*const mix[])(const sure_material *, sure_vec3, double,
                                double) = OF_TIERS(sure_phong_mix);
static sure_vec3 (*const mirror[])(const sure_material *, sure_vec3,
                                   sure_vec3) = OF_TIERS(sure_phong_mirror);

/* Three unit vectors at 3 1/2, each component of the mirrored one 18 (part_check.c), which the
 * product adds up to sqrt(3) times that, and 3 of its own: less than */
#define CLOSENESS_ROUNDINGS 48

/* x^n by products is off by less than 2 n u of itself; the least number may be lost in each. */
static bool is_power_near(sure_tier tier, double given, long double closeness, int n)
{
    long double off = CLOSENESS_ROUNDINGS * unit(tier),
                grown = 2 * unit(tier) * ((long double)n + 1);
    long double low = fmaxl(0, closeness - off), high = fmaxl(0, fminl(1, closeness + off));
    if (closeness < off)
        return given <= powl(high, n) * expl(grown) + 64 * least(tier);
    return given >= powl(low, n) * expl(-grown) - 64 * least(tier) &&
           given <= powl(high, n) * expl(grown) + 64 * least(tier);
}

const char *highlight_broken(sure_tier tier, sure_vec3 normal, sure_vec3 to_eye, sure_vec3 to_light,
                             int shine)
{
    double given = specular[tier](normal, to_eye, to_light, shine);
    double back = specular[tier](normal, to_light, to_eye, shine);
    if (!(given >= 0 && given <= 1))
        return "a highlight that is not from 0 to 1";
    long_vector v = long_of(to_eye), n = long_of(normal), l = long_of(to_light);
    if (!is_moderate(tier, v) || !is_moderate(tier, n) || !is_moderate(tier, l))
        return NULL;
    v = long_unit(v), n = long_unit(n), l = long_unit(l);
    long double closeness = long_dot(long_sum(2 * long_dot(n, v), n, -1, v), l);
    if (!is_power_near(tier, given, closeness, shine))
        return "a highlight";
    return is_power_near(tier, back, closeness, shine) ? NULL : "Law 2: eye and light exchanged";
}

/* Products and sums of numbers that are not negative: at most four roundings of each term. */
static bool is_sum_near(sure_tier tier, double given, long double right)
{
    long double largest = tier == SURE_TIER_FLOAT32 ? FLT_MAX / 2 : DBL_MAX / 2;
    return right > largest || is_near(given, right, 5 * unit(tier) * right + 4 * least(tier));
}

const char *mix_broken(sure_tier tier, const sure_material *material, sure_vec3 incoming,
                       sure_vec3 reflected, double intensity_there, double highlight)
{
    const sure_vec3 none = {0, 0, 0};
    sure_vec3 seen = mix[tier](material, incoming, intensity_there, highlight);
    sure_vec3 dark = mix[tier](material, none, intensity_there, highlight);
    sure_vec3 mixed = mirror[tier](material, incoming, reflected);
    const double in[] = {incoming.x, incoming.y, incoming.z}, out[] = {seen.x, seen.y, seen.z};
    const double own[] = {material->color.x, material->color.y, material->color.z};
    const double from[] = {reflected.x, reflected.y, reflected.z};
    const double to[] = {mixed.x, mixed.y, mixed.z};
    long double share = material->mirror;
    if (dark.x != 0 || dark.y != 0 || dark.z != 0)
        return "Law 3: no light gives none";
    for (int i = 0; i < 3; i++) {
        long double glow = (long double)own[i] * intensity_there;
        glow += (long double)material->specular * highlight;
        if (!is_sum_near(tier, out[i], in[i] * glow))
            return "a mix";
        if (!is_sum_near(tier, to[i], (1 - share) * in[i] + share * from[i]))
            return "a mirror's mix";
    }
    return NULL;
}
