/* The .rt reader: everything that docs/scene_format.md says is read, and everything it refuses. */
#define _GNU_SOURCE /* vasprintf, open_memstream, mkdtemp */

#include <glob.h>
#include <locale.h>
#include <math.h>
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
    char *text = format(HEAD "%s", lines);
    rt_scene scene = read_good(text);
    free(text);
    return scene;
}

static void check_vector(sure_vec3 v, double x, double y, double z)
{
    ck_assert_msg(v.x == x && v.y == y && v.z == z, "%a,%a,%a is not %a,%a,%a", v.x, v.y, v.z, x, y,
                  z);
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

TEST(good_texts)
{
    FILE *file = rows_open("scene/good.txt");
    rt_scene head = read_good(HEAD);
    char *known = written_scene(&head);
    text_row row;
    int count = 0;
    for (; rows_next(file, &row); count++)
        check_good(row.text, known, row.lines);
    fclose(file);
    rt_scene_free(&head);
    free(known);
    ck_assert_int_gt(count, 60);
}

/* However lines end, before them a byte order mark or none; what is behind elements may stand
 * before them. */
TEST(places_of_elements)
{
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    for (int i = 0; i < 6; i++) {
        const char *a = ends[i % 3], *b = ends[i / 2];
        char *text = format("%s# a%s    sp 1,2,3 4 5,6,7%s%s\t C 0,0,0 0,0,1 90%sL 0,0,0 1%s"
                            "cone 0,0,0 1,0,0 1 1 0,0,0%s  A 1 0,0,0",
                            i % 2 ? "\xef\xbb\xbf" : "", b, a, a, b, a, b);
        rt_scene s = read_good(text);
        ck_assert_uint_eq(s.element_count, 2);
        ck_assert(s.elements[0].at.line == 2 && s.elements[0].at.column == 5);
        ck_assert(s.camera_at.line == 4 && s.camera_at.column == 3);
        ck_assert(s.elements[1].at.line == 6 && s.elements[1].at.column == 1);
        rt_scene_free(&s);
        free(text);
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
    rt_scene s = read_with_head(lines);
    ck_assert_uint_eq(s.element_count, COUNT);
    ck_assert_uint_eq(s.light_count, COUNT + 1);
    for (int i = 0; i < COUNT; i++) {
        double expected = strtod(texts[i], NULL);
        ck_assert_msg(s.elements[i].position.y == expected, "%s gives %a and not %a", texts[i],
                      s.elements[i].position.y, expected);
        ck_assert_uint_eq(s.elements[i].at.line, 2 * (size_t)i + HEAD_LINES + 1);
        check_vector(s.materials[i].color, i % 256 / 255.0, 0, (255 - i % 256) / 255.0);
        ck_assert(s.lights[i + 1].light.position.x == i);
    }
    rt_scene_free(&s);
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
    rt_scene s = read_with_head("sp 0.1,1.5e0,0.12345678901234567890 1.25 0,0,0");
    setlocale(LC_ALL, "C");
    check_vector(s.elements[0].position, 0.1, 1.5, 0.12345678901234567890);
    ck_assert(s.elements[0].diameter == 1.25);
    rt_scene_free(&s);
}

/* Options, by lines and by the command line. */

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

LOOP_TEST(option_by_words, LENGTH(option_rows))
{
    rt_options o = rt_default_options();
    rt_options_set set = 0;
    ck_assert_ptr_null(rt_set_option(&o, &set, option_rows[_i].name, option_rows[_i].value));
    ck_assert_int_eq(digest(o), option_rows[_i].changed);
    ck_assert_int_eq((int)set, option_rows[_i].set);
}

/* On a line of the scene, wherever it stands; and the command line wins. */
LOOP_TEST(option_by_line, LENGTH(option_rows))
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

/* The first rows ask for the default ones. The command line's values count where the set says so
 * and nowhere else. */
TEST(unset_options_do_not_count)
{
    ck_assert_int_eq(digest(rt_default_options()), 0);
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
}

static const struct {
    const char *name, *value, *expected;
} option_faults[] = {
    {"handedness", "", "right or left"},
    {"handedness", NULL, "right or left"},
    {"size", NULL, "WxH"},
    {"size", "", "WxH"},
    {"", NULL, "one of handedness"},
};

LOOP_TEST(option_fault, LENGTH(option_faults))
{
    rt_options o = rt_default_options();
    rt_options_set set = 0;
    const char *expected = rt_set_option(&o, &set, option_faults[_i].name, option_faults[_i].value);
    ck_assert_ptr_nonnull(expected);
    ck_assert_ptr_nonnull(strstr(expected, option_faults[_i].expected));
    ck_assert_int_eq(digest(o), 0);
    ck_assert_int_eq((int)set, 0);
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
    char *text = malloc(all), *messages = format("");
    memcpy(text, head, all - size);
    memcpy(text + all - size, marked, size);
    char *place = take_place(text, &all);
    while (*said) {
        int length = (int)strcspn(said, "\n");
        char *more = *said >= '0' && *said <= '9'
                         ? format("%stest.rt:%.*s\n", messages, length, said)
                         : format("%stest.rt:%s: error: %.*s\n", messages, place, length, said);
        free(messages);
        messages = more;
        said += length + (said[length] == '\n');
    }
    outcome o = read_bytes(text, all, "test.rt");
    ck_assert_str_eq(o.messages, messages);
    ck_assert(o.good == !strstr(messages, ": error: "));
    outcome_free(&o);
    free(place);
    free(messages);
    free(text);
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

TEST(first_errors_and_how_many_more)
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
        outcome_free(&o);
        free(text);
        free(bad);
    }
}

/* Errors that depend on options of later lines are shown in the order of the text, among others. */
TEST(pending_errors_keep_their_order)
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
    outcome_free(&o);
    free(text);
    free(surfaces);
}

