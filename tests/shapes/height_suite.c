/* The stem SUBJECT, cone_height or cylinder_height: the end points C -+ h/2 N/|N|, and what lies
 * between them. */
#include "suite.h"
#include "true_hit.h"

#include <float.h>
#include <math.h>
#include <string.h>

typedef sure_field make_object(sure_vec3 centre, sure_vec3 axis, double radius, double height,
                               sure_object *made);
typedef int is_between(sure_vec3 p, const sure_object *object);

#define STEM(shape, tier)                                                                          \
    static sure_field shape##_##tier(sure_vec3 centre, sure_vec3 axis, double radius,              \
                                     double height, sure_object *made)                             \
    {                                                                                              \
        return sure_##shape##_from_axis_##tier(centre, axis, radius, height, &made->as.shape);     \
    }                                                                                              \
    static int shape##_between_##tier(sure_vec3 p, const sure_object *object)                      \
    {                                                                                              \
        return sure_##shape##_height_##tier(p, &object->as.shape);                                 \
    }

STEM(cone, float32)
STEM(cone, textbook)
STEM(cylinder, float32)
STEM(cylinder, textbook)

/* Points of the double cone around (0, y, 0) with walls at 45 degrees: those within the slant
 * height of the apex at y = 4, below it. */
static void check_cone(is_between *between)
{
    const sure_object cone = {SURE_SHAPE_CONE, {.cone = {{0, 0, 0}, {0, 4, 0}, 4}}};
    for (int y = -4; y <= 12; y++) {
        ck_assert_int_eq(between((sure_vec3){4 - y, y, 0}, &cone), y >= 0 && y <= 4);
        ck_assert_int_eq(between((sure_vec3){0, y, y - 4}, &cone), y >= 0 && y <= 4);
    }
    /* wherever the viewer stands */
    const sure_object ahead = {SURE_SHAPE_CONE, {.cone = {{0, 0, -10}, {0, 0, -6}, 4}}};
    const sure_object behind = {SURE_SHAPE_CONE, {.cone = {{0, 0, 6}, {0, 0, 10}, 4}}};
    ck_assert_int_eq(between((sure_vec3){2, 0, -8}, &ahead), 1);
    ck_assert_int_eq(between((sure_vec3){2, 0, -4}, &ahead), 0);
    ck_assert_int_eq(between((sure_vec3){0, 2, 8}, &behind), 1);
    ck_assert_int_eq(between((sure_vec3){0, 2, 12}, &behind), 0);
}

/* N.(P - top) <= 0 <= N.(P - base): the ends belong to it, the distance from the axis does not
 * matter. */
static void check_cylinder(is_between *between)
{
    const sure_object oblique = {SURE_SHAPE_CYLINDER, {.cylinder = {{1, 1, 1}, {2, 2, 1}, 1}}};
    for (int x = -3; x <= 5; x++) {
        for (int y = -3; y <= 5; y++) {
            int height = (x - 1) + (y - 1); /* of 2 */
            ck_assert_int_eq(between((sure_vec3){x, y, 9}, &oblique), height >= 0 && height <= 2);
        }
    }
    for (int k = 0; k <= 2; k++) /* on the axis itself, half way too */
        ck_assert_int_eq(between((sure_vec3){1 + k / 2.0, 1 + k / 2.0, 1}, &oblique), 1);
}

typedef struct {
    make_object *make[PART_TIERS];
    is_between *between[PART_TIERS];
    void (*check)(is_between *);
    sure_field upper; /* the field that names the other end */
} stem;

#define TIERS(name)                                                                                \
    {                                                                                              \
        name##_float32, name##_textbook                                                            \
    }

static const stem stems[SURE_SHAPES] = {
    [SURE_SHAPE_CYLINDER] = {TIERS(cylinder), TIERS(cylinder_between), check_cylinder,
                             SURE_FIELD_TOP},
    [SURE_SHAPE_CONE] = {TIERS(cone), TIERS(cone_between), check_cone, SURE_FIELD_APEX},
};
static const stem *const subject = &stems[SUBJECT];

LOOP_TEST(test_between, PART_TIERS)
{
    subject->check(subject->between[_i]);
}

/* Both shapes have two ends, the base first, and a radius. */
static sure_field make(int tier, sure_vec3 centre, sure_vec3 axis, double radius, double height,
                       sure_vec3 ends[2])
{
    sure_object made;
    sure_field bad = subject->make[tier](centre, axis, radius, height, &made);
    if (bad == SURE_FIELD_NONE) {
        ends[0] = made.as.cylinder.base;
        ends[1] = made.as.cylinder.top;
        ck_double_same(made.as.cylinder.radius, radius);
    }
    return bad;
}

static void expect_ends(int tier, sure_vec3 centre, sure_vec3 axis, double height, sure_vec3 low,
                        sure_vec3 high)
{
    sure_vec3 ends[2];
    ck_assert_int_eq(make(tier, centre, axis, 1, height, ends), SURE_FIELD_NONE);
    ck_vector_same(ends[0], low);
    ck_vector_same(ends[1], high);
}

