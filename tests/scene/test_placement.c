/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include "suite.h"
#include "text_rows.h"
#include "written_scene.h"

static const char header[] = "A 0.5 255,0,0\nC 1,2,3 0,0,-1 90\nL 1,5,3 0.5 0,255,0\n";

/* The scene of `header` (or another camera) with some lines. */
static outcome placed(const char *head, const char *lines)
{
    char text[1024];
    rt_options options = rt_default_options();
    snprintf(text, sizeof text, "%s%s", head, lines);
    FREED_BY(outcome_free) outcome read = outcome_of_text(text, strlen(text), "t.rt", &options, 0);
    ck_assert_msg(read.good, "the test's own scene cannot be read: %s", text);
    return outcome_of_placement(&read.scene);
}

static void put(FILE *out, const char *what, const double *numbers, int count)
{
    fprintf(out, "%s", what);
    for (int i = 0; i < count; i++)
        fprintf(out, " %.17g", numbers[i] + 0.0); /* 0 has no sign here */
    fputc('\n', out);
}

/* The scene, or what is wrong. */
static char *described(const char *head, const char *lines)
{
    char *text;
    size_t size;
    outcome o = placed(head, lines);
    const sure_scene s = o.placed;
    if (!o.good)
        return o.messages;
    ck_assert_str_eq(o.messages, "");
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
    put(out, "right, up, back", &s.turn.row[0].x, 9);
    fclose(out);
    outcome_free(&o);
    return text;
}

TEST(test_placed)
{
    FILE *file = rows_open("scene/placed.txt");
    text_row row;
    char known[ROW_LINES_BYTES] = "";
    int count = 0;
    for (; rows_next(file, &row); count++) {
        bool whole = *row.text == '|';
        FREED_BY(free_text) char *seen = described(whole ? "" : header, row.text + whole);
        rows_drop_known(seen, known);
        ck_assert_msg(strcmp(seen, row.lines) == 0, "%sis not\n%sfor\n%s", seen, row.lines,
                      row.text);
        if (count == 0)
            strcpy(known, row.lines);
    }
    fclose(file);
    ck_assert_int_gt(count, 10);
}

TEST(test_many_errors)
{
    char lines[900] = "";
    for (int i = 0; i < RT_ERRORS_SHOWN + 5; i++) {
        strcat(lines, "cy 0,1e17,0 0,1,0 2 1 0,0,0\n");
        FREED_BY(outcome_free) outcome o = placed(header, lines);
        const char *more = strstr(o.messages, "\nt.rt: ");
        ck_assert(!o.good && !strstr(o.messages, "t.rt:24:1: error"));
        ck_assert(i + 1 < RT_ERRORS_SHOWN || strstr(o.messages, "t.rt:23:1: error"));
        ck_assert_int_eq(more ? more[7] - '0' : 0,
                         i < RT_ERRORS_SHOWN ? 0 : i + 1 - RT_ERRORS_SHOWN);
    }
}

SUITE("placement")
