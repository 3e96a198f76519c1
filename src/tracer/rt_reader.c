/* Reads .rt scenes (docs/scene_format.md), line by line, field by field.
 *
 * A fault is noted with its place and reading goes on behind it, so that one run names them all. A
 * number at fault becomes NaN, which passes every later check: no fault is named twice. */
#define _GNU_SOURCE /* strtod_l */

#include "rt.h"

#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#define LONGEST_LINE 65535 /* bytes */
#define LARGEST_WHOLE 65535
#define PLACE "%s:%zu:%zu: "

static const char identifiers[] =
    "one of A, C, L, R, falloff, sp, pl, cy, co (or cn, con, cone)";

/* Whether the last two are errors is known only when the whole scene is read. */
typedef enum { ERROR, WARNING, BRIGHT_LIGHT, UNKNOWN_SURFACE, VERDICTS } verdict;

typedef struct {
    size_t line, column;
    verdict verdict;
    char text[256];
} note;

typedef struct {
    char *name; /* of the file, without control characters */
    FILE *messages;
    const rt_options *options; /* of the command line */
    const rt_options_set *set;
    locale_t c_locale;

    size_t line;
    const char *line_start, *at, *end; /* of the line; `at` is what is read next */
    bool out_of_memory;

    rt_scene scene;
    size_t light_capacity, element_capacity;
    rt_options_set set_by_scene;
    size_t ambient_line; /* 0: none seen */
    bool has_light, refracts;

    note notes[VERDICTS * RT_ERRORS_SHOWN]; /* in the order of the text */
    size_t note_count, counts[VERDICTS];
} reader;

typedef struct {
    const char *start, *end;
} word;

/* A field of one number: what it is called and which numbers it takes. */
typedef struct {
    const char *name, *expected;
    double low, high;
    bool open; /* low and high themselves are refused */
} field;

static const field position = {.name = "position", .expected = "x,y,z"};
static const field direction = {.name = "direction", .expected = "x,y,z, not all zero"};
static const field normal = {.name = "normal", .expected = "x,y,z, not all zero"};
static const field axis = {.name = "axis", .expected = "x,y,z, not all zero"};
static const field color = {"colour", "R,G,B, whole numbers from 0 to 255", 0, 255, false};
static const field ambient_ratio = {"ambient ratio", "a number from 0 to 1", 0, 1, false};
static const field light_ratio = {"light ratio", "a number from 0 to 1", 0, INFINITY, false};
static const field view = {"field of view", "degrees above 0 and below 180", 0, 180, true};
static const field diameter = {"diameter", "a number above 0", 0, INFINITY, true};
static const field height = {"height", "a number above 0", 0, INFINITY, true};
static const field columns = {"width", "a whole number from 1 to 65535", 1, LARGEST_WHOLE, false};
static const field rows = {"height", "a whole number from 1 to 65535", 1, LARGEST_WHOLE, false};
static const field spec = {"spec", "a number from 0 to 1", 0, 1, false};
static const field refl = {"refl", "a number from 0 to 1", 0, 1, false};
static const field refr = {"refr", "an index of refraction from 1", 1, INFINITY, false};
static const field shine = {"shine", "a whole number from 0 to 65535", 0, LARGEST_WHOLE, false};

/* Notes: what is said about the scene, kept until its options are settled. */

#define QUOTED_BYTES 24

typedef struct {
    char text[4 * QUOTED_BYTES + sizeof "''..."];
} quotation;

/* The word in quotes, cut short, with no byte that a terminal could take for anything but text. */
static quotation quote(word w)
{
    quotation q;
    size_t length = (size_t)(w.end - w.start);
    size_t shown = length < QUOTED_BYTES ? length : QUOTED_BYTES;
    char *out = q.text;
    *out++ = '\'';
    for (size_t i = 0; i < shown; i++) {
        unsigned char byte = (unsigned char)w.start[i];
        if (byte >= ' ' && byte < 0x7f)
            *out++ = (char)byte;
        else
            out += sprintf(out, "\\x%02x", byte);
    }
    strcpy(out, shown < length ? "...'" : "'");
    return q;
}

static char *without_controls(const char *name)
{
    char *copy = malloc(4 * strlen(name) + 1), *out = copy;
    if (!copy)
        return NULL;
    for (; *name; name++) {
        unsigned char byte = (unsigned char)*name;
        if (byte < ' ' || byte == 0x7f)
            out += sprintf(out, "\\x%02x", byte);
        else
            *out++ = *name;
    }
    *out = '\0';
    return copy;
}

