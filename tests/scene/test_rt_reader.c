/* SPDX-License-Identifier: MIT */
/* The .rt reader: everything that docs/scene_format.md says is read, and everything it refuses. */

#include <glob.h>
#include <locale.h>
#include <stdarg.h>

#include "files.h"
#include "rt_notes.h"
#include "text_rows.h"
#include "written_scene.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

#define HEAD "A 0.2 255,255,255\nC 0,0,20 0,0,-1 70\nL -10,10,10 0.7 255,255,255\n"
#define HEAD_LINES 3

static rt_options cli_options;
static rt_options_set cli_set;

static void no_cli_options(void)
{
    cli_options = rt_default_options();
    cli_set = 0;
}

static outcome read_bytes(const char *text, size_t size, const char *name)
{
    return outcome_of_text(text, size, name, &cli_options, cli_set);
}

static outcome read_string(const char *text)
{
    return read_bytes(text, strlen(text), "test.rt");
}

static outcome read_path(const char *path)
{
    return outcome_of_file(path, &cli_options, cli_set);
}

/* A scene that must be read without a word. */
static rt_scene read_good(const char *text)
{
    outcome o = read_string(text);
    ck_assert_msg(o.good && *o.messages == '\0', "of\n%.600s\nthe reader says\n%s", text,
                  o.messages);
    free(o.messages);
    return o.scene;
}

static char *format(const char *pattern, ...)
{
    char *text;
    va_list arguments;
    va_start(arguments, pattern);
    ck_assert(vasprintf(&text, pattern, arguments) >= 0);
    va_end(arguments);
    return text;
}

static rt_scene read_with_head(const char *lines)
{
    FREED_BY(free_text) char *text = format(HEAD "%s", lines);
    return read_good(text);
}

/* What is read. */

/* What is written of the text's scene, whatever ends the last line, without the known lines. */
static void check_good(const char *row, const char *known, const char *expected)
{
    static const char *const ends[] = {"", "\n", "\r\n", "\r"};
    for (int end = 0; end < LENGTH(ends); end++) {
        bool whole = *row == '|';
        FREED_BY(free_text)
        char *text = format("%s%s%s", whole ? "" : HEAD, row + whole, ends[end]);
        FREED_BY(rt_scene_free) rt_scene s = read_good(text);
        FREED_BY(free_text) char *written = written_scene(&s);
        rows_drop_known(written, known);
        ck_assert_msg(strcmp(written, expected) == 0, "%sis not\n%sfor\n%s", written, expected,
                      text);
    }
}

TEST(good_texts)
{
    FILE *file = rows_open("scene/good.txt");
    FREED_BY(rt_scene_free) rt_scene head = read_good(HEAD);
    FREED_BY(free_text) char *known = written_scene(&head);
    text_row row;
    int count = 0;
    for (; rows_next(file, &row); count++)
        check_good(row.text, known, row.lines);
    fclose(file);
    ck_assert_int_gt(count, 60);
}

/* However lines end, before them a byte order mark or none; what is behind elements may stand
 * before them. */
TEST(places_of_elements)
{
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    for (int i = 0; i < 6; i++) {
        const char *a = ends[i % 3], *b = ends[i / 2];
        FREED_BY(free_text)
        char *text = format("%s# a%s    sp 1,2,3 4 5,6,7%s%s\t C 0,0,0 0,0,1 90%sL 0,0,0 1%s"
                            "cone 0,0,0 1,0,0 1 1 0,0,0%s  A 1 0,0,0",
                            i % 2 ? "\xef\xbb\xbf" : "", b, a, a, b, a, b);
        FREED_BY(rt_scene_free) rt_scene s = read_good(text);
        ck_assert_uint_eq(s.element_count, 2);
        ck_assert(s.elements[0].at.line == 2 && s.elements[0].at.column == 5);
        ck_assert(s.camera_at.line == 4 && s.camera_at.column == 3);
        ck_assert(s.elements[1].at.line == 6 && s.elements[1].at.column == 1);
    }
}

