/* SPDX-License-Identifier: MIT */
/* What the reference alone answers, against answers reasoned out by hand (reference.rows). */

#include "case.h"
#include "objects.h"
#include "reference.h"
#include "suite.h"
#include "text_rows.h"
#include "true_number.h"

enum { NUMBERS = 12, UNTOUCHED = 77 };

/* Of a case's ray and object and some numbers x; y is what they give, or is left as it was. */
#define ANSWER(name)                                                                               \
    static void name(const sure_ray *ray CK_ATTRIBUTE_UNUSED,                                      \
                     const sure_object *object CK_ATTRIBUTE_UNUSED,                                \
                     const double *x CK_ATTRIBUTE_UNUSED, double *y)

/* The case that a line of the case format holds. */
static sure_case case_of(const char *line)
{
    sure_case question;
    ck_assert_msg(case_read(line, &question), "not a case: %s", line);
    return question;
}

ANSWER(signs)
{
    reference_decisions d = {.leading = UNTOUCHED};
    y[0] = reference_decide(ray, object, &d);
    const int is[] = {d.leading,      d.discriminant, d.axis,        d.roots,    d.base_side[0],
                      d.base_side[1], d.top_side[0],  d.top_side[1], d.base_cap, d.top_cap};
    for (int i = 0; i < 10; i++)
        y[1 + i] = is[i];
}

ANSWER(compare)
{
    int sign = UNTOUCHED;
    y[0] = reference_compare_hit(ray, object, x[0], &sign);
    y[1] = sign;
}

ANSWER(within)
{
    int is = UNTOUCHED;
    y[0] = reference_hit_within(ray, object, x[0], x[1], &is);
    y[1] = is;
}

ANSWER(normal_within)
{
    int is = UNTOUCHED;
    y[0] = reference_normal_within(ray, object, vector_of(x), x[3], &is);
    y[1] = is;
}

ANSWER(ulps)
{
    y[0] = (double)reference_ulps(x[0], x[1]);
}

/* Seen from the origin, too. */
ANSWER(where)
{
    const sure_ray from_origin = {{0, 0, 0}, vector_of(x), 0, 1};
    y[0] = reference_where(object, vector_of(x));
    if (x[0] != 0 || x[1] != 0 || x[2] != 0)
        ck_assert_int_eq(reference_where_at(&from_origin, object, 1), (int)y[0]);
}

ANSWER(where_at)
{
    y[0] = reference_where_at(ray, object, x[0]);
}

ANSWER(wall)
{
    y[0] = reference_wall_hit(ray, object, &y[1]);
}

ANSWER(wall_normal)
{
    put_vector(y, reference_wall_normal(object, vector_of(x)));
}

ANSWER(height)
{
    y[0] = reference_height(object, vector_of(x));
}

ANSWER(end_points)
{
    sure_vec3 low, high;
    reference_end_points(vector_of(x), vector_of(x + 3), x[6], &low, &high);
    put_vector(y, low);
    put_vector(y + 3, high);
}

ANSWER(quadratic)
{
    y[0] = reference_quadratic(x[0], x[1], x[2], y + 1);
}

ANSWER(project)
{
    put_vector(y, reference_project(vector_of(x), vector_of(x + 3)));
}

ANSWER(reflect)
{
    put_vector(y, reference_reflect(vector_of(x), vector_of(x + 3)));
}

ANSWER(rotate)
{
    put_vector(y, reference_rotate((int)x[0], x[1], vector_of(x + 2)));
}

ANSWER(extent)
{
    y[0] = reference_viewport_extent(x[0], x[1]);
}

#define NAMED(name)                                                                                \
    {                                                                                              \
#name, name                                                                                \
    }
