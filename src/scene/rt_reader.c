/* Reads .rt scenes (docs/scene_format.md), line by line, field by field.
 *
 * A fault is noted with its place and reading goes on behind it, so that one run names them all. */
#define _POSIX_C_SOURCE 200809L /* open, fstat, newlocale */

#include "rt_fields.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
    rt_notes notes;
    rt_line line;
    const rt_options *options; /* of the command line */
    const rt_options_set *set;
    bool out_of_memory;

    rt_scene scene;
    size_t light_capacity, element_capacity;
    rt_options_set set_by_scene;
    size_t ambient_line; /* 0: none seen */
    bool has_light;
} reader;

static const rt_field position = {.name = "position", .expected = "x,y,z"};
static const rt_field direction = {.name = "direction", .expected = "x,y,z, not all zero"};
static const rt_field normal = {.name = "normal", .expected = "x,y,z, not all zero"};
static const rt_field axis = {.name = "axis", .expected = "x,y,z, not all zero"};
static const rt_field ambient_ratio = {"ambient ratio", "a number from 0 to 1", 0, 1, false};
static const rt_field light_ratio = {"light ratio", "a number from 0 to 1", 0, INFINITY, false};
static const rt_field view = {"field of view", "degrees above 0 and below 180", 0, 180, true};
static const rt_field diameter = {"diameter", "a number above 0", 0, INFINITY, true};
static const rt_field height = {"height", "a number above 0", 0, INFINITY, true};
static const rt_field columns = {"width", "a whole number from 1 to 65535", 1, RT_WHOLE_MAX, false};
static const rt_field rows = {"height", "a whole number from 1 to 65535", 1, RT_WHOLE_MAX, false};
static const rt_field spec = {"spec", "a number from 0 to 1", 0, 1, false};
static const rt_field refl = {"refl", "a number from 0 to 1", 0, 1, false};
static const rt_field refr = {"refr", "an index of refraction from 1", 1, INFINITY, false};
static const rt_field shine = {"shine", "a whole number from 0 to 65535", 0, RT_WHOLE_MAX, false};

/* Materials: words behind the colour. */

static bool read_once(reader *r, rt_word label, bool *seen)
{
    if (*seen) {
        rt_complain(&r->notes, RT_ERROR, label.start, "a second %s; expected it once",
                    rt_quote(label).text);
        return false;
    }
    *seen = true;
    return true;
}

/* spec:0.5 shine:32 refl:0.3 refr:1.5, any of them in any order. */
static bool read_material(reader *r, sure_material *material)
{
    bool has_spec = false, has_shine = false, has_refl = false, has_refr = false;
    while (rt_more_fields(&r->line)) {
        rt_word w = rt_word_at(&r->line, r->line.at);
        const char *colon = memchr(w.start, ':', (size_t)(w.end - w.start));
        rt_word label = {w.start, colon ? colon : w.end};
        r->line.at = colon ? colon + 1 : w.start;
        bool going_on = false;
        if (colon && rt_is_word(label, "spec"))
            going_on = read_once(r, label, &has_spec) &&
                       rt_read_value(&r->line, &spec, &material->specular);
        else if (colon && rt_is_word(label, "shine"))
            going_on = read_once(r, label, &has_shine) &&
                       rt_read_integer(&r->line, &shine, &material->shine);
        else if (colon && rt_is_word(label, "refl"))
            going_on = read_once(r, label, &has_refl) &&
                       rt_read_value(&r->line, &refl, &material->mirror);
        else if (colon && rt_is_word(label, "refr"))
            going_on = read_once(r, label, &has_refr) &&
                       rt_read_value(&r->line, &refr, &material->refract);
        else
            rt_complain(&r->notes, RT_ERROR, w.start,
                        "%s after the colour; expected spec:, shine:, refl:, refr: or the end of "
                        "the line",
                        rt_quote(rt_run_at(&r->line, w.start)).text);
        if (!going_on)
            return false;
    }
    return true;
}

/* Elements: one function each. */

static void run_out_of_memory(reader *r)
{
    r->out_of_memory = true;
    rt_complain(&r->notes, RT_ERROR, r->notes.line_start,
                "no memory for more; expected a smaller scene");
}

/* The array with room for `capacity` items; NULL, with the array kept, if there is none. */
static void *grown(void *array, size_t capacity, size_t size)
{
    return capacity > SIZE_MAX / size ? NULL : realloc(array, capacity * size);
}

