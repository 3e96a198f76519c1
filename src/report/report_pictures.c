/* SPDX-License-Identifier: MIT */
#include "report.h"

#include "../scene/placement.h"
#include "../support/base64.h"

#include <stdlib.h>
#include <string.h>

/* page.html says what they show. */
static const struct {
    const char *name, *file;
} subjects[] = {
    {"ball", "A 0.15 255,255,255\n"
             "C 0,0,30000000 0,0,-1 4.125e-6\n"
             "L 18000000,21000000,27000000 0.85\n"
             "sp 0,0,0 2 206,92,70\n"
             "R 160 160\n"},
    {"cylinder and cone", "A 0.15 255,255,255\n"
                          "C 0,0,10000000 0,0,-1 2.177e-5\n"
                          "L 6000000,7000000,9000000 0.85\n"
                          "cy -0.85,0,0 0.3,1,0.35 1.1 2.2 80,140,210\n"
                          "co 0.9,0,0 -0.3,1,0.3 1.5 2.3 120,180,90\n"
                          "R 160 160\n"},
};

/* NULL: no memory. */
static json_t *draw_tier(const sure_scene *scene, sure_tier tier)
{
    const render_options how = {.tier = tier};
    picture image;
    if (!picture_new(scene->width, scene->height, &image))
        return NULL;
    render(scene, &how, &image);
    char *text = base64_of(image.rgb, 3 * (size_t)image.width * (size_t)image.height);
    json_t *drawn = text ? json_string(text) : NULL;
    free(text);
    picture_free(&image);
    return drawn;
}

static json_t *draw_tiers(const sure_scene *scene)
{
    json_t *drawn = json_object();
    for (int tier = 0; tier < SURE_TIERS; tier++)
        json_object_set_new(drawn, sure_tier_name((sure_tier)tier),
                            draw_tier(scene, (sure_tier)tier));
    return drawn;
}

static json_t *draw_subject(const char *name, const char *text)
{
    rt_options reading = rt_default_options();
    rt_options_set set = 0;
    rt_scene file;
    sure_scene scene;
    if (!rt_read_text(text, strlen(text), "the report's scene", &reading, set, stderr, &file))
        return NULL;
    bool placed = placement(&file, stderr, &scene);
    rt_scene_free(&file);
    if (!placed)
        return NULL;
    json_t *drawn = json_pack("{s:s, s:s, s:i, s:i, s:o}", "name", name, "file", text, "width",
                              scene.width, "height", scene.height, "tiers", draw_tiers(&scene));
    placement_free(&scene);
    return drawn;
}

json_t *report_pictures_draw(void)
{
    json_t *list = json_array();
    for (size_t i = 0; i < sizeof subjects / sizeof *subjects; i++) {
        if (json_array_append_new(list, draw_subject(subjects[i].name, subjects[i].file)) == 0)
            continue;
        report_fail("a picture cannot be drawn");
        json_decref(list);
        return NULL;
    }
    return list;
}
