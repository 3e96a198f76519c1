/* The frozen vectors (docs/vectors.md): every tier's promises held against them, and what is read
 * of a line. The bytes themselves are test_vectors.py's. */
#include "suite.h"
#include "vectors.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <surehit/bounds.h>

static bool same_bits(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

/* All of a shape's, in order; a line that cannot be read fails. */
static int each_vector(sure_shape shape, void (*use)(const frozen_case *, const char *line))
{
    const char *path = suite_file("vectors/%s.jsonl", sure_shape_name(shape));
    FILE *file = fopen(path, "r");
    ck_assert_msg(file != NULL, "%s cannot be opened", path);
    char line[VECTORS_LINE_MAX];
    sure_shape named;
    ck_assert(fgets(line, sizeof line, file) && vectors_read_head(line, &named) && named == shape);
    int count = 0;
    for (; fgets(line, sizeof line, file); count++) {
        frozen_case frozen;
        ck_assert_msg(vectors_read(shape, line, &frozen), "not as it is printed: %s", line);
        use(&frozen, line);
    }
    fclose(file);
    return count;
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

START_TEST(test_promises)
{
    asked_tier = (sure_tier)_i;
    for (int shape = 0; shape < SURE_SHAPES; shape++)
        ck_assert_int_gt(each_vector((sure_shape)shape, check_vector), 10 * VECTORS_PER_REGIME);
}
END_TEST

/* Which regimes occur, and how often; and the shape's file of hard cases. */
static int of_regime[REGIMES], by_hand;

static void count_source(const frozen_case *frozen, const char *line)
{
    regime which;
    (void)line;
    if (!regime_from_name(frozen->source, &which)) {
        by_hand++;
        return;
    }
    ck_assert_uint_eq(frozen->number, (uint64_t)of_regime[which]);
    of_regime[which]++;
}

START_TEST(test_every_regime)
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        memset(of_regime, 0, sizeof of_regime);
        by_hand = 0;
        each_vector((sure_shape)shape, count_source);
        for (int r = 0; r < REGIMES; r++)
            ck_assert_int_eq(of_regime[r],
                             regime_applies((sure_shape)shape, (regime)r) ? VECTORS_PER_REGIME : 0);
        ck_assert_int_gt(by_hand, 0);
    }
}
END_TEST

/* Every number is printed as it is: each exponent, whole and odd fractions, both signs. */
START_TEST(test_round_trip)
{
    for (int power = 0; power < 2048; power++) {
        for (int i = 0; i < 4; i++) {
            uint64_t fraction = suite_bits(1, (uint64_t)(4 * power + i)) >> 12 >> (17 * i % 52);
            uint64_t bits = (uint64_t)i % 2 << 63 | (uint64_t)power << 52 | fraction;
            double numbers[CASE_NUMBERS_MAX] = {0}, read[CASE_NUMBERS_MAX];
            memcpy(&numbers[i], &bits, sizeof bits);
            sure_case question = case_from_numbers(SURE_SHAPE_SPHERE, numbers);
            frozen_case frozen = vectors_case_of("test", 7, &question), back;
            char line[VECTORS_LINE_MAX], number[64];
            vectors_print(&frozen, line);
            snprintf(number, sizeof number, isnan(numbers[i]) ? "\"nan\"" : "\"%a\"", numbers[i]);
            ck_assert_msg(strstr(line, number) != NULL, "%s not in %s", number, line);
            ck_assert_msg(vectors_read(SURE_SHAPE_SPHERE, line, &back), "%s", line);
            case_to_numbers(&back.question, read);
            ck_assert_msg(same_bits(numbers, read, sizeof(double) * 12), "%s", line);
        }
    }
}
END_TEST

/* No other line is read, and nothing is written then. */
START_TEST(test_refused)
{
    sure_case question = regime_case(SURE_SHAPE_SPHERE, REGIME_TYPICAL, 1, 2);
    frozen_case frozen = vectors_case_of("test", 1, &question), read, before;
    char line[VECTORS_LINE_MAX + 1];
    ck_assert_int_eq(frozen.answer.status, SURE_HIT);
    vectors_print(&frozen, line);
    size_t length = strlen(line);
    memset(&before, 0xa5, sizeof before);
    read = before;
    for (size_t i = 0; i < length; i++) {
        char right = line[i];
        line[i] = right == '9' ? '1' : '9';
        bool is_name = vectors_read(SURE_SHAPE_SPHERE, line, &read);
        /* a digit of the number or a letter of the source: another line as good */
        ck_assert_msg(!is_name || (i < strlen("{\"from\":\"test\",\"number\":1")), "%s", line);
        if (is_name)
            read = before;
        ck_assert_msg(same_bits(&read, &before, sizeof read), "%s", line);
        line[i] = '\0';
        ck_assert(!vectors_read(SURE_SHAPE_SPHERE, line, &read));
        line[i] = right;
    }
    strcat(line, " ");
    ck_assert(!vectors_read(SURE_SHAPE_SPHERE, line, &read));
    ck_assert(!vectors_read(SURE_SHAPE_CONE, line, &read));
    sure_shape shape = SURE_SHAPE_CONE;
    vectors_print_head(SURE_SHAPE_SPHERE, line);
    line[strlen("{\"surehit_vectors\":")]++; /* a later version */
    ck_assert(!vectors_read_head(line, &shape));
    ck_assert_int_eq(shape, SURE_SHAPE_CONE);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("vectors");
    TCase *tests = tcase_create("vectors");
    tcase_add_test(tests, test_every_regime);
    tcase_add_test(tests, test_round_trip);
    tcase_add_test(tests, test_refused);
    suite_add_tcase(suite, tests);
    suite_add_all_tiers(suite, "promises", test_promises);
    return suite_run(suite);
}
