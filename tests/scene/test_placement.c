#define _POSIX_C_SOURCE 200809L

#include "placement.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char header[] = "A 0.5 255,0,0\nC 1,2,3 0,0,-1 90\nL 1,5,3 0.5 0,255,0\n";

/* The scene of `header` (or another camera) with some lines, placed; the caller frees it. */
static bool placed(const char *head, const char *lines, sure_scene *scene, char **messages)
{
    char text[1024];
    size_t size;
    rt_options options = rt_default_options();
    rt_options_set set = {0};
    rt_scene file;
    FILE *out = open_memstream(messages, &size);
    snprintf(text, sizeof text, "%s%s", head, lines);
    bool read = rt_read_text(text, strlen(text), "t.rt", &options, set, out, &file);
    ck_assert_msg(read, "the test's own scene cannot be read: %s", text);
    bool done = placement(&file, out, scene);
    rt_scene_free(&file);
    fclose(out);
    return done;
}

static sure_scene place(const char *head, const char *lines)
{
    sure_scene scene;
    char *messages;
    ck_assert(placed(head, lines, &scene, &messages));
    ck_assert_str_eq(messages, "");
    free(messages);
    return scene;
}

START_TEST(test_moved)
{
    sure_scene s = place(header, "sp 1,2,-7 4 51,102,255\npl 0,-1,0 0,2,0 0,0,0\n");
    ck_assert_uint_eq(s.object_count, 2);
    ck_vector_same(s.objects[0].as.sphere.centre, (sure_vec3){0, 0, -10});
    ck_double_same(s.objects[0].as.sphere.radius, 2);
    ck_vector_same(s.materials[0].color, (sure_vec3){0.2, 0.4, 1});
    ck_vector_same(s.objects[1].as.plane.point, (sure_vec3){-1, -3, -3});
    ck_vector_same(s.objects[1].as.plane.normal, (sure_vec3){0, 2, 0});
    ck_vector_same(s.lights[0].position, (sure_vec3){0, 3, 0});
    ck_vector_same(s.lights[0].color, (sure_vec3){0, 1, 0});
    ck_double_same(s.lights[0].brightness, 0.5);
    ck_vector_same(s.ambient, (sure_vec3){0.5, 0, 0});
    ck_vector_same(s.camera.position, (sure_vec3){0, 0, 0});
    placement_free(&s);
}
END_TEST

/* 90 degrees across see a viewport of 2 at distance 1; 1280x720 by default. */
START_TEST(test_window)
{
    sure_scene s = place(header, "");
    ck_assert_int_eq(s.width, 1280);
    ck_assert_int_eq(s.height, 720);
    ck_double_same(s.camera.viewport_width, 2);
    ck_double_same(s.camera.viewport_height, 2 / (1280 / 720.0));
    placement_free(&s);
    s = place(header, "#! fov vertical\nR 400 100\n");
    ck_double_same(s.camera.viewport_width, 8);
    ck_double_same(s.camera.viewport_height, 2);
    placement_free(&s);
}
END_TEST

/* Looking along +x: what is ahead comes to lie along -z, what is on the right (+z) along +x. */
START_TEST(test_turned)
{
    static const char east[] = "A 0 0,0,0\nC 0,0,0 3,0,0 90\nL 0,9,0 1\n";
    sure_scene s = place(east, "sp 5,0,0 2 0,0,0\nsp 5,1,2 2 0,0,0\ncy 5,0,0 0,0,1 2 4 0,0,0\n");
    ck_vector_same(s.objects[0].as.sphere.centre, (sure_vec3){0, 0, -5});
    ck_vector_same(s.objects[1].as.sphere.centre, (sure_vec3){2, 1, -5});
    ck_vector_same(s.objects[2].as.cylinder.base, (sure_vec3){-2, 0, -5});
    ck_vector_same(s.objects[2].as.cylinder.top, (sure_vec3){2, 0, -5});
    placement_free(&s);
    s = place(east, "#! handedness left\nsp 5,1,2 2 0,0,0\npl 0,0,-4 1,0,1 0,0,0\n");
    ck_vector_same(s.objects[0].as.sphere.centre, (sure_vec3){-2, 1, -5});
    ck_vector_same(s.objects[1].as.plane.point, (sure_vec3){4, 0, 0});
    ck_vector_same(s.objects[1].as.plane.normal, (sure_vec3){-1, 0, -1});
    placement_free(&s);
}
END_TEST