/* At least the first RT_ERRORS_SHOWN of each verdict are kept, so those of all errors are among
 * them whatever the pending ones turn out to be. */
__attribute__((format(printf, 4, 5))) static void complain(reader *r, verdict what,
                                                           const char *place, const char *format,
                                                           ...)
{
    if (r->counts[what]++ >= RT_ERRORS_SHOWN)
        return;
    note *n = &r->notes[r->note_count++];
    n->line = r->line;
    n->column = (size_t)(place - r->line_start) + 1;
    n->verdict = what;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(n->text, sizeof n->text, format, arguments);
    va_end(arguments);
}

static void print_error(const reader *r, const note *n)
{
    fprintf(r->messages, PLACE "error: ", r->name, n->line, n->column);
    if (n->verdict == UNKNOWN_SURFACE)
        fprintf(r->messages, "unknown surface %s; expected %s, or the option skip-unknown\n",
                n->text, identifiers);
    else
        fprintf(r->messages, "%s\n", n->text);
}

static void print_warning(const reader *r, const note *n)
{
    fprintf(r->messages, PLACE "warning: ", r->name, n->line, n->column);
    if (n->verdict == UNKNOWN_SURFACE)
        fprintf(r->messages, "unknown surface %s is left out\n", n->text);
    else
        fprintf(r->messages, "%s\n", n->text);
}

/* Writes the notes, now that the options are settled. Returns the number of errors. */
static size_t report(const reader *r)
{
    const bool is_error[VERDICTS] = {
        [ERROR] = true,
        [BRIGHT_LIGHT] = r->scene.options.falloff == SURE_FALLOFF_NONE,
        [UNKNOWN_SURFACE] = !r->scene.options.skip_unknown,
    };
    const bool is_warning[VERDICTS] = {
        [WARNING] = true,
        [UNKNOWN_SURFACE] = r->scene.options.skip_unknown,
    };
    size_t errors = 0, shown = 0;
    for (int v = 0; v < VERDICTS; v++)
        errors += is_error[v] ? r->counts[v] : 0;
    for (size_t i = 0; i < r->note_count; i++) {
        const note *n = &r->notes[i];
        if (is_warning[n->verdict])
            print_warning(r, n);
        else if (is_error[n->verdict] && shown++ < RT_ERRORS_SHOWN)
            print_error(r, n);
    }
    size_t left_out = r->counts[UNKNOWN_SURFACE];
    if (is_warning[UNKNOWN_SURFACE] && left_out > RT_ERRORS_SHOWN)
        fprintf(r->messages, "%s: warning: %zu more unknown surface%s left out\n", r->name,
                left_out - RT_ERRORS_SHOWN, left_out - RT_ERRORS_SHOWN == 1 ? " is" : "s are");
    if (errors > RT_ERRORS_SHOWN)
        fprintf(r->messages, "%s: %zu more error%s\n", r->name, errors - RT_ERRORS_SHOWN,
                errors - RT_ERRORS_SHOWN == 1 ? "" : "s");
    return errors;
}

/* Words: what stands between blanks, commas, comments and line ends. */

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_lower_case(char c)
{
    return c >= 'a' && c <= 'z';
}

/* The end of the line, or a comment, which is as good. */
static bool ends_line(const reader *r, const char *at)
{
    return at == r->end || *at == '#' || (*at == '/' && at + 1 < r->end && at[1] == '/');
}

static bool ends_word(const reader *r, const char *at)
{
    return ends_line(r, at) || is_blank(*at) || *at == ',';
}

static void skip_blanks(reader *r)
{
    while (r->at < r->end && is_blank(*r->at))
        r->at++;
}

static bool more_fields(reader *r)
{
    skip_blanks(r);
    return !ends_line(r, r->at);
}

static word word_at(const reader *r, const char *start)
{
    word w = {start, start};
    while (!ends_word(r, w.end))
        w.end++;
    return w;
}

/* As word_at, with commas as a part of it. */
static word run_at(const reader *r, const char *start)
{
    word w = {start, start};
    while (!ends_line(r, w.end) && !is_blank(*w.end))
        w.end++;
    return w;
}

static bool is_word(word w, const char *text)
{
    size_t length = (size_t)(w.end - w.start);
    return strlen(text) == length && memcmp(w.start, text, length) == 0;
}

/* Numbers: the grammar is checked here; what one division can't round is left to strtod. */

/* Most numbers in scenes have so few digits that digits and power of ten are exact doubles; then
 * one division rounds correctly. False where this is not so, or not a number at all. */
