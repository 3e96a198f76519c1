/* The .rt reader: everything that docs/scene_format.md says is read, and everything it refuses. */
#define _GNU_SOURCE /* open_memstream, mkdtemp */

#include <dirent.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "rt_notes.h"
#include "suite.h"
#include "text_rows.h"
#include "written_scene.h"

#define LENGTH(array) (int)(sizeof(array) / sizeof *(array))

#define HEAD "A 0.2 255,255,255\nC 0,0,20 0,0,-1 70\nL -10,10,10 0.7 255,255,255\n"
#define HEAD_LINES 3

typedef struct {
    bool good;
    rt_scene scene; /* when good */
    char *messages;
} outcome;

static rt_options cli_options;
static rt_options_set cli_set;

static void no_cli_options(void)
{
    cli_options = rt_default_options();
    cli_set = 0;
}

/* The text is handed over in a block of just its size, so that reading past it shows. */
static outcome read_bytes(const char *text, size_t size, const char *name)
{
    outcome o = {0};
    size_t written;
    char *copy = malloc(size);
    FILE *messages = open_memstream(&o.messages, &written);
    ck_assert(messages && (copy || size == 0));
    if (size > 0)
        memcpy(copy, text, size);
    o.good = rt_read_text(copy, size, name, &cli_options, cli_set, messages, &o.scene);
    fclose(messages);
    free(copy);
    return o;
}

static outcome read_string(const char *text)
{
    return read_bytes(text, strlen(text), "test.rt");
}

static outcome read_path(const char *path)
{
    outcome o = {0};
    size_t written;
    FILE *messages = open_memstream(&o.messages, &written);
    ck_assert(messages);
    o.good = rt_read(path, &cli_options, cli_set, messages, &o.scene);
    fclose(messages);
    return o;
}

