/* The options of a scene by their words, the same on the command line and in `#!` lines. */
#include "rt.h"

#include <string.h>

#define SIZE_MAXIMUM 65535

typedef struct {
    const char *option, *expected;
    const char *words[3];
    int meanings[3];
} choice;

enum { HANDEDNESS, FOV, CYLINDER_POSITION, CONE_POSITION, FALLOFF, CHOICES };

static const choice choices[CHOICES] = {
    [HANDEDNESS] = {"handedness",
                    "right or left",
                    {"right", "left"},
                    {RT_RIGHT_HANDED, RT_LEFT_HANDED}},
    [FOV] = {"fov",
             "horizontal or vertical",
             {"horizontal", "vertical"},
             {RT_FOV_HORIZONTAL, RT_FOV_VERTICAL}},
    [CYLINDER_POSITION] = {"cylinder-position",
                           "middle or base",
                           {"middle", "base"},
                           {RT_POSITION_MIDDLE, RT_POSITION_BASE}},
    [CONE_POSITION] = {"cone-position",
                       "middle, apex or base",
                       {"middle", "apex", "base"},
                       {RT_POSITION_MIDDLE, RT_POSITION_APEX, RT_POSITION_BASE}},
    [FALLOFF] = {"falloff",
                 "none or inverse-square",
                 {"none", "inverse-square"},
                 {SURE_FALLOFF_NONE, SURE_FALLOFF_INVERSE_SQUARE}},
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

static void choose(rt_options *options, rt_options_set *set, int option, int meaning)
{
    switch (option) {
    case HANDEDNESS:
        options->handedness = (rt_handedness)meaning;
        set->handedness = true;
        break;
    case FOV:
        options->fov = (rt_fov_axis)meaning;
        set->fov = true;
        break;
    case CYLINDER_POSITION:
        options->cylinder_position = (rt_position)meaning;
        set->cylinder_position = true;
        break;
    case CONE_POSITION:
        options->cone_position = (rt_position)meaning;
        set->cone_position = true;
        break;
    case FALLOFF:
        options->falloff = (sure_falloff)meaning;
        set->falloff = true;
        break;
    }
}

static const char *set_choice(rt_options *options, rt_options_set *set, int option,
                              const char *value)
{
    const choice *c = &choices[option];
    for (int i = 0; i < 3 && c->words[i]; i++) {
        if (value && strcmp(value, c->words[i]) == 0) {
            choose(options, set, option, c->meanings[i]);
            return NULL;
        }
    }
    return c->expected;
}

/* The whole number 1..SIZE_MAXIMUM at *text, moved behind its digits; 0 where there is none. */
static int dimension(const char **text)
{
    int value = 0;
    for (; **text >= '0' && **text <= '9'; ++*text) {
        value = 10 * value + (**text - '0');
        if (value > SIZE_MAXIMUM)
            return 0;
    }
    return value;
}

static const char *set_size(rt_options *options, rt_options_set *set, const char *value)
{
    static const char expected[] = "WxH, whole numbers from 1 to 65535 such as 1280x720";
    if (!value)
        return expected;
    int width = dimension(&value);
    if (width == 0 || *value++ != 'x')
        return expected;
    int height = dimension(&value);
    if (height == 0 || *value != '\0')
        return expected;
    options->width = width;
    options->height = height;
    set->size = true;
    return NULL;
}

const char *rt_set_option(rt_options *options, rt_options_set *set, const char *name,
                          const char *value)
{
    for (int option = 0; option < CHOICES; option++) {
        if (strcmp(name, choices[option].option) == 0)
            return set_choice(options, set, option, value);
    }
    if (strcmp(name, "size") == 0)
        return set_size(options, set, value);
    if (strcmp(name, "skip-unknown") == 0) {
        if (value && *value)
            return "no value";
        options->skip_unknown = true;
        set->skip_unknown = true;
        return NULL;
    }
    return "one of handedness, fov, cylinder-position, cone-position, falloff, size, skip-unknown";
}
