/* SPDX-License-Identifier: MIT */
/* Writes scenes as the regime camera has them, for src/cases/regimes/camera_scenes.jsonl.
 *
 *     camera_scenes SCENE.rt[:COLUMNSxROWS]...
 *
 * With the size of a window (camera_pictures.h), only what rays of the picture's four windows may
 * meet is written. */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <surehit/backward.h>

#include "../../src/cases/regimes/camera_pictures.h"
#include "../../src/cases/regimes/regimes_layout.h"
#include "../../src/geometry/coordinate.h"
#include "../../src/hierarchy/bvh_build.h"
#include "../../src/scene/placement.h"

typedef struct {
    camera_picture picture; /* of all of its scene */
    char name[64];
    sure_bounds *boxes; /* by object: the picture's */
    bool *wanted;       /* by object: may be met from one of the windows */
} written;

static void fail(const char *path)
{
    fprintf(stderr, "camera_scenes: %s: no such scene\n", path);
    exit(2);
}

static json_t *vector_json(const double *x)
{
    return json_pack("[f, f, f]", x[0], x[1], x[2]);
}

static json_t *box_json(const sure_bounds *box)
{
    return isfinite(box->low[0])
               ? json_pack("[o, o]", vector_json(box->low), vector_json(box->high))
               : json_null();
}

static json_t *object_json(const sure_object *object, const sure_material *material,
                           const sure_bounds *box)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    const double *x = (const double *)(const void *)&object->as;
    json_t *made =
        json_pack("[s, f, f, o]", info->name, material->mirror, material->refract, box_json(box));
    for (int i = 0; i < info->field_count; i++) {
        const double *at = x + info->fields[i].at;
        json_array_append_new(made, info->fields[i].kind == SURE_KIND_RADIUS ? json_real(*at)
                                                                             : vector_json(at));
    }
    return made;
}

static written read_scene(const char *path)
{
    rt_scene file;
    written w = {.wanted = NULL};
    camera_picture *picture = &w.picture;
    const rt_options options = rt_default_options();
    const char *slash = strrchr(path, '/');
    snprintf(w.name, sizeof w.name, "%s", slash ? slash + 1 : path);
    w.name[strcspn(w.name, ".")] = '\0';
    if (!rt_read(path, &options, 0, stderr, &file))
        fail(path);
    if (!placement(&file, stderr, &picture->scene))
        fail(path);
    rt_scene_free(&file);
    return w;
}

/* The boxes of the hierarchy's leaves, to the thousandth outside; all space where there is no
 * hierarchy, and for what is not bounded. */

static void set_box(sure_bounds *box, const sure_bvh_node *node, int child)
{
    for (int axis = 0; axis < 3; axis++) {
        box->low[axis] = node ? floor(1000 * node->bound[2 * axis][child]) / 1000 : -INFINITY;
        box->high[axis] = node ? ceil(1000 * node->bound[2 * axis + 1][child]) / 1000 : INFINITY;
    }
}

static void find_leaves(const written *w, const sure_bvh *bvh, uint32_t index)
{
    const sure_bvh_node *node = &bvh->nodes[index];
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        if (node->count[k] == SURE_BVH_INNER)
            find_leaves(w, bvh, node->first[k]);
        for (uint32_t i = 0; node->count[k] != SURE_BVH_INNER && i < node->count[k]; i++)
            set_box(&w->boxes[bvh->slots[node->first[k] + i]], node, k);
    }
}

static void find_boxes(const written *w)
{
    const sure_bvh *bvh = w->picture.scene.bvh;
    for (size_t i = 0; i < w->picture.scene.object_count; i++)
        set_box(&w->boxes[i], NULL, 0);
    if (bvh)
        find_leaves(w, bvh, 0);
}

/* What may be met by rays of the windows' pixels, and by those from what they hit to a light. */

static void want_along(const written *w, const sure_ray *ray)
{
    for (size_t i = 0; i < w->picture.scene.object_count; i++)
        w->wanted[i] = w->wanted[i] || camera_meets_box(ray, &w->boxes[i]);
}

