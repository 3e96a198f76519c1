/* The scene reader against the world: whatever the bytes, either a scene of which every number is
 * in its range, or errors of which each names a place and says what was expected there. */
#define _GNU_SOURCE /* open_memstream */

#include "fuzz.h"

#include "mutate_text.h"
#include "placement.h"
#include "rt.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char fuzz_name[] = "rt_reader";

enum { HEAD = 3, NAME_LENGTH = 4 };
static const char name[] = "f.rt"; /* what messages begin with */

static size_t mutate(uint8_t *data, size_t size, size_t max, unsigned seed)
{
    static const char *const words[] = {"A",
                                        "C",
                                        "L",
                                        "R",
                                        "sp",
                                        "pl",
                                        "cy",
                                        "co",
                                        "cn",
                                        "con",
                                        "cone",
                                        "falloff",
                                        "sq",
                                        "tr",
                                        "SP",
                                        "#!",
                                        "#",
                                        "//",
                                        "handedness",
                                        "left",
                                        "right",
                                        "fov",
                                        "horizontal",
                                        "vertical",
                                        "cylinder-position",
                                        "cone-position",
                                        "middle",
                                        "base",
                                        "apex",
                                        "none",
                                        "inverse-square",
                                        "size",
                                        "640x480",
                                        "0x0",
                                        "65536x1",
                                        "skip-unknown",
                                        "spec:0.5",
                                        "shine:32",
                                        "refl:1",
                                        "refr:1.5",
                                        "spec:",
                                        "shine:-1",
                                        "refr:0.5",
                                        "0",
                                        "-0",
                                        "1",
                                        "-1",
                                        "0.1",
                                        "70",
                                        "180",
                                        "179.99999999999997",
                                        "255",
                                        "256",
                                        "-255",
                                        "65535",
                                        "65536",
                                        "4294967296",
                                        "1e308",
                                        "-1e308",
                                        "1.7976931348623157e308",
                                        "1e309",
                                        "5e-324",
                                        "2.4e-324",
                                        "1e-400",
                                        "0x1p-1074",
                                        "0x1.8p+1",
                                        "0X.8",
                                        "0x",
                                        "1e",
                                        "1.2.3",
                                        ".",
                                        "+",
                                        "--1",
                                        "inf",
                                        "nan",
                                        "1e22",
                                        "9007199254740993",
                                        "123456789012345678901234567890",
                                        "0.0000000000000000000000000000001",
                                        "0,0,0",
                                        "0,1,0",
                                        "1e308,-1e308,1e308",
                                        "5e-324,0,0",
                                        "0,0,-1",
                                        "255,255,255",
                                        "1,2",
                                        "1,2,3,4",
                                        "\xef\xbb\xbf",
                                        "\xff\xfe",
                                        "\xc2\xa0"};
    static const char *const wholes[] = {"A 0.2 255,255,255\nC 0,0,20 0,0,-1 70\n",
                                         "A 0.2 255,255,255\n",
                                         "C 0,0,20 0,0,-1 70\n",
                                         "L -10,10,10 0.7 255,255,255\n",
                                         "R 640 480\n",
                                         "falloff inverse-square\n",
                                         "#! skip-unknown\n",
                                         "#! handedness left\n",
                                         "pl 0,-1,0 0,1,0 1,2,3\n",
                                         "sp 0,0,0 2 1,2,3 spec:0.5\n",
                                         "cy 0,0,0 0,1,0 1 2 1,2,3\n",
                                         "co 0,0,0 0,1,0 1 2 1,2,3 refl:0.5\n",
                                         "sq 1,2,3 4 5,6,7\n"};
    static const text_words all = {words, wholes, sizeof words / sizeof *words,
                                   sizeof wholes / sizeof *wholes, 70000};
    return text_mutate(data, HEAD, size, max, seed, &all);
}

size_t (*const fuzz_mutator)(uint8_t *, size_t, size_t, unsigned) = mutate;

typedef struct {
    const char *text;
    size_t size;
    rt_options options;
    rt_options_set set;
} question;

typedef struct {
    bool good;
    rt_scene scene; /* when good */
    char *messages;
} outcome;

static void expect(bool holds, const char *law, const outcome *o)
{
    if (!holds)
        fuzz_find(law, o->messages);
}