LOOP_TEST(test_known, PART_TIERS)
{
    expect_ends(_i, (sure_vec3){1, 2, 3}, (sure_vec3){0, 5, 0}, 6, (sure_vec3){1, -1, 3},
                (sure_vec3){1, 5, 3});
    expect_ends(_i, (sure_vec3){0, 0, 0}, (sure_vec3){3, 0, -4}, 20, (sure_vec3){-6, 0, 8},
                (sure_vec3){6, 0, -8});
}

static sure_vec3 vector(uint64_t stream, uint64_t index, int spread)
{
    return (sure_vec3){suite_single(stream, index, spread), suite_single(stream + 1, index, spread),
                       suite_single(stream + 2, index, spread)};
}

LOOP_TEST(test_laws, PART_TIERS)
{
    int most = _i == SURE_TIER_FLOAT32 ? 30 : 900;
    for (uint64_t i = 0; i < 2000; i++) {
        sure_vec3 c = vector(1, i, 4), n = vector(4, i, 4), plain[2];
        int k = suite_integer(7, i, most);
        ck_assert_int_eq(make(_i, c, n, 1, 2, plain), SURE_FIELD_NONE);
        expect_ends(_i, c, (sure_vec3){-n.x, -n.y, -n.z}, 2, plain[1], plain[0]);
        expect_ends(_i, c, (sure_vec3){ldexp(n.x, k), ldexp(n.y, k), ldexp(n.z, k)}, 2, plain[0],
                    plain[1]);
    }
}

/* |value - (c + share n / |n|)| in ulps of the larger of |c| and h/2. */
static double error_ulps(double value, double c, double share, double n, sure_vec3 axis,
                         double half_height)
{
    int exponent;
    mpfr_t x, length;
    true_vector along;
    mpfr_inits2(300, x, length, (mpfr_ptr)0);
    true_vector_init(along, 300);
    true_vector_between(along, (sure_vec3){0, 0, 0}, axis);
    true_dot(length, along, along);
    mpfr_sqrt(length, length, MPFR_RNDN);
    mpfr_set_d(x, n, MPFR_RNDN);
    mpfr_mul_d(x, x, share, MPFR_RNDN);
    mpfr_div(x, x, length, MPFR_RNDN);
    mpfr_add_d(x, x, c, MPFR_RNDN);
    mpfr_sub_d(x, x, value, MPFR_RNDN);
    (void)frexp(fmax(fabs(c), half_height), &exponent);
    double ulps = fabs(ldexp(mpfr_get_d(x, MPFR_RNDA), 53 - exponent));
    mpfr_clears(x, length, (mpfr_ptr)0);
    true_vector_clear(along);
    return ulps;
}

TEST(test_bound)
{
    double worst = 0;
    for (uint64_t i = 0; i < 20000; i++) {
        sure_vec3 c = {suite_double(1, i, 6), suite_double(2, i, 6), suite_double(3, i, 6)};
        sure_vec3 n = {suite_double(4, i, 6), suite_double(5, i, 6), suite_double(6, i, 6)};
        double height = fabs(suite_double(7, i, 6));
        sure_vec3 ends[2];
        ck_assert_int_eq(make(SURE_TIER_TEXTBOOK, c, n, 1, height, ends), SURE_FIELD_NONE);
        for (int e = 0; e < 2; e++) {
            double share = (e == 0 ? -height : height) / 2;
            worst = fmax(worst, error_ulps(ends[e].x, c.x, share, n.x, n, height / 2));
            worst = fmax(worst, error_ulps(ends[e].y, c.y, share, n.y, n, height / 2));
            worst = fmax(worst, error_ulps(ends[e].z, c.z, share, n.z, n, height / 2));
        }
    }
    ck_assert_msg(worst <= SURE_END_POINT_ULPS, "%g ulps", worst);
    ck_assert_msg(worst > 0.5, "only %g ulps: is anything measured?", worst);
}

static void refused(int tier, sure_vec3 centre, sure_vec3 axis, double radius, double height,
                    sure_field expected)
{
    sure_vec3 ends[2] = {{7, 7, 7}, {7, 7, 7}}, before[2] = {{7, 7, 7}, {7, 7, 7}};
    ck_assert_int_eq(make(tier, centre, axis, radius, height, ends), expected);
    ck_assert(memcmp(ends, before, sizeof ends) == 0);
}

LOOP_TEST(test_invalid, PART_TIERS)
{
    const sure_vec3 zero = {0, 0, 0}, y = {0, 1, 0};
    refused(_i, (sure_vec3){NAN, 0, 0}, y, 1, 1, SURE_FIELD_CENTRE);
    refused(_i, zero, zero, 1, 1, SURE_FIELD_NORMAL);
    refused(_i, zero, (sure_vec3){0, INFINITY, 0}, 1, 1, SURE_FIELD_NORMAL);
    refused(_i, zero, y, 1, 0, subject->upper);
    refused(_i, zero, y, 1, -1, subject->upper);
    refused(_i, zero, y, 1, NAN, subject->upper);
    refused(_i, zero, y, 1, INFINITY, subject->upper);
    refused(_i, (sure_vec3){0, 1e17, 0}, y, 1, 1, subject->upper);
    refused(_i, (sure_vec3){0, DBL_MAX, 0}, y, 1, DBL_MAX, subject->upper);
    refused(_i, zero, y, -1, 1, SURE_FIELD_RADIUS);
    refused(_i, zero, y, NAN, 1, SURE_FIELD_RADIUS);
}

SUITE("height")