TEST(bright_lights)
{
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "falloff", "inverse-square"));
    rt_scene s = read_with_head("L 0,0,0 1.5");
    ck_assert(s.lights[1].light.brightness == 1.5);
    rt_scene_free(&s);
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "falloff", "none"));
    check_said("falloff inverse-square\nL 0,0,0 ^1.5",
               "light ratio '1.5' is out of range; expected a number from 0 to 1 (with falloff "
               "inverse-square, from 0)");
}

TEST(skipping_unknown_surfaces)
{
    ck_assert_ptr_null(rt_set_option(&cli_options, &cli_set, "skip-unknown", NULL));
    check_said("sq 1,2,3 whatever,\n  triangle\nsp 0,0,0 1 1,2,3",
               "4:1: warning: unknown surface 'sq' is left out\n"
               "5:3: warning: unknown surface 'triangle' is left out\n");
    char *many = repeated("sq\n", RT_ERRORS_SHOWN + 3), *text = format(HEAD "%s", many);
    outcome o = read_string(text);
    ck_assert(o.good && o.scene.options.skip_unknown && o.scene.element_count == 0);
    ck_assert_int_eq(count_of(o.messages, " 'sq' is left out\n"), RT_ERRORS_SHOWN);
    ck_assert_ptr_nonnull(
        strstr(o.messages, "\ntest.rt: warning: 3 more unknown surfaces are left out\n"));
    outcome_free(&o);
    free(text);
    free(many);
    /* a slip of the pen is no unknown surface */
    check_said("^SP 0,0,0 1 1,2,3", "unknown identifier 'SP'; expected 'sp' and a blank");
    check_said("^sp0,0,0 1 1,2,3", "unknown identifier 'sp0'; expected 'sp' and a blank");
    check_said("^l 0,0,0 1", "unknown identifier 'l'; expected 'L' and a blank");
    text = format("a line that starts with '0,0,0'; expected %s: an element stands on one line",
                  rt_identifiers().text);
    check_said("^0,0,0 1 1,2,3", text);
    free(text);
}

