#define _POSIX_C_SOURCE 200809L

#include "placement.h"
#include "suite.h"
#include "text_rows.h"

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

static void put(FILE *out, const char *what, const double *numbers, int count)
{
    fprintf(out, "%s", what);
    for (int i = 0; i < count; i++)
        fprintf(out, " %.17g", numbers[i] + 0.0); /* 0 has no sign here */
    fputc('\n', out);
}

/* What the camera sees, or what is wrong. */
static char *described(const char *head, const char *lines)
{
    char *text, *messages;
    size_t size;
    sure_scene s;
    if (!placed(head, lines, &s, &messages))
        return messages;
    ck_assert_str_eq(messages, "");
    free(messages);
    FILE *out = open_memstream(&text, &size);
    for (size_t i = 0; i < s.object_count; i++) {
        const sure_shape_info *info = sure_shape_info_of(s.objects[i].shape);
        put(out, info->name, (const double *)&s.objects[i].as, info->numbers);
        put(out, "  colour", &s.materials[i].color.x, 3);
    }
    for (size_t i = 0; i < s.light_count; i++) {
        put(out, "light", &s.lights[i].position.x, 3);
        put(out, "  brightness", &s.lights[i].brightness, 1);
        put(out, "  colour", &s.lights[i].color.x, 3);
    }
    const double window[] = {s.width, s.height, s.camera.viewport_width, s.camera.viewport_height};
    put(out, "ambient", &s.ambient.x, 3);
    put(out, "window", window, 4);
    put(out, "camera", &s.camera.position.x, 3);
    fclose(out);
    placement_free(&s);
    return text;
}

START_TEST(test_placed)
{
    FILE *file = rows_open("scene/placed.txt");
    char row[ROW_BYTES], expected[ROW_LINES_BYTES], known[ROW_LINES_BYTES] = "";
    int count = 0;
    for (; rows_next(file, row, expected); count++) {
        char *seen = described(*row == '|' ? "" : header, *row == '|' ? row + 1 : row);
        rows_drop_known(seen, known);
        ck_assert_msg(strcmp(seen, expected) == 0, "%sis not\n%sfor\n%s", seen, expected, row);
        if (count == 0)
            strcpy(known, expected);
        free(seen);
    }
    fclose(file);
    ck_assert_int_gt(count, 10);
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
    tcase_add_test(tests, test_placed);
    tcase_add_test(tests, test_many_errors);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
