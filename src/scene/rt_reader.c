/* Reads .rt scenes (docs/scene_format.md), line by line, field by field.
 *
 * A fault is noted with its place and reading goes on behind it, so that one run names them all. */
#include "rt_reader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

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

/* `name` and the word behind it, if any. */
static void read_option(rt_reader *r, rt_word name)
{
    r->at = name.end;
    bool has_value = rt_more_fields(r);
    rt_word value = has_value ? rt_run_at(r, r->at) : name;
    r->at = value.end;
    char name_text[OPTION_BYTES], value_text[OPTION_BYTES];
    copy_word(name, name_text);
    copy_word(value, value_text);
    rt_options options = r->scene.options;
    rt_options_set which = 0;
    const char *expected =
        rt_set_option(&options, &which, name_text, has_value ? value_text : NULL);
    if (expected) {
        rt_word both = {name.start, value.end};
        rt_fault(r, name.start, "option %s; expected %s", rt_quote(both).text, expected);
        return;
    }
    set_by_scene(r, name.start, &options, which);
    rt_expect_end(r);
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
    {.word = "L", .read = rt_read_light},     {.word = "A", .read = rt_read_ambient},
    {.word = "C", .read = rt_read_camera},    {.word = "R", .read = read_resolution},
    {.word = "falloff", .read = read_option}, {.word = NULL},
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

static void complain_identifier(rt_reader *r, rt_word w)
{
    const char *known = find_kind(w, is_like).word;
    if (w.start == w.end || rt_starts_number(*w.start))
        rt_fault(r, w.start,
                 "a line that starts with %s; expected %s: an element stands on one line",
                 rt_quote(rt_run_at(r, w.start)).text, rt_identifiers().text);
    else if (known)
        rt_fault(r, w.start, "unknown identifier %s; expected '%s' and a blank", rt_quote(w).text,
                 known);
    else if (is_all_lower_case(w))
        rt_complain(&r->notes, RT_UNKNOWN_SURFACE, rt_place_of(&r->notes, w.start), "%s",
                    rt_quote(w).text);
    else
        rt_fault(r, w.start, "unknown identifier %s; expected %s", rt_quote(w).text,
                 rt_identifiers().text);
}

static void read_fields(rt_reader *r)
{
    rt_word w = rt_word_at(r, r->at);
    line_kind kind = find_kind(w, rt_is_word);
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
    if (!r->ambient_at.line)
        rt_fault(r, text_end, "no ambient light; expected a line 'A ratio R,G,B'");
    if (!r->scene.camera_at.line)
        rt_fault(r, text_end, "no camera; expected a line 'C position direction fov'");
    if (!r->has_light)
        rt_complain(&r->notes, RT_WARNING, rt_place_of(&r->notes, text_end),
                    "no light; the ambient light alone shows the scene");
}

static void read_text(rt_reader *r, const char *text, size_t size)
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

static bool begin(rt_reader *r, const char *name, const rt_options *options, rt_options_set set,
                  FILE *messages)
{
    *r = (rt_reader){.options = options, .set = set};
    r->notes.messages = messages;
    r->notes.line_number = 1;
    r->scene.options = rt_default_options();
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

static bool finish(rt_reader *r, rt_scene *scene)
{
    rt_take_options(&r->scene.options, r->options, r->set);
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
    if (!begin(&r, name, options, set, messages))
        return false;
    read_text(&r, text, size);
    return finish(&r, scene);
}

/* Files. */

/* All bytes up to the end of the file or pipe, whatever its size was said to be; to be freed,
 * whatever is returned: what is wrong, and what was expected, or NULL. */
static const char *read_all(FILE *file, char **text, size_t *size, const char **expected)
{
    struct stat about;
    *expected = "a scene that can be read";
    if (!file || fstat(fileno(file), &about) != 0)
        return strerror(errno);
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) {
        *expected = "a scene file";
        return S_ISDIR(about.st_mode) ? "a directory" : "neither a file nor a pipe";
    }
    char *larger;
    for (size_t room = (size_t)about.st_size + 4096; (larger = realloc(*text, room)); room *= 2) {
        *text = larger;
        *size += fread(larger + *size, 1, room - *size, file);
        if (*size < room)
            return ferror(file) ? strerror(errno) : NULL;
    }
    *expected = "a smaller scene";
    return "no memory for more";
}

bool rt_read(const char *path, const rt_options *options, rt_options_set set, FILE *messages,
             rt_scene *scene)
{
    static const char nowhere[] = "";
    const char *expected, *dot = strrchr(path, '.');
    char *text = NULL;
    size_t size = 0;
    rt_reader r;
    if (!begin(&r, path, options, set, messages))
        return false;
    r.notes.line_start = nowhere;
    FILE *file = fopen(path, "r");
    const char *wrong = read_all(file, &text, &size, &expected);
    if (wrong)
        rt_fault(&r, nowhere, "%s; expected %s", wrong, expected);
    else if (!dot || strcmp(dot, ".rt") != 0)
        rt_complain(&r.notes, RT_WARNING, rt_place_of(&r.notes, nowhere),
                    "the file's name does not end in .rt");
    if (!wrong)
        read_text(&r, text, size);
    if (file)
        fclose(file);
    free(text);
    return finish(&r, scene);
}

void rt_scene_free(rt_scene *scene)
{
    free(scene->name);
    free(scene->lights);
    free(scene->elements);
    free(scene->materials);
    *scene = (rt_scene){0};
}