static uint64_t random_below(uint64_t bound)
{
    static uint64_t drawn;
    return suite_bits(1, drawn++) % bound;
}

/* Up to 24 digits, a point somewhere, and in one of four an exponent. */
static void random_number(char *text)
{
    int digits = 1 + (int)random_below(24), point = (int)random_below((uint64_t)digits + 1);
    if (random_below(2))
        *text++ = '-';
    for (int i = 0; i < digits; i++) {
        if (i == point)
            *text++ = '.';
        *text++ = (char)('0' + random_below(10));
    }
    *text = '\0';
    if (random_below(4) == 0)
        sprintf(text, "e%d", (int)random_below(614) - 330);
}

/* What strtod makes of a number in the C locale is the correct rounding; every value of a colour;
 * and with so many elements and lights the arrays grow. */
TEST(random_numbers)
{
    enum { COUNT = 20000 };
    char(*texts)[40] = malloc(COUNT * sizeof *texts);
    char *lines = malloc(COUNT * 96), *end = lines;
    ck_assert(texts && lines);
    for (int i = 0; i < COUNT; i++) {
        random_number(texts[i]);
        end +=
            sprintf(end, "sp 0,%s,0 1 %d,0,%d\nL %d,0,0 .5\n", texts[i], i % 256, 255 - i % 256, i);
    }
    FREED_BY(rt_scene_free) rt_scene s = read_with_head(lines);
    ck_assert_uint_eq(s.element_count, COUNT);
    ck_assert_uint_eq(s.light_count, COUNT + 1);
    for (int i = 0; i < COUNT; i++) {
        double expected = strtod(texts[i], NULL);
        ck_assert_msg(s.elements[i].position.y == expected, "%s gives %a and not %a", texts[i],
                      s.elements[i].position.y, expected);
        ck_assert_uint_eq(s.elements[i].at.line, 2 * (size_t)i + HEAD_LINES + 1);
        ck_vector_same(s.materials[i].color,
                       (sure_vec3){i % 256 / 255.0, 0, (255 - i % 256) / 255.0});
        ck_assert(s.lights[i + 1].light.position.x == i);
    }
    free(lines);
    free(texts);
}

TEST(decimal_comma)
{
    const char *folder = getenv("LOCPATH");
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8"),
                  "no locale de_DE.UTF-8; LOCPATH, which meson sets to its folder, is %s",
                  folder ? folder : "not set");
    ck_assert_str_eq(localeconv()->decimal_point, ",");
    FREED_BY(rt_scene_free)
    FREED_BY(rt_scene_free)
    rt_scene s = read_with_head("sp 0.1,1.5e0,0.12345678901234567890 1.25 0,0,0");
    setlocale(LC_ALL, "C");
    ck_vector_same(s.elements[0].position, (sure_vec3){0.1, 1.5, 0.12345678901234567890});
    ck_assert(s.elements[0].diameter == 1.25);
}

/* Options, by lines and by the command line. */

/* The values that are not the default ones, and others of the same options. */
static const struct {
    const char *name, *value, *other;
} option_rows[] = {
    {"handedness", "left", "right"},         {"fov", "vertical", "horizontal"},
    {"cylinder-position", "base", "middle"}, {"cone-position", "apex", "middle"},
    {"cone-position", "base", "middle"},     {"falloff", "inverse-square", "none"},
    {"size", "1281x720", "1280x720"},        {"size", "1280x721", "1280x720"},
    {"size", "65535x1", "1280x720"},         {"skip-unknown", NULL, NULL},
};

/* By words, if there are any, and by a line of the scene, wherever it stands; it is written out
 * as the only change. */