static bool short_decimal(const reader *r, const char *at, const char **behind, double *value)
{
    static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                  1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
    bool negative = at < r->end && *at == '-';
    if (at < r->end && (*at == '-' || *at == '+'))
        at++;
    uint64_t digits = 0;
    const char *start = at;
    for (; at < r->end && is_digit(*at); at++)
        digits = 10 * digits + (uint64_t)(*at - '0');
    ptrdiff_t count = at - start, decimals = 0;
    if (at < r->end && *at == '.') {
        start = ++at;
        for (; at < r->end && is_digit(*at); at++)
            digits = 10 * digits + (uint64_t)(*at - '0');
        decimals = at - start;
    }
    count += decimals;
    if (count == 0 || count > 19 || digits > UINT64_C(1) << 53 || !ends_word(r, at))
        return false;
    double magnitude = (double)digits / tens[decimals];
    *value = negative ? -magnitude : magnitude;
    *behind = at;
    return true;
}

static size_t skip_digits(word *w, bool hexadecimal)
{
    const char *start = w->start;
    while (w->start < w->end &&
           (is_digit(*w->start) ||
            (hexadecimal && (*w->start | 32) >= 'a' && (*w->start | 32) <= 'f')))
        w->start++;
    return (size_t)(w->start - start);
}

static void skip_sign(word *w)
{
    if (w->start < w->end && (*w->start == '+' || *w->start == '-'))
        w->start++;
}

/* Decimal or hexadecimal, but none of strtod's words for infinity and NaN. */
static bool is_number(word w)
{
    skip_sign(&w);
    bool hexadecimal = w.end - w.start > 2 && w.start[0] == '0' && (w.start[1] | 32) == 'x';
    if (hexadecimal)
        w.start += 2;
    size_t digits = skip_digits(&w, hexadecimal);
    if (w.start < w.end && *w.start == '.') {
        w.start++;
        digits += skip_digits(&w, hexadecimal);
    }
    if (digits == 0)
        return false;
    if (w.start < w.end && (*w.start | 32) == (hexadecimal ? 'p' : 'e')) {
        w.start++;
        skip_sign(&w);
        if (skip_digits(&w, false) == 0)
            return false;
    }
    return w.start == w.end;
}

/* Correctly rounded; the text need not end in NUL, strtod's does. */
static double convert(const reader *r, word w)
{
    char text[LONGEST_LINE + 1];
    size_t length = (size_t)(w.end - w.start);
    memcpy(text, w.start, length);
    text[length] = '\0';
    return strtod_l(text, NULL, r->c_locale);
}

/* No number where one should be: the line ends or there is a comma. */
static void complain_missing(reader *r, const field *f)
{
    bool ended = ends_line(r, r->at);
    complain(r, ERROR, r->at, "%s; expected the %s, %s",
             ended               ? "the line ends here"
             : is_blank(*r->at) ? "a blank"
                                 : "a comma without a number before it",
             f->name, f->expected);
}

/* Reads the number at r->at. False, after an error, when the rest of the line makes no sense. */
static bool read_number(reader *r, const field *f, double *value)
{
    if (short_decimal(r, r->at, &r->at, value))
        return true;
    word w = word_at(r, r->at);
    if (w.start == w.end) {
        complain_missing(r, f);
        return false;
    }
    r->at = w.end;
    *value = is_number(w) ? convert(r, w) : NAN;
    if (isnan(*value))
        complain(r, ERROR, w.start, "%s is not a number; expected the %s, %s", quote(w).text,
                 f->name, f->expected);
    if (isinf(*value)) {
        complain(r, ERROR, w.start, "%s is beyond the largest double, 1.8e308; expected the %s, %s",
                 quote(w).text, f->name, f->expected);
        *value = NAN;
    }
    return true;
}

static bool out_of_range(const field *f, double value)
{
    return value < f->low || value > f->high ||
           (f->open && (value == f->low || value == f->high));
}

/* Is it 0 by rounding only? */
static bool underflows(word w, double value)
{
    if (value != 0)
        return false;
    while (w.start < w.end && strchr("+-.0xX", *w.start))
        w.start++;
    return w.start < w.end && (*w.start | 32) != 'e' && (*w.start | 32) != 'p';
}

static void check_range(reader *r, const field *f, const char *start, double value)
{
    if (!out_of_range(f, value))
        return;
    word w = word_at(r, start);
    complain(r, ERROR, start, "%s %s %s; expected %s", f->name, quote(w).text,
             underflows(w, value) ? "rounds to 0" : "is out of range", f->expected);
}

