/* SPDX-License-Identifier: MIT */
#include "blackness.h"

#include "../numbers/sums.h"
#include "explain.h"

#include <surehit/bvh.h>

/* Where an object lies: told from its bounds, so that what is only near a border may be given to
 * the other side of it. */
typedef enum { BEHIND, BESIDE, HOLDS_CAMERA, BETWEEN, PLACES } place;

static const char *const words[PLACES] = {
    [BEHIND] = "behind the camera",
    [BESIDE] = "beside the view",
    [HOLDS_CAMERA] = "edge-on, in a plane with the camera",
    [BETWEEN] = "in front, but too small or thin for any ray",
};

/* As the camera has it: to the right, above and ahead. */
static sure_vec3 seen_from_camera(const sure_scene *scene, sure_vec3 point)
{
    sure_vec3 way = difference_of(point, scene->camera.position);
    const sure_vec3 *row = scene->turn.row;
    return (sure_vec3){dot(row[0], way), dot(row[1], way), -dot(row[2], way)};
}

/* Of a plane, which alone has no bounds. No ray met it: it is behind, or the camera lies in it. */
static place place_of_plane(const sure_scene *scene, const sure_plane *plane)
{
    double side = dot(plane->normal, difference_of(scene->camera.position, plane->point));
    return side == 0 ? HOLDS_CAMERA : BEHIND;
}

/* Corners of the box that are on the outer side of each border of the view. */
static place place_of_bounds(const sure_scene *scene, const sure_bounds *box)
{
    const double across = scene->camera.viewport_width / 2 / scene->camera.focal_length;
    const double up = scene->camera.viewport_height / 2 / scene->camera.focal_length;
    int behind = 0, outside[4] = {0};
    for (int corner = 0; corner < 8; corner++) {
        sure_vec3 at = {corner & 1 ? box->high[0] : box->low[0],
                        corner & 2 ? box->high[1] : box->low[1],
                        corner & 4 ? box->high[2] : box->low[2]};
        sure_vec3 seen = seen_from_camera(scene, at);
        behind += seen.z <= 0;
        outside[0] += seen.x > across * seen.z;
        outside[1] += seen.x < -across * seen.z;
        outside[2] += seen.y > up * seen.z;
        outside[3] += seen.y < -up * seen.z;
    }
    if (behind == 8)
        return BEHIND;
    for (int border = 0; border < 4; border++) {
        if (outside[border] == 8)
            return BESIDE;
    }
    return behind > 0 ? BESIDE : BETWEEN;
}

static place where_is(const sure_scene *scene, const sure_object *object)
{
    sure_bounds box;
    return sure_bvh_box(object, &box) ? place_of_bounds(scene, &box)
                                      : place_of_plane(scene, &object->as.plane);
}

static void print_places(FILE *messages, const sure_scene *scene)
{
    size_t counts[PLACES] = {0};
    for (size_t i = 0; i < scene->object_count; i++)
        counts[where_is(scene, &scene->objects[i])]++;
    fprintf(messages, "no ray met anything: of %zu object%s", scene->object_count,
            scene->object_count == 1 ? "" : "s");
    const char *between = " ";
    for (int i = 0; i < PLACES; i++) {
        if (counts[i] == 0)
            continue;
        fprintf(messages, "%s%zu %s %s", between, counts[i], counts[i] == 1 ? "is" : "are",
                words[i]);
        between = ", ";
    }
    if (2 * counts[BEHIND] > scene->object_count)
        fputs("; --handedness mirrors a view and does not turn it round: that is the camera's "
              "direction",
              messages);
}

static bool is_black(sure_vec3 color)
{
    return color.x == 0 && color.y == 0 && color.z == 0;
}

/* Is only what lies elsewhere seen in it or through it? */
static bool shows_others(const sure_scene *scene, const sure_material *material, bool lit)
{
    bool clear = material->refract > 0 && !(lit && material->specular > 0);
    return scene->depth > 0 && (clear || material->mirror >= 1);
}

static void print_darkness(FILE *messages, const sure_scene *scene)
{
    size_t black = 0, shining = 0, others = 0;
    for (size_t i = 0; i < scene->light_count; i++)
        shining += scene->lights[i].brightness > 0 && !is_black(scene->lights[i].color);
    for (size_t i = 0; i < scene->object_count; i++) {
        bool dark = is_black(scene->materials[i].color);
        black += dark;
        others += !dark && shows_others(scene, &scene->materials[i], shining > 0);
    }
    fputs("rays met objects, and all that they saw is black: ", messages);
    if (black == scene->object_count)
        fputs("so is every object's colour", messages);
    else if (black + others == scene->object_count)
        fprintf(messages, "nothing but empty space%s is seen in mirrors and through glass",
                black > 0 ? " and what is black" : "");
    else if (shining == 0 && is_black(scene->ambient))
        fputs("there is no light", messages);
    else
        fprintf(messages,
                "light is too faint there, or reaches none of it%s; of %zu object%s %zu %s black",
                others > 0 ? ", or it is a mirror or glass, and shows nothing" : "",
                scene->object_count, scene->object_count == 1 ? "" : "s", black,
                black == 1 ? "is" : "are");
}

void blackness_explain(FILE *messages, const char *name, const sure_scene *scene,
                       const sure_statistics *statistics)
{
    fprintf(messages, "%s: warning: ", name);
    if (scene->object_count == 0)
        fputs("no ray met anything: there is no object", messages);
    else if (explain_sum(statistics->decided, SURE_STAGES) == 0)
        print_places(messages, scene);
    else
        print_darkness(messages, scene);
    fputc('\n', messages);
}
