#include "sights.h"

#include "render_file.h"

#include <stdlib.h>

bool sights_new(const sure_scene *scene, sights *seen)
{
    *seen = (sights){scene->width, scene->height,
                     malloc((size_t)scene->width * (size_t)scene->height * sizeof(int))};
    return seen->objects != NULL;
}

void sights_free(sights *seen)
{
    free(seen->objects);
    seen->objects = NULL;
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

/* Draws the scene with the lights given in matte colours of the objects' own, or in white. */
static bool draw_matte(const sure_scene *scene, sure_tier tier, bool white, picture *image)
{
    const render_settings settings = {.how = {.tier = tier, .threads = 1},
                                      .integrator = INTEGRATOR_BACKWARD};
    sure_scene matte = *scene;
    sure_material *materials = calloc(scene->object_count + 1, sizeof *materials);
    matte.materials = materials;
    for (size_t i = 0; materials && i < scene->object_count; i++)
        materials[i].color = white ? (sure_vec3){1, 1, 1} : color_of(i + 1);
    bool ok = materials && picture_new(scene->width, scene->height, image);
    if (ok)
        render_scene(&matte, &settings, image);
    free(materials);
    return ok;
}

bool sights_drawn(const sure_scene *scene, sure_tier tier, sights *seen)
{
    picture image;
    sure_scene unlit = *scene;
    unlit.light_count = 0;
    unlit.ambient = (sure_vec3){1, 1, 1};
    if (!draw_matte(&unlit, tier, false, &image))
        return false;
    bool ok = sights_new(scene, seen);
    for (int i = 0; ok && i < pixels_of(seen); i++) {
        const uint8_t *rgb = image.rgb + 3 * i;
        seen->objects[i] = (rgb[0] << 16 | rgb[1] << 8 | rgb[2]) - 1;
    }
    picture_free(&image);
    return ok;
}

int sights_differ(const sights *seen, const sights *expected)
{
    int wrong = 0;
    for (int i = 0; i < pixels_of(seen); i++)
        wrong += seen->objects[i] != expected->objects[i];
    return wrong;
}

/* So bright that no cosine of theirs is too small for a byte. */
int sights_dark(const sure_scene *scene, sure_tier tier, bool *ok)
{
    const sure_light lamp = {scene->camera.position, {1, 1, 1}, 0x1p60};
    sure_scene lit = *scene;
    picture image;
    sights seen;
    int dark = 0;
    lit.lights = &lamp;
    lit.light_count = 1;
    lit.falloff = SURE_FALLOFF_NONE;
    lit.ambient = (sure_vec3){0, 0, 0};
    *ok = false;
    if (!sights_drawn(scene, tier, &seen))
        return 0;
    if (draw_matte(&lit, tier, true, &image)) {
        for (int i = 0; i < pixels_of(&seen); i++)
            dark += seen.objects[i] != SIGHT_NOTHING && image.rgb[3 * i] == 0;
        picture_free(&image);
        *ok = true;
    }
    sights_free(&seen);
    return dark;
}