/* As read_number, for digits with an optional sign only. */
static bool read_whole(reader *r, const field *f, double *value)
{
    word w = word_at(r, r->at), digits = w;
    if (w.start == w.end) {
        complain_missing(r, f);
        return false;
    }
    r->at = w.end;
    skip_sign(&digits);
    int magnitude = 0;
    const char *at = digits.start;
    for (; at < w.end && is_digit(*at); at++)
        magnitude = magnitude > LARGEST_WHOLE ? magnitude : 10 * magnitude + (*at - '0');
    if (digits.start == w.end || at < w.end) {
        complain(r, ERROR, w.start, "%s is not a whole number; expected the %s, %s", quote(w).text,
                 f->name, f->expected);
        *value = NAN;
        return true;
    }
    *value = *w.start == '-' ? -magnitude : magnitude;
    check_range(r, f, w.start, *value);
    return true;
}

/* Fields: numbers with their range, and three of them. */

static bool blank_follows(reader *r, const field *f)
{
    if (r->at == r->end || *r->at != ',')
        return true;
    complain(r, ERROR, r->at, "a comma after the %s; expected a blank", f->name);
    return false;
}

static bool read_value(reader *r, const field *f, double *value)
{
    const char *start = r->at;
    if (!read_number(r, f, value) || !blank_follows(r, f))
        return false;
    check_range(r, f, start, *value);
    return true;
}

static bool read_scalar(reader *r, const field *f, double *value)
{
    skip_blanks(r);
    return read_value(r, f, value);
}

static bool read_integer(reader *r, const field *f, int *value)
{
    double whole;
    if (!read_whole(r, f, &whole) || !blank_follows(r, f))
        return false;
    *value = isnan(whole) || out_of_range(f, whole) ? 0 : (int)whole;
    return true;
}

/* Three numbers with a comma between them, and perhaps blanks behind the comma. */
static bool read_triple(reader *r, const field *f,
                        bool (*read_part)(reader *, const field *, double *), sure_vec3 *triple)
{
    double parts[3];
    skip_blanks(r);
    const char *start = r->at;
    for (int i = 0; i < 3; i++) {
        if (!read_part(r, f, &parts[i]))
            return false;
        if (i == 2)
            break;
        if (r->at == r->end || *r->at != ',') {
            complain(r, ERROR, start, "%s of %s; expected three parts, %s", f->name,
                     i == 0 ? "one part" : "two parts", f->expected);
            return false;
        }
        r->at++;
        skip_blanks(r);
    }
    if (r->at < r->end && *r->at == ',') {
        complain(r, ERROR, r->at, "a comma after three parts; expected the %s, %s", f->name,
                 f->expected);
        return false;
    }
    *triple = (sure_vec3){parts[0], parts[1], parts[2]};
    return true;
}

static bool read_vector(reader *r, const field *f, sure_vec3 *vector)
{
    return read_triple(r, f, read_number, vector);
}

static bool read_direction(reader *r, const field *f, sure_vec3 *vector)
{
    skip_blanks(r);
    const char *start = r->at;
    if (!read_vector(r, f, vector))
        return false;
    if (vector->x == 0 && vector->y == 0 && vector->z == 0)
        complain(r, ERROR, start, "%s is zero in double precision; expected %s", f->name,
                 f->expected);
    return true;
}

static bool read_color(reader *r, sure_vec3 *linear)
{
    if (!read_triple(r, &color, read_whole, linear))
        return false;
    *linear = (sure_vec3){linear->x / 255, linear->y / 255, linear->z / 255};
    return true;
}

static void expect_end(reader *r)
{
    if (more_fields(r))
        complain(r, ERROR, r->at, "%s after the last field; expected the end of the line",
                 quote(run_at(r, r->at)).text);
    else if (r->end - r->at >= 2 && r->at[0] == '#' && r->at[1] == '!')
        complain(r, ERROR, r->at, "an option behind fields; expected '#!' on a line of its own");
}

/* Materials: words behind the colour. */

static bool read_once(reader *r, word label, bool *seen)
{
    if (*seen) {
        complain(r, ERROR, label.start, "a second %s; expected it once", quote(label).text);
        return false;
    }
    *seen = true;
    return true;
}

static bool read_refraction(reader *r, word label, double *index)
{
    if (!r->refracts)
        complain(r, WARNING, label.start,
                 "refr: transparency is not traced yet; the surface is shown opaque");
    r->refracts = true;
    return read_value(r, &refr, index);
}

