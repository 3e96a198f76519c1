/* SPDX-License-Identifier: MIT */
/* The scene reader against the world: whatever the bytes, either a scene of which every number is
 * in its range, or errors of which each names a place and says what was expected there. */

#include <strings.h>

#include "mutate_text.h"
#include "shapes/rt_shape.h"
#include "tiers.h"
#include "written_scene.h"

enum { HEAD = 3, NAME_LENGTH = 4 };
static const char name[] = "f.rt"; /* what messages begin with */

/* What is in scenes, and what is nearly. */
static const char further_words[] =
    "A C L R falloff sq tr SP #! # // handedness left right fov horizontal vertical "
    "cylinder-position cone-position middle base apex none inverse-square size 640x480 0x0 65536x1 "
    "skip-unknown dialect 42 strict camera 2 c l SUN rgb textures/x.png mat:1 cu bx sphere "
    "0.5,0.25,1 "
    "spec:0.5 shine:32 refl:1 refr:1.5 spec: shine:-1 refr:0.5 0 -0 1 -1 0.1 70 180 "
    "179.99999999999997 255 256 -255 65535 65536 4294967296 1e308 -1e308 1.7976931348623157e308 "
    "1e309 5e-324 2.4e-324 1e-400 0x1p-1074 0x1.8p+1 0X.8 0x 1e 1.2.3 . + --1 inf nan 1e22 "
    "9007199254740993 123456789012345678901234567890 0.0000000000000000000000000000001 0,0,0 0,1,0 "
    "1e308,-1e308,1e308 5e-324,0,0 0,0,-1 255,255,255 1,2 1,2,3,4 \xef\xbb\xbf \xff\xfe \xc2\xa0";
static const char *const further_lines[] = {"A 0.2 255,255,255\nC 0,0,20 0,0,-1 70\n",
                                            "A 0.2 255,255,255\n",
                                            "C 0,0,20 0,0,-1 70\n",
                                            "L -10,10,10 0.7 255,255,255\n",
                                            "R 640 480\n",
                                            "falloff inverse-square\n",
                                            "#! skip-unknown\n",
                                            "#! handedness left\n",
                                            "#! dialect 42\n",
                                            "#! camera 2\n",
                                            "c 0,0,20 0,0,0 180\n",
                                            "l 1,2,3 4 5\n",
                                            "co 1,2,3 0,1,0 45 5,6,7 checker\n",
                                            "sp 1,2,3 4 tex 5,6,7\n",
                                            "cu 1,2,3 0,1,0 4 5,6,7\n",
                                            "sq 1,2,3 4 5,6,7\n"};

enum { FURTHER_LINES = sizeof further_lines / sizeof *further_lines };

/* A line of the shape; "" if scenes have none. */
static void put_line(const rt_shape *row, char line[80])
{
    static const char *const values[] = {
        [RT_POINT] = "0,0,0", [RT_DIRECTION] = "0,1,0", [RT_NUMBER] = "2"};
    *line = '\0';
    if (!row->words[0])
        return;
    char *out = line + sprintf(line, "%s", row->words[0]);
    for (const rt_field *f = row->fields; f->name; f++)
        out += sprintf(out, " %s", values[f->kind]);
    strcpy(out, " 1,2,3 refl:0.5\n");
}

static size_t mutate(uint8_t *data, size_t size, size_t max, unsigned seed)
{
    static char words[sizeof further_words + SURE_SHAPES * 30], shape_lines[SURE_SHAPES][80];
    static const char *lines[SURE_SHAPES + FURTHER_LINES];
    static const text_words all = {words, lines, SURE_SHAPES + FURTHER_LINES, 70000};
    if (*words == '\0') {
        char *out = words;
        memcpy(lines + SURE_SHAPES, further_lines, sizeof further_lines);
        for (int i = 0; i < SURE_SHAPES; i++) {
            const rt_shape *row = rt_shapes[i];
            for (const char *const *word = row->words; *word; word++)
                out += sprintf(out, "%s ", *word);
            put_line(row, shape_lines[i]);
            lines[i] = shape_lines[i];
        }
        strcpy(out, further_words);
    }
    return text_mutate(data, HEAD, size, max, seed, &all);
}

