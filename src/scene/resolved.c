#include "resolved.h"

#include <string.h>

void resolved_print(FILE *out, const rt_options *options)
{
    for (int i = 0; i < RT_CHOICES; i++)
        fprintf(out, "%s %s\n", rt_option_name((rt_option)i),
                rt_option_word(options, (rt_option)i));
    fprintf(out, "skip-unknown %s\n", options->skip_unknown ? "yes" : "no");
}

bool resolved_read_one(text_fields *r, rt_options *options, const char *name)
{
    rt_options_set unused = 0;
    if (!text_next_field(r, name))
        return false;
    const char *expected = rt_set_option(options, &unused, name, r->at);
    return !expected || text_wrong(r, "%s '%s': expected %s", name, r->at, expected);
}

bool resolved_read(text_fields *r, rt_options *options)
{
    for (int i = 0; i < RT_CHOICES; i++) {
        if (!resolved_read_one(r, options, rt_option_name((rt_option)i)))
            return false;
    }
    if (!text_next_field(r, "skip-unknown"))
        return false;
    options->skip_unknown = strcmp(r->at, "yes") == 0;
    return options->skip_unknown || strcmp(r->at, "no") == 0 ||
           text_wrong(r, "expected 'yes' or 'no'");
}

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

const char *resolved_from_json(const json_t *object, rt_options *options)
{
    const json_t *skip = json_object_get(object, "skip-unknown");
    rt_options_set unused = 0;
    options->skip_unknown = json_is_true(skip);
    if (!json_is_boolean(skip))
        return "skip-unknown";
    for (int i = 0; i < RT_OPTIONS; i++) {
        const char *name = rt_option_name((rt_option)i);
        const char *word = json_string_value(json_object_get(object, name));
        if (i != RT_SKIP_UNKNOWN && (!word || rt_set_option(options, &unused, name, word)))
            return name;
    }
    return json_object_size(object) == RT_OPTIONS ? NULL : "more";
}

const char *resolved_difference(const rt_options *a, const rt_options *b)
{
    if (a->width != b->width || a->height != b->height)
        return "size";
    for (int i = 0; i < RT_CHOICES; i++) {
        rt_option choice = (rt_option)i;
        if (rt_option_word(a, choice) != rt_option_word(b, choice))
            return rt_option_name(choice);
    }
    return a->skip_unknown != b->skip_unknown ? "skip-unknown" : NULL;
}