static void check_option(const char *name, const char *words, const char *line,
                         const char *expected)
{
    static const char *const patterns[] = {HEAD "#! %s %s\n", "#!%s\t%s\n" HEAD,
                                           HEAD "  #!  %s  %s  # comment"};
    for (int i = 0; i < LENGTH(patterns); i++) {
        FREED_BY(free_text) char *text = format(patterns[i], name, line ? line : "");
        no_cli_options();
        FREED_BY(rt_scene_free) rt_scene plain = read_good(HEAD);
        if (words) {
            ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, name, words));
            ck_assert(cli_set != 0 && (cli_set & (cli_set - 1)) == 0);
        }
        FREED_BY(rt_scene_free) rt_scene s = read_good(text);
        FREED_BY(free_text) char *known = written_scene(&plain), *written = written_scene(&s);
        rows_drop_known(written, known);
        ck_assert_str_eq(written, expected);
    }
}

/* The command line wins. */
LOOP_TEST(option, LENGTH(option_rows))
{
    const char *name = option_rows[_i].name, *value = option_rows[_i].value;
    const char *other = option_rows[_i].other;
    FREED_BY(free_text)
    char *changed = value ? format("#! %s %s\n", name, value) : format("#! %s\n", name);
    check_option(name, NULL, value, changed);
    if (!value)
        return;
    check_option(name, NULL, other, "");
    check_option(name, value, other, changed);
    check_option(name, other, value, "");
}

/* The command line's values count where the set says so and nowhere else. */
TEST(unset_options_do_not_count)
{
    const rt_options none = rt_default_options();
    for (int i = 0; i < LENGTH(option_rows); i++)
        ck_assert_ptr_null(
            rt_set_option(&cli_options, &cli_set, option_rows[i].name, option_rows[i].value));
    ck_assert_uint_eq(cli_set | RT_SET(RT_DIALECT) | RT_SET(RT_CAMERA), RT_SET_ALL);
    FREED_BY(rt_scene_free)
    rt_scene set = read_good(HEAD "R 640 480\nfalloff none\n#! handedness right\n");
    ck_assert_ptr_null(rt_options_difference(&set.options, &cli_options));
    cli_set = 0;
    FREED_BY(rt_scene_free) rt_scene unset = read_good(HEAD);
    ck_assert_ptr_null(rt_options_difference(&unset.options, &none));
}

/* Words that no line can have. */
TEST(option_faults)
{
    static const char *const rows[][3] = {{"handedness", "", "right or left"},
                                          {"handedness", NULL, "right or left"},
                                          {"size", NULL, "WxH"},
                                          {"size", "", "WxH"},
                                          {"", NULL, "one of handedness"}};
    const rt_options none = rt_default_options();
    for (int i = 0; i < LENGTH(rows); i++) {
        const char *expected = rt_set_option(&cli_options, &cli_set, rows[i][0], rows[i][1]);
        ck_assert(expected && strstr(expected, rows[i][2]));
        ck_assert_ptr_null(rt_options_difference(&cli_options, &none));
        ck_assert_uint_eq(cli_set, 0);
    }
}

/* What is refused, line by line. */

/* Where the caret stands in the text, which is taken out of it: LINE:COLUMN. */
static char *take_place(char *text, size_t *size)
{
    size_t line = 1, column = 1;
    char *caret = memchr(text, '^', *size);
    if (!caret)
        return format("");
    for (const char *at = text; at < caret; at++) {
        column = *at == '\n' ? 1 : column + 1;
        line += *at == '\n';
    }
    memmove(caret, caret + 1, (size_t)(text + --*size - caret));
    return format("%zu:%zu", line, column);
}

/* Each line that is said has its place, or is an error at the caret, which is not part of the text
 * and stands before the byte that is meant. */