static void drop(outcome *o)
{
    if (o->good)
        rt_scene_free(&o->scene);
    free(o->messages);
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

static rt_scene read_with_head(const char *lines)
{
    char *text;
    ck_assert(asprintf(&text, HEAD "%s", lines) >= 0);
    rt_scene scene = read_good(text);
    free(text);
    return scene;
}

static void check_messages(const char *text, bool good, const char *messages)
{
    outcome o = read_string(text);
    ck_assert_str_eq(o.messages, messages);
    ck_assert(o.good == good);
    drop(&o);
}

static void check_vector(sure_vec3 v, double x, double y, double z)
{
    ck_assert_msg(v.x == x && v.y == y && v.z == z, "%a,%a,%a is not %a,%a,%a", v.x, v.y, v.z, x, y,
                  z);
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

/* What is read. */

/* What is written of the text's scene, whatever ends the last line, without the known lines. */
static void check_good(const char *row, const char *known, const char *expected)
{
    static const char *const ends[] = {"", "\n", "\r\n", "\r"};
    for (int end = 0; end < LENGTH(ends); end++) {
        char *text =
            *row == '|' ? format("%s%s", row + 1, ends[end]) : format(HEAD "%s%s", row, ends[end]);
        rt_scene s = read_good(text);
        char *written = written_scene(&s);
        rows_drop_known(written, known);
        ck_assert_msg(strcmp(written, expected) == 0, "%sis not\n%sfor\n%s", written, expected,
                      text);
        rt_scene_free(&s);
        free(written);
        free(text);
    }
}

START_TEST(good_texts)
{
    FILE *file = rows_open("scene/good.txt");
    rt_scene head = read_good(HEAD);
    char row[ROW_BYTES], written[ROW_LINES_BYTES], *known = written_scene(&head);
    int count = 0;
    for (; rows_next(file, row, written); count++)
        check_good(row, known, written);
    fclose(file);
    rt_scene_free(&head);
    free(known);
    ck_assert_int_gt(count, 60);
}
END_TEST

#define BOM "\xef\xbb\xbf"
#define REVERSED(end) "sp 1,2,3 4 5,6,7" end "L 0,0,0 1" end "C 0,0,0 0,0,1 90" end "A 1 0,0,0"

START_TEST(order_line_ends_and_byte_order_mark)
{
    static const char *const texts[] = {
        REVERSED("\n"),     REVERSED("\r\n"),     REVERSED("\r"),
        BOM REVERSED("\n"), BOM REVERSED("\r\n"), BOM REVERSED("\r"),
    };
    for (int i = 0; i < LENGTH(texts); i++) {
        rt_scene s = read_good(texts[i]);
        ck_assert_uint_eq(s.element_count, 1);
        ck_assert_uint_eq(s.elements[0].line, 1);
        ck_assert_uint_eq(s.elements[0].column, 1);
        ck_assert_uint_eq(s.camera_line, 3);
        rt_scene_free(&s);
    }
}
END_TEST

START_TEST(places_of_elements)
{
    rt_scene s = read_good("# a\n"
                           "  A 0 0,0,0\r\n"
                           "\t C 0,0,0 1,0,0 1\r"
                           "L 0,0,0 0\n"
                           "\n"
                           "    pl 0,0,0 1,0,0 0,0,0\n"
                           "cone 0,0,0 1,0,0 1 1 0,0,0");
    ck_assert(s.camera_line == 3 && s.camera_column == 3);
    ck_assert(s.elements[0].line == 6 && s.elements[0].column == 5);
    ck_assert(s.elements[1].line == 7 && s.elements[1].column == 1);
    rt_scene_free(&s);
}
END_TEST

static uint64_t random_stream, random_index;

static void begin_random(uint64_t stream)
{
    random_stream = stream;
    random_index = 0;
}

static uint64_t random_below(uint64_t bound)
{
    return suite_bits(random_stream, random_index++) % bound;
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

/* What strtod makes of a number in the C locale is the correct rounding; and with so many elements
 * the arrays grow. */
START_TEST(random_numbers)
{
    enum { COUNT = 20000 };
    char(*texts)[40] = malloc(COUNT * sizeof *texts);
    char *lines = malloc(COUNT * 64), *end = lines;
    ck_assert(texts && lines);
    begin_random(1);
    for (int i = 0; i < COUNT; i++) {
        random_number(texts[i]);
        end += sprintf(end, "sp 0,%s,0 1 0,0,0\n", texts[i]);
    }
    rt_scene s = read_with_head(lines);
    ck_assert_uint_eq(s.element_count, COUNT);
    for (int i = 0; i < COUNT; i++) {
        double expected = strtod(texts[i], NULL);
        ck_assert_msg(s.elements[i].position.y == expected, "%s gives %a and not %a", texts[i],
                      s.elements[i].position.y, expected);
        ck_assert_uint_eq(s.elements[i].line, (size_t)i + HEAD_LINES + 1);
    }
    rt_scene_free(&s);
    free(lines);
    free(texts);
}
END_TEST

START_TEST(every_color_value)
{
    for (int i = 0; i < 256; i++) {
        char *line = format("sp 0,0,0 1 %d,0,%d", i, 255 - i);
        rt_scene s = read_with_head(line);
        check_vector(s.materials[0].color, i / 255.0, 0, (255 - i) / 255.0);
        rt_scene_free(&s);
        free(line);
    }
}
END_TEST

START_TEST(many_lights)
{
    enum { COUNT = 1000 };
    char *lines = malloc(COUNT * 32), *end = lines;
    ck_assert(lines);
    for (int i = 0; i < COUNT; i++)
        end += sprintf(end, "L %d,0,0 .5\n", i);
    rt_scene s = read_with_head(lines);
    ck_assert_uint_eq(s.light_count, COUNT + 1);
    for (int i = 0; i < COUNT; i++)
        ck_assert(s.lights[i + 1].light.position.x == i);
    rt_scene_free(&s);
    free(lines);
}
END_TEST

START_TEST(decimal_comma)
{
    const char *folder = getenv("LOCPATH");
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8"),
                  "no locale de_DE.UTF-8; LOCPATH, which meson sets to its folder, is %s",
                  folder ? folder : "not set");
    ck_assert_str_eq(localeconv()->decimal_point, ",");
    rt_scene s = read_with_head("sp 0.1,1.5e0,0.12345678901234567890 1.25 0,0,0");
    setlocale(LC_ALL, "C");
    check_vector(s.elements[0].position, 0.1, 1.5, 0.12345678901234567890);
    ck_assert(s.elements[0].diameter == 1.25);
    rt_scene_free(&s);
}
END_TEST

/* Options, by lines and by the command line. */

START_TEST(default_options)
{
    rt_options d = rt_default_options();
    ck_assert(d.handedness == RT_RIGHT_HANDED && d.fov == RT_FOV_HORIZONTAL);
    ck_assert(d.cylinder_position == RT_POSITION_MIDDLE && d.cone_position == RT_POSITION_MIDDLE);
    ck_assert(d.falloff == SURE_FALLOFF_NONE && !d.skip_unknown);
    ck_assert(d.width == 1280 && d.height == 720);
}
END_TEST

/* One number for all options, so that "this and nothing else has changed" is one comparison. */
static int digest(rt_options o)
{
    return (int)o.handedness + 2 * (int)o.fov + 4 * (int)o.cylinder_position +
           16 * (int)o.cone_position + 64 * (int)o.falloff + 128 * o.skip_unknown +
           256 * ((o.width - 1280) + 2000 * (o.height - 720));
}

static const struct {
    const char *name, *value, *other; /* the other is a further value of the same option */
    int changed, set;                 /* digests */
} option_rows[] = {
    {"handedness", "right", "left", 0, 1},
    {"handedness", "left", "right", RT_LEFT_HANDED, 1},
    {"fov", "horizontal", "vertical", 0, 2},
    {"fov", "vertical", "horizontal", 2 * RT_FOV_VERTICAL, 2},
    {"cylinder-position", "middle", "base", 0, 4},
    {"cylinder-position", "base", "middle", 4 * RT_POSITION_BASE, 4},
    {"cone-position", "middle", "apex", 0, 8},
    {"cone-position", "apex", "base", 16 * RT_POSITION_APEX, 8},
    {"cone-position", "base", "middle", 16 * RT_POSITION_BASE, 8},
    {"falloff", "none", "inverse-square", 0, 16},
    {"falloff", "inverse-square", "none", 64 * SURE_FALLOFF_INVERSE_SQUARE, 16},
    {"skip-unknown", NULL, NULL, 128, 32},
    {"size", "1281x720", "7x9", 256, 64},
    {"size", "1280x721", "65535x1", 256 * 2000, 64},
};

START_TEST(option_by_words)
{
    rt_options o = rt_default_options();
    rt_options_set set = 0;
    ck_assert_ptr_null(rt_set_option(&o, &set, option_rows[_i].name, option_rows[_i].value));
    ck_assert_int_eq(digest(o), option_rows[_i].changed);
    ck_assert_int_eq((int)set, option_rows[_i].set);
}
END_TEST

/* On a line of the scene, wherever it stands; and the command line wins. */
START_TEST(option_by_line)
{
    const char *name = option_rows[_i].name, *other = option_rows[_i].other;
    const char *value = option_rows[_i].value ? option_rows[_i].value : "";
    static const char *const patterns[] = {HEAD "#! %s %s\n", "#!%s\t%s\n" HEAD,
                                           HEAD "  #!  %s  %s  # comment"};
    for (int i = 0; i < LENGTH(patterns); i++) {
        char *text = format(patterns[i], name, value);
        rt_scene s = read_good(text);
        ck_assert_int_eq(digest(s.options), option_rows[_i].changed);
        rt_scene_free(&s);
        ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, name, other));
        s = read_good(text);
        ck_assert_int_eq(digest(s.options), digest(cli_options));
        rt_scene_free(&s);
        no_cli_options();
        free(text);
    }
}
END_TEST

