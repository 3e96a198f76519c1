/* SPDX-License-Identifier: MIT */
/* Reads .rt scenes (docs/scene_format.md), line by line, field by field.
 *
 * A fault is noted with its place and reading goes on behind it, so that one run names them all. */
#include "rt_reader.h"

#include <stdlib.h>
#include <string.h>

#define SIZE "a whole number from 1 to 65535", 1, RT_WHOLE_MAX

static const rt_field resolution[] = {
    RT_FIELD(WHOLE, rt_options, width, "width", SIZE),
    RT_FIELD(WHOLE, rt_options, height, "height", SIZE),
    {0},
};

/* Options: the command line wins, and a scene sets each of them once. */

static void set_by_scene(rt_reader *r, const char *place, const rt_options *options,
                         rt_options_set which)
{
    if (r->set_by_scene & which)
        rt_fault(r, place, "this option is set already; expected it once in a scene");
    r->set_by_scene |= which;
    rt_take_options(&r->scene.options, options, which);
}

#define OPTION_BYTES 32

/* A word longer than any option's becomes "", which is none either. */
static void copy_word(rt_word w, char text[OPTION_BYTES])
{
    size_t length = (size_t)(w.end - w.start);
    if (length >= OPTION_BYTES)
        length = 0;
    memcpy(text, w.start, length);
    text[length] = '\0';
}

/* The option that `name` stands for, and the word behind it, if any. */
static void read_option_called(rt_reader *r, rt_word name, const char *option)
{
    r->at = name.end;
    bool has_value = rt_more_fields(r);
    rt_word value = has_value ? rt_run_at(r, r->at) : name;
    r->at = value.end;
    char value_text[OPTION_BYTES];
    copy_word(value, value_text);
    rt_options options = r->scene.options;
    rt_options_set which = 0;
    const char *expected = rt_set_option(&options, &which, option, has_value ? value_text : NULL);
    if (expected) {
        rt_word both = {name.start, value.end};
        rt_fault(r, name.start, "option %s; expected %s", rt_quote(both).text, expected);
        return;
    }
    set_by_scene(r, name.start, &options, which);
    rt_expect_end(r);
}

static void read_option(rt_reader *r, rt_word name)
{
    char option[OPTION_BYTES];
    copy_word(name, option);
    read_option_called(r, name, option);
}

/* In dialect 42 its word is of letters of any case. */
static void read_falloff(rt_reader *r, rt_word identifier)
{
    read_option_called(r, identifier, "falloff");
}

static void read_resolution(rt_reader *r, rt_word identifier)
{
    rt_options options = r->scene.options;
    if (!rt_read_fields(r, resolution, &options))
        return;
    set_by_scene(r, identifier.start, &options, RT_SET(RT_SIZE));
    rt_expect_end(r);
}

/* Lines: what they start with tells what they are. */

/* A line by its first word, which is NULL for none: of a shape, if `read` is NULL. */
typedef struct {
    const char *word;
    void (*read)(rt_reader *, rt_word identifier);
    sure_shape shape;
} line_kind;

static const line_kind others[] = {
    {.word = "L", .read = rt_read_light},      {.word = "A", .read = rt_read_ambient},
    {.word = "C", .read = rt_read_camera},     {.word = "R", .read = read_resolution},
    {.word = "falloff", .read = read_falloff}, {.word = NULL},
};

/* The first kind of which the word is. */
static line_kind find_kind(rt_word w, bool (*is)(rt_word, const char *))
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (const char *const *known = rt_shapes[shape]->words; *known; known++) {
            if (is(w, *known))
                return (line_kind){*known, NULL, (sure_shape)shape};
        }
    }
    const line_kind *kind = others;
    while (kind->word && !is(w, kind->word))
        kind++;
    return *kind;
}

/* Another case of the known one, or it without the blank that should follow. */
static bool is_like(rt_word w, const char *known)
{
    size_t length = (size_t)(w.end - w.start), known_length = strlen(known);
    return known_length <= length && strncasecmp(known, w.start, known_length) == 0 &&
           (known_length == length || rt_starts_number(w.start[known_length]));
}

static bool is_all_lower_case(rt_word w)
{
    while (w.start < w.end && *w.start >= 'a' && *w.start <= 'z')
        w.start++;
    return w.start == w.end;
}

/* What dialect 42 leaves out: a word of text, or one that begins with two dashes. */
static bool is_name(rt_word w)
{
    const char *at = w.start;
    while (at<w.end && * at> ' ' && *at <= '~')
        at++;
    bool letter =
        w.start < w.end && (*w.start == '_' || ((*w.start | 32) >= 'a' && (*w.start | 32) <= 'z'));
    return at == w.end && (letter || (w.end - w.start >= 2 && memcmp(w.start, "--", 2) == 0));
}

