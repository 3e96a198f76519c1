#include "resolved.h"

json_t *resolved_json(const rt_options *options)
{
    char size[24];
    snprintf(size, sizeof size, "%dx%d", options->width, options->height);
    json_t *object = json_pack("{s:s, s:b}", "size", size, "skip-unknown", options->skip_unknown);
    for (int i = 0; i < RT_CHOICES; i++)
        json_object_set_new(object, rt_option_name((rt_option)i),
                            json_string(rt_option_word(options, (rt_option)i)));
    return object;
}

static const char *wrong(const char *name)
{
    static char reason[64];
    snprintf(reason, sizeof reason, "expected another value of %s", name);
    return reason;
}

const char *resolved_from_json(const json_t *object, rt_options *options)
{
    const json_t *skip = json_object_get(object, "skip-unknown");
    rt_options_set unused = 0;
    options->skip_unknown = json_is_true(skip);
    if (!json_is_boolean(skip))
        return wrong("skip-unknown");
    for (int i = 0; i < RT_OPTIONS; i++) {
        const char *name = rt_option_name((rt_option)i);
        const char *word = json_string_value(json_object_get(object, name));
        if (i != RT_SKIP_UNKNOWN && (!word || rt_set_option(options, &unused, name, word)))
            return wrong(name);
    }
    return json_object_size(object) == RT_OPTIONS ? NULL : "more options than there are";
}