/* The command line's values count where the set says so and nowhere else. */
START_TEST(unset_options_do_not_count)
{
    cli_options = (rt_options){.handedness = RT_LEFT_HANDED,
                               .fov = RT_FOV_VERTICAL,
                               .cylinder_position = RT_POSITION_BASE,
                               .cone_position = RT_POSITION_BASE,
                               .falloff = SURE_FALLOFF_INVERSE_SQUARE,
                               .skip_unknown = true,
                               .width = 3,
                               .height = 4};
    rt_scene s = read_good(HEAD);
    ck_assert_int_eq(digest(s.options), 0);
    rt_scene_free(&s);
    cli_set = RT_SET_ALL;
    s = read_good(HEAD "R 640 480\nfalloff none\n#! handedness right\n");
    ck_assert_int_eq(digest(s.options), digest(cli_options));
    rt_scene_free(&s);
    no_cli_options();
}
END_TEST

static const struct {
    const char *name, *value, *expected;
} option_faults[] = {
    {"handedness", "", "right or left"},
    {"handedness", NULL, "right or left"},
    {"size", NULL, "WxH"},
    {"size", "", "WxH"},
    {"", NULL, "one of handedness"},
};

START_TEST(option_fault)
{
    rt_options o = rt_default_options();
    rt_options_set set = 0;
    const char *expected = rt_set_option(&o, &set, option_faults[_i].name, option_faults[_i].value);
    ck_assert_ptr_nonnull(expected);
    ck_assert_ptr_nonnull(strstr(expected, option_faults[_i].expected));
    ck_assert_int_eq(digest(o), 0);
    ck_assert_int_eq((int)set, 0);
}
END_TEST

