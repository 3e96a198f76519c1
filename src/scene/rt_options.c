/* The options of a scene by their words, the same on the command line and in `#!` lines. */
#include "rt.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define SIZE_MAXIMUM 65535

static const struct {
    const char *name, *expected;
    const char *words[3]; /* by meaning */
    size_t at;            /* of the meaning in rt_options */
} choices[RT_CHOICES] = {
    [RT_HANDEDNESS] = {"handedness",
                       "right or left",
                       {[RT_RIGHT_HANDED] = "right", [RT_LEFT_HANDED] = "left"},
                       offsetof(rt_options, handedness)},
    [RT_FOV] = {"fov",
                "horizontal or vertical",
                {[RT_FOV_HORIZONTAL] = "horizontal", [RT_FOV_VERTICAL] = "vertical"},
                offsetof(rt_options, fov)},
    [RT_CYLINDER_POSITION] = {"cylinder-position",
                              "middle or base",
                              {[RT_POSITION_MIDDLE] = "middle", [RT_POSITION_BASE] = "base"},
                              offsetof(rt_options, cylinder_position)},
    [RT_CONE_POSITION] = {"cone-position",
                          "middle, apex or base",
                          {[RT_POSITION_MIDDLE] = "middle",
                           [RT_POSITION_BASE] = "base",
                           [RT_POSITION_APEX] = "apex"},
                          offsetof(rt_options, cone_position)},
    [RT_FALLOFF] =
        {"falloff",
         "none or inverse-square",
         {[SURE_FALLOFF_NONE] = "none", [SURE_FALLOFF_INVERSE_SQUARE] = "inverse-square"},
         offsetof(rt_options, falloff)},
};

rt_options rt_default_options(void)
{
    return (rt_options){
        .handedness = RT_RIGHT_HANDED,
        .fov = RT_FOV_HORIZONTAL,
        .cylinder_position = RT_POSITION_MIDDLE,
        .cone_position = RT_POSITION_MIDDLE,
        .falloff = SURE_FALLOFF_NONE,
        .skip_unknown = false,
        .width = 1280,
        .height = 720,
    };
}

/* A choice is an enumeration, as large as an int. */
_Static_assert(sizeof(rt_position) == sizeof(int) && sizeof(sure_falloff) == sizeof(int), "");

static int meaning_of(const rt_options *options, rt_option choice)
{
    int meaning;
    memcpy(&meaning, (const char *)options + choices[choice].at, sizeof meaning);
    return meaning;
}

static void choose(rt_options *options, rt_option choice, int meaning)
{
    memcpy((char *)options + choices[choice].at, &meaning, sizeof meaning);
}

const char *rt_option_name(rt_option option)
{
    static const char *const others[] = {"skip-unknown", "size"};
    return option < RT_CHOICES ? choices[option].name : others[option - RT_CHOICES];
}

const char *rt_option_word(const rt_options *options, rt_option choice)
{
    return choices[choice].words[meaning_of(options, choice)];
}

void rt_take_options(rt_options *to, const rt_options *from, rt_options_set which)
{
    for (int i = 0; i < RT_CHOICES; i++) {
        if (which & RT_SET(i))
            choose(to, (rt_option)i, meaning_of(from, (rt_option)i));
    }
    if (which & RT_SET(RT_SKIP_UNKNOWN))
        to->skip_unknown = from->skip_unknown;
    if (which & RT_SET(RT_SIZE)) {
        to->width = from->width;
        to->height = from->height;
    }
}

static const char *set_choice(rt_options *options, rt_options_set *set, rt_option choice,
                              const char *value)
{
    for (int i = 0; i < 3 && choices[choice].words[i]; i++) {
        if (value && strcmp(value, choices[choice].words[i]) == 0) {
            choose(options, choice, i);
            *set |= RT_SET(choice);
            return NULL;
        }
    }
    return choices[choice].expected;
}

static const char *set_size(rt_options *options, rt_options_set *set, const char *value)
{
    char *end = "";
    bool plain = value && value[strspn(value, "0123456789x")] == '\0';
    unsigned long width = plain ? strtoul(value, &end, 10) : 0;
    unsigned long height = *end == 'x' ? strtoul(end + 1, &end, 10) : 0;
    if (width < 1 || width > SIZE_MAXIMUM || height < 1 || height > SIZE_MAXIMUM || *end != '\0')
        return "WxH, whole numbers from 1 to 65535 such as 1280x720";
    options->width = (int)width;
    options->height = (int)height;
    *set |= RT_SET(RT_SIZE);
    return NULL;
}

const char *rt_set_option(rt_options *options, rt_options_set *set, const char *name,
                          const char *value)
{
    int option = 0;
    while (option < RT_OPTIONS && strcmp(name, rt_option_name((rt_option)option)) != 0)
        option++;
    if (option < RT_CHOICES)
        return set_choice(options, set, (rt_option)option, value);
    if (option == RT_SIZE)
        return set_size(options, set, value);
    if (option == RT_OPTIONS)
        return "one of handedness, fov, cylinder-position, cone-position, falloff, size, "
               "skip-unknown";
    if (value && *value)
        return "no value";
    options->skip_unknown = true;
    *set |= RT_SET(RT_SKIP_UNKNOWN);
    return NULL;
}