FUZZ_TARGET("rt_reader", mutate)

typedef struct {
    const char *text;
    size_t size;
    rt_options options;
    rt_options_set set;
} question;

static outcome read_text(const question *q)
{
    return outcome_of_text(q->text, q->size, name, &q->options, q->set);
}

/* A line of the text, found here in another way: a line ends at each LF, and each CR that no LF
 * follows. */
typedef struct {
    size_t number, start, length;
} line;

static line line_from(const question *q, size_t number, size_t start)
{
    size_t end = start;
    while (end < q->size && q->text[end] != '\n' && q->text[end] != '\r')
        end++;
    return (line){number, start, end - start};
}

static line first_line(const question *q)
{
    bool marked = q->size >= 3 && memcmp(q->text, "\xef\xbb\xbf", 3) == 0;
    return line_from(q, 1, marked ? 3 : 0);
}

/* False when there is no further one. */
static bool next_line(const question *q, line *l)
{
    size_t end = l->start + l->length;
    if (end == q->size)
        return false;
    bool pair = q->text[end] == '\r' && end + 1 < q->size && q->text[end + 1] == '\n';
    *l = line_from(q, l->number + 1, end + 1 + pair);
    return true;
}

/* Does the place exist? One column past the line's end is where something is missing. */
static bool is_place(const question *q, size_t number, size_t column)
{
    line l = first_line(q);
    while (l.number != number)
        if (!next_line(q, &l))
            return false;
    return column >= 1 && column <= l.length + 1;
}

/* What is said. */

typedef struct {
    size_t errors, warnings, more;
    size_t line; /* of the last one that has a place */
} tally;

/* Without a comparison a byte, which an engine would look at. */
static bool is_printable(const char *text, size_t length)
{
    int outside = 0; /* below 0 once one is */
    for (size_t i = 0; i < length; i++)
        outside |= (text[i] - ' ') | ('~' - text[i]);
    return outside >= 0;
}

/* LINE:COLUMN: error|warning: TEXT */
static void check_placed(const question *q, const char *at, tally *sum)
{
    size_t number, column;
    int read = 0;
    expect(sscanf(at, "%zu:%zu: %n", &number, &column, &read) == 2 && read > 0,
           "a message names no line and column");
    at += read;
    expect(is_place(q, number, column), "a message names a place that is not in the text");
    expect(number >= sum->line, "messages out of order");
    sum->line = number;
    const char *newline = strchr(at, '\n');
    size_t length = (size_t)(newline - at);
    if (strncmp(at, "error: ", 7) == 0) {
        sum->errors++;
        const char *expected = strstr(at, "; expected ");
        expect(length > 20 && expected && expected < newline, "an error expects nothing");
    } else {
        expect(strncmp(at, "warning: ", 9) == 0 && length > 20, "a message of no kind");
        sum->warnings++;
    }
}

/* FILE: N more error(s), FILE: warning: N more unknown surface(s) or kind(s) ... */
static void check_unplaced(const char *at, tally *sum)
{
    size_t count = 0;
    int read = 0;
    bool warns = sscanf(at, "warning: %zu more unknown %n", &count, &read) > 0;
    if (!warns)
        (void)sscanf(at, "%zu more error%n", &count, &read);
    expect(count > 0 && read > 0, "a message of no place");
    if (!warns)
        sum->more += count;
}

static tally check_messages(const outcome *o, const question *q)
{
    tally sum = {0};
    for (const char *at = o->messages; *at;) {
        const char *newline = strchr(at, '\n');
        expect(newline && is_printable(at, (size_t)(newline - at)), "a message is no line of text");
        expect(strncmp(at, name, NAME_LENGTH) == 0 && at[NAME_LENGTH] == ':',
               "a message names no file");
        at += NAME_LENGTH + 1;
        if (*at == ' ')
            check_unplaced(at + 1, &sum);
        else
            check_placed(q, at, &sum);
        at = newline + 1;
    }
    return sum;
}