static const struct {
    const char *name;
    void (*answer)(const sure_ray *, const sure_object *, const double *x, double *y);
} answers[] = {NAMED(signs),       NAMED(compare), NAMED(within),     NAMED(normal_within),
               NAMED(ulps),        NAMED(where),   NAMED(where_at),   NAMED(wall),
               NAMED(wall_normal), NAMED(height),  NAMED(end_points), NAMED(quadratic),
               NAMED(project),     NAMED(reflect), NAMED(rotate),     NAMED(extent)};
enum { ANSWERS = sizeof answers / sizeof *answers };

/* A number, a status, or - for no sign. */
static double number(const char *word)
{
    char *end;
    double x = strtod(word, &end);
    if (*end == '\0')
        return x;
    ck_assert_msg(strcmp(word, "-") == 0 || strcmp(word, "hit") == 0 || strcmp(word, "miss") == 0 ||
                      strcmp(word, "invalid") == 0,
                  "no number: %s", word);
    return *word == '-'   ? REFERENCE_NONE
           : *word == 'h' ? SURE_HIT
           : *word == 'm' ? SURE_MISS
                          : SURE_INVALID;
}

static int numbers(char *text, double *x)
{
    int count = 0;
    for (char *word = strtok(text, " "); word && count < NUMBERS; word = strtok(NULL, " "))
        x[count++] = number(word);
    return count;
}

static void check_row(char *line, int asked[ANSWERS])
{
    char *given = row_cut(line, "& "), *result = row_cut(given, "-> "),
         *why = row_cut(result, " ; ");
    char *question = row_cut(line, " ");
    double x[NUMBERS] = {0}, y[NUMBERS], expected[NUMBERS];
    sure_case c = {.ray.t_max = 0};
    if (*question != '\0') {
        question[strlen(question) - 1] = '\0';
        c = case_of(question);
    }
    (void)numbers(given, x);
    int known = 0, count = numbers(result, expected);
    while (known < ANSWERS && strcmp(answers[known].name, line) != 0)
        known++;
    ck_assert_msg(known < ANSWERS && count > 0, "%s: %s", line, why);
    for (int i = 0; i < NUMBERS; i++)
        y[i] = UNTOUCHED;
    answers[known].answer(&c.ray, &c.object, x, y);
    asked[known]++;
    for (int i = 0; i < count; i++) /* and +0 for a zero */
        ck_assert_msg(y[i] == expected[i] && !(y[i] == 0 && signbit(y[i])),
                      "%s %s: number %d is %a, not %a: %s", line, question, i, y[i], expected[i],
                      why);
}

TEST(test_rows)
{
    FILE *file = rows_open("oracles/reference.rows");
    int asked[ANSWERS] = {0};
    char line[1024];
    while (rows_line(file, line, sizeof line))
        check_row(line, asked);
    fclose(file);
    for (int i = 0; i < ANSWERS; i++)
        ck_assert_msg(asked[i] > 0, "%s is not asked", answers[i].name);
}

/* On a miss or an invalid input nothing is written; a NULL output is none. */
TEST(test_outputs)
{
    static const char *lines[] = {"sphere 0 9 0 1 0 0 0 inf 0 0 0 1",
                                  "sphere 0 9 0 0 0 0 0 inf 0 0 0 1"};
    for (size_t i = 0; i < 2; i++) {
        sure_case q = case_of(lines[i]);
        double t = 77;
        sure_part part = SURE_PART_TOP;
        sure_vec3 n = {77, 78, 79};
        int sign = 77;
        sure_status status = reference_hit(&q.ray, &q.object, &t, &part, &n);
        ck_assert_int_eq(status, i == 0 ? SURE_MISS : SURE_INVALID);
        ck_assert_int_eq(reference_compare_hit(&q.ray, &q.object, 0, &sign), status);
        ck_assert_int_eq(reference_hit_within(&q.ray, &q.object, 0, INFINITY, &sign), status);
        ck_assert_int_eq(reference_normal_within(&q.ray, &q.object, n, INFINITY, &sign), status);
        ck_assert(t == 77 && part == SURE_PART_TOP && n.x == 77 && n.y == 78 && n.z == 79);
        ck_assert_int_eq(sign, 77);
    }
    sure_case q = case_of("sphere -5 0 0 1 0 0 0 inf 0 0 0 1");
    sure_case second = case_of("sphere 0 0 0 1 0 0 0 1 0 5 0 1");
    int order = 77;
    ck_assert_int_eq(reference_hit_order(&q.ray, &q.object, &second.object, &order), SURE_MISS);
    second.object.as.sphere.radius = NAN;
    ck_assert_int_eq(reference_hit_order(&q.ray, &q.object, &second.object, &order), SURE_INVALID);
    ck_assert_int_eq(order, 77);
    ck_assert_int_eq(reference_hit(&q.ray, &q.object, NULL, NULL, NULL), SURE_HIT);
    ck_assert_int_eq(reference_interval(&q.ray, &q.object, NULL), SURE_HIT);
}