static bool reserve_light(reader *r)
{
    rt_scene *scene = &r->scene;
    if (scene->light_count < r->light_capacity)
        return true;
    size_t capacity = r->light_capacity ? 2 * r->light_capacity : 16;
    sure_light *lights = grown(scene->lights, capacity, sizeof *lights);
    if (lights)
        scene->lights = lights;
    rt_place *places = grown(scene->light_places, capacity, sizeof *places);
    if (places)
        scene->light_places = places;
    if (lights && places)
        r->light_capacity = capacity;
    else
        run_out_of_memory(r);
    return lights && places;
}

static void add_light(reader *r, const sure_light *light, rt_word identifier)
{
    if (!reserve_light(r))
        return;
    rt_scene *scene = &r->scene;
    size_t column = (size_t)(identifier.start - r->notes.line_start) + 1;
    scene->light_places[scene->light_count] = (rt_place){r->notes.line_number, column};
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

static void read_ambient(reader *r, rt_word identifier)
{
    if (r->ambient_line)
        rt_complain(&r->notes, RT_ERROR, identifier.start,
                    "a second A; expected one, it is on line %zu", r->ambient_line);
    else
        r->ambient_line = r->notes.line_number;
    if (rt_read_scalar(&r->line, &ambient_ratio, &r->scene.ambient_ratio) &&
        rt_read_color(&r->line, &r->scene.ambient_color))
        rt_expect_end(&r->line);
}

static void read_camera(reader *r, rt_word identifier)
{
    rt_scene *scene = &r->scene;
    if (scene->camera_line) {
        rt_complain(&r->notes, RT_ERROR, identifier.start,
                    "a second C; expected one, it is on line %zu", scene->camera_line);
    } else {
        scene->camera_line = r->notes.line_number;
        scene->camera_column = (size_t)(identifier.start - r->notes.line_start) + 1;
    }
    if (rt_read_vector(&r->line, &position, &scene->camera_position) &&
        rt_read_direction(&r->line, &direction, &scene->camera_direction) &&
        rt_read_scalar(&r->line, &view, &scene->camera_fov))
        rt_expect_end(&r->line);
}

static void read_light(reader *r, rt_word identifier)
{
    r->has_light = true;
    sure_light light = {.color = {1, 1, 1}};
    if (!rt_read_vector(&r->line, &position, &light.position))
        return;
    rt_skip_blanks(&r->line);
    const char *ratio = r->line.at;
    if (!rt_read_scalar(&r->line, &light_ratio, &light.brightness))
        return;
    if (light.brightness > 1)
        rt_complain(&r->notes, RT_BRIGHT_LIGHT, ratio,
                    "light ratio %s is out of range; expected a number from 0 to 1 (with falloff "
                    "inverse-square, from 0)",
                    rt_quote(rt_word_at(&r->line, ratio)).text);
    if (rt_more_fields(&r->line) && !rt_read_color(&r->line, &light.color))
        return;
    rt_expect_end(&r->line);
    add_light(r, &light, identifier);
}

static void read_element(reader *r, rt_word identifier, sure_shape shape)
{
    rt_element element = {.shape = shape,
                          .line = r->notes.line_number,
                          .column = (size_t)(identifier.start - r->notes.line_start) + 1};
    sure_material material = {.shine = 32};
    bool has_height = shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
    if (!rt_read_vector(&r->line, &position, &element.position))
        return;
    if (shape != SURE_SHAPE_SPHERE &&
        !rt_read_direction(&r->line, shape == SURE_SHAPE_PLANE ? &normal : &axis, &element.axis))
        return;
    if (shape != SURE_SHAPE_PLANE && !rt_read_scalar(&r->line, &diameter, &element.diameter))
        return;
    if (has_height && !rt_read_scalar(&r->line, &height, &element.height))
        return;
    if (!rt_read_color(&r->line, &material.color) || !read_material(r, &material))
        return;
    rt_expect_end(&r->line);
    add_element(r, &element, &material);
}

static void read_sphere(reader *r, rt_word identifier)
{
    read_element(r, identifier, SURE_SHAPE_SPHERE);
}

static void read_plane(reader *r, rt_word identifier)
{
    read_element(r, identifier, SURE_SHAPE_PLANE);
}

static void read_cylinder(reader *r, rt_word identifier)
{
    read_element(r, identifier, SURE_SHAPE_CYLINDER);
}

static void read_cone(reader *r, rt_word identifier)
{
    read_element(r, identifier, SURE_SHAPE_CONE);
}

/* Options: the command line wins, and a scene sets each of them once. */

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
        rt_complain(&r->notes, RT_ERROR, place,
                    "this option is set already; expected it once in a scene");
    take_options(&r->scene.options, options, which);
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
static void read_option(reader *r, rt_word name)
{
    r->line.at = name.end;
    bool has_value = rt_more_fields(&r->line);
    rt_word value = has_value ? rt_run_at(&r->line, r->line.at) : name;
    r->line.at = value.end;
    char name_text[OPTION_BYTES], value_text[OPTION_BYTES];
    copy_word(name, name_text);
    copy_word(value, value_text);
    rt_options options = r->scene.options;
    rt_options_set which = {0};
    const char *expected =
        rt_set_option(&options, &which, name_text, has_value ? value_text : NULL);
    if (expected) {
        rt_word both = {name.start, value.end};
        rt_complain(&r->notes, RT_ERROR, name.start, "option %s; expected %s", rt_quote(both).text,
                    expected);
        return;
    }
    set_by_scene(r, name.start, &options, &which);
    rt_expect_end(&r->line);
}

static void read_falloff(reader *r, rt_word identifier)
{
    read_option(r, identifier);
}

static void read_resolution(reader *r, rt_word identifier)
{
    rt_options options = r->scene.options;
    rt_skip_blanks(&r->line);
    if (!rt_read_integer(&r->line, &columns, &options.width))
        return;
    rt_skip_blanks(&r->line);
    if (!rt_read_integer(&r->line, &rows, &options.height))
        return;
    set_by_scene(r, identifier.start, &options, &(rt_options_set){.size = true});
    rt_expect_end(&r->line);
}

/* Lines: what they start with tells what they are. */

static const struct {
    const char *identifier;
    void (*read)(reader *, rt_word identifier);
} elements[] = {
    {"sp", read_sphere}, {"pl", read_plane}, {"cy", read_cylinder},  {"co", read_cone},
    {"cn", read_cone},   {"con", read_cone}, {"cone", read_cone},    {"L", read_light},
    {"A", read_ambient}, {"C", read_camera}, {"R", read_resolution}, {"falloff", read_falloff},
};

#define ELEMENTS (sizeof elements / sizeof *elements)

/* The known identifier that the word looks like: another case of it, or it without the blank that
 * should follow; NULL if none. */
static const char *likeness(rt_word w)
{
    size_t length = (size_t)(w.end - w.start);
    for (size_t i = 0; i < ELEMENTS; i++) {
        const char *known = elements[i].identifier;
        size_t known_length = strlen(known);
        if (known_length > length || strncasecmp(known, w.start, known_length) != 0)
            continue;
        if (known_length == length || rt_starts_number(w.start[known_length]))
            return known;
    }
    return NULL;
}

static bool is_all_lower_case(rt_word w)
{
    while (w.start < w.end && *w.start >= 'a' && *w.start <= 'z')
        w.start++;
    return w.start == w.end;
}

static void complain_identifier(reader *r, rt_word w)
{
    const char *known = likeness(w);
    if (w.start == w.end || rt_starts_number(*w.start))
        rt_complain(&r->notes, RT_ERROR, w.start,
                    "a line that starts with %s; expected %s: an element stands on one line",
                    rt_quote(rt_run_at(&r->line, w.start)).text, rt_identifiers);
    else if (known)
        rt_complain(&r->notes, RT_ERROR, w.start,
                    "unknown identifier %s; expected '%s' and a blank", rt_quote(w).text, known);
    else if (is_all_lower_case(w))
        rt_complain(&r->notes, RT_UNKNOWN_SURFACE, w.start, "%s", rt_quote(w).text);
    else
        rt_complain(&r->notes, RT_ERROR, w.start, "unknown identifier %s; expected %s",
                    rt_quote(w).text, rt_identifiers);
}

static void read_fields(reader *r)
{
    rt_word w = rt_word_at(&r->line, r->line.at);
    for (size_t i = 0; i < ELEMENTS; i++) {
        if (rt_is_word(w, elements[i].identifier)) {
            r->line.at = w.end;
            if (r->line.at < r->line.end && *r->line.at == ',')
                rt_complain(&r->notes, RT_ERROR, r->line.at, "a comma after '%s'; expected a blank",
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
    size_t length = (size_t)(r->line.end - r->notes.line_start);
    if (length > RT_LONGEST_LINE) {
        rt_complain(&r->notes, RT_ERROR, r->notes.line_start + RT_LONGEST_LINE,
                    "a line of %zu bytes; expected at most %d", length, RT_LONGEST_LINE);
        return;
    }
    const char *nul = memchr(r->notes.line_start, '\0', length);
    if (nul) {
        rt_complain(&r->notes, RT_ERROR, nul, "a NUL byte; expected text");
        return;
    }
    r->line.at = r->notes.line_start;
    rt_skip_blanks(&r->line);
    if (r->line.end - r->line.at >= 2 && r->line.at[0] == '#' && r->line.at[1] == '!') {
        r->line.at += 2;
        rt_skip_blanks(&r->line);
        read_option(r, rt_run_at(&r->line, r->line.at));
    } else if (rt_more_fields(&r->line)) {
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
        rt_complain(&r->notes, RT_ERROR, text_end,
                    "no ambient light; expected a line 'A ratio R,G,B'");
    if (!r->scene.camera_line)
        rt_complain(&r->notes, RT_ERROR, text_end,
                    "no camera; expected a line 'C position direction fov'");
    if (!r->has_light)
        rt_complain(&r->notes, RT_WARNING, text_end,
                    "no light; the ambient light alone shows the scene");
}

static void read_text(reader *r, const char *text, size_t size)
{
    const char *text_end = text + size, *next = text, *lf;
    r->notes.line_start = text;
    r->notes.line_number = 1;
    if (size >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0)) {
        rt_complain(&r->notes, RT_ERROR, text, "text in UTF-16; expected UTF-8 or ASCII");
        return;
    }
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        next = r->notes.line_start = text + 3;
    const char *found = memchr(next, '\n', (size_t)(text_end - next));
    lf = found ? found : text_end;
    while (next < text_end && !r->out_of_memory) {
        r->notes.line_start = next;
        next = find_line_end(next, text_end, &lf, &r->line.end);
        read_line(r);
        if (next < text_end || text_end[-1] == '\n' || text_end[-1] == '\r') {
            r->notes.line_number++;
            r->notes.line_start = next;
        }
    }
    if (!r->out_of_memory)
        check_complete(r, text_end);
}

static bool begin(reader *r, const char *name, const rt_options *options, const rt_options_set *set,
                  FILE *messages)
{
    *r = (reader){.options = options, .set = set};
    r->notes.messages = messages;
    r->notes.line_number = 1;
    r->scene.options = rt_default_options();
    r->notes.name = r->scene.name = rt_printable_name(name);
    r->line.notes = &r->notes;
    r->line.c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (r->notes.name && r->line.c_locale)
        return true;
    fprintf(messages, "error: no memory to read a scene\n");
    if (r->line.c_locale)
        freelocale(r->line.c_locale);
    free(r->notes.name);
    return false;
}

static bool finish(reader *r, rt_scene *scene)
{
    take_options(&r->scene.options, r->options, r->set);
    bool good = rt_report(&r->notes, &r->scene.options) == 0;
    freelocale(r->line.c_locale);
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

static const char atomic_file[] = ""; /* the place of what has none */

/* Opens a file that has an end. */
static int open_scene(reader *r, const char *path, size_t *size)
{
    struct stat about;
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0 || fstat(file, &about) != 0) {
        rt_complain(&r->notes, RT_ERROR, atomic_file, "%s; expected a scene that can be read",
                    strerror(errno));
    } else if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) {
        rt_complain(&r->notes, RT_ERROR, atomic_file, "%s; expected a scene file",
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
            rt_complain(&r->notes, RT_ERROR, atomic_file, "%s; expected a scene that can be read",
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
    r.notes.line_start = atomic_file;
    int file = open_scene(&r, path, &size);
    if (file >= 0) {
        char *text = read_all(&r, file, &size);
        close(file);
        if (text) {
            if (!ends_in_rt(path))
                rt_complain(&r.notes, RT_WARNING, atomic_file,
                            "the file's name does not end in .rt");
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
    free(scene->light_places);
    free(scene->elements);
    free(scene->materials);
    *scene = (rt_scene){0};
}