/* What is refused, line by line. */

/* Takes the caret out of the text; returns where it stood. */
static size_t take_caret(char *text)
{
    size_t place = strcspn(text, "^");
    memmove(text + place, text + place + 1, strlen(text + place));
    return place;
}

static void find_place(const char *text, size_t offset, size_t *line, size_t *column)
{
    *line = *column = 1;
    for (size_t i = 0; i < offset; i++) {
        *column = text[i] == '\n' ? 1 : *column + 1;
        *line += text[i] == '\n';
    }
}

/* Each line that is said has its place, or is an error at the caret, which is not part of the text
 * and stands before the byte that is meant. */
static void check_said(const char *head, const char *marked, const char *said)
{
    char *text = format("%s%s", head, marked), *messages = format("");
    size_t line = 0, column = 0;
    if (strchr(text, '^'))
        find_place(text, take_caret(text), &line, &column);
    while (*said) {
        int length = (int)strcspn(said, "\n");
        char *more =
            *said >= '0' && *said <= '9'
                ? format("%stest.rt:%.*s\n", messages, length, said)
                : format("%stest.rt:%zu:%zu: error: %.*s\n", messages, line, column, length, said);
        free(messages);
        messages = more;
        said += length + (said[length] == '\n');
    }
    check_messages(text, !strstr(messages, ": error: "), messages);
    free(messages);
    free(text);
}

START_TEST(faults)
{
    FILE *file = rows_open("scene/faults.txt");
    char row[ROW_BYTES], said[ROW_LINES_BYTES];
    int count = 0;
    while (rows_next(file, row, said)) {
        check_said(*row == '|' ? "" : HEAD, *row == '|' ? row + 1 : row, said);
        count++;
    }
    fclose(file);
    ck_assert_int_gt(count, 220);
}
END_TEST

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

START_TEST(first_errors_and_how_many_more)
{
    static const struct {
        int lines;
        const char *last;
    } lengths[] = {
        {RT_ERRORS_SHOWN, "test.rt:23:1: error: unknown identifier 'X'"},
        {RT_ERRORS_SHOWN + 1, "\ntest.rt: 1 more error\n"},
        {5000, "\ntest.rt: 4980 more errors\n"},
    };
    for (int i = 0; i < LENGTH(lengths); i++) {
        char *bad = repeated("X\n", lengths[i].lines);
        char *text = format(HEAD "%s", bad);
        outcome o = read_string(text);
        ck_assert(!o.good);
        ck_assert_int_eq(count_of(o.messages, ": error: "), RT_ERRORS_SHOWN);
        ck_assert_ptr_nonnull(strstr(o.messages, "test.rt:4:1: error: "));
        ck_assert_ptr_nonnull(strstr(o.messages, "test.rt:23:1: error: "));
        const char *last = strstr(o.messages, lengths[i].last);
        ck_assert_msg(last && !strchr(last + 1, '\n')[1], "%s", o.messages);
        drop(&o);
        free(text);
        free(bad);
    }
}
END_TEST

