/* SPDX-License-Identifier: MIT */
/* camera: a pixel's ray, or one to a light, from a mirror or through glass, and an object whose box
 * it meets. Hits and normals are those of the tier exact, of which every bit is told. */
#include "regimes_camera.h"

#include "../../geometry/coordinate.h"

#include "regimes_layout.h"

#include <math.h>

#include <surehit/backward.h>
#include <surehit/reflect.h>
#include <surehit/refract.h>
#include <surehit/spawn.h>

/* Followed so far. */
typedef struct {
    camera_pixel pixel;
    sure_ray_kind kind;
    sure_ray ray;
    sure_surface_point from; /* where it is no pixel's */
    double way;
} sight;

static int random_pixel(rng *g, int pixels, int window, int finer)
{
    int first = camera_window(pixels, window, rng_integer(g, 0, 1)) * finer;
    return rng_integer(g, first, first + window * finer - 1);
}

static sight random_sight(const camera_picture *picture, rng *g)
{
    camera_pixel at = {.of = picture, .finer = rng_integer(g, 1, CAMERA_FINEST)};
    at.column = random_pixel(g, picture->scene.width, picture->columns, at.finer);
    at.row = random_pixel(g, picture->scene.height, picture->rows, at.finer);
    return (sight){.pixel = at,
                   .kind = SURE_RAY_PIXEL,
                   .ray = camera_pixel_ray(picture, at.finer, at.column, at.row)};
}

/* A direction to the side of the surface that is seen, or to the other one. */
typedef struct {
    sure_vec3 direction;
    bool beyond, found;
} turning;

/* Glass bends what goes through it; a sheet's two faces do so to and fro. */
static turning through(sure_vec3 direction, sure_vec3 normal, const sure_object *object,
                       double index, bool within)
{
    turning way = {direction, true, true};
    if (sure_shape_info_of(object->shape)->solid)
        way.found = sure_refract_textbook(direction, normal, within ? index : 1 / index,
                                          &way.direction) == SURE_HIT;
    return way;
}

/* Lights behind the surface reach nothing. */
static turning to_light(const sure_scene *scene, const sure_ray *ray, double t, sure_vec3 normal,
                        rng *g)
{
    if (scene->light_count == 0)
        return (turning){.found = false};
    sure_vec3 light = scene->lights[rng_integer(g, 0, (int)scene->light_count - 1)].position;
    sure_vec3 way = difference_of(light, sum_of(ray->origin, t, ray->direction));
    return (turning){light, false, dot(normal, way) > 0};
}

static bool sends(const sure_material *material, sure_ray_kind kind)
{
    return kind == SURE_RAY_MIRROR      ? material->mirror > 0
           : kind == SURE_RAY_REFRACTED ? material->refract > 0
                                        : true;
}

/* Does the ray meet what sends one of that kind, be it behind something else? Mostly not, which is
 * told sooner than what it meets first, but where all do. What it has left it meets again from
 * within alone. */
static bool meets_sender(const sight *s, sure_ray_kind kind)
{
    const sure_scene *scene = &s->pixel.of->scene;
    bool met = kind == SURE_RAY_SHADOW;
    for (size_t i = 0; i < scene->object_count && !met; i++)
        met = sends(&scene->materials[i], kind) &&
              sure_object_occluded(&s->ray, &scene->objects[i], SURE_TIER_CERTAIN) == SURE_HIT;
    return met;
}

/* The nearest surface, if it sends a ray of that kind at all: which one, `certain` knows, too. */
static bool find_sender(const sight *s, sure_ray_kind kind, sure_nearest *seen)
{
    const sure_scene *scene = &s->pixel.of->scene;
    const sure_surface_point *leaving = s->kind == SURE_RAY_PIXEL ? NULL : &s->from;
    if (!meets_sender(s, kind) ||
        sure_backward_nearest(scene, SURE_TIER_CERTAIN, &s->ray, leaving, seen) != SURE_HIT ||
        !sends(&scene->materials[seen->object], kind))
        return false;
    const sure_object *object = &scene->objects[seen->object];
    if (leaving && leaving->object == seen->object)
        return sure_scene_meets_again(scene, SURE_TIER_EXACT, &s->ray, leaving, &seen->hit) ==
               SURE_HIT;
    return sure_object_hit(&s->ray, object, SURE_TIER_EXACT, &seen->hit) == SURE_HIT;
}

/* On to what the ray of that kind meets, if the nearest surface sends one. */
static bool follow(sight *s, sure_ray_kind kind, rng *g)
{
    const sure_scene *scene = &s->pixel.of->scene;
    const sure_ray ray = s->ray;
    sure_nearest seen;
    if (!find_sender(s, kind, &seen))
        return false;
    const sure_object *object = &scene->objects[seen.object];
    const sure_material *material = &scene->materials[seen.object];
    sure_vec3 normal = sure_object_normal(&ray, object, SURE_TIER_EXACT, &seen.hit);
    bool within = dot(normal, ray.direction) > 0;
    if (within)
        normal = scaled(-1, normal);
    turning on = {sure_reflect_textbook(scaled(-1, ray.direction), normal), false, true};
    if (kind == SURE_RAY_REFRACTED)
        on = through(ray.direction, normal, object, material->refract, within);
    else if (kind == SURE_RAY_SHADOW)
        on = to_light(scene, &ray, seen.hit.t, normal, g);
    sure_side side = within == on.beyond ? SURE_SIDE_OUTSIDE : SURE_SIDE_INSIDE;
    if (!on.found || !sure_spawn(&ray, object, &seen.hit, side, &s->from.point))
        return false;
    bool lit = kind == SURE_RAY_SHADOW; /* the light itself, at t = 1, is no obstacle */
    s->way += seen.hit.t * sqrt(dot(ray.direction, ray.direction));
    s->kind = kind;
    s->from.object = seen.object;
    s->from.inside = side == SURE_SIDE_INSIDE && sure_shape_info_of(object->shape)->solid;
    s->ray =
        (sure_ray){s->from.point, lit ? difference_of(on.direction, s->from.point) : on.direction,
                   0, lit ? 1 - 0x1p-53 : HUGE_VAL};
    return true;
}