static void complain_identifier(rt_reader *r, rt_word w)
{
    const char *known = find_kind(w, is_like).word;
    bool is_slip = known && w.start + strlen(known) < w.end; /* no blank behind it */
    if (w.start == w.end || (rt_starts_number(*w.start) && !(r->lenient && is_name(w))))
        rt_fault(r, w.start,
                 "a line that starts with %s; expected %s: an element stands on one line",
                 rt_quote(rt_run_at(r, w.start)).text, rt_identifiers().text);
    else if (is_slip)
        rt_fault(r, w.start, "unknown identifier %s; expected '%s' and a blank", rt_quote(w).text,
                 known);
    else if (r->lenient && is_name(w))
        rt_complain(&r->notes, RT_LIBERTY, rt_place_of(&r->notes, w.start),
                    "unknown word %s: its lines are left out", rt_quote(w).text);
    else if (known && !r->lenient)
        rt_may(r, w.start, NULL, "unknown identifier %s; expected '%s' and a blank",
               rt_quote(w).text, known);
    else if (is_all_lower_case(w))
        rt_complain(&r->notes, RT_UNKNOWN_SURFACE, rt_place_of(&r->notes, w.start), "%s",
                    rt_quote(w).text);
    else
        rt_complain(&r->notes, is_name(w) && !r->lenient ? RT_ERROR_BUT_IN_42 : RT_ERROR,
                    rt_place_of(&r->notes, w.start), "unknown identifier %s; expected %s",
                    rt_quote(w).text, rt_identifiers().text);
}

/* What dialect 42 takes it for: c and l, which it has; other slips with a warning; other forms. */
static line_kind find_kind_in_42(rt_reader *r, rt_word w)
{
    line_kind kind = find_kind(w, rt_is_word_in_any_case);
    if (kind.word && !rt_is_word(w, "c") && !rt_is_word(w, "l"))
        rt_complain(&r->notes, RT_LIBERTY, rt_place_of(&r->notes, w.start), "%s is read as '%s'",
                    rt_quote(w).text, kind.word);
    const char *start = r->at;
    r->at = w.end;
    if (!kind.word && rt_form_word(w, &kind.shape) && rt_form_of(r, w, kind.shape))
        kind.word = rt_shapes[kind.shape]->words[0];
    r->at = start;
    return kind;
}

static void read_fields(rt_reader *r)
{
    rt_word w = rt_word_at(r, r->at);
    line_kind kind = find_kind(w, rt_is_word);
    if (!kind.word && r->lenient)
        kind = find_kind_in_42(r, w);
    if (!kind.word) {
        complain_identifier(r, w);
        return;
    }
    r->at = w.end;
    if (r->at < r->end && *r->at == ',')
        rt_fault(r, r->at, "a comma after '%s'; expected a blank", kind.word);
    else if (kind.read)
        kind.read(r, w);
    else
        rt_read_shape(r, w, kind.shape);
}

static void read_line(rt_reader *r)
{
    size_t length = (size_t)(r->end - r->notes.line_start);
    if (length > RT_LONGEST_LINE) {
        rt_fault(r, r->notes.line_start + RT_LONGEST_LINE,
                 "a line of %zu bytes; expected at most %d", length, RT_LONGEST_LINE);
        return;
    }
    const char *nul = memchr(r->notes.line_start, '\0', length);
    if (nul) {
        rt_fault(r, nul, "a NUL byte; expected text");
        return;
    }
    r->at = r->notes.line_start;
    rt_skip_blanks(r);
    if (r->end - r->at >= 2 && r->at[0] == '#' && r->at[1] == '!') {
        r->at += 2;
        rt_skip_blanks(r);
        read_option(r, rt_run_at(r, r->at));
    } else if (rt_more_fields(r)) {
        read_fields(r);
    }
}

/* The text: its lines, and what is missing from it. */

/* Where a line starts whose one before ends at `at`: with LF, CR LF or CR, or with the text. */
static const char *next_line(const char *at, const char *text_end)
{
    bool both = text_end - at >= 2 && at[0] == '\r' && at[1] == '\n';
    return at == text_end ? at : at + 1 + both;
}

