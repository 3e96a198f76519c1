/* SPDX-License-Identifier: MIT */
/* Scenes in the ways in which others write them (dialect.txt), hundreds of them with random values:
 * refused at their place by the strict reader, read by dialect 42 as what they mean, never without
 * a word where that is a guess. */

#include <stdarg.h>

#include "text_rows.h"
#include "written_scene.h"
#include "suite.h"

#define HEAD "A 0.2 255,255,255\nC 0,0,20 0,0,-1 70\nL -10,10,10 0.7 255,255,255\n"
#define NAMED ", or the option dialect 42\n"

enum { SEEDS = 12, TEXT = 4096 };

static uint64_t seed;

/* Number `part` of the value that a row calls so, below the bound: the same each time. */
static unsigned drawn(const char *name, int part, unsigned bound)
{
    uint64_t key = seed << 24 | (uint64_t)name[0] << 16 | (uint64_t)name[1] << 8 | (uint64_t)part;
    return (unsigned)(suite_bits(2, key) % bound);
}

static double decimal(const char *name, int part)
{
    return (double)drawn(name, part, 20001) / 100 - 100;
}

/* A value in a form that scenes have it in: "v1" a position and so on. */
static int put_value(char *out, const char *name)
{
    unsigned a = drawn(name, 0, 256), b = drawn(name, 1, 256), c = drawn(name, 2, 256);
    switch (*name) {
    case 'v':
        return sprintf(out, "%g,%s%g,%.1f", decimal(name, 0), a % 4 == 0 ? " " : "",
                       decimal(name, 1), decimal(name, 2));
    case 'd': return sprintf(out, "%g,%.6f,1.0", decimal(name, 0) / 100, decimal(name, 1) / 100);
    case 'n': return sprintf(out, a % 2 ? "%g" : "%.1f", (b + 1) / 8.0);
    case 'r': return sprintf(out, "%.2f", a / 255.0);
    case 'a': return sprintf(out, "%u", 1 + a % 179);
    case 'c': return sprintf(out, "%u,%u,%u", a, b, c);
    default: return sprintf(out, "0.%u,%.2f,1.0", 1 + a % 9, b / 255.0);
    }
}

/* Where the marks stand, LINE:COLUMN each. */
typedef struct {
    char strict[24], warning[24];
} places;

static void note_place(const char *text, const char *end, char place[24])
{
    size_t line = 1, column = 1;
    for (const char *at = text; at < end; at++) {
        column = *at == '\n' ? 1 : column + 1;
        line += *at == '\n';
    }
    sprintf(place, "%zu:%zu", line, column);
}

/* Writes the pattern with its values behind `*end`, which moves; notes the marks' places. */
static void put_line(const char *text, char **end, const char *pattern, places *at)
{
    for (; *pattern != '\0'; pattern++) {
        if (*pattern == '{') {
            *end += put_value(*end, pattern + 1);
            pattern += 3;
        } else if (*pattern == '\\') { /* of what a line means: "\n", as it stands in the table */
            *(*end)++ = '\n';
            pattern++;
        } else if (*pattern == '^') {
            note_place(text, *end, at->strict);
        } else if (*pattern == '~') {
            note_place(text, *end, at->warning);
        } else {
            *(*end)++ = *pattern;
        }
    }
    **end = '\0';
}

/* The line `count` times with different values, behind a scene or as a whole one. */
static void put_scene(char *text, const char *pattern, int count, places *first)
{
    bool whole = *pattern == '|';
    char *end = text + sprintf(text, "%s", whole ? "" : HEAD);
    uint64_t of = seed;
    for (int i = 0; i < (whole ? 1 : count); i++, seed += 1 << 20) {
        places at = {"", ""};
        put_line(text, &end, pattern + whole, &at);
        end += sprintf(end, whole ? "" : "\n");
        if (i == 0)
            *first = at;
    }
    if (*first->warning == '\0')
        strcpy(first->warning, first->strict);
    seed = of;
}

static outcome read_by(const char *text, const char *dialect)
{
    rt_options options = rt_default_options();
    rt_options_set set = 0;
    ck_assert_ptr_null(rt_set_option(&options, &set, "dialect", dialect));
    return outcome_of_text(text, strlen(text), "t.rt", &options, set);
}