/* As a hierarchy asks: the object whose leaf's box the ray meets, but not the surface that it has
 * left, unless from within; ... */
static bool is_asked(const sight *s, size_t object)
{
    bool leaves = s->kind != SURE_RAY_PIXEL && s->from.object == object && !s->from.inside;
    return !leaves && camera_meets_box(&s->ray, &s->pixel.of->boxes[object]);
}

/* ... and a cap in its own box. */
static bool is_shown(const sight *s, const sure_object *shown, const sure_object *whole)
{
    sure_bounds box;
    return shown->shape == whole->shape || !sure_bvh_box(shown, &box) ||
           camera_meets_box(&s->ray, &box);
}

/* From within, the tracer asks for the end of the chord on its far half. The first hit is that end,
 * where it is in the range, and found sooner than both. */
static sure_ray ray_from_within(const sure_ray *ray, const sure_object *object)
{
    sure_hit end;
    sure_interval chord;
    sure_ray rest = *ray;
    if (sure_object_hit(ray, object, SURE_TIER_EXACT, &end) == SURE_HIT && end.leaves)
        rest.t_min = fmax(ray->t_min, end.t / 2);
    else if (sure_object_interval(ray, object, SURE_TIER_EXACT, &chord) == SURE_HIT)
        rest.t_min = fmax(ray->t_min, chord.t_leave / 2);
    return rest.t_min <= rest.t_max ? rest : *ray;
}

static bool random_asked(const sight *s, sure_shape shape, rng *g, sure_case *asked)
{
    const sure_scene *scene = &s->pixel.of->scene;
    const sure_shape_info *info = sure_shape_info_of(shape);
    const bool is_cap = info->bounded && !info->solid;
    int count = 0;
    for (size_t i = 0; i < scene->object_count; i++) {
        const sure_object *object = &scene->objects[i];
        if (object->shape != shape && !is_cap)
            continue;
        bool own = s->kind != SURE_RAY_PIXEL && s->from.object == i && shape == object->shape;
        sure_object shown[2];
        int shows = camera_shown_by(object, shape, shown);
        if (shows > 0 && !is_asked(s, i))
            continue;
        for (int k = 0; k < shows; k++) {
            if (is_shown(s, &shown[k], object) && rng_integer(g, 0, count++) == 0)
                *asked = (sure_case){.ray = own ? ray_from_within(&s->ray, object) : s->ray,
                                     .object = shown[k]};
        }
    }
    return count > 0;
}

/* In a quarter of draws what is seen in a mirror, or through glass. */
static bool random_follow(sight *s, sure_ray_kind kind, rng *g)
{
    if (kind == SURE_RAY_PIXEL)
        return true;
    bool indirect = rng_chance(g, 1, 4);
    sure_ray_kind first = rng_chance(g, 1, 2) ? SURE_RAY_MIRROR : SURE_RAY_REFRACTED;
    return (!indirect || follow(s, first, g)) && follow(s, kind, g);
}

static const camera_picture *random_picture(sure_shape shape, sure_ray_kind kind, rng *g)
{
    const camera_picture *picture;
    do
        picture = &camera_pictures[rng_integer(g, 0, camera_picture_count - 1)];
    while (!camera_has_shape(picture, shape) || !camera_has_kind(picture, kind));
    return picture;
}

camera_case camera_case_of(sure_shape shape, rng *g)
{
    enum { TRIES = 256 }; /* of a picture: where rays of a kind may meet no such object */
    static const sure_ray_kind kinds[8] = {SURE_RAY_PIXEL,  SURE_RAY_PIXEL,    SURE_RAY_PIXEL,
                                           SURE_RAY_PIXEL,  SURE_RAY_SHADOW,   SURE_RAY_SHADOW,
                                           SURE_RAY_MIRROR, SURE_RAY_REFRACTED};
    sure_ray_kind kind = kinds[rng_integer(g, 0, 7)];
    const camera_picture *picture = NULL;
    for (int tries = 0;; tries++) {
        if (tries % TRIES == 0)
            picture = random_picture(shape, kind, g);
        sight s = random_sight(picture, g);
        sure_case asked;
        if (random_follow(&s, kind, g) && random_asked(&s, shape, g, &asked))
            return (camera_case){asked, s.pixel, kind, s.way};
    }
}

static double length(sure_vec3 v)
{
    return sqrt(dot(v, v));
}

camera_lengths camera_lengths_of(const camera_case *of)
{
    const camera_pixel *at = &of->pixel;
    const sure_scene *scene = &at->of->scene;
    sure_vec3 middle = camera_pixel_ray(at->of, at->finer, at->column, at->row).direction;
    return (camera_lengths){.extent = at->of->extent,
                            .pixel = scene->camera.viewport_width / (scene->width * at->finer) /
                                     length(middle),
                            .way = of->way,
                            .speed = length(of->question.ray.direction)};
}

sure_case make_camera(sure_shape shape, rng *g)
{
    return camera_case_of(shape, g).question;
}