static outcome read_text(const question *q)
{
    outcome o = {0};
    size_t size;
    FILE *messages = open_memstream(&o.messages, &size);
    if (!messages)
        abort();
    memset(&o.scene, 0x5a, sizeof o.scene);
    o.good = rt_read_text(q->text, q->size, name, &q->options, &q->set, messages, &o.scene);
    fclose(messages);
    return o;
}

static void drop(outcome *o)
{
    if (o->good)
        rt_scene_free(&o->scene);
    free(o->messages);
}

/* The text's own lines, found here in another way: an end of line after each LF, and each CR that
 * no LF follows. */
typedef struct {
    size_t count, capacity;
    size_t *starts, *lengths;
} lines;

static void add_line(lines *all, size_t start, size_t length)
{
    if (all->count == all->capacity) {
        all->capacity = all->capacity ? 2 * all->capacity : 64;
        all->starts = realloc(all->starts, all->capacity * sizeof *all->starts);
        all->lengths = realloc(all->lengths, all->capacity * sizeof *all->lengths);
        if (!all->starts || !all->lengths)
            abort();
    }
    all->starts[all->count] = start;
    all->lengths[all->count++] = length;
}

static lines lines_of(const char *text, size_t size)
{
    lines all = {0};
    size_t start = size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    for (size_t at = start; at < size; at++) {
        bool pair = text[at] == '\r' && at + 1 < size && text[at + 1] == '\n';
        if (text[at] != '\n' && text[at] != '\r')
            continue;
        add_line(&all, start, at - start);
        at += pair;
        start = at + 1;
    }
    add_line(&all, start, size - start);
    return all;
}

static void free_lines(lines *all)
{
    free(all->starts);
    free(all->lengths);
}