static void check_bytes(const char *head, const char *marked, size_t size, const char *said)
{
    size_t all = strlen(head) + size;
    FREED_BY(free_text) char *text = malloc(all), *messages = format("");
    memcpy(text, head, all - size);
    memcpy(text + all - size, marked, size);
    FREED_BY(free_text) char *place = take_place(text, &all);
    while (*said) {
        int length = (int)strcspn(said, "\n");
        char *more = *said >= '0' && *said <= '9'
                         ? format("%stest.rt:%.*s\n", messages, length, said)
                         : format("%stest.rt:%s: error: %.*s\n", messages, place, length, said);
        free(messages);
        messages = more;
        said += length + (said[length] == '\n');
    }
    FREED_BY(outcome_free) outcome o = read_bytes(text, all, "test.rt");
    ck_assert_str_eq(o.messages, messages);
    ck_assert(o.good == !strstr(messages, ": error: "));
}

static void check_said(const char *marked, const char *said)
{
    check_bytes(HEAD, marked, strlen(marked), said);
}

TEST(faults)
{
    FILE *file = rows_open("scene/faults.txt");
    text_row row;
    int count = 0;
    for (; rows_next(file, &row); count++) {
        bool whole = *row.text == '|';
        check_bytes(whole ? "" : HEAD, row.text + whole, row.size - whole, row.lines);
    }
    fclose(file);
    ck_assert_int_gt(count, 220);
}

static char *repeated(const char *line, int count)
{
    size_t length = strlen(line);
    char *text = malloc((size_t)count * length + 1);
    ck_assert(text);
    for (int i = 0; i < count; i++)
        memcpy(text + (size_t)i * length, line, length);
    text[(size_t)count * length] = '\0';
    return text;
}

static int count_of(const char *text, const char *words)
{
    int count = 0;
    while ((text = strstr(text, words))) {
        count++;
        text++;
    }
    return count;
}

/* The first ones, and how many more there are; those that depend on options of later lines are in
 * the order of the text, among others. */
TEST(first_errors_and_how_many_more)
{
    static const struct {
        const char *lines, *said, *last;
        int count;
    } rows[] = {
        {"X\n", "error", "test.rt:23:1: error: unknown identifier 'X'", RT_ERRORS_SHOWN},
        {"X\n", "error", "test.rt: 1 more error\n", RT_ERRORS_SHOWN + 1},
        {"X\n", "error", "test.rt: 4980 more errors\n", 5000},
        {"sq 1\nL 0,0,0 2\nX\n", "error", "test.rt: 70 more errors\n", 30},
        {"sq\n", "warning", "test.rt: warning: 1 more unknown surface is left out\n",
         RT_ERRORS_SHOWN + 1},
        {"sq\n", "warning", "test.rt: warning: 3 more unknown surfaces are left out\n",
         RT_ERRORS_SHOWN + 3},
    };
    for (int i = 0; i < LENGTH(rows); i++) {
        bool good = *rows[i].said == 'w';
        FREED_BY(free_text) char *lines = repeated(rows[i].lines, rows[i].count);
        FREED_BY(free_text) char *text = format(HEAD "%s", lines);
        if (good)
            ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "skip-unknown", NULL));
        FREED_BY(outcome_free) outcome o = read_string(text);
        ck_assert_int_eq(o.good, good);
        for (int line = 4; line < 4 + RT_ERRORS_SHOWN; line++) {
            FREED_BY(free_text) char *place = format("test.rt:%d:", line);
            ck_assert_int_eq(count_of(o.messages, place), 1);
        }
        ck_assert_int_le(count_of(o.messages, "\n"), RT_ERRORS_SHOWN + 1);
        const char *last = strstr(o.messages, rows[i].last);
        ck_assert_msg(last && last[-1] == '\n' && !strchr(last, '\n')[1], "%s", o.messages);
    }
}

/* Each option of its own is told apart, and becomes JSON and is taken from it; of several the size
 * is named first. */
