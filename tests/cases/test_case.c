/* SPDX-License-Identifier: MIT */
/* Reading cases, shrinking them and moving their faces; fuzz/fuzz_case.c has the format, line by
 * line. */
#include "case.h"
#include "shrink.h"
#include "suite.h"

#include "../../src/cases/moved.h"

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

static sure_case case_of(const char *line)
{
    sure_case question;
    ck_assert_msg(case_read(line, &question), "%s", line);
    return question;
}

/* Of a wall a start on it is within, as in a solid. */
TEST(test_within_wall)
{
    static const struct {
        const char *line;
        bool within;
    } rows[] = {
        {"cylinder 0 0 9 1 0 0 0 inf 0 0 0 0 0 2 1", true},
        {"cylinder 1 0 9 1 0 0 0 inf 0 0 0 0 0 2 1", true},
        {"cylinder 0x1.0000000000001p+0 0 9 1 0 0 0 inf 0 0 0 0 0 2 1", false},
        {"cone 0 0 1 1 0 0 0 inf 0 0 0 0 0 2 2", true},
        {"cone 1 0 1 1 0 0 0 inf 0 0 0 0 0 2 2", true},
        {"cone 0x1.0000000000001p+0 0 1 1 0 0 0 inf 0 0 0 0 0 2 2", false},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        sure_case question = case_of(rows[i].line);
        question.wall = true;
        ck_assert_msg(case_starts_within(&question, &question.ray) == rows[i].within, "%s",
                      rows[i].line);
    }
}

TEST(test_invalid_wall)
{
    sure_case question = case_of("cylinder 0 0 9 1 0 0 0 inf 0 0 0 0 0 2 -1");
    question.wall = true;
    case_answer said = case_answer_of(&question, SURE_TIER_EXACT);
    ck_assert_int_eq(said.status, SURE_INVALID);
    ck_assert_int_eq(said.field, SURE_FIELD_RADIUS);
}

/* Half of the longest side, whichever it is, or of the height, or the radius. */
TEST(test_object_size)
{
    static const struct {
        const char *line;
        double size;
    } rows[] = {
        {"box 0 0 0 0 0 1 0 inf 1 1 1 9 3 5", 4},
        {"box 0 0 0 0 0 1 0 inf 1 1 1 3 9 5", 4},
        {"box 0 0 0 0 0 1 0 inf 1 1 1 3 5 9", 4},
        {"cylinder 0 0 0 0 0 1 0 inf 1 1 1 4 5 13 3", 6.5},
        {"cone 0 0 0 0 0 1 0 inf 1 1 1 4 5 13 7", 7},
        {"plane 0 0 0 0 0 1 0 inf 1 1 1 4 5 13", 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const sure_case question = case_of(rows[i].line);
        ck_double_same(object_size(&question.object), rows[i].size);
    }
}

/* A way that is nothing beside the coordinates leads to another number nevertheless. */
TEST(test_moved_by_little)
{
    const sure_object box = case_of("box 0 0 0 0 0 1 0 inf 1 -2 3 4 5 6").object;
    const sure_object tube = case_of("cylinder 0 0 0 0 0 1 0 inf 0 0 0 0 0 2 1").object;
    const movement out = movement_of_all(0x1p-70), in = movement_times(&out, -1);
    sure_object larger, smaller;
    ck_assert(object_moved(&box, &out, &larger) && object_moved(&box, &in, &smaller));
    const double *x = (const double *)(const void *)&box.as;
    const double *l = (const double *)(const void *)&larger.as;
    const double *s = (const double *)(const void *)&smaller.as;
    for (int i = 0; i < 3; i++) {
        ck_assert(l[i] < x[i] && x[i] < s[i]);
        ck_assert(s[3 + i] < x[3 + i] && x[3 + i] < l[3 + i]);
    }
    ck_assert(wall_moved(&tube, &out, &larger) && wall_moved(&tube, &in, &smaller));
    ck_assert(smaller.as.cylinder.radius < 1 && larger.as.cylinder.radius > 1);
}

TEST(test_times)
{
    const movement how = movement_times(&(movement){.by = {1, 2, 3}, .along = 4}, -2);
    ck_double_same(how.by[2], -6);
    ck_double_same(how.along, -8);
}

/* Of a box whose corners are exchanged in some coordinates the sides stay. */
TEST(test_mended)
{
    double box[] = {1, 5, -3, 4, 2, -6}, ball[] = {1, 2, 3, -4};
    object_mend(SURE_SHAPE_BOX, box);
    object_mend(SURE_SHAPE_SPHERE, ball);
    static const double sides[] = {1, 2, -6, 4, 5, -3};
    for (int i = 0; i < 6; i++)
        ck_double_same(box[i], sides[i]);
    ck_double_same(ball[3], 4);
}

SUITE("case")