/* Is that the first error, at the strict place, and is the option named? */
static void check_refusal(const outcome *o, const places *at, const char *text, const char *message,
                          bool named)
{
    char line[TEXT];
    snprintf(line, sizeof line, "t.rt:%s: error: %s", at->strict, message);
    const char *found = strstr(o->messages, ": error: ");
    while (found && found > o->messages && found[-1] != '\n')
        found--;
    const char *end = found ? strchr(found, '\n') : NULL;
    ck_assert_msg(!o->good && found && strncmp(found, line, strlen(line)) == 0,
                  "of\n%s\nexpected was\n%s\nsaid is\n%s", text, line, o->messages);
    bool is_named = end - found > (int)strlen(NAMED) && strstr(found, "dialect 42\n") &&
                    strstr(found, "dialect 42\n") < end;
    ck_assert_msg(is_named == named, "%s", o->messages);
}

/* What a row's lines say. */
typedef struct {
    const char *strict, *unnamed, *refused, *warning, *once, *reads;
} expectation;

static const char *value_of(char *line, const char *key)
{
    size_t length = strlen(key);
    bool is = strncmp(line, key, length) == 0 && line[length] == ':';
    return is ? line + length + 1 + (line[length + 1] == ' ') : NULL;
}

static expectation expected_of(char *lines)
{
    expectation e = {NULL};
    const struct {
        const char *key, **to;
    } keys[] = {{"strict", &e.strict},   {"unnamed", &e.unnamed}, {"refused", &e.refused},
                {"warning", &e.warning}, {"once", &e.once},       {"reads", &e.reads}};
    for (char *line = strtok(lines, "\n"); line; line = strtok(NULL, "\n")) {
        bool known = false;
        for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
            const char *value = value_of(line, keys[i].key);
            known = known || value;
            *keys[i].to = value ? value : *keys[i].to;
        }
        ck_assert_msg(known, "an unknown line: %s", line);
    }
    return e;
}

/* Nothing but the warning, once for all the lines of its kind. */
static void check_warnings(const outcome *o, const expectation *e, const places *at, int count,
                           const char *text)
{
    char expected[TEXT] = "", times[24] = "";
    const char *warning = e->once ? e->once : e->warning;
    if (count > 1 && !e->once)
        sprintf(times, " (%d times)", count);
    if (warning)
        snprintf(expected, sizeof expected, "t.rt:%s: warning: %s%s\n", at->warning, warning,
                 times);
    ck_assert_msg(o->good && strcmp(o->messages, expected) == 0,
                  "of\n%s\nexpected was\n%s\nsaid is\n%s", text, expected, o->messages);
}

static void check_meaning(const outcome *o, const expectation *e, int count, bool whole,
                          const char *text)
{
    char plain[TEXT], pattern[TEXT];
    places unused = {"", ""};
    snprintf(pattern, sizeof pattern, "%s%s", whole ? "|" : "", e->reads ? e->reads : "");
    put_scene(plain, pattern, count, &unused);
    outcome other = read_by(plain, "42");
    ck_assert_msg(other.good, "%s\n%s", plain, other.messages);
    char *got = written_scene(&o->scene), *expected = written_scene(&other.scene);
    ck_assert_msg(strcmp(got, expected) == 0, "of\n%s\nread is\n%s\nand not\n%s", text, got,
                  expected);
    outcome placed = outcome_of_placement(&o->scene);
    ck_assert_msg(placed.good, "%s\n%s", text, placed.messages);
    outcome_free(&placed);
    outcome_free(&other);
    free(got);
    free(expected);
}

static void check_row(const char *pattern, const expectation *e)
{
    char text[TEXT];
    places at = {"", ""};
    bool whole = *pattern == '|';
    int count = e->refused || whole ? 1 : 1 + (int)drawn("k0", 0, 3);
    put_scene(text, pattern, count, &at);
    outcome strict = read_by(text, "strict"), lenient = read_by(text, "42");
    if (e->strict || e->unnamed)
        check_refusal(&strict, &at, text, e->strict ? e->strict : e->unnamed, e->strict);
    if (e->refused) {
        check_refusal(&strict, &at, text, e->refused, false);
        check_refusal(&lenient, &at, text, e->refused, false);
    } else {
        check_warnings(&lenient, e, &at, count, text);
        check_meaning(&lenient, e, count, whole, text);
        ck_assert(strict.good == !(e->strict || e->unnamed));
    }
    outcome_free(&strict);
    outcome_free(&lenient);
}