static void check_said(const outcome *o, const question *q)
{
    fuzz_ask("%s", o->messages);
    tally sum = check_messages(o, q);
    expect(o->good == (sum.errors == 0), "good with an error, or bad without one");
    expect(sum.errors <= RT_ERRORS_SHOWN && (sum.more == 0 || sum.errors == RT_ERRORS_SHOWN),
           "more errors are shown than should be");
}

/* What is read. */

static bool is_between(double low, double x, double high)
{
    return low <= x && x <= high; /* and a number */
}

static bool is_color(sure_vec3 c)
{
    return is_between(0, c.x, 1) && is_between(0, c.y, 1) && is_between(0, c.z, 1);
}

/* Where the scene says that its lines begin, and with what: found by going through the text. */

typedef struct {
    size_t column, length;
    const char *start;
} first_word;

static first_word first_word_of(const question *q, const line *l)
{
    const char *start = q->text + l->start, *end = start + l->length, *at = start;
    while (at < end && (*at == ' ' || *at == '\t'))
        at++;
    first_word w = {.start = at, .column = (size_t)(at - start) + 1};
    while (at < end && !memchr(" \t,#/", *at, 5))
        at++;
    w.length = (size_t)(at - w.start);
    return w;
}

static bool is_word(const first_word *w, const char *word)
{
    return strlen(word) == w->length && memcmp(w->start, word, w->length) == 0;
}

/* In dialect 42 in either case. */
static bool is_called(const first_word *w, const char *word, bool in_42)
{
    return is_word(w, word) ||
           (in_42 && strlen(word) == w->length && strncasecmp(w->start, word, w->length) == 0);
}

static bool is_element(const first_word *w, bool in_42, sure_shape *shape)
{
    for (int i = 0; i < SURE_SHAPES; i++) {
        *shape = (sure_shape)i;
        for (const char *const *word = rt_shapes[*shape]->words; *word; word++) {
            if (is_called(w, *word, in_42))
                return true;
        }
    }
    return false;
}

/* Of a line that may, in dialect 42, describe the shape in another way, or nothing. */
static bool is_form(const first_word *w, sure_shape shape)
{
    for (const rt_form *form = rt_shapes[shape]->forms; form->words[0]; form++) {
        for (const char *const *word = form->words; *word; word++) {
            if (is_word(w, *word))
                return true;
        }
    }
    return false;
}

/* What has been found of the text. */
typedef struct {
    size_t elements, lights;
    int cameras;
} findings;

/* Is it, as the next of its kind, where the scene says? */
static void check_place(const rt_scene *s, const question *q, const line *l, findings *found)
{
    const bool in_42 = s->options.dialect == RT_42;
    const rt_element *e = &s->elements[found->elements];
    const rt_light *light = &s->lights[found->lights];
    first_word w = first_word_of(q, l);
    sure_shape shape;
    bool is_next =
        found->elements < s->element_count && e->at.line == l->number && e->at.column == w.column;
    if (is_called(&w, "C", in_42))
        expect(++found->cameras != s->options.camera ||
                   (s->camera_at.line == l->number && s->camera_at.column == w.column),
               "the camera is not where it is said to be");
    else if (is_called(&w, "L", in_42))
        expect(found->lights++ < s->light_count && light->at.line == l->number &&
                   light->at.column == w.column,
               "a light is not where it is said to be");
    else if (is_element(&w, in_42, &shape) && !(in_42 && is_form(&w, shape) && !is_next))
        expect(++found->elements <= s->element_count && is_next && e->shape == shape,
               "an element is not where it is said to be");
    else if (in_42 && is_next)
        expect(++found->elements <= s->element_count && is_form(&w, e->shape),
               "an element of an unknown word");
}

/* Each line of an element is that element, in the order of the text, and there are no others. */
static void check_places(const question *q, const rt_scene *s)
{
    findings found = {0};
    line l = first_line(q);
    do
        check_place(s, q, &l, &found);
    while (next_line(q, &l));
    expect(found.elements == s->element_count && found.lights == s->light_count &&
               found.cameras >= s->options.camera &&
               (found.cameras == 1 || s->options.dialect == RT_42),
           "more or less than the text has");
}