static void want_by_pixel(const written *w, int column, int row)
{
    const sure_scene *scene = &w->picture.scene;
    sure_nearest seen;
    sure_ray ray = camera_pixel_ray(&w->picture, 1, column, row);
    want_along(w, &ray);
    if (sure_backward_nearest(scene, SURE_TIER_EXACT, &ray, NULL, &seen) != SURE_HIT)
        return;
    for (size_t i = 0; i < scene->light_count; i++) {
        sure_vec3 hit = sum_of(ray.origin, seen.hit.t, ray.direction);
        sure_ray back = {hit, difference_of(scene->lights[i].position, hit), 0, 1};
        want_along(w, &back);
    }
}

static void want_window(const written *w, int which)
{
    const camera_picture *picture = &w->picture;
    int left = camera_window(picture->scene.width, picture->columns, which % 2);
    int lowest = camera_window(picture->scene.height, picture->rows, which / 2);
    for (int i = 0; i < picture->columns * picture->rows; i++)
        want_by_pixel(w, left + i % picture->columns, lowest + i / picture->columns);
}

/* SCENE.rt[:COLUMNSxROWS] */
static written ask(char *argument)
{
    char *window = strchr(argument, ':');
    if (window)
        *window++ = '\0';
    written w = read_scene(argument);
    camera_picture *picture = &w.picture;
    picture->columns = picture->scene.width / 2;
    picture->rows = picture->scene.height / 2;
    size_t count = picture->scene.object_count;
    w.wanted = calloc(count + 1, sizeof *w.wanted);
    w.boxes = calloc(count + 1, sizeof *w.boxes);
    if (!w.wanted || !w.boxes ||
        (window && sscanf(window, "%dx%d", &picture->columns, &picture->rows) != 2))
        fail(argument);
    memset(w.wanted, !window, count);
    sure_bvh bvh;
    picture->scene.bvh = bvh_for(&picture->scene, true, 0, &bvh);
    find_boxes(&w);
    for (int which = 0; window && which < 4; which++)
        want_window(&w, which);
    picture->scene.bvh = NULL;
    bvh_free(&bvh);
    return w;
}

static void print(json_t *line)
{
    json_dumpf(line, stdout, JSON_COMPACT);
    putchar('\n');
    json_decref(line);
}

static double extent_of(const written *w)
{
    const sure_scene *scene = &w->picture.scene;
    const sure_vec3 eye = scene->camera.position;
    sure_vec3 low = eye, high = eye;
    sure_bounds box;
    for (size_t i = 0; i < scene->object_count; i++) {
        if (!w->wanted[i] || !sure_bvh_box(&scene->objects[i], &box))
            continue;
        for (int k = 0; k < 3; k++) {
            double *least = coordinate_of(&low, k), *most = coordinate_of(&high, k);
            *least = fmin(*least, box.low[k]);
            *most = fmax(*most, box.high[k]);
        }
    }
    const sure_vec3 across = difference_of(high, low);
    return sqrt(dot(across, across));
}

static void print_picture(const written *w)
{
    const sure_scene *scene = &w->picture.scene;
    const sure_camera *camera = &scene->camera;
    json_t *lights = json_array();
    for (size_t i = 0; i < scene->light_count; i++)
        json_array_append_new(lights, vector_json(&scene->lights[i].position.x));
    const sure_vec3 *turn = scene->turn.row;
    print(json_pack("{s:s, s:[i, i], s:[i, i], s:[o, f, f, f], s:[o, o, o], s:f, s:o}", "name",
                    w->name, "size", scene->width, scene->height, "window", w->picture.columns,
                    w->picture.rows, "camera", vector_json(&camera->position.x),
                    camera->focal_length, camera->viewport_width, camera->viewport_height, "turn",
                    vector_json(&turn[0].x), vector_json(&turn[1].x), vector_json(&turn[2].x),
                    "extent", extent_of(w), "lights", lights));
    for (size_t i = 0; i < scene->object_count; i++) {
        if (w->wanted[i])
            print(object_json(&scene->objects[i], &scene->materials[i], &w->boxes[i]));
    }
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        written w = ask(argv[i]);
        print_picture(&w);
        placement_free(&w.picture.scene);
        free(w.wanted);
        free(w.boxes);
    }
    return fflush(stdout) == 0 && !ferror(stdout) ? EXIT_SUCCESS : EXIT_FAILURE;
}