TEST(options_apart)
{
    static const char *const others[][2] = {{"handedness", "left"},
                                            {"fov", "vertical"},
                                            {"cylinder-position", "base"},
                                            {"cone-position", "apex"},
                                            {"falloff", "inverse-square"},
                                            {"dialect", "42"},
                                            {"skip-unknown", ""},
                                            {"size", "7x5"},
                                            {"camera", "3"}};
    const rt_options usual = rt_default_options();
    rt_options all = usual;
    rt_options_set set = 0;
    for (int i = 0; i < LENGTH(others); i++) {
        rt_options one = usual, back = usual;
        ck_assert_ptr_null(rt_set_option(&one, &set, others[i][0], others[i][1]));
        ck_assert_ptr_null(rt_set_option(&all, &set, others[i][0], others[i][1]));
        ck_assert_str_eq(rt_options_difference(&usual, &one), others[i][0]);
        json_t *object = rt_options_json(&one);
        ck_assert_ptr_null(rt_options_from_json(object, &back));
        ck_assert_ptr_null(rt_options_difference(&one, &back));
        json_decref(object);
    }
    ck_assert_int_eq(LENGTH(others), RT_OPTIONS);
    ck_assert_str_eq(rt_options_difference(&usual, &all), "size");
}

TEST(bright_lights)
{
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "falloff", "inverse-square"));
    FREED_BY(rt_scene_free) rt_scene s = read_with_head("L 0,0,0 1.5");
    ck_assert(s.lights[1].light.brightness == 1.5);
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "falloff", "none"));
    check_said("falloff inverse-square\nL 0,0,0 ^1.5",
               "light ratio '1.5' is out of range; expected a number from 0 to 1 (with falloff "
               "inverse-square, from 0)");
}

/* One message of reasonable length for any line that is too long, whatever is in it. */
TEST(long_lines)
{
    enum { LONGEST = 65535, MEGABYTE = 1 << 20 };
    static const char *const fillings[] = {"a", "1", "# comment ", " ", "sp 0,0,0 1 ", ","};
    for (int i = 0; i < LENGTH(fillings); i++) {
        FREED_BY(free_text)
        char *line = repeated(fillings[i], MEGABYTE / (int)strlen(fillings[i]) + 1);
        line[MEGABYTE] = '\0';
        FREED_BY(free_text) char *text = format("%s\nX", line);
        FREED_BY(free_text)
        char *said = format("4:65536: error: a line of 1048576 bytes; expected at most 65535\n"
                            "5:1: error: unknown identifier 'X'; expected %s, or the "
                            "option dialect 42\n",
                            rt_identifiers().text);
        check_said(text, said);
    }
    FREED_BY(free_text)
    char *digits = repeated("7", LONGEST - (int)strlen("sp 0.,0,0 1 1,2,3")),
         *line = format("sp 0.%s,0,0 1 1,2,3\n", digits),
         *bad = format("sp 0.%sx,0,0 1 1,2,\n", digits);
    FREED_BY(rt_scene_free) rt_scene s = read_with_head(line);
    ck_assert(s.elements[0].position.x == 7 / 9.0);
    check_said(bad, "4:4: error: '0.7777777777777777777777...' is not a number; expected the "
                    "position, x,y,z\n"
                    "4:65536: error: the line ends here; expected the colour, R,G,B, whole "
                    "numbers from 0 to 255\n");
}

TEST(name_with_control_characters)
{
    FREED_BY(outcome_free) outcome o = read_bytes("", 0, "a\x1b[2J\nb\x7f.rt");
    ck_assert_int_eq(strncmp(o.messages, "a\\x1b[2J\\x0ab\\x7f.rt:1:1: error: ", 31), 0);
}

/* Files. */

TEST(not_a_scene_file)
{
    static const char *const rows[][2] = {
        {".", "a directory; expected a scene file"},
        {"no-such-folder/no-such-file.rt",
         "No such file or directory; expected a scene that can be read"},
        {"/dev/zero", "neither a file nor a pipe; expected a scene file"}};
    for (int i = 0; i < LENGTH(rows); i++) {
        FREED_BY(outcome_free) outcome o = read_path(rows[i][0]);
        FREED_BY(free_text) char *message = format("%s:1:1: error: %s\n", rows[i][0], rows[i][1]);
        ck_assert_str_eq(o.messages, message);
        ck_assert(!o.good);
    }
}