/* One message of reasonable length for any line that is too long, whatever is in it. */
TEST(long_lines)
{
    enum { LONGEST = 65535, MEGABYTE = 1 << 20 };
    static const char *const fillings[] = {"a", "1", "# comment ", " ", "sp 0,0,0 1 ", ","};
    for (int i = 0; i < LENGTH(fillings); i++) {
        char *line = repeated(fillings[i], MEGABYTE / (int)strlen(fillings[i]) + 1);
        line[MEGABYTE] = '\0';
        char *text = format("%s\nX", line);
        char *said = format("4:65536: error: a line of 1048576 bytes; expected at most 65535\n"
                            "5:1: error: unknown identifier 'X'; expected %s\n",
                            rt_identifiers().text);
        check_said(text, said);
        free(said);
        free(text);
        free(line);
    }
    char *digits = repeated("7", LONGEST - (int)strlen("sp 0.,0,0 1 1,2,3"));
    char *line = format("sp 0.%s,0,0 1 1,2,3\n", digits);
    rt_scene s = read_with_head(line);
    ck_assert(s.elements[0].position.x == 7 / 9.0);
    rt_scene_free(&s);
    free(line);
    line = format("sp 0.%sx,0,0 1 1,2,\n", digits);
    check_said(line, "4:4: error: '0.7777777777777777777777...' is not a number; expected the "
                     "position, x,y,z\n"
                     "4:65536: error: the line ends here; expected the colour, R,G,B, whole "
                     "numbers from 0 to 255\n");
    free(line);
    free(digits);
}

TEST(name_with_control_characters)
{
    outcome o = read_bytes("", 0, "a\x1b[2J\nb\x7f.rt");
    ck_assert_int_eq(strncmp(o.messages, "a\\x1b[2J\\x0ab\\x7f.rt:1:1: error: ", 31), 0);
    outcome_free(&o);
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
        outcome o = read_path(rows[i][0]);
        char *message = format("%s:1:1: error: %s\n", rows[i][0], rows[i][1]);
        ck_assert_str_eq(o.messages, message);
        ck_assert(!o.good);
        outcome_free(&o);
        free(message);
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
        char *warning = format("%s:1:1: warning: the file's name does not end in .rt\n", name);
        put(name, HEAD, strlen(HEAD));
        outcome o = read_path(name);
        ck_assert(o.good);
        ck_assert_str_eq(o.messages, names[i].warned ? warning : "");
        ck_assert_str_eq(o.scene.name, name);
        free(warning);
        outcome_free(&o);
    }
    leave_folder();
}

/* A pipe has no size to be known beforehand. */
TEST(scene_from_a_pipe)
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
    outcome_free(&o);
    free(path);
    free(text);
    free(spheres);
}

/* What else is in it shows in its picture. */
TEST(scene_found_in_the_wild)
{
    outcome o = read_path(suite_file("scenes/wild.rt"));
    ck_assert_msg(o.good && *o.messages == '\0', "%s", o.messages);
    ck_assert(o.scene.light_count == 3 && o.scene.element_count == 26);
    ck_assert(o.scene.materials[25].shine == 96);
    outcome_free(&o);
}

/* tests/scenes/faulty/EXPECTED: `file:line:column: message`, in the order of the names, for every
 * scene of the folder. */
TEST(faulty_scenes)
{
    size_t size, same = 0;
    glob_t files;
    FILE *all = listen();
    ck_assert_int_eq(chdir(suite_file("scenes/faulty")), 0);
    char *expected = (char *)get("EXPECTED", &size);
    expected[size] = '\0';
    ck_assert_int_eq(glob("*.rt", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        outcome o = read_path(files.gl_pathv[i]);
        ck_assert_msg(!o.good, "%s is read without an error", files.gl_pathv[i]);
        fputs(o.messages, all);
        outcome_free(&o);
    }
    fclose(all);
    while (heard[same] && heard[same] == expected[same])
        same++;
    ck_assert_msg(!heard[same] && !expected[same], "%.300s\nis not\n%.300s", heard + same,
                  expected + same);
    free(expected);
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
    char *text = (char *)get(suite_file("scenes/wild.rt"), &size);
    ck_assert_uint_gt(size, 1000);
    for (size_t cut = 0; cut <= size; cut++) {
        outcome o = read_bytes(text, cut, "test.rt");
        check_consistent(&o);
        outcome_free(&o);
    }
    free(text);
}

SUITE_IN("rt_reader", no_cli_options, NULL)
