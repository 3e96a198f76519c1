/* SPDX-License-Identifier: MIT */
#include "sights.h"

#include "render_file.h"

#include <stdlib.h>

static void *needed(void *memory)
{
    if (!memory)
        abort();
    return memory;
}

sights sights_new(const sure_scene *scene)
{
    size_t pixels = (size_t)scene->width * (size_t)scene->height;
    return (sights){scene->width, scene->height, needed(malloc(pixels * sizeof(int)))};
}

void sights_free(sights *seen)
{
    free(seen->objects);
}

static int pixels_of(const sights *seen)
{
    return seen->width * seen->height;
}

/* The bytes of a number, as a colour; 0 is black. */
static sure_vec3 color_of(size_t number)
{
    return (sure_vec3){(double)(number >> 16) / 255, (double)(number >> 8 & 255) / 255,
                       (double)(number & 255) / 255};
}

/* The scene with the lights given in matte colours of the objects' own, or in white. */
static picture matte_picture(sure_scene scene, sure_tier tier, bool white)
{
    const render_settings settings = {.how = {.tier = tier, .threads = 1},
                                      .integrator = INTEGRATOR_BACKWARD};
    sure_material *materials = needed(calloc(scene.object_count + 1, sizeof *materials));
    picture image;
    for (size_t i = 0; i < scene.object_count; i++)
        materials[i].color = white ? (sure_vec3){1, 1, 1} : color_of(i + 1);
    scene.materials = materials;
    if (!picture_new(scene.width, scene.height, &image))
        abort();
    render_scene(&scene, &settings, &image);
    free(materials);
    return image;
}

picture sights_picture(const sure_scene *scene, sure_tier tier)
{
    sure_scene unlit = *scene;
    unlit.light_count = 0;
    unlit.ambient = (sure_vec3){1, 1, 1};
    return matte_picture(unlit, tier, false);
}

sights sights_drawn(const sure_scene *scene, sure_tier tier)
{
    picture image = sights_picture(scene, tier);
    sights seen = sights_new(scene);
    for (int i = 0; i < pixels_of(&seen); i++) {
        const uint8_t *rgb = image.rgb + 3 * i;
        seen.objects[i] = (rgb[0] << 16 | rgb[1] << 8 | rgb[2]) - 1;
    }
    picture_free(&image);
    return seen;
}

int sights_differ(const sights *seen, const sights *expected)
{
    int wrong = 0;
    for (int i = 0; i < pixels_of(seen); i++)
        wrong += seen->objects[i] != expected->objects[i];
    return wrong;
}

/* So bright that no cosine of theirs is too small for a byte. */
int sights_dark(const sure_scene *scene, sure_tier tier)
{
    const sure_light lamp = {scene->camera.position, {1, 1, 1}, 0x1p60};
    sure_scene lit = *scene;
    int dark = 0;
    lit.lights = &lamp;
    lit.light_count = 1;
    lit.falloff = SURE_FALLOFF_NONE;
    lit.ambient = (sure_vec3){0, 0, 0};
    picture image = matte_picture(lit, tier, true);
    sights seen = sights_drawn(scene, tier);
    for (int i = 0; i < pixels_of(&seen); i++)
        dark += seen.objects[i] != SIGHT_NOTHING && image.rgb[3 * i] == 0;
    picture_free(&image);
    sights_free(&seen);
    return dark;
}
