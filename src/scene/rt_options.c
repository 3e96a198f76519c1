/* The options of a scene by their words, on the command line, in `#!` lines and in JSON alike. */
#include "rt.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define SIZE_MAXIMUM 65535

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
    [RT_SKIP_UNKNOWN] = {"skip-unknown", AT(skip_unknown), {NULL}, "no value"},
    [RT_SIZE] = {"size", AT_SIZE, {NULL}, "WxH, whole numbers from 1 to 65535 such as 1280x720"},
};

rt_options rt_default_options(void)
{
    return (rt_options)RT_DEFAULTS;
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

static bool set_size(rt_options *options, const char *value)
{
    char *end = "";
    bool plain = value[strspn(value, "0123456789x")] == '\0';
    unsigned long width = plain ? strtoul(value, &end, 10) : 0;
    unsigned long height = *end == 'x' ? strtoul(end + 1, &end, 10) : 0;
    if (width < 1 || width > SIZE_MAXIMUM || height < 1 || height > SIZE_MAXIMUM || *end != '\0')
        return false;
    options->width = (int)width;
    options->height = (int)height;
    return true;
}

/* From its value, "" for none. */
static bool set_option(rt_options *options, int option, const char *value)
{
    if (option == RT_SIZE)
        return set_size(options, value);
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
        return "one of handedness, fov, cylinder-position, cone-position, falloff, size, "
               "skip-unknown";
    if (!set_option(options, option, value ? value : ""))
        return rows[option].expected;
    *set |= RT_SET(option);
    return NULL;
}

json_t *rt_options_json(const rt_options *options)
{
    char size[24];
    snprintf(size, sizeof size, "%dx%d", options->width, options->height);
    json_t *object = json_pack("{s:s, s:b}", "size", size, "skip-unknown", options->skip_unknown);
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
