#include "resolved.h"

#include <string.h>

/* The options' words, as rt_set_option takes them. */
static const struct {
    const char *name, *words[3];
} choices[] = {
    {"handedness", {[RT_RIGHT_HANDED] = "right", [RT_LEFT_HANDED] = "left"}},
    {"fov", {[RT_FOV_HORIZONTAL] = "horizontal", [RT_FOV_VERTICAL] = "vertical"}},
    {"cylinder-position", {[RT_POSITION_MIDDLE] = "middle", [RT_POSITION_BASE] = "base"}},
    {"cone-position",
     {[RT_POSITION_MIDDLE] = "middle", [RT_POSITION_BASE] = "base", [RT_POSITION_APEX] = "apex"}},
    {"falloff", {[SURE_FALLOFF_NONE] = "none", [SURE_FALLOFF_INVERSE_SQUARE] = "inverse-square"}},
};

#define CHOICES (sizeof choices / sizeof *choices)

/* One a choice. */
static void list_meanings(const rt_options *options, int meanings[])
{
    const int all[CHOICES] = {(int)options->handedness, (int)options->fov,
                              (int)options->cylinder_position, (int)options->cone_position,
                              (int)options->falloff};
    memcpy(meanings, all, sizeof all);
}

void resolved_print(FILE *out, const rt_options *options)
{
    int meanings[CHOICES];
    list_meanings(options, meanings);
    for (size_t i = 0; i < CHOICES; i++)
        fprintf(out, "%s %s\n", choices[i].name, choices[i].words[meanings[i]]);
    fprintf(out, "skip-unknown %s\n", options->skip_unknown ? "yes" : "no");
}

bool resolved_read_one(text_fields *r, rt_options *options, const char *name)
{
    rt_options_set unused = {0};
    if (!text_next_field(r, name))
        return false;
    const char *expected = rt_set_option(options, &unused, name, r->at);
    return !expected || text_wrong(r, "%s '%s': expected %s", name, r->at, expected);
}

bool resolved_read(text_fields *r, rt_options *options)
{
    for (size_t i = 0; i < CHOICES; i++) {
        if (!resolved_read_one(r, options, choices[i].name))
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
    int meanings[CHOICES];
    list_meanings(options, meanings);
    snprintf(size, sizeof size, "%dx%d", options->width, options->height);
    json_t *object = json_pack("{s:s, s:b}", "size", size, "skip-unknown", options->skip_unknown);
    for (size_t i = 0; i < CHOICES; i++)
        json_object_set_new(object, choices[i].name, json_string(choices[i].words[meanings[i]]));
    return object;
}

const char *resolved_from_json(const json_t *object, rt_options *options)
{
    const json_t *skip = json_object_get(object, "skip-unknown");
    rt_options_set unused = {0};
    options->skip_unknown = json_is_true(skip);
    if (!json_is_boolean(skip))
        return "skip-unknown";
    for (size_t i = 0; i <= CHOICES; i++) {
        const char *name = i < CHOICES ? choices[i].name : "size";
        const char *word = json_string_value(json_object_get(object, name));
        if (!word || rt_set_option(options, &unused, name, word))
            return name;
    }
    return json_object_size(object) == CHOICES + 2 ? NULL : "more";
}

const char *resolved_difference(const rt_options *a, const rt_options *b)
{
    int of_a[CHOICES], of_b[CHOICES];
    list_meanings(a, of_a);
    list_meanings(b, of_b);
    if (a->width != b->width || a->height != b->height)
        return "size";
    for (size_t i = 0; i < CHOICES; i++) {
        if (of_a[i] != of_b[i])
            return choices[i].name;
    }
    return a->skip_unknown != b->skip_unknown ? "skip-unknown" : NULL;
}
