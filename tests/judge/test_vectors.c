/* The frozen vectors of the regimes (docs/vectors.md): every tier's promises held against them, and
 * how numbers are printed. The bytes themselves are test_vectors.py's. */
#include "suite.h"
#include "vectors.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <surehit/bounds.h>

static bool same_bits(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

static bool is_in_range(const sure_ray *ray, double t)
{
    return t >= ray->t_min && t <= ray->t_max;
}

/* What follows from |t - t*| <= t_error for the rounded t*, each number rounded up or monotonely
 * (law 8 of the headers). */
static bool agrees(double t, double t_error, double rounded)
{
    double step = nextafter(fabs(rounded), INFINITY) - fabs(rounded);
    return t == rounded || fabs(t - rounded) <= t_error + step;
}

/* SURE_NORMAL_ERROR, and half an ulp of what is below 1. */
static bool is_normal_near(double component, double rounded)
{
    return fabs(component - rounded) <= SURE_NORMAL_ERROR + 0x1p-53;
}

static void check_exact(const frozen_case *frozen, const sure_hit *hit, const sure_vec3 *normal,
                        const char *line)
{
    ck_assert_msg(same_bits(&hit->t, &frozen->answer.t, sizeof hit->t), "exact: t: %s", line);
    ck_assert_msg(same_bits(normal, &frozen->answer.normal, sizeof *normal), "exact: normal: %s",
                  line);
}

static void check_certain(const frozen_case *frozen, const sure_hit *hit, const sure_vec3 *normal,
                          const char *line)
{
    const case_answer *truth = &frozen->answer;
    ck_assert_msg(is_in_range(&frozen->question.ray, hit->t), "certain: range: %s", line);
    ck_assert_msg(hit->t_error >= 0 && agrees(hit->t, hit->t_error, truth->t), "certain: t: %s",
                  line);
    ck_assert_msg(is_normal_near(normal->x, truth->normal.x) &&
                      is_normal_near(normal->y, truth->normal.y) &&
                      is_normal_near(normal->z, truth->normal.z),
                  "certain: normal: %s", line);
}

/* A t_error that is finite promises, and stable alone has one. */
static void check_plain(const frozen_case *frozen, sure_tier tier, const sure_hit *hit,
                        const sure_vec3 *normal, const char *line)
{
    bool promised = tier == SURE_TIER_STABLE && agrees(hit->t, hit->t_error, frozen->answer.t);
    ck_assert_msg(!isnan(hit->t) && (hit->t_error == INFINITY || promised), "a plain tier's t: %s",
                  line);
    ck_assert_msg(!isnan(normal->x) && !isnan(normal->y) && !isnan(normal->z),
                  "a plain tier's normal: %s", line);
}

static void check_hit(const frozen_case *frozen, sure_tier tier, const sure_hit *hit,
                      const char *line)
{
    sure_vec3 normal =
        sure_object_normal(&frozen->question.ray, &frozen->question.object, tier, hit);
    if (tier == SURE_TIER_EXACT)
        check_exact(frozen, hit, &normal, line);
    else if (tier == SURE_TIER_CERTAIN)
        check_certain(frozen, hit, &normal, line);
    else
        check_plain(frozen, tier, hit, &normal, line);
}

static sure_tier asked_tier;

static void check_vector(const frozen_case *frozen, const char *line)
{
    const sure_ray *ray = &frozen->question.ray;
    const sure_object *object = &frozen->question.object;
    const case_answer *truth = &frozen->answer;
    sure_hit untouched, hit;
    memset(&untouched, 0xa5, sizeof untouched);
    hit = untouched;
    sure_status status = sure_object_hit(ray, object, asked_tier, &hit);
    bool decides = asked_tier >= SURE_TIER_CERTAIN;
    ck_assert_msg(sure_object_check(ray, object) == truth->field, "field: %s", line);
    ck_assert_msg(sure_object_occluded(ray, object, asked_tier) == status, "occluded: %s", line);
    if (decides || truth->status == SURE_INVALID)
        ck_assert_msg(status == truth->status, "%s: %s", sure_status_name(status), line);
    if (status != SURE_HIT) {
        ck_assert_msg(same_bits(&hit, &untouched, sizeof hit), "touched: %s", line);
        return;
    }
    ck_assert_msg(!decides || hit.part == truth->part, "part: %s", line);
    check_hit(frozen, asked_tier, &hit, line);
}

static char *line_of(const frozen_case *frozen)
{
    json_t *object = vectors_json(frozen);
    char *line = json_dumps(object, JSON_COMPACT);
    json_decref(object);
    return line;
}

static void check_regime(sure_shape shape, regime which)
{
    for (uint64_t i = 0; i < VECTORS_PER_REGIME; i++) {
        frozen_case frozen = vectors_case(shape, which, i);
        char *line = line_of(&frozen);
        check_vector(&frozen, line);
        free(line);
    }
}

LOOP_TEST(test_promises, SURE_TIERS)
{
    asked_tier = (sure_tier)_i;
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime which = 0; which < REGIMES; which++) {
            if (regime_applies(shape, which))
                check_regime(shape, which);
        }
    }
}

/* Every number is printed as it is: each exponent, whole and odd fractions, both signs. */
TEST(test_numbers)
{
    for (int power = 0; power < 2048; power++) {
        for (int i = 0; i < 4; i++) {
            uint64_t fraction = suite_bits(1, (uint64_t)(4 * power + i)) >> 12 >> (17 * i % 52);
            uint64_t bits = (uint64_t)i % 2 << 63 | (uint64_t)power << 52 | fraction;
            double numbers[CASE_NUMBERS_MAX] = {0};
            memcpy(&numbers[i], &bits, sizeof bits);
            sure_case question = case_from_numbers(SURE_SHAPE_SPHERE, numbers);
            frozen_case frozen = vectors_case_of("test", 7, &question);
            char *line = line_of(&frozen), number[64], digits[64];
            snprintf(number, sizeof number, isnan(numbers[i]) ? "\"nan\"" : "\"%a\"", numbers[i]);
            snprintf(digits, sizeof digits, "\"%016" PRIx64 "\"", bits);
            ck_assert_msg(strstr(line, number) && strstr(line, digits), "%s or %s not in %s",
                          number, digits, line);
            free(line);
        }
    }
}

SUITE("vectors")