TEST(name_of_another_ending)
{
    static const struct {
        const char *name;
        bool warned;
    } names[] = {
        {"a.rt", false}, {"a.txt", true}, {"a.rt.txt", true}, {"a.RT", true}, {"rt", true},
    };
    enter_folder();
    for (int i = 0; i < LENGTH(names); i++) {
        const char *name = names[i].name;
        FREED_BY(free_text)
        char *warning = format("%s:1:1: warning: the file's name does not end in .rt\n", name);
        put(name, HEAD, strlen(HEAD));
        FREED_BY(outcome_free) outcome o = read_path(name);
        ck_assert(o.good);
        ck_assert_str_eq(o.messages, names[i].warned ? warning : "");
        ck_assert_str_eq(o.scene.name, name);
    }
    leave_folder();
}

/* A pipe has no size to be known beforehand. */
TEST(scene_from_a_pipe)
{
    int ends[2];
    ck_assert_int_eq(pipe(ends), 0);
    FREED_BY(free_text)
    char *spheres = repeated("sp 1,2,3 4 5,6,7\n", 1500), *text = format(HEAD "%s", spheres),
         *path = format("/dev/fd/%d", ends[0]);
    size_t size = strlen(text);
    ck_assert_int_eq(write(ends[1], text, size), (ssize_t)size);
    close(ends[1]);
    FREED_BY(outcome_free) outcome o = read_path(path);
    close(ends[0]);
    ck_assert_msg(o.good && o.scene.element_count == 1500, "%s", o.messages);
}

/* tests/scenes/faulty/EXPECTED: `file:line:column: message`, in the order of the names, for every
 * scene of the folder. */
TEST(faulty_scenes)
{
    size_t size, same = 0;
    glob_t files;
    FILE *all = listen();
    ck_assert_int_eq(chdir(suite_file("scenes/faulty")), 0);
    FREED_BY(free_text) char *expected = (char *)get("EXPECTED", &size);
    expected[size] = '\0';
    ck_assert_int_eq(glob("*.rt", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        FREED_BY(outcome_free) outcome o = read_path(files.gl_pathv[i]);
        ck_assert_msg(!o.good, "%s is read without an error", files.gl_pathv[i]);
        fputs(o.messages, all);
    }
    fclose(all);
    while (heard[same] && heard[same] == expected[same])
        same++;
    ck_assert_msg(!heard[same] && !expected[same], "%.300s\nis not\n%.300s", heard + same,
                  expected + same);
    globfree(&files);
}

/* Good and silent, or good with warnings, or bad with at least one error and a full last line. */
static void check_consistent(const outcome *o)
{
    size_t length = strlen(o->messages);
    ck_assert(length == 0 || o->messages[length - 1] == '\n');
    ck_assert(o->good == !strstr(o->messages, ": error: "));
    ck_assert_int_le(count_of(o->messages, ": error: "), RT_ERRORS_SHOWN);
    for (const char *c = o->messages; *c; c++)
        ck_assert_msg(*c == '\n' || (*c >= ' ' && *c <= '~'), "%s", o->messages);
}

TEST(cut_off_anywhere)
{
    size_t size;
    FREED_BY(free_text) char *text = (char *)get(suite_file("scenes/wild.rt"), &size);
    ck_assert_uint_gt(size, 1000);
    for (size_t cut = 0; cut <= size; cut++) {
        FREED_BY(outcome_free) outcome o = read_bytes(text, cut, "test.rt");
        check_consistent(&o);
    }
}

SUITE_IN("rt_reader", no_cli_options, NULL)