static void check_options(const question *q, const rt_options *got)
{
    const rt_options *asked = &q->options;
    expect(is_between(1, got->width, 65535) && is_between(1, got->height, 65535),
           "a picture without a size");
    expect(got->cylinder_position != RT_POSITION_APEX, "a cylinder by its apex");
    bool wins =
        !(q->set & RT_SET(RT_SIZE)) || (got->width == asked->width && got->height == asked->height);
    for (int i = 0; i < RT_CHOICES; i++)
        wins = wins && (!(q->set & RT_SET(i)) ||
                        rt_option_word(got, (rt_option)i) == rt_option_word(asked, (rt_option)i));
    if (q->set & RT_SET(RT_SKIP_UNKNOWN))
        wins = wins && got->skip_unknown == asked->skip_unknown;
    if (q->set & RT_SET(RT_CAMERA))
        wins = wins && got->camera == asked->camera;
    expect(wins, "the command line does not win");
}

static bool is_value(const rt_field *f, const void *value)
{
    const double *number = value;
    switch (f->kind) {
    case RT_POINT: return all_finite(*(const sure_vec3 *)value);
    case RT_DIRECTION: return is_direction(*(const sure_vec3 *)value);
    default: return f->low < *number && *number < f->high;
    }
}

static void check_element(const rt_element *e, const sure_material *m)
{
    expect(e->shape < SURE_SHAPES && rt_shapes[e->shape]->words[0], "an unknown shape");
    for (const rt_field *f = rt_shapes[e->shape]->fields; f->name; f++)
        expect(is_value(f, rt_value(e, f)), f->name);
    expect(is_color(m->color) && is_between(0, m->specular, 1) && is_between(0, m->mirror, 1) &&
               is_between(0, m->shine, 65535) &&
               (m->refract == 0 || (m->refract >= 1 && isfinite(m->refract))),
           "a material out of range");
}

static void check_light(const sure_light *l, bool bright)
{
    expect(all_finite(l->position) && is_color(l->color), "a light out of range");
    expect(l->brightness >= 0 && (bright ? isfinite(l->brightness) : l->brightness <= 1),
           "a brightness out of range");
}

static void check_scene(const question *q, const rt_scene *s)
{
    expect(strcmp(s->name, name) == 0, "another name");
    check_options(q, &s->options);
    expect(is_between(0, s->ambient_ratio, 1) && is_color(s->ambient_color),
           "an ambient light out of range");
    expect(all_finite(s->camera_position) && is_direction(s->camera_direction) &&
               s->camera_fov > 0 && s->camera_fov < 180,
           "a camera out of range");
    check_places(q, s);
    for (size_t i = 0; i < s->element_count; i++)
        check_element(&s->elements[i], &s->materials[i]);
    for (size_t i = 0; i < s->light_count; i++)
        check_light(&s->lights[i].light, s->options.falloff != SURE_FALLOFF_NONE);
}

/* The scene written out in full, every number to the bit, and read again. */

/* That text, too, is read as `o` was. */
static void check_like(const outcome *o, const question *q, const char *law)
{
    outcome other = read_text(q);
    expect(o->good == other.good && strcmp(o->messages, other.messages) == 0, law);
    if (o->good) {
        char *before = written_scene(&o->scene), *after = written_scene(&other.scene);
        expect(strcmp(before, after) == 0, law);
        free(before);
        free(after);
    }
    outcome_free(&other);
}

/* Every LF becomes CR LF, in a text that has no CR of its own: nothing else may change. */
static void check_line_ends(const question *q, const outcome *o)
{
    if (memchr(q->text, '\r', q->size))
        return;
    size_t size = 0;
    char *text = malloc(2 * q->size);
    if (!text)
        abort();
    for (size_t i = 0; i < q->size; i++) {
        if (q->text[i] == '\n')
            text[size++] = '\r';
        text[size++] = q->text[i];
    }
    check_like(o, &(question){text, size, q->options, q->set}, "CR LF is read differently");
    free(text);
}

