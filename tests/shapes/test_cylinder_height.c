#include "end_points_suite.h"

#define MAKE(tier)                                                                                 \
    static sure_field tier(sure_vec3 centre, sure_vec3 axis, double radius, double height,         \
                           sure_vec3 ends[2])                                                      \
    {                                                                                              \
        sure_cylinder made;                                                                        \
        sure_field bad = sure_cylinder_from_axis_##tier(centre, axis, radius, height, &made);      \
        if (bad == SURE_FIELD_NONE) {                                                              \
            ends[0] = made.base;                                                                   \
            ends[1] = made.top;                                                                    \
            ck_double_same(made.radius, radius);                                                   \
        }                                                                                          \
        return bad;                                                                                \
    }

MAKE(float32)
MAKE(textbook)

static const end_points_stem stems[PART_TIERS] = {
    {float32, SURE_FIELD_TOP},
    {textbook, SURE_FIELD_TOP},
};

/* N.(P - top) <= 0 <= N.(P - base): the ends belong to it, the distance from the axis does not
 * matter. */
START_TEST(test_between)
{
    const sure_cylinder oblique = {{1, 1, 1}, {2, 2, 1}, 1};
    static int (*const between[PART_TIERS])(sure_vec3, const sure_cylinder *) = {
        sure_cylinder_height_float32, sure_cylinder_height_textbook};
    for (int x = -3; x <= 5; x++) {
        for (int y = -3; y <= 5; y++) {
            int height = (x - 1) + (y - 1); /* of 2 */
            ck_assert_int_eq(between[_i]((sure_vec3){x, y, 9}, &oblique),
                             height >= 0 && height <= 2);
        }
    }
    for (int k = 0; k <= 2; k++) /* on the axis itself, half way too */
        ck_assert_int_eq(between[_i]((sure_vec3){1 + k / 2.0, 1 + k / 2.0, 1}, &oblique), 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cylinder_height");
    end_points_add(suite, stems);
    suite_add_part_tiers(suite, "between", test_between);
    return suite_run(suite);
}
