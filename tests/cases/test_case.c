#include "case.h"
#include "regimes.h"
#include "shrink.h"
#include "suite.h"

#include <math.h>
#include <string.h>

static bool same_number(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

/* Every case of every regime survives being written and read, sign of zero included. */
TEST(test_round_trip)
{
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime r = 0; r < REGIMES; r++) {
            for (uint64_t i = 0; regime_applies(shape, r) && i < 300; i++) {
                sure_case question = regime_case(shape, r, 3, i), read;
                double a[CASE_NUMBERS_MAX], b[CASE_NUMBERS_MAX];
                char line[CASE_LINE_MAX];
                case_print(&question, line);
                ck_assert_uint_lt(strlen(line), CASE_LINE_MAX - 1);
                ck_assert_msg(case_read(line, &read), "%s", line);
                ck_assert_int_eq(read.object.shape, shape);
                case_to_numbers(&question, a);
                case_to_numbers(&read, b);
                for (int n = 0; n < case_numbers(shape); n++)
                    ck_assert_msg(same_number(a[n], b[n]), "%s", line);
            }
        }
    }
}

TEST(test_refused)
{
    static const char *const lines[] = {
        "",
        "\n",
        "sphere",
        "sphere ",
        "Sphere 0 0 0 0 0 1 0 inf 0 0 5 1",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1 2",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1 ",
        " sphere 0 0 0 0 0 1 0 inf 0 0 5 1",
        "sphere  0 0 0 0 0 1 0 inf 0 0 5 1",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1x",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 -",
        "sphere 0,0,0 0 0 1 0 inf 0 0 5 1",
        "sphere 0\t0 0 0 0 1 0 inf 0 0 5 1",
        "sphere \t0 0 0 0 0 1 0 inf 0 0 5 1",
        "sphereoidallylongname 0 0 0 0 0 1 0 inf 0 0 5 1",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        sure_case question, before;
        memset(&question, 0x5a, sizeof question);
        before = question;
        ck_assert_msg(!case_read(lines[i], &question), "%s", lines[i]);
        ck_assert(memcmp(&question, &before, sizeof question) == 0);
    }
}

TEST(test_accepted)
{
    static const char *const lines[] = {
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1\n",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1\r\n",
        "sphere +0 -0 0x0p+0 0.0 0e9 1 0 INF 0 0 0x1.4p+2 1",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        sure_case question;
        ck_assert_msg(case_read(lines[i], &question), "%s", lines[i]);
        ck_double_same(question.object.as.sphere.centre.z, 5);
        ck_double_same(question.ray.t_max, INFINITY);
    }
}

TEST(test_answers)
{
    static const char *const good[] = {"miss", "invalid t_max", "invalid radius",
                                       "hit 0x1.8p+1 wall -0x1p+0 0x0p+0 0x0p+0"};
    static const char *const bad[] = {
        "",     "hit",          "hit 3",  "invalid",          "miss ",         "invalid none",
        "hits", "invalid line", "miss 3", "hit 3 side 0 0 1", "hit 3 wall 0 0"};
    char line[CASE_LINE_MAX];
    case_answer answer;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        ck_assert_msg(case_answer_read(good[i], &answer), "%s", good[i]);
        case_answer_print(&answer, line);
        ck_assert_str_eq(line, good[i]);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        ck_assert_msg(!case_answer_read(bad[i], &answer), "%s", bad[i]);
}

/* A bug that shows whenever the sphere's centre lies beyond 3 shrinks to little else. */
static bool far_centre(const sure_case *question, void *context)
{
    ++*(int *)context;
    return question->object.as.sphere.centre.z > 3;
}

TEST(test_shrink)
{
    sure_case question = {
        .ray = {{1.1, -2.7, 1e9}, {0.1, 1e-30, 5.5}, 0.25, 1e300},
        .object = {SURE_SHAPE_SPHERE, {.sphere = {{7.7, 1 / 3.0, 12345.678}, 0.9}}},
    };
    int asked = 0;
    sure_case simple = shrink_case(&question, false, far_centre, &asked);
    ck_assert_int_gt(asked, 10);
    ck_vector_same(simple.ray.origin, (sure_vec3){0, 0, 0});
    ck_vector_same(simple.ray.direction, (sure_vec3){0, 0, 0});
    ck_vector_same(simple.object.as.sphere.centre, (sure_vec3){0, 0, 4});
    ck_double_same(simple.object.as.sphere.radius, 0);
}

SUITE("case")