/* Does the place exist? One column past the line's end is where something is missing. */
static bool is_place(const lines *all, size_t line, size_t column)
{
    return line >= 1 && line <= all->count && column >= 1 && column <= all->lengths[line - 1] + 1;
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
static void check_placed(const outcome *o, const lines *all, const char *at, tally *sum)
{
    char *end;
    size_t line = strtoul(at, &end, 10);
    expect(end > at && *end == ':', "a message names no line", o);
    at = end + 1;
    size_t column = strtoul(at, &end, 10);
    expect(end > at && strncmp(end, ": ", 2) == 0, "a message names no column", o);
    at = end + 2;
    expect(is_place(all, line, column), "a message names a place that is not in the text", o);
    expect(line >= sum->line, "messages out of order", o);
    sum->line = line;
    const char *newline = strchr(at, '\n');
    size_t length = (size_t)(newline - at);
    if (strncmp(at, "error: ", 7) == 0) {
        sum->errors++;
        const char *expected = strstr(at, "; expected ");
        expect(length > 20 && expected && expected < newline, "an error expects nothing", o);
    } else {
        expect(strncmp(at, "warning: ", 9) == 0 && length > 20, "a message of no kind", o);
        sum->warnings++;
    }
}

/* FILE: N more error(s), FILE: warning: N more unknown surface(s) ... */
static void check_unplaced(const outcome *o, const char *at, tally *sum)
{
    static const char warning[] = "warning: ";
    bool warns = strncmp(at, warning, sizeof warning - 1) == 0;
    char *end;
    size_t count = strtoul(warns ? at + sizeof warning - 1 : at, &end, 10);
    const char *what = warns ? " more unknown surface" : " more error";
    expect(count > 0 && strncmp(end, what, strlen(what)) == 0, "a message of no place", o);
    if (!warns)
        sum->more += count;
}

static tally check_messages(const outcome *o, const lines *all)
{
    tally sum = {0};
    for (const char *at = o->messages; *at;) {
        const char *newline = strchr(at, '\n');
        expect(newline && is_printable(at, (size_t)(newline - at)), "a message is no line of text",
               o);
        expect(strncmp(at, name, NAME_LENGTH) == 0 && at[NAME_LENGTH] == ':',
               "a message names no file", o);
        at += NAME_LENGTH + 1;
        if (*at == ' ')
            check_unplaced(o, at + 1, &sum);
        else
            check_placed(o, all, at, &sum);
        at = newline + 1;
    }
    return sum;
}

static void check_said(const outcome *o, const lines *all)
{
    tally sum = check_messages(o, all);
    expect(o->good == (sum.errors == 0), "good with an error, or bad without one", o);
    expect(sum.errors <= RT_ERRORS_SHOWN && (sum.more == 0 || sum.errors == RT_ERRORS_SHOWN),
           "more errors are shown than should be", o);
}

/* What is read. */

static bool is_between(double low, double x, double high)
{
    return low <= x && x <= high; /* and a number */
}

static bool is_finite(sure_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static bool is_direction(sure_vec3 v)
{
    return is_finite(v) && (v.x != 0 || v.y != 0 || v.z != 0);
}

static bool is_color(sure_vec3 c)
{
    return is_between(0, c.x, 1) && is_between(0, c.y, 1) && is_between(0, c.z, 1);
}

/* Where the scene says that its lines begin, and with what: found by going through the text. */

typedef struct {
    size_t line, column, length;
    const char *start;
} first_word;

static first_word first_word_of(const question *q, const lines *all, size_t line)
{
    const char *start = q->text + all->starts[line - 1], *at = start;
    const char *end = start + all->lengths[line - 1];
    first_word w = {.line = line};
    while (at < end && (*at == ' ' || *at == '\t'))
        at++;
    w.start = at;
    while (at < end && !memchr(" \t,#/", *at, 5))
        at++;
    w.column = (size_t)(w.start - start) + 1;
    w.length = (size_t)(at - w.start);
    return w;
}

static bool is_word(const first_word *w, const char *word)
{
    return strlen(word) == w->length && memcmp(w->start, word, w->length) == 0;
}

static const struct {
    const char *word;
    sure_shape shape;
} element_words[] = {{"pl", SURE_SHAPE_PLANE},    {"sp", SURE_SHAPE_SPHERE},
                     {"cy", SURE_SHAPE_CYLINDER}, {"co", SURE_SHAPE_CONE},
                     {"cn", SURE_SHAPE_CONE},     {"con", SURE_SHAPE_CONE},
                     {"cone", SURE_SHAPE_CONE}};

enum { ELEMENT_WORDS = sizeof element_words / sizeof *element_words };

static bool is_element(const first_word *w, sure_shape *shape)
{
    for (size_t i = 0; i < ELEMENT_WORDS; i++) {
        *shape = element_words[i].shape;
        if (is_word(w, element_words[i].word))
            return true;
    }
    return false;
}

/* Each line of an element is that element, in the order of the text, and there are no others. */
static void check_places(const question *q, const lines *all, const outcome *o)
{
    const rt_scene *s = &o->scene;
    size_t elements = 0, lights = 0;
    for (size_t line = 1; line <= all->count; line++) {
        first_word w = first_word_of(q, all, line);
        sure_shape shape;
        if (is_word(&w, "C")) {
            expect(s->camera_line == w.line && s->camera_column == w.column,
                   "the camera is not where it is said to be", o);
        } else if (is_word(&w, "L")) {
            const rt_place *place = &s->light_places[lights];
            expect(lights++ < s->light_count && place->line == line && place->column == w.column,
                   "a light is not where it is said to be", o);
        } else if (is_element(&w, &shape)) {
            const rt_element *e = &s->elements[elements];
            expect(elements++ < s->element_count && e->line == line && e->column == w.column &&
                       e->shape == shape,
                   "an element is not where it is said to be", o);
        }
    }
    expect(elements == s->element_count && lights == s->light_count, "more than the text has", o);
}

static void check_options(const question *q, const outcome *o)
{
    const rt_options *got = &o->scene.options, *asked = &q->options;
    const rt_options_set *set = &q->set;
    expect(is_between(1, got->width, 65535) && is_between(1, got->height, 65535),
           "a picture without a size", o);
    expect(got->cylinder_position != RT_POSITION_APEX, "a cylinder by its apex", o);
    expect((!set->handedness || got->handedness == asked->handedness) &&
               (!set->fov || got->fov == asked->fov) &&
               (!set->cylinder_position || got->cylinder_position == asked->cylinder_position) &&
               (!set->cone_position || got->cone_position == asked->cone_position) &&
               (!set->falloff || got->falloff == asked->falloff) &&
               (!set->skip_unknown || got->skip_unknown == asked->skip_unknown) &&
               (!set->size || (got->width == asked->width && got->height == asked->height)),
           "the command line does not win", o);
}

static void check_element(const outcome *o, size_t i)
{
    const rt_element *e = &o->scene.elements[i];
    const sure_material *m = &o->scene.materials[i];
    bool has_height = e->shape == SURE_SHAPE_CYLINDER || e->shape == SURE_SHAPE_CONE;
    expect(e->shape < SURE_SHAPES && e->shape != SURE_SHAPE_DISC, "an unknown shape", o);
    expect(is_finite(e->position), "a position that is not finite", o);
    expect(e->shape == SURE_SHAPE_SPHERE || is_direction(e->axis), "an axis that is none", o);
    expect(e->shape == SURE_SHAPE_PLANE || (e->diameter > 0 && isfinite(e->diameter)),
           "a diameter that is not above 0", o);
    expect(!has_height || (e->height > 0 && isfinite(e->height)), "a height that is not above 0",
           o);
    expect(is_color(m->color) && is_between(0, m->specular, 1) && is_between(0, m->mirror, 1) &&
               is_between(0, m->shine, 65535) &&
               (m->refract == 0 || (m->refract >= 1 && isfinite(m->refract))),
           "a material out of range", o);
}

static void check_light(const outcome *o, size_t i)
{
    const sure_light *l = &o->scene.lights[i];
    bool bright = o->scene.options.falloff != SURE_FALLOFF_NONE;
    expect(is_finite(l->position) && is_color(l->color), "a light out of range", o);
    expect(l->brightness >= 0 && (bright ? isfinite(l->brightness) : l->brightness <= 1),
           "a brightness out of range", o);
}

static void check_scene(const question *q, const lines *all, const outcome *o)
{
    const rt_scene *s = &o->scene;
    expect(strcmp(s->name, name) == 0, "another name", o);
    check_options(q, o);
    expect(is_between(0, s->ambient_ratio, 1) && is_color(s->ambient_color),
           "an ambient light out of range", o);
    expect(is_finite(s->camera_position) && is_direction(s->camera_direction) &&
               s->camera_fov > 0 && s->camera_fov < 180,
           "a camera out of range", o);
    check_places(q, all, o);
    for (size_t i = 0; i < s->element_count; i++)
        check_element(o, i);
    for (size_t i = 0; i < s->light_count; i++)
        check_light(o, i);
}

/* Once more. */

static bool same_bits(const void *a, const void *b, size_t count, size_t size)
{
    return count == 0 || memcmp(a, b, count * size) == 0;
}

static bool same_vector(sure_vec3 a, sure_vec3 b)
{
    return same_bits(&a, &b, 1, sizeof a);
}

static bool same_element(const rt_element *a, const rt_element *b, bool with_places)
{
    return a->shape == b->shape && same_vector(a->position, b->position) &&
           same_vector(a->axis, b->axis) && a->diameter == b->diameter && a->height == b->height &&
           (!with_places || (a->line == b->line && a->column == b->column));
}

static bool same_material(const sure_material *a, const sure_material *b)
{
    return same_vector(a->color, b->color) && a->specular == b->specular && a->shine == b->shine &&
           a->mirror == b->mirror && a->refract == b->refract;
}

static bool same_light(const sure_light *a, const sure_light *b)
{
    return same_vector(a->position, b->position) && same_vector(a->color, b->color) &&
           a->brightness == b->brightness;
}

static bool same_options(const rt_options *a, const rt_options *b)
{
    return a->handedness == b->handedness && a->fov == b->fov &&
           a->cylinder_position == b->cylinder_position && a->cone_position == b->cone_position &&
           a->falloff == b->falloff && a->skip_unknown == b->skip_unknown && a->width == b->width &&
           a->height == b->height;
}

static bool same_scene(const rt_scene *a, const rt_scene *b, bool with_places)
{
    bool same = same_options(&a->options, &b->options) && a->ambient_ratio == b->ambient_ratio &&
                same_vector(a->ambient_color, b->ambient_color) &&
                same_vector(a->camera_position, b->camera_position) &&
                same_vector(a->camera_direction, b->camera_direction) &&
                a->camera_fov == b->camera_fov && a->light_count == b->light_count &&
                a->element_count == b->element_count;
    for (size_t i = 0; same && i < a->light_count; i++)
        same = same_light(&a->lights[i], &b->lights[i]);
    for (size_t i = 0; same && i < a->element_count; i++)
        same = same_element(&a->elements[i], &b->elements[i], with_places) &&
               same_material(&a->materials[i], &b->materials[i]);
    return same;
}

static void check_again(const question *q, const outcome *o)
{
    outcome again = read_text(q);
    expect(o->good == again.good && strcmp(o->messages, again.messages) == 0 &&
               (!o->good || same_scene(&o->scene, &again.scene, true)),
           "the same text is read differently", o);
    drop(&again);
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
    question other = {text, size, q->options, q->set};
    outcome with_cr = read_text(&other);
    expect(o->good == with_cr.good && strcmp(o->messages, with_cr.messages) == 0 &&
               (!o->good || same_scene(&o->scene, &with_cr.scene, true)),
           "CR LF is read differently", o);
    drop(&with_cr);
    free(text);
}

/* Written out in full, the scene is read as it was: every number to the bit. */

static void put_vector(FILE *out, sure_vec3 v)
{
    fprintf(out, " %a,%a,%a", v.x, v.y, v.z);
}

static void put_color(FILE *out, sure_vec3 c)
{
    fprintf(out, " %.0f,%.0f,%.0f", 255 * c.x, 255 * c.y, 255 * c.z);
}

static void put_options(FILE *out, const rt_options *o)
{
    static const char *const positions[] = {
        [RT_POSITION_MIDDLE] = "middle", [RT_POSITION_BASE] = "base", [RT_POSITION_APEX] = "apex"};
    fprintf(out, "#! handedness %s\n", o->handedness == RT_LEFT_HANDED ? "left" : "right");
    fprintf(out, "#! fov %s\n", o->fov == RT_FOV_VERTICAL ? "vertical" : "horizontal");
    fprintf(out, "#! cylinder-position %s\n", positions[o->cylinder_position]);
    fprintf(out, "#! cone-position %s\n", positions[o->cone_position]);
    fprintf(out, "#! size %dx%d\n%s", o->width, o->height,
            o->skip_unknown ? "#! skip-unknown\n" : "");
    fprintf(out, "falloff %s\n", o->falloff == SURE_FALLOFF_NONE ? "none" : "inverse-square");
}

static void put_element(FILE *out, const rt_element *e, const sure_material *m)
{
    static const char *const words[] = {[SURE_SHAPE_PLANE] = "pl",
                                        [SURE_SHAPE_SPHERE] = "sp",
                                        [SURE_SHAPE_CYLINDER] = "cy",
                                        [SURE_SHAPE_CONE] = "co"};
    fputs(words[e->shape], out);
    put_vector(out, e->position);
    if (e->shape != SURE_SHAPE_SPHERE)
        put_vector(out, e->axis);
    if (e->shape != SURE_SHAPE_PLANE)
        fprintf(out, " %a", e->diameter);
    if (e->shape == SURE_SHAPE_CYLINDER || e->shape == SURE_SHAPE_CONE)
        fprintf(out, " %a", e->height);
    put_color(out, m->color);
    fprintf(out, " spec:%a shine:%d refl:%a", m->specular, m->shine, m->mirror);
    if (m->refract != 0)
        fprintf(out, " refr:%a", m->refract);
    fputc('\n', out);
}

static void put_scene(FILE *out, const rt_scene *s)
{
    put_options(out, &s->options);
    fprintf(out, "A %a", s->ambient_ratio);
    put_color(out, s->ambient_color);
    fputs("\nC", out);
    put_vector(out, s->camera_position);
    put_vector(out, s->camera_direction);
    fprintf(out, " %a\n", s->camera_fov);
    for (size_t i = 0; i < s->light_count; i++) {
        fputc('L', out);
        put_vector(out, s->lights[i].position);
        fprintf(out, " %a", s->lights[i].brightness);
        put_color(out, s->lights[i].color);
        fputc('\n', out);
    }
    for (size_t i = 0; i < s->element_count; i++)
        put_element(out, &s->elements[i], &s->materials[i]);
}

static void check_written(const outcome *o)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        abort();
    put_scene(out, &o->scene);
    fclose(out);
    question q = {text, size, rt_default_options(), {0}};
    outcome back = read_text(&q);
    expect(back.good, "a scene that was read is refused when it is written out", &back);
    expect(same_scene(&o->scene, &back.scene, false), "a scene that is written out is another", o);
    drop(&back);
    free(text);
}

/* In the camera's space. */

static bool is_window(const sure_camera *c)
{
    return c->focal_length > 0 && c->viewport_width > 0 && c->viewport_height > 0 &&
           isfinite(c->focal_length) && isfinite(c->viewport_width) && isfinite(c->viewport_height);
}

static void check_placed_scene(const outcome *o, const sure_scene *placed)
{
    const sure_ray ahead = {{0, 0, 0}, {0, 0, -1}, 0, INFINITY};
    expect(placed->object_count == o->scene.element_count &&
               placed->light_count == o->scene.light_count,
           "the placed scene has more or fewer objects", o);
    for (size_t i = 0; i < placed->object_count; i++)
        expect(sure_object_check(&ahead, &placed->objects[i]) == SURE_FIELD_NONE,
               "the placed scene has an object that is invalid", o);
    for (size_t i = 0; i < placed->light_count; i++)
        expect(is_finite(placed->lights[i].position), "a placed light is not finite", o);
    expect(is_color(placed->ambient), "the placed ambient light is out of range", o);
    expect(is_window(&placed->camera), "the camera's window is none", o);
}

static void check_placement(const outcome *o, const lines *all)
{
    sure_scene placed;
    size_t size;
    outcome said = {.good = false};
    FILE *messages = open_memstream(&said.messages, &size);
    if (!messages)
        abort();
    said.good = placement(&o->scene, messages, &placed);
    fclose(messages);
    check_said(&said, all);
    if (said.good) {
        check_placed_scene(o, &placed);
        placement_free(&placed);
    }
    free(said.messages);
}

/* Two bytes tell what the command line sets, the rest is the text. */
static question read_question(const uint8_t *data, size_t size)
{
    uint8_t set = data[0], to = data[1];
    question q = {.options = rt_default_options()};
    q.set = (rt_options_set){set & 1, set & 2, set & 4, set & 8, set & 16, set & 32, set & 64};
    q.options.handedness = to & 1 ? RT_LEFT_HANDED : RT_RIGHT_HANDED;
    q.options.fov = to & 2 ? RT_FOV_VERTICAL : RT_FOV_HORIZONTAL;
    q.options.cylinder_position = to & 4 ? RT_POSITION_BASE : RT_POSITION_MIDDLE;
    q.options.cone_position = to & 8    ? RT_POSITION_APEX
                              : to & 16 ? RT_POSITION_BASE
                                        : RT_POSITION_MIDDLE;
    q.options.falloff = to & 32 ? SURE_FALLOFF_INVERSE_SQUARE : SURE_FALLOFF_NONE;
    q.options.skip_unknown = to & 64;
    q.options.width = to & 128 ? 65535 : 1;
    q.size = size - HEAD;
    return q;
}

/* A third byte chooses among what costs as much as reading. */
static void compare(const question *q, uint8_t how)
{
    outcome o = read_text(q);
    lines all = lines_of(q->text, q->size);
    check_said(&o, &all);
    if (how % 4 == 0)
        check_again(q, &o);
    if (how % 4 == 1 && q->size > 0)
        check_line_ends(q, &o);
    if (o.good) {
        check_scene(q, &all, &o);
        check_placement(&o, &all);
        if (how % 4 >= 2)
            check_written(&o);
    }
    free_lines(&all);
    drop(&o);
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    if (size < HEAD)
        return false;
    question q = read_question(data, size);
    char *text = malloc(q.size > 0 ? q.size : 1); /* of its own size: reading past it is seen */
    if (!text)
        abort();
    if (q.size > 0)
        memcpy(text, data + HEAD, q.size);
    q.text = text;
    compare(&q, data[2]);
    free(text);
    return true;
}