/* spec:0.5 shine:32 refl:0.3 refr:1.5, any of them in any order. */
static bool read_material(reader *r, sure_material *material)
{
    bool has_spec = false, has_shine = false, has_refl = false, has_refr = false;
    while (more_fields(r)) {
        word w = word_at(r, r->at);
        const char *colon = memchr(w.start, ':', (size_t)(w.end - w.start));
        word label = {w.start, colon ? colon : w.end};
        r->at = colon ? colon + 1 : w.start;
        bool going_on = false;
        if (colon && is_word(label, "spec"))
            going_on = read_once(r, label, &has_spec) && read_value(r, &spec, &material->specular);
        else if (colon && is_word(label, "shine"))
            going_on = read_once(r, label, &has_shine) && read_integer(r, &shine, &material->shine);
        else if (colon && is_word(label, "refl"))
            going_on = read_once(r, label, &has_refl) && read_value(r, &refl, &material->mirror);
        else if (colon && is_word(label, "refr"))
            going_on = read_once(r, label, &has_refr) &&
                       read_refraction(r, label, &material->refract);
        else
            complain(r, ERROR, w.start,
                     "%s after the colour; expected spec:, shine:, refl:, refr: or the end of the "
                     "line",
                     quote(run_at(r, w.start)).text);
        if (!going_on)
            return false;
    }
    return true;
}

/* Lines: one function an element. */

static void run_out_of_memory(reader *r)
{
    r->out_of_memory = true;
    complain(r, ERROR, r->line_start, "no memory for more; expected a smaller scene");
}

/* The array with room for `capacity` items; NULL, with the array kept, if there is none. */
static void *grown(void *array, size_t capacity, size_t size)
{
    return capacity > SIZE_MAX / size ? NULL : realloc(array, capacity * size);
}

static void add_light(reader *r, const sure_light *light)
{
    rt_scene *scene = &r->scene;
    if (scene->light_count == r->light_capacity) {
        size_t capacity = r->light_capacity ? 2 * r->light_capacity : 16;
        sure_light *lights = grown(scene->lights, capacity, sizeof *lights);
        if (!lights) {
            run_out_of_memory(r);
            return;
        }
        scene->lights = lights;
        r->light_capacity = capacity;
    }
    scene->lights[scene->light_count++] = *light;
}

static bool reserve_element(reader *r)
{
    rt_scene *scene = &r->scene;
    if (scene->element_count < r->element_capacity)
        return true;
    size_t capacity = r->element_capacity ? 2 * r->element_capacity : 64;
    rt_element *elements = grown(scene->elements, capacity, sizeof *elements);
    if (elements)
        scene->elements = elements;
    sure_material *materials = grown(scene->materials, capacity, sizeof *materials);
    if (materials)
        scene->materials = materials;
    if (!elements || !materials)
        return false;
    r->element_capacity = capacity;
    return true;
}

static void add_element(reader *r, const rt_element *element, const sure_material *material)
{
    rt_scene *scene = &r->scene;
    if (!reserve_element(r)) {
        run_out_of_memory(r);
        return;
    }
    scene->elements[scene->element_count] = *element;
    scene->materials[scene->element_count++] = *material;
}

static void read_ambient(reader *r, word identifier)
{
    if (r->ambient_line)
        complain(r, ERROR, identifier.start, "a second A; expected one, it is on line %zu",
                 r->ambient_line);
    else
        r->ambient_line = r->line;
    if (read_scalar(r, &ambient_ratio, &r->scene.ambient_ratio) &&
        read_color(r, &r->scene.ambient_color))
        expect_end(r);
}

static void read_camera(reader *r, word identifier)
{
    rt_scene *scene = &r->scene;
    if (scene->camera_line) {
        complain(r, ERROR, identifier.start, "a second C; expected one, it is on line %zu",
                 scene->camera_line);
    } else {
        scene->camera_line = r->line;
        scene->camera_column = (size_t)(identifier.start - r->line_start) + 1;
    }
    if (read_vector(r, &position, &scene->camera_position) &&
        read_direction(r, &direction, &scene->camera_direction) &&
        read_scalar(r, &view, &scene->camera_fov))
        expect_end(r);
}

