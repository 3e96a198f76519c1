#include "end_points_suite.h"

#define MAKE(tier)                                                                                 \
    static sure_field tier(sure_vec3 centre, sure_vec3 axis, double radius, double height,         \
                           sure_vec3 ends[2])                                                      \
    {                                                                                              \
        sure_cone made;                                                                            \
        sure_field bad = sure_cone_from_axis_##tier(centre, axis, radius, height, &made);          \
        if (bad == SURE_FIELD_NONE) {                                                              \
            ends[0] = made.base;                                                                   \
            ends[1] = made.apex;                                                                   \
            ck_double_same(made.radius, radius);                                                   \
        }                                                                                          \
        return bad;                                                                                \
    }

MAKE(float32)
MAKE(textbook)

static const end_points_stem stems[PART_TIERS] = {
    {float32, SURE_FIELD_APEX},
    {textbook, SURE_FIELD_APEX},
};

/* Points of the double cone around (0, y, 0) with walls at 45 degrees: those within the slant
 * height of the apex at y = 4, below it. */
START_TEST(test_between)
{
    const sure_cone cone = {{0, 0, 0}, {0, 4, 0}, 4};
    static int (*const between[PART_TIERS])(sure_vec3, const sure_cone *) = {
        sure_cone_height_float32, sure_cone_height_textbook};
    for (int y = -4; y <= 12; y++) {
        ck_assert_int_eq(between[_i]((sure_vec3){4 - y, y, 0}, &cone), y >= 0 && y <= 4);
        ck_assert_int_eq(between[_i]((sure_vec3){0, y, y - 4}, &cone), y >= 0 && y <= 4);
    }
    /* wherever the viewer stands */
    const sure_cone ahead = {{0, 0, -10}, {0, 0, -6}, 4}, behind = {{0, 0, 6}, {0, 0, 10}, 4};
    ck_assert_int_eq(between[_i]((sure_vec3){2, 0, -8}, &ahead), 1);
    ck_assert_int_eq(between[_i]((sure_vec3){2, 0, -4}, &ahead), 0);
    ck_assert_int_eq(between[_i]((sure_vec3){0, 2, 8}, &behind), 1);
    ck_assert_int_eq(between[_i]((sure_vec3){0, 2, 12}, &behind), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cone_height");
    end_points_add(suite, stems);
    suite_add_part_tiers(suite, "between", test_between);
    return suite_run(suite);
}