/* Errors that depend on options of later lines are shown in the order of the text, among others. */
START_TEST(pending_errors_keep_their_order)
{
    char *surfaces = repeated("sq 1\nL 0,0,0 2\nX\n", 30);
    char *text = format(HEAD "%s", surfaces);
    outcome o = read_string(text);
    ck_assert_int_eq(count_of(o.messages, ": error: "), RT_ERRORS_SHOWN);
    for (int line = 4; line < 4 + RT_ERRORS_SHOWN; line++) {
        char *place = format("test.rt:%d:", line);
        ck_assert_ptr_nonnull(strstr(o.messages, place));
        free(place);
    }
    ck_assert_ptr_nonnull(strstr(o.messages, "\ntest.rt: 70 more errors\n"));
    drop(&o);
    free(text);
    free(surfaces);
}
END_TEST

START_TEST(bright_lights)
{
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "falloff", "inverse-square"));
    rt_scene s = read_with_head("L 0,0,0 1.5");
    ck_assert(s.lights[1].light.brightness == 1.5);
    rt_scene_free(&s);
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "falloff", "none"));
    check_said(HEAD, "falloff inverse-square\nL 0,0,0 ^1.5",
               "light ratio '1.5' is out of range; expected a number from 0 to 1 (with falloff "
               "inverse-square, from 0)");
    no_cli_options();
}
END_TEST

START_TEST(skipping_unknown_surfaces)
{
    static const char messages[] = "test.rt:4:1: warning: unknown surface 'sq' is left out\n"
                                   "test.rt:5:3: warning: unknown surface 'triangle' is left out\n";
    char *text = format("%stest.rt:8:1: error: unknown identifier 'X'; expected %s\n", messages,
                        rt_identifiers().text);
#define SURFACES "sq 1,2,3 whatever,\n  triangle\nsp 0,0,0 1 1,2,3\n"
    check_messages(HEAD SURFACES "#! skip-unknown", true, messages);
    check_messages(HEAD SURFACES "#! skip-unknown\nX", false, text);
    free(text);
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "skip-unknown", NULL));
    outcome o = read_string(HEAD SURFACES);
    ck_assert_str_eq(o.messages, messages);
    ck_assert(o.good && o.scene.element_count == 1 && o.scene.options.skip_unknown);
    drop(&o);
#undef SURFACES
    char *many = repeated("sq\n", RT_ERRORS_SHOWN + 3);
    text = format(HEAD "%s", many);
    o = read_string(text);
    ck_assert(o.good);
    ck_assert_int_eq(count_of(o.messages, " 'sq' is left out\n"), RT_ERRORS_SHOWN);
    ck_assert_ptr_nonnull(
        strstr(o.messages, "\ntest.rt: warning: 3 more unknown surfaces are left out\n"));
    drop(&o);
    free(text);
    free(many);
    /* a slip of the pen is no unknown surface */
    check_said(HEAD, "^SP 0,0,0 1 1,2,3", "unknown identifier 'SP'; expected 'sp' and a blank");
    check_said(HEAD, "^sp0,0,0 1 1,2,3", "unknown identifier 'sp0'; expected 'sp' and a blank");
    check_said(HEAD, "^l 0,0,0 1", "unknown identifier 'l'; expected 'L' and a blank");
    text = format("a line that starts with '0,0,0'; expected %s: an element stands on one line",
                  rt_identifiers().text);
    check_said(HEAD, "^0,0,0 1 1,2,3", text);
    free(text);
    no_cli_options();
}
END_TEST

static void check_bytes(const char *text, size_t size, const char *messages)
{
    outcome o = read_bytes(text, size, "test.rt");
    ck_assert(!o.good);
    ck_assert_str_eq(o.messages, messages);
    drop(&o);
}