/* y cos(angle) - z sin(angle) in one rounding from far more digits than the cases below can
 * need. */
static double turned(double angle, double y, double z)
{
    TRUE_NUMBERS(6000, w, c, s);
    mpfr_set_d(w, angle, MPFR_RNDN);
    mpfr_sin_cos(s, c, w, MPFR_RNDN);
    mpfr_mul_d(c, c, y, MPFR_RNDN);
    mpfr_mul_d(s, s, z, MPFR_RNDN);
    mpfr_sub(c, c, s, MPFR_RNDN);
    double x = mpfr_get_d(c, MPFR_RNDN);
    return x == 0 ? 0 : x;
}

TEST(test_rotation)
{
    /* The double next to cot(1): cos(1) - cot(1) sin(1) loses 53 bits. */
    double cot = 0x1.48c05d04e1cfep-1;
    ck_vector_same(reference_rotate(0, 1, (sure_vec3){0, 1, cot}),
                   (sure_vec3){0, turned(1, 1, cot), turned(1, cot, -1)});
    for (uint64_t i = 0; i < 2000; i++) {
        double angle = suite_double(1, i, 1 << (i % 9));
        double y = suite_double(2, i, 1 << (i % 10)), z = suite_double(3, i, 1 << (i % 10));
        sure_vec3 x = reference_rotate(0, angle, (sure_vec3){9, y, z});
        ck_vector_same(x, (sure_vec3){9, turned(angle, y, z), turned(angle, z, -y)});
        sure_vec3 about_y = reference_rotate(1, angle, (sure_vec3){z, 9, y});
        ck_vector_same(about_y, (sure_vec3){x.z, 9, x.y});
        sure_vec3 about_z = reference_rotate(2, angle, (sure_vec3){y, z, 9});
        ck_vector_same(about_z, (sure_vec3){x.y, x.z, 9});
    }
}

/* tan by way of the angle, not of the turn; MPFR's own pi. */
static double true_extent(double focal_length, double fov)
{
    TRUE_NUMBERS(6000, x);
    mpfr_const_pi(x, MPFR_RNDN);
    mpfr_mul_d(x, x, fov, MPFR_RNDN);
    mpfr_div_ui(x, x, 360, MPFR_RNDN);
    mpfr_tan(x, x, MPFR_RNDN);
    mpfr_mul_d(x, x, focal_length, MPFR_RNDN);
    mpfr_mul_ui(x, x, 2, MPFR_RNDN);
    return mpfr_get_d(x, MPFR_RNDN);
}

TEST(test_viewport)
{
    for (uint64_t i = 0; i < 2000; i++) {
        double fov = fabs(suite_double(4, i, i % 2 ? 7 : 300)), f = fabs(suite_double(5, i, 400));
        if (fov > 0 && fov < 180 && f > 0)
            ck_double_same(reference_viewport_extent(f, fov), true_extent(f, fov));
    }
    ck_double_same(reference_viewport_extent(3, nextafter(180, 0)),
                   true_extent(3, nextafter(180, 0)));
}

SUITE("reference")
