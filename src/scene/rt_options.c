/* SPDX-License-Identifier: MIT */
/* The options of a scene by their words, on the command line, in `#!` lines and in JSON alike. */
#include "rt.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define WHOLE_MAXIMUM 65535

#define AT(member) offsetof(rt_options, member), sizeof((rt_options *)0)->member
#define AT_SIZE offsetof(rt_options, width), 2 * sizeof(int)

static const struct {
    const char *name;
    size_t at, size;      /* in rt_options */
    const char *words[4]; /* in the order of their enumeration, up to NULL */
    const char *expected;
} rows[RT_OPTIONS] = {
    [RT_HANDEDNESS] = {"handedness", AT(handedness), {"right", "left"}, "right or left"},
    [RT_FOV] = {"fov", AT(fov), {"horizontal", "vertical"}, "horizontal or vertical"},
    [RT_CYLINDER_POSITION] = {"cylinder-position",
                              AT(cylinder_position),
                              {"middle", "base"},
                              "middle or base"},
    [RT_CONE_POSITION] = {"cone-position",
                          AT(cone_position),
                          {"middle", "base", "apex"},
                          "middle, apex or base"},
    [RT_FALLOFF] = {"falloff", AT(falloff), {"none", "inverse-square"}, "none or inverse-square"},
    [RT_DIALECT] = {"dialect", AT(dialect), {"strict", "42"}, "strict or 42"},
    [RT_SKIP_UNKNOWN] = {"skip-unknown", AT(skip_unknown), {NULL}, "no value"},
    [RT_SIZE] = {"size", AT_SIZE, {NULL}, "WxH, whole numbers from 1 to 65535 such as 1280x720"},
    [RT_CAMERA] = {"camera", AT(camera), {NULL}, "a whole number from 1 to 65535"},
};

rt_options rt_default_options(void)
{
    return (rt_options)RT_DEFAULTS;
}

rt_options rt_dialect_options(rt_dialect dialect)
{
    rt_options options = RT_DEFAULTS;
    options.dialect = dialect;
    if (dialect == RT_42) {
        options.handedness = RT_LEFT_HANDED;
        options.cone_position = RT_POSITION_APEX;
    }
    return options;
}

/* A choice is an enumeration, as large as an int. */
_Static_assert(sizeof(rt_position) == sizeof(int) && sizeof(sure_falloff) == sizeof(int), "");

const char *rt_option_name(rt_option option)
{
    return rows[option].name;
}

const char *rt_option_word(const rt_options *options, rt_option choice)
{
    int meaning;
    memcpy(&meaning, (const char *)options + rows[choice].at, sizeof meaning);
    return rows[choice].words[meaning];
}

void rt_take_options(rt_options *to, const rt_options *from, rt_options_set which)
{
    for (int i = 0; i < RT_OPTIONS; i++) {
        if (which & RT_SET(i))
            memcpy((char *)to + rows[i].at, (const char *)from + rows[i].at, rows[i].size);
    }
}

const char *rt_options_difference(const rt_options *a, const rt_options *b)
{
    for (int i = 0; i < RT_OPTIONS; i++) {
        int option = (i + RT_SIZE) % RT_OPTIONS; /* the size first */
        size_t at = rows[option].at;
        if (memcmp((const char *)a + at, (const char *)b + at, rows[option].size) != 0)
            return rows[option].name;
    }
    return NULL;
}

static bool set_choice(rt_options *options, int choice, const char *value)
{
    for (int i = 0; rows[choice].words[i]; i++) {
        if (strcmp(value, rows[choice].words[i]) == 0) {
            memcpy((char *)options + rows[choice].at, &i, sizeof i);
            return true;
        }
    }
    return false;
}

/* Digits, up to their end; 0 for no number from 1 to WHOLE_MAXIMUM. */
static int read_whole(const char *value, const char **end)
{
    char *behind = (char *)value;
    unsigned long number = *value >= '0' && *value <= '9' ? strtoul(value, &behind, 10) : 0;
    *end = behind;
    return number <= WHOLE_MAXIMUM ? (int)number : 0;
}

static bool set_size(rt_options *options, const char *value)
{
    const char *end;
    int width = read_whole(value, &end), height = *end == 'x' ? read_whole(end + 1, &end) : 0;
    if (width == 0 || height == 0 || *end != '\0')
        return false;
    options->width = width;
    options->height = height;
    return true;
}

static bool set_camera(rt_options *options, const char *value)
{
    const char *end;
    int camera = read_whole(value, &end);
    if (camera == 0 || *end != '\0')
        return false;
    options->camera = camera;
    return true;
}

/* From its value, "" for none. */
static bool set_option(rt_options *options, int option, const char *value)
{
    if (option == RT_SIZE)
        return set_size(options, value);
    if (option == RT_CAMERA)
        return set_camera(options, value);
    if (option != RT_SKIP_UNKNOWN)
        return set_choice(options, option, value);
    options->skip_unknown |= *value == '\0';
    return *value == '\0';
}

const char *rt_set_option(rt_options *options, rt_options_set *set, const char *name,
                          const char *value)
{
    int option = 0;
    while (option < RT_OPTIONS && strcmp(name, rows[option].name) != 0)
        option++;
    if (option == RT_OPTIONS)
        return "one of handedness, fov, cylinder-position, cone-position, falloff, dialect, size, "
               "camera, skip-unknown";
    if (!set_option(options, option, value ? value : ""))
        return rows[option].expected;
    *set |= RT_SET(option);
    return NULL;
}

json_t *rt_options_json(const rt_options *options)
{
    char size[24], camera[12];
    snprintf(size, sizeof size, "%dx%d", options->width, options->height);
    snprintf(camera, sizeof camera, "%d", options->camera);
    json_t *object = json_pack("{s:s, s:s, s:b}", "size", size, "camera", camera, "skip-unknown",
                               options->skip_unknown);
    for (int i = 0; i < RT_CHOICES; i++)
        json_object_set_new(object, rows[i].name,
                            json_string(rt_option_word(options, (rt_option)i)));
    return object;
}

static const char *wrong(const char *name)
{
    static char reason[64];
    snprintf(reason, sizeof reason, "expected another value of %s", name);
    return reason;
}

const char *rt_options_from_json(const json_t *object, rt_options *options)
{
    const json_t *skip = json_object_get(object, "skip-unknown");
    rt_options_set unused = 0;
    options->skip_unknown = json_is_true(skip);
    if (!json_is_boolean(skip))
        return wrong("skip-unknown");
    for (int i = 0; i < RT_OPTIONS; i++) {
        const char *name = rows[i].name;
        const char *word = json_string_value(json_object_get(object, name));
        if (i != RT_SKIP_UNKNOWN && (!word || rt_set_option(options, &unused, name, word)))
            return wrong(name);
    }
    return json_object_size(object) == RT_OPTIONS ? NULL : "more options than there are";
}