START_TEST(nul_bytes)
{
    static const char in_field[] = HEAD "sp 0,0,\0 1 1,2,3\nsp 0,0,0 0 1,2,3\n";
    static const char in_comment[] = HEAD "sp 0,0,0 1 1,2,3 # \0\n";
    static const char alone[] = HEAD "\0";
    check_bytes(in_field, sizeof in_field - 1,
                "test.rt:4:8: error: a NUL byte; expected text\n"
                "test.rt:5:10: error: diameter '0' is out of range; expected a number above 0\n");
    check_bytes(in_comment, sizeof in_comment - 1,
                "test.rt:4:20: error: a NUL byte; expected text\n");
    check_bytes(alone, sizeof alone - 1, "test.rt:4:1: error: a NUL byte; expected text\n");
}
END_TEST

START_TEST(utf_16)
{
    static const char little[] = "\xff\xfe"
                                 "A\0 \0",
                      big[] = "\xfe\xff\0A\0 ";
    check_bytes(little, sizeof little - 1,
                "test.rt:1:1: error: text in UTF-16; expected UTF-8 or ASCII\n");
    check_bytes(big, sizeof big - 1,
                "test.rt:1:1: error: text in UTF-16; expected UTF-8 or ASCII\n");
}
END_TEST

START_TEST(binary_data)
{
    static const char png[] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\5\0\0\0\2\xd0\b\2\0\0\0@\x1fJ\xa6";
    outcome o = read_bytes(png, sizeof png - 1, "test.rt");
    ck_assert(!o.good);
    ck_assert_int_eq(strncmp(o.messages, "test.rt:1:1: error: unknown identifier '\\x89PNG'; ", 50),
                     0);
    ck_assert_ptr_nonnull(strstr(o.messages, "\ntest.rt:2:1: error: unknown identifier '\\x1a'; "));
    ck_assert_ptr_nonnull(strstr(o.messages, "\ntest.rt:3:1: error: a NUL byte; expected text\n"));
    drop(&o);
}
END_TEST

/* One message of reasonable length for any line that is too long, whatever is in it. */
START_TEST(long_lines)
{
    enum { LONGEST = 65535, MEGABYTE = 1 << 20 };
    static const char *const fillings[] = {"a", "1", "# comment ", " ", "sp 0,0,0 1 ", ","};
    for (int i = 0; i < LENGTH(fillings); i++) {
        char *line = repeated(fillings[i], MEGABYTE / (int)strlen(fillings[i]) + 1);
        line[MEGABYTE] = '\0';
        char *text = format(HEAD "%s\nX", line);
        char *messages = format("test.rt:4:65536: error: a line of 1048576 bytes; expected at most "
                                "65535\ntest.rt:5:1: error: unknown identifier 'X'; expected %s\n",
                                rt_identifiers().text);
        check_messages(text, false, messages);
        free(messages);
        free(text);
        free(line);
    }
    char *digits = repeated("7", LONGEST - (int)strlen("sp 0.,0,0 1 1,2,3"));
    char *line = format("sp 0.%s,0,0 1 1,2,3\n", digits);
    rt_scene s = read_with_head(line);
    ck_assert(s.elements[0].position.x == 7 / 9.0);
    rt_scene_free(&s);
    free(line);
    line = format(HEAD "sp 0.%sx,0,0 1 1,2,\n", digits);
    outcome o = read_string(line);
    ck_assert_str_eq(o.messages, "test.rt:4:4: error: '0.7777777777777777777777...' is not a "
                                 "number; expected the position, x,y,z\n"
                                 "test.rt:4:65536: error: the line ends here; expected the colour, "
                                 "R,G,B, whole numbers from 0 to 255\n");
    drop(&o);
    free(line);
    free(digits);
}
END_TEST

START_TEST(name_with_control_characters)
{
    outcome o = read_bytes("", 0, "a\x1b[2J\nb\x7f.rt");
    ck_assert_int_eq(strncmp(o.messages, "a\\x1b[2J\\x0ab\\x7f.rt:1:1: error: ", 31), 0);
    drop(&o);
}
END_TEST

/* Files. */