TEST(scenes_of_others)
{
    FILE *file = rows_open("scene/dialect.txt");
    text_row row;
    int accepted = 0, refused = 0;
    while (rows_next(file, &row)) {
        expectation e = expected_of(row.lines);
        for (seed = 1; seed <= SEEDS; seed++)
            check_row(row.text, &e);
        *(e.refused ? &refused : &accepted) += SEEDS;
    }
    fclose(file);
    ck_assert_int_gt(accepted, 500);
    ck_assert_int_gt(refused, 200);
}

/* What is no angle or side is a fault, and nothing else that is said to be left out. */
TEST(fault_of_a_form)
{
    static const char *const lines[][2] = {
        {"co 0,0,0 0,1,0 -3 300,0,0", "half-angle '-3' is out of range"},
        {"co 0,0,0 0,1,0 0 300,0,0", "half-angle '0' is out of range"},
        {"cu 0,0,0 1e999 300,0,0", "'1e999' is beyond the largest double"},
        {"cu 0,0,0 0,1,0 -inf 300,0,0", "'-inf' is not a number"},
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char text[TEXT];
        sprintf(text, "%s%s\n", HEAD, lines[i][0]);
        outcome o = read_by(text, "42");
        ck_assert_msg(!o.good && strstr(o.messages, lines[i][1]) &&
                          strstr(o.messages, "colour '300' is out of range") &&
                          !strstr(o.messages, "left out"),
                      "%s", o.messages);
        outcome_free(&o);
    }
}

/* A line that sets the dialect counts wherever it stands; what the command line says wins. */
TEST(dialect_by_a_line)
{
    static const char *const texts[] = {"#! dialect 42\n" HEAD "SUN 1\n",
                                        HEAD "SUN 1\n#! dialect 42\n"};
    const rt_options none = rt_default_options();
    for (int i = 0; i < 2; i++) {
        outcome by_line = outcome_of_text(texts[i], strlen(texts[i]), "t.rt", &none, 0);
        ck_assert_msg(by_line.good && strstr(by_line.messages, "warning: unknown word 'SUN'"), "%s",
                      by_line.messages);
        ck_assert(by_line.scene.options.handedness == RT_LEFT_HANDED &&
                  by_line.scene.options.cone_position == RT_POSITION_APEX);
        outcome strict = read_by(texts[i], "strict");
        ck_assert(!strict.good);
        outcome_free(&by_line);
        outcome_free(&strict);
    }
}

/* The dialect's own choices give way to a line of the scene and to the command line. */
TEST(dialect_and_other_options)
{
    const char *text = HEAD "#! handedness right\n#! cone-position middle\n";
    outcome o = read_by(text, "42");
    ck_assert(o.good && o.scene.options.handedness == RT_RIGHT_HANDED &&
              o.scene.options.cone_position == RT_POSITION_MIDDLE);
    outcome_free(&o);
}

TEST(light_that_falls_off_may_be_bright)
{
    outcome o = read_by(HEAD "#! falloff inverse-square\nL 0,0,0 1.5\n", "42");
    ck_assert(o.good && o.scene.lights[o.scene.light_count - 1].light.brightness == 1.5);
    outcome_free(&o);
}

/* A word in capitals has all the forms that it has in small letters. */
TEST(forms_in_capitals)
{
    outcome small = read_by(HEAD "co 1,2,3 0,0,1 45 9,8,7\n", "42");
    outcome capital = read_by(HEAD "CO 1,2,3 0,0,1 45 9,8,7\n", "42");
    ck_assert_msg(small.good && capital.good, "%s", capital.messages);
    char *expected = written_scene(&small.scene), *got = written_scene(&capital.scene);
    ck_assert_str_eq(got, expected);
    free(got);
    free(expected);
    outcome_free(&small);
    outcome_free(&capital);
}

SUITE("dialect")