static void check_written(const rt_scene *scene)
{
    char *text = written_scene(scene);
    question q = {text, strlen(text), rt_default_options(), 0};
    outcome back = read_text(&q);
    expect(back.good, "a scene that was read is refused when it is written out");
    char *again = written_scene(&back.scene);
    expect(strcmp(text, again) == 0, "a scene that is written out is another");
    outcome_free(&back);
    free(again);
    free(text);
}

/* In the camera's space. */

static bool is_window(const sure_camera *c)
{
    return c->focal_length > 0 && c->viewport_width > 0 && c->viewport_height > 0 &&
           isfinite(c->focal_length) && isfinite(c->viewport_width) && isfinite(c->viewport_height);
}

static void check_placed_scene(const rt_scene *scene, const sure_scene *placed)
{
    const sure_ray ahead = {{0, 0, 0}, {0, 0, -1}, 0, INFINITY};
    expect(placed->object_count == scene->element_count &&
               placed->light_count == scene->light_count,
           "the placed scene has more or fewer objects");
    for (size_t i = 0; i < placed->object_count; i++)
        expect(sure_object_check(&ahead, &placed->objects[i]) == SURE_FIELD_NONE,
               "the placed scene has an object that is invalid");
    for (size_t i = 0; i < placed->light_count; i++)
        expect(all_finite(placed->lights[i].position), "a placed light is not finite");
    expect(is_color(placed->ambient), "the placed ambient light is out of range");
    expect(is_window(&placed->camera), "the camera's window is none");
}

static void check_placement(const rt_scene *scene, const question *q)
{
    outcome said = outcome_of_placement(scene);
    check_said(&said, q);
    if (said.good)
        check_placed_scene(scene, &said.placed);
    outcome_free(&said);
}

/* By two bytes and a part of the third: what the command line sets; the rest is the text. */
static const rt_option by_bits[8] = {RT_HANDEDNESS,    RT_FOV,     RT_CYLINDER_POSITION,
                                     RT_CONE_POSITION, RT_FALLOFF, RT_SKIP_UNKNOWN,
                                     RT_SIZE,          RT_DIALECT};

static question read_question(const uint8_t *data, size_t size)
{
    uint8_t set = data[0], to = data[1], how = data[2];
    question q = {(const char *)data + HEAD, size - HEAD, rt_default_options(), 0};
    for (int i = 0; i < 8; i++)
        q.set |= set >> i & 1 ? RT_SET(by_bits[i]) : 0;
    q.set |= how & 8 ? RT_SET(RT_CAMERA) : 0;
    q.options.dialect = how & 4 ? RT_42 : RT_STRICT;
    q.options.camera = how & 16 ? 2 : 1;
    q.options.handedness = to & 1 ? RT_LEFT_HANDED : RT_RIGHT_HANDED;
    q.options.fov = to & 2 ? RT_FOV_VERTICAL : RT_FOV_HORIZONTAL;
    q.options.cylinder_position = to & 4 ? RT_POSITION_BASE : RT_POSITION_MIDDLE;
    q.options.cone_position = to & 8    ? RT_POSITION_APEX
                              : to & 16 ? RT_POSITION_BASE
                                        : RT_POSITION_MIDDLE;
    q.options.falloff = to & 32 ? SURE_FALLOFF_INVERSE_SQUARE : SURE_FALLOFF_NONE;
    q.options.skip_unknown = to & 64;
    q.options.width = to & 128 ? 65535 : 1;
    return q;
}

/* A third byte chooses among what costs as much as reading. */
static void compare(const question *q, uint8_t how)
{
    outcome o = read_text(q);
    check_said(&o, q);
    if (how % 4 == 0)
        check_like(&o, q, "the same text is read differently");
    if (how % 4 == 1 && q->size > 0)
        check_line_ends(q, &o);
    if (o.good) {
        check_scene(q, &o.scene);
        check_placement(&o.scene, q);
        if (how % 4 >= 2)
            check_written(&o.scene);
    }
    outcome_free(&o);
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    if (size < HEAD)
        return false;
    question q = read_question(data, size);
    compare(&q, data[2]);
    return true;
}