START_TEST(not_a_scene_file)
{
    outcome o = read_path(suite_file("scenes"));
    char *message =
        format("%s:1:1: error: a directory; expected a scene file\n", suite_file("scenes"));
    ck_assert_str_eq(o.messages, message);
    ck_assert(!o.good);
    drop(&o);
    free(message);
    o = read_path("no-such-folder/no-such-file.rt");
    ck_assert_str_eq(o.messages, "no-such-folder/no-such-file.rt:1:1: error: No such file or "
                                 "directory; expected a scene that can be read\n");
    ck_assert(!o.good);
    drop(&o);
    o = read_path("/dev/zero");
    ck_assert_str_eq(o.messages, "/dev/zero:1:1: error: neither a file nor a pipe; expected a "
                                 "scene file\n");
    drop(&o);
}
END_TEST

static void write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    ck_assert(file && fputs(text, file) >= 0 && fclose(file) == 0);
}

START_TEST(name_of_another_ending)
{
    const char *temporary = getenv("TMPDIR");
    char *folder = format("%s/surehit-XXXXXX", temporary ? temporary : "/tmp");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    static const struct {
        const char *name;
        bool warned;
    } names[] = {
        {"a.rt", false}, {"a.txt", true}, {"a.rt.txt", true}, {"a.RT", true}, {"rt", true},
    };
    for (int i = 0; i < LENGTH(names); i++) {
        char *path = format("%s/%s", folder, names[i].name);
        write_file(path, HEAD);
        outcome o = read_path(path);
        unlink(path);
        char *warning = format("%s:1:1: warning: the file's name does not end in .rt\n", path);
        ck_assert(o.good);
        ck_assert_str_eq(o.messages, names[i].warned ? warning : "");
        ck_assert_str_eq(o.scene.name, path);
        free(warning);
        free(path);
        drop(&o);
    }
    rmdir(folder);
    free(folder);
}
END_TEST

/* A pipe has no size to be known beforehand. */
START_TEST(scene_from_a_pipe)
{
    int ends[2];
    ck_assert_int_eq(pipe(ends), 0);
    char *spheres = repeated("sp 1,2,3 4 5,6,7\n", 1500), *text = format(HEAD "%s", spheres);
    size_t size = strlen(text);
    ck_assert_int_eq(write(ends[1], text, size), (ssize_t)size);
    close(ends[1]);
    char *path = format("/dev/fd/%d", ends[0]);
    outcome o = read_path(path);
    close(ends[0]);
    ck_assert_msg(o.good && o.scene.element_count == 1500, "%s", o.messages);
    drop(&o);
    free(path);
    free(text);
    free(spheres);
}
END_TEST

START_TEST(scene_found_in_the_wild)
{
    outcome o = read_path(suite_file("scenes/wild.rt"));
    ck_assert_msg(o.good && *o.messages == '\0', "%s", o.messages);
    const rt_scene *s = &o.scene;
    ck_assert(s->ambient_ratio == 0.22 && s->camera_fov == 60);
    check_vector(s->camera_position, 0, 34, 0);
    check_vector(s->camera_direction, 0, -1, 0);
    ck_assert_uint_eq(s->light_count, 3);
    check_vector(s->lights[1].light.position, 15, 20, 8);
    check_vector(s->lights[1].light.color, 150 / 255.0, 190 / 255.0, 1);
    check_vector(s->lights[2].light.color, 1, 1, 1);
    size_t counts[SURE_SHAPES] = {0};
    for (size_t i = 0; i < s->element_count; i++)
        counts[s->elements[i].shape]++;
    ck_assert(counts[SURE_SHAPE_PLANE] == 1 && counts[SURE_SHAPE_SPHERE] == 14);
    ck_assert(counts[SURE_SHAPE_CYLINDER] == 8 && counts[SURE_SHAPE_CONE] == 3);
    const rt_element *last = &s->elements[s->element_count - 1];
    check_vector(last->position, -17, 0.8, 2.25);
    ck_assert(s->materials[s->element_count - 1].shine == 96);
    drop(&o);
}
END_TEST

static int scenes_in_faulty(void)
{
    DIR *folder = opendir(suite_file("scenes/faulty"));
    ck_assert(folder);
    int scenes = 0;
    for (struct dirent *entry; (entry = readdir(folder));)
        scenes += strstr(entry->d_name, ".rt") != NULL;
    closedir(folder);
    return scenes;
}