static void read_light(reader *r, word identifier)
{
    (void)identifier;
    r->has_light = true;
    sure_light light = {.color = {1, 1, 1}};
    if (!read_vector(r, &position, &light.position))
        return;
    skip_blanks(r);
    const char *ratio = r->at;
    if (!read_scalar(r, &light_ratio, &light.brightness))
        return;
    if (light.brightness > 1)
        complain(r, BRIGHT_LIGHT, ratio,
                 "light ratio %s is out of range; expected a number from 0 to 1 (with falloff "
                 "inverse-square, from 0)",
                 quote(word_at(r, ratio)).text);
    if (more_fields(r) && !read_color(r, &light.color))
        return;
    expect_end(r);
    add_light(r, &light);
}

static void read_element(reader *r, word identifier, sure_shape shape)
{
    rt_element element = {.shape = shape,
                          .line = r->line,
                          .column = (size_t)(identifier.start - r->line_start) + 1};
    sure_material material = {.shine = 32};
    bool has_height = shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
    if (!read_vector(r, &position, &element.position))
        return;
    if (shape != SURE_SHAPE_SPHERE &&
        !read_direction(r, shape == SURE_SHAPE_PLANE ? &normal : &axis, &element.axis))
        return;
    if (shape != SURE_SHAPE_PLANE && !read_scalar(r, &diameter, &element.diameter))
        return;
    if (has_height && !read_scalar(r, &height, &element.height))
        return;
    if (!read_color(r, &material.color) || !read_material(r, &material))
        return;
    expect_end(r);
    add_element(r, &element, &material);
}

static void read_sphere(reader *r, word identifier)
{
    read_element(r, identifier, SURE_SHAPE_SPHERE);
}

static void read_plane(reader *r, word identifier)
{
    read_element(r, identifier, SURE_SHAPE_PLANE);
}

static void read_cylinder(reader *r, word identifier)
{
    read_element(r, identifier, SURE_SHAPE_CYLINDER);
}

static void read_cone(reader *r, word identifier)
{
    read_element(r, identifier, SURE_SHAPE_CONE);
}

static void take_options(rt_options *to, const rt_options *from, const rt_options_set *which)
{
    if (which->handedness)
        to->handedness = from->handedness;
    if (which->fov)
        to->fov = from->fov;
    if (which->cylinder_position)
        to->cylinder_position = from->cylinder_position;
    if (which->cone_position)
        to->cone_position = from->cone_position;
    if (which->falloff)
        to->falloff = from->falloff;
    if (which->skip_unknown)
        to->skip_unknown = from->skip_unknown;
    if (which->size) {
        to->width = from->width;
        to->height = from->height;
    }
}

/* Adds the one option of `which`; false when it is there already. */
static bool set_once(rt_options_set *set, const rt_options_set *which)
{
    bool twice = (set->handedness && which->handedness) || (set->fov && which->fov) ||
                 (set->cylinder_position && which->cylinder_position) ||
                 (set->cone_position && which->cone_position) ||
                 (set->falloff && which->falloff) || (set->skip_unknown && which->skip_unknown) ||
                 (set->size && which->size);
    set->handedness |= which->handedness;
    set->fov |= which->fov;
    set->cylinder_position |= which->cylinder_position;
    set->cone_position |= which->cone_position;
    set->falloff |= which->falloff;
    set->skip_unknown |= which->skip_unknown;
    set->size |= which->size;
    return !twice;
}

static void set_by_scene(reader *r, const char *place, const rt_options *options,
                         const rt_options_set *which)
{
    if (!set_once(&r->set_by_scene, which))
        complain(r, ERROR, place, "this option is set already; expected it once in a scene");
    take_options(&r->scene.options, options, which);
}

#define OPTION_BYTES 32

/* A word longer than any option's becomes "", which is none either. */
static void copy_word(word w, char text[OPTION_BYTES])
{
    size_t length = (size_t)(w.end - w.start);
    if (length >= OPTION_BYTES)
        length = 0;
    memcpy(text, w.start, length);
    text[length] = '\0';
}

/* `name` and the word behind it, if any. */
static void read_option(reader *r, word name)
{
    r->at = name.end;
    bool has_value = more_fields(r);
    word value = has_value ? run_at(r, r->at) : name;
    r->at = value.end;
    char name_text[OPTION_BYTES], value_text[OPTION_BYTES];
    copy_word(name, name_text);
    copy_word(value, value_text);
    rt_options options = r->scene.options;
    rt_options_set which = {0};
    const char *expected =
        rt_set_option(&options, &which, name_text, has_value ? value_text : NULL);
    if (expected) {
        word both = {name.start, value.end};
        complain(r, ERROR, name.start, "option %s; expected %s", quote(both).text, expected);
        return;
    }
    set_by_scene(r, name.start, &options, &which);
    expect_end(r);
}