static void check_complete(rt_reader *r, const char *text_end)
{
    if (!r->ambient_at.line && r->lenient)
        rt_complain(&r->notes, RT_LIBERTY, rt_place_of(&r->notes, text_end),
                    "no ambient light: what no light reaches is black");
    else if (!r->ambient_at.line)
        rt_fault(r, text_end, "no ambient light; expected a line 'A ratio R,G,B'");
    if (r->camera_count == 0)
        rt_fault(r, text_end, "no camera; expected a line 'C position direction fov'");
    else if (r->camera_count < r->camera)
        rt_fault(r, text_end, "no camera %d, which an option asks for; expected 1%s%.0d", r->camera,
                 r->camera_count > 1 ? " to " : "", r->camera_count > 1 ? r->camera_count : 0);
    if (!r->has_light)
        rt_complain(&r->notes, RT_WARNING, rt_place_of(&r->notes, text_end),
                    "no light; the ambient light alone shows the scene");
}

static void read_lines(rt_reader *r, const char *text, size_t size)
{
    const char *text_end = text + size, *next = text;
    r->notes.line_start = text;
    r->notes.line_number = 1;
    if (size >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0)) {
        rt_fault(r, text, "text in UTF-16; expected UTF-8 or ASCII");
        return;
    }
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        next = r->notes.line_start = text + 3;
    while (next < text_end && !r->out_of_memory) {
        r->notes.line_start = next;
        for (r->end = next; r->end < text_end; r->end++)
            if (*r->end == '\n' || *r->end == '\r')
                break;
        next = next_line(r->end, text_end);
        read_line(r);
        if (next < text_end || text_end[-1] == '\n' || text_end[-1] == '\r') {
            r->notes.line_number++;
            r->notes.line_start = next;
        }
    }
    if (!r->out_of_memory)
        check_complete(r, text_end);
}

/* By the options that are known beforehand. */
static void read_under(rt_reader *r, const rt_options *known, const char *text, size_t size)
{
    r->lenient = known->dialect == RT_42;
    r->camera = known->camera;
    r->scene.options = rt_dialect_options(known->dialect);
    read_lines(r, text, size);
}

static void free_lists(rt_scene *scene)
{
    free(scene->lights);
    free(scene->elements);
    free(scene->materials);
}

/* A line anywhere in the text may set dialect and camera, which other lines are read by. Then it is
 * read again: with what is known now, nothing of this changes any more. */
void rt_read_known(rt_reader *r, const char *text, size_t size)
{
    const rt_reader before = *r;
    rt_options known = rt_default_options();
    rt_take_options(&known, r->options, r->set);
    read_under(r, &known, text, size);
    rt_options found = r->scene.options;
    rt_take_options(&found, r->options, r->set);
    if (found.dialect == known.dialect && found.camera == known.camera)
        return;
    free_lists(&r->scene);
    *r = before;
    read_under(r, &found, text, size);
}

bool rt_begin(rt_reader *r, const char *name, const rt_options *options, rt_options_set set,
              FILE *messages)
{
    *r = (rt_reader){.options = options, .set = set};
    r->notes.messages = messages;
    r->notes.line_start = "";
    r->notes.line_number = 1;
    r->notes.name = r->scene.name = rt_printable_name(name);
    r->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (r->notes.name && r->c_locale)
        return true;
    fprintf(messages, "error: no memory to read a scene\n");
    if (r->c_locale)
        freelocale(r->c_locale);
    free(r->notes.name);
    return false;
}

/* What a bright light is taken for where light does not fall off. */
static void dim_lights(rt_scene *scene)
{
    for (size_t i = 0; i < scene->light_count; i++) {
        double *brightness = &scene->lights[i].light.brightness;
        *brightness = *brightness > 1 ? 1 : *brightness;
    }
}

bool rt_finish(rt_reader *r, rt_scene *scene)
{
    rt_take_options(&r->scene.options, r->options, r->set);
    if (r->lenient && r->scene.options.falloff == SURE_FALLOFF_NONE)
        dim_lights(&r->scene);
    bool good = rt_report(&r->notes, &r->scene.options) == 0;
    freelocale(r->c_locale);
    if (good)
        *scene = r->scene;
    else
        rt_scene_free(&r->scene);
    return good;
}

bool rt_read_text(const char *text, size_t size, const char *name, const rt_options *options,
                  rt_options_set set, FILE *messages, rt_scene *scene)
{
    rt_reader r;
    if (!rt_begin(&r, name, options, set, messages))
        return false;
    rt_read_known(&r, text, size);
    return rt_finish(&r, scene);
}

void rt_scene_free(rt_scene *scene)
{
    free(scene->name);
    free_lists(scene);
    *scene = (rt_scene){0};
}