/* tests/scenes/faulty/EXPECTED: `file:line:column: message`, in the order of the text, for every
 * scene of the folder. */
START_TEST(faulty_scenes)
{
    FILE *expected = fopen(suite_file("scenes/faulty/EXPECTED"), "r");
    ck_assert_msg(expected != NULL, "%s can't be read", suite_file("scenes/faulty/EXPECTED"));
    char line[400], name[100] = "";
    outcome o = {0};
    const char *at = NULL;
    int scenes = 0;
    while (fgets(line, sizeof line, expected)) {
        size_t length = strcspn(line, ":");
        ck_assert(length < sizeof name && strchr(line, '\n'));
        if (strncmp(name, line, length) != 0 || name[length] != '\0') {
            ck_assert_msg(!at || *at == '\0', "%s also says\n%s", name, at);
            drop(&o);
            snprintf(name, sizeof name, "%.*s", (int)length, line);
            o = read_path(suite_file("scenes/faulty/%s", name));
            ck_assert_msg(!o.good, "%s is read without an error", name);
            at = o.messages;
            scenes++;
        }
        const char *wanted = suite_file("scenes/faulty/%s", line);
        ck_assert_msg(strncmp(at, wanted, strlen(wanted)) == 0, "%s\nis not\n%s", at, wanted);
        at += strlen(wanted);
    }
    ck_assert_msg(at && *at == '\0', "%s also says\n%s", name, at);
    ck_assert_int_eq(scenes, scenes_in_faulty());
    drop(&o);
    fclose(expected);
}
END_TEST

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

START_TEST(cut_off_anywhere)
{
    FILE *file = fopen(suite_file("scenes/wild.rt"), "rb");
    ck_assert_ptr_nonnull(file);
    char text[1 << 14];
    size_t size = fread(text, 1, sizeof text, file);
    ck_assert(size > 1000 && size < sizeof text);
    fclose(file);
    for (size_t cut = 0; cut <= size; cut++) {
        outcome o = read_bytes(text, cut, "test.rt");
        check_consistent(&o);
        drop(&o);
    }
}
END_TEST

static void add_tests(TCase *tests)
{
    tcase_add_test(tests, good_texts);
    tcase_add_test(tests, order_line_ends_and_byte_order_mark);
    tcase_add_test(tests, places_of_elements);
    tcase_add_test(tests, random_numbers);
    tcase_add_test(tests, every_color_value);
    tcase_add_test(tests, many_lights);
    tcase_add_test(tests, decimal_comma);
    tcase_add_test(tests, default_options);
    tcase_add_loop_test(tests, option_by_words, 0, LENGTH(option_rows));
    tcase_add_loop_test(tests, option_by_line, 0, LENGTH(option_rows));
    tcase_add_test(tests, unset_options_do_not_count);
    tcase_add_loop_test(tests, option_fault, 0, LENGTH(option_faults));
    tcase_add_test(tests, faults);
    tcase_add_test(tests, first_errors_and_how_many_more);
    tcase_add_test(tests, pending_errors_keep_their_order);
    tcase_add_test(tests, bright_lights);
    tcase_add_test(tests, skipping_unknown_surfaces);
    tcase_add_test(tests, nul_bytes);
    tcase_add_test(tests, utf_16);
    tcase_add_test(tests, binary_data);
    tcase_add_test(tests, long_lines);
    tcase_add_test(tests, name_with_control_characters);
    tcase_add_test(tests, not_a_scene_file);
    tcase_add_test(tests, name_of_another_ending);
    tcase_add_test(tests, scene_from_a_pipe);
    tcase_add_test(tests, scene_found_in_the_wild);
    tcase_add_test(tests, faulty_scenes);
    tcase_add_test(tests, cut_off_anywhere);
}

int main(void)
{
    Suite *suite = suite_create("rt_reader");
    TCase *tests = tcase_create("rt_reader");
    tcase_add_checked_fixture(tests, no_cli_options, NULL);
    tcase_set_timeout(tests, 60);
    add_tests(tests);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