static void read_falloff(reader *r, word identifier)
{
    read_option(r, identifier);
}

static void read_resolution(reader *r, word identifier)
{
    rt_options options = r->scene.options;
    skip_blanks(r);
    if (!read_integer(r, &columns, &options.width))
        return;
    skip_blanks(r);
    if (!read_integer(r, &rows, &options.height))
        return;
    set_by_scene(r, identifier.start, &options, &(rt_options_set){.size = true});
    expect_end(r);
}

static const struct {
    const char *identifier;
    void (*read)(reader *, word identifier);
} elements[] = {
    {"sp", read_sphere},  {"pl", read_plane},   {"cy", read_cylinder},   {"co", read_cone},
    {"cn", read_cone},    {"con", read_cone},   {"cone", read_cone},     {"L", read_light},
    {"A", read_ambient},  {"C", read_camera},   {"R", read_resolution},  {"falloff", read_falloff},
};

#define ELEMENTS (sizeof elements / sizeof *elements)

/* The known identifier that the word looks like: another case of it, or it without the blank that
 * should follow; NULL if none. */
static const char *likeness(word w)
{
    size_t length = (size_t)(w.end - w.start);
    for (size_t i = 0; i < ELEMENTS; i++) {
        const char *known = elements[i].identifier;
        size_t known_length = strlen(known);
        if (known_length > length || strncasecmp(known, w.start, known_length) != 0)
            continue;
        if (known_length == length || is_digit(w.start[known_length]) ||
            strchr("+-.", w.start[known_length]))
            return known;
    }
    return NULL;
}

static bool is_all_lower_case(word w)
{
    while (w.start < w.end && is_lower_case(*w.start))
        w.start++;
    return w.start == w.end;
}

static void complain_identifier(reader *r, word w)
{
    const char *known = likeness(w);
    if (w.start == w.end || is_digit(*w.start) || strchr("+-.", *w.start))
        complain(r, ERROR, w.start,
                 "a line that starts with %s; expected %s: an element stands on one line",
                 quote(run_at(r, w.start)).text, identifiers);
    else if (known)
        complain(r, ERROR, w.start, "unknown identifier %s; expected '%s' and a blank",
                 quote(w).text, known);
    else if (is_all_lower_case(w))
        complain(r, UNKNOWN_SURFACE, w.start, "%s", quote(w).text);
    else
        complain(r, ERROR, w.start, "unknown identifier %s; expected %s", quote(w).text,
                 identifiers);
}

static void read_fields(reader *r)
{
    word w = word_at(r, r->at);
    for (size_t i = 0; i < ELEMENTS; i++) {
        if (is_word(w, elements[i].identifier)) {
            r->at = w.end;
            if (r->at < r->end && *r->at == ',')
                complain(r, ERROR, r->at, "a comma after '%s'; expected a blank",
                         elements[i].identifier);
            else
                elements[i].read(r, w);
            return;
        }
    }
    complain_identifier(r, w);
}

static void read_line(reader *r)
{
    size_t length = (size_t)(r->end - r->line_start);
    if (length > LONGEST_LINE) {
        complain(r, ERROR, r->line_start + LONGEST_LINE,
                 "a line of %zu bytes; expected at most %d", length, LONGEST_LINE);
        return;
    }
    const char *nul = memchr(r->line_start, '\0', length);
    if (nul) {
        complain(r, ERROR, nul, "a NUL byte; expected text");
        return;
    }
    r->at = r->line_start;
    skip_blanks(r);
    if (r->end - r->at >= 2 && r->at[0] == '#' && r->at[1] == '!') {
        r->at += 2;
        skip_blanks(r);
        read_option(r, run_at(r, r->at));
    } else if (!ends_line(r, r->at)) {
        read_fields(r);
    }
}

/* The text: its lines, and what is missing from it. */

/* Finds the end of the line that starts at `start`: LF, CR LF or CR. *lf is the first LF from there
 * on (or the end of the text), kept between calls so that a text of CRs is not searched for LFs
 * again and again. Returns where the next line starts. */
static const char *find_line_end(const char *start, const char *text_end, const char **lf,
                                 const char **line_end)
{
    if (*lf < start) {
        const char *found = memchr(start, '\n', (size_t)(text_end - start));
        *lf = found ? found : text_end;
    }
    const char *cr = memchr(start, '\r', (size_t)(*lf - start));
    *line_end = cr ? cr : *lf;
    const char *next = cr && cr + 1 != *lf ? cr : *lf;
    return next < text_end ? next + 1 : text_end;
}

