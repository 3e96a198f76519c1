/* SPDX-License-Identifier: MIT */
/* Reading cases, and shrinking them; fuzz/fuzz_case.c has the format, line by line. */
#include "case.h"
#include "shrink.h"
#include "suite.h"

TEST(test_accepted)
{
    static const char *const lines[] = {
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1\n",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1\r\n",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1 #",
        "sphere 0 0 0 0 0 1 0 inf 0 0 5 1 # rim, or so\n",
        "sphere +0 -0 0x0p+0 0.0 0e9 1 0 INF 0 0 0x1.4p+2 1",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        sure_case question;
        ck_assert_msg(case_read(lines[i], &question), "%s", lines[i]);
        ck_double_same(question.object.as.sphere.centre.z, 5);
        ck_double_same(question.ray.t_max, INFINITY);
    }
}

/* A remark has a blank before it, and an answer has none. */
TEST(test_refused)
{
    sure_case question;
    case_answer answer;
    ck_assert(!case_read("sphere 0 0 0 0 0 1 0 inf 0 0 5 1# rim", &question));
    ck_assert(!case_read("sphere 0 0 0 0 0 1 0 inf 0 0 5 1  # rim", &question));
    ck_assert(!case_read("sphere 0 0 0 0 0 1 0 inf 0 0 5 # 1", &question));
    ck_assert(!case_answer_read("miss # rim", &answer));
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