START_TEST(test_positions)
{
    static const char at_origin[] = "A 0 0,0,0\nC 0,0,0 0,0,-1 90\nL 0,9,0 1\n";
    sure_scene s = place(at_origin, "cy 0,0,0 0,2,0 2 4 0,0,0\nco 0,0,0 0,2,0 2 4 0,0,0\n");
    ck_vector_same(s.objects[0].as.cylinder.base, (sure_vec3){0, -2, 0});
    ck_vector_same(s.objects[0].as.cylinder.top, (sure_vec3){0, 2, 0});
    ck_double_same(s.objects[0].as.cylinder.radius, 1);
    ck_vector_same(s.objects[1].as.cone.base, (sure_vec3){0, -2, 0});
    ck_vector_same(s.objects[1].as.cone.apex, (sure_vec3){0, 2, 0});
    placement_free(&s);
    s = place(at_origin, "#! cylinder-position base\n#! cone-position base\n"
                         "cy 0,0,0 0,2,0 2 4 0,0,0\nco 0,0,0 0,2,0 2 4 0,0,0\n");
    ck_vector_same(s.objects[0].as.cylinder.base, (sure_vec3){0, 0, 0});
    ck_vector_same(s.objects[0].as.cylinder.top, (sure_vec3){0, 4, 0});
    ck_vector_same(s.objects[1].as.cone.base, (sure_vec3){0, 0, 0});
    ck_vector_same(s.objects[1].as.cone.apex, (sure_vec3){0, 4, 0});
    placement_free(&s);
    s = place(at_origin, "#! cone-position apex\nco 0,0,0 0,2,0 2 4 0,0,0\n");
    ck_vector_same(s.objects[0].as.cone.apex, (sure_vec3){0, 0, 0});
    ck_vector_same(s.objects[0].as.cone.base, (sure_vec3){0, 4, 0});
    placement_free(&s);
}
END_TEST

/* What only the stored doubles show is refused at its line and column, all of it. */
START_TEST(test_collapsed)
{
    static const char far_off[] = "A 0 0,0,0\nC -1.7e308,0,0 0,0,-1 90\nL 0,9,0 1\n";
    sure_scene scene;
    char *messages;
    ck_assert(!placed(header, "cy 0,1e17,0 0,1,0 2 1 0,0,0\n  co 0,1e17,0 0,1,0 2 1 0,0,0\n",
                      &scene, &messages));
    ck_assert_ptr_nonnull(strstr(messages, "t.rt:4:1: error: cylinder: end points coincide"));
    ck_assert_ptr_nonnull(strstr(messages, "t.rt:5:3: error: cone: end points coincide"));
    free(messages);
    ck_assert(!placed(header, "#! cylinder-position base\ncy 0,1e17,0 0,1,0 2 1 0,0,0\n", &scene,
                      &messages));
    ck_assert_ptr_nonnull(strstr(messages, "t.rt:5:1: error: cylinder: end points coincide"));
    free(messages);
    ck_assert(!placed(far_off, "sp 1.7e308,0,0 1 0,0,0\n", &scene, &messages));
    ck_assert_ptr_nonnull(strstr(messages, "t.rt:4:1: error: sphere: lies out of range"));
    free(messages);
    ck_assert(!placed(far_off, "L 0,0,0 1\n L 1.7e308,0,0 1\n", &scene, &messages));
    ck_assert_str_eq(messages, "t.rt:5:2: error: light: lies out of range of the camera; expected "
                               "coordinates whose differences are finite\n");
    free(messages);
    ck_assert(!placed(header, "#! cylinder-position base\ncy 0,0,0 0,1,0 1 1e308 1,2,3\n", &scene,
                      &messages));
    ck_assert_ptr_nonnull(strstr(messages, "t.rt:5:1: error: cylinder: lies out of range"));
    free(messages);
}
END_TEST

/* In the order of the text, whatever is wrong. */
START_TEST(test_errors_in_order)
{
    static const char far_off[] = "A 0 0,0,0\nC -1.7e308,0,0 0,0,-1 90\n";
    static const char *const places[] = {"t.rt:3:1: error: light", "t.rt:4:1: error: sphere",
                                         "t.rt:5:1: error: light", "t.rt:6:1: error: sphere"};
    sure_scene scene;
    char *messages;
    ck_assert(!placed(far_off,
                      "L 1.7e308,0,0 1\nsp 1.7e308,0,0 1 0,0,0\nL 1.7e308,0,0 1\n"
                      "sp 1.7e308,0,0 1 0,0,0\n",
                      &scene, &messages));
    const char *at = messages;
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(strncmp(at, places[i], strlen(places[i])), 0);
        at = strchr(at, '\n') + 1;
    }
    ck_assert_str_eq(at, "");
    free(messages);
}
END_TEST

START_TEST(test_many_errors)
{
    static const struct {
        int errors;
        const char *summary; /* NULL: none */
    } rows[] = {
        {RT_ERRORS_SHOWN, NULL},
        {RT_ERRORS_SHOWN + 1, "\nt.rt: 1 more error\n"},
        {RT_ERRORS_SHOWN + 5, "\nt.rt: 5 more errors\n"},
    };
    for (size_t row = 0; row < sizeof rows / sizeof *rows; row++) {
        char lines[900] = "", *messages;
        sure_scene scene;
        for (int i = 0; i < rows[row].errors; i++)
            strcat(lines, "cy 0,1e17,0 0,1,0 2 1 0,0,0\n");
        ck_assert(!placed(header, lines, &scene, &messages));
        ck_assert_ptr_nonnull(strstr(messages, "t.rt:23:1: error"));
        ck_assert_ptr_null(strstr(messages, "t.rt:24:1: error"));
        ck_assert(rows[row].summary ? strstr(messages, rows[row].summary) != NULL
                                    : strstr(messages, "more error") == NULL);
        free(messages);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("placement");
    TCase *tests = tcase_create("placement");
    tcase_add_test(tests, test_moved);
    tcase_add_test(tests, test_window);
    tcase_add_test(tests, test_turned);
    tcase_add_test(tests, test_positions);
    tcase_add_test(tests, test_collapsed);
    tcase_add_test(tests, test_errors_in_order);
    tcase_add_test(tests, test_many_errors);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