static void check_complete(reader *r, const char *text_end)
{
    if (!r->ambient_line)
        complain(r, ERROR, text_end, "no ambient light; expected a line 'A ratio R,G,B'");
    if (!r->scene.camera_line)
        complain(r, ERROR, text_end, "no camera; expected a line 'C position direction fov'");
    if (!r->has_light)
        complain(r, WARNING, text_end, "no light; the ambient light alone shows the scene");
}

static void read_text(reader *r, const char *text, size_t size)
{
    const char *text_end = text + size, *next = text, *lf;
    r->line_start = text;
    r->line = 1;
    if (size >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0)) {
        complain(r, ERROR, text, "text in UTF-16; expected UTF-8 or ASCII");
        return;
    }
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        next = r->line_start = text + 3;
    const char *found = memchr(next, '\n', (size_t)(text_end - next));
    lf = found ? found : text_end;
    while (next < text_end && !r->out_of_memory) {
        r->line_start = next;
        next = find_line_end(next, text_end, &lf, &r->end);
        read_line(r);
        if (next < text_end || text_end[-1] == '\n' || text_end[-1] == '\r') {
            r->line++;
            r->line_start = next;
        }
    }
    if (!r->out_of_memory)
        check_complete(r, text_end);
}

static bool begin(reader *r, const char *name, const rt_options *options,
                  const rt_options_set *set, FILE *messages)
{
    *r = (reader){.messages = messages, .options = options, .set = set, .line = 1};
    r->scene.options = rt_default_options();
    r->name = r->scene.name = without_controls(name);
    r->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (r->name && r->c_locale)
        return true;
    fprintf(messages, "error: no memory to read a scene\n");
    if (r->c_locale)
        freelocale(r->c_locale);
    free(r->name);
    return false;
}

static bool finish(reader *r, rt_scene *scene)
{
    take_options(&r->scene.options, r->options, r->set);
    bool good = report(r) == 0;
    freelocale(r->c_locale);
    if (good)
        *scene = r->scene;
    else
        rt_scene_free(&r->scene);
    return good;
}

bool rt_read_text(const char *text, size_t size, const char *name, const rt_options *options,
                  const rt_options_set *set, FILE *messages, rt_scene *scene)
{
    reader r;
    if (!begin(&r, name, options, set, messages))
        return false;
    read_text(&r, text, size);
    return finish(&r, scene);
}

/* The file: a text that is read into memory first. */

static const char whole_file[] = ""; /* the place of what has none */

/* Opens a file that has an end. */
static int open_scene(reader *r, const char *path, size_t *size)
{
    struct stat about;
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0 || fstat(file, &about) != 0) {
        complain(r, ERROR, whole_file, "%s; expected a scene that can be read", strerror(errno));
    } else if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) {
        complain(r, ERROR, whole_file, "%s; expected a scene file",
                 S_ISDIR(about.st_mode) ? "a directory" : "neither a file nor a pipe");
    } else {
        *size = (size_t)about.st_size;
        return file;
    }
    if (file >= 0)
        close(file);
    return -1;
}

/* All bytes up to the end of the file, whatever its size was said to be. */
static char *read_all(reader *r, int file, size_t *size)
{
    size_t capacity = *size + 4096, count = 0;
    char *text = malloc(capacity);
    while (text) {
        ssize_t got = read(file, text + count, capacity - count);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0) {
            complain(r, ERROR, whole_file, "%s; expected a scene that can be read",
                     strerror(errno));
            free(text);
            return NULL;
        }
        count += (size_t)got;
        *size = count;
        if (got == 0)
            return text;
        if (count == capacity) {
            char *larger = realloc(text, capacity *= 2);
            if (!larger)
                free(text);
            text = larger;
        }
    }
    run_out_of_memory(r);
    return NULL;
}

static bool ends_in_rt(const char *path)
{
    size_t length = strlen(path);
    return length >= 3 && strcmp(path + length - 3, ".rt") == 0;
}

bool rt_read(const char *path, const rt_options *options, const rt_options_set *set, FILE *messages,
             rt_scene *scene)
{
    reader r;
    if (!begin(&r, path, options, set, messages))
        return false;
    size_t size = 0;
    r.line_start = whole_file;
    int file = open_scene(&r, path, &size);
    if (file >= 0) {
        char *text = read_all(&r, file, &size);
        close(file);
        if (text) {
            if (!ends_in_rt(path))
                complain(&r, WARNING, whole_file, "the file's name does not end in .rt");
            read_text(&r, text, size);
            free(text);
        }
    }
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
