/* SPDX-License-Identifier: MIT */
#include "../numbers/sums.h"

#include <surehit/backward.h>

#include "meeting.h"
#include "visible.h"

#include <surehit/mixed.h>
#include <surehit/shadow.h>

#include <assert.h>
#include <math.h>

/* A ray that is to be followed. */
typedef struct {
    sure_ray_kind kind;
    const sure_ray *ray;
    const sure_surface_point *leaving; /* NULL: the eye */
    int depth;
} follow;

/* What one light gives that reaches the point: a transparent surface shows its highlight only. */
static sure_vec3 lit_by(const sure_scene *scene, const sure_light *light, double intensity,
                        const meeting *at)
{
    const sure_material *material = at->material;
    double highlight = 0;
    if (material->specular > 0) {
        sure_vec3 to_light = difference_of(light->position, at->point);
        highlight = sure_phong_specular_textbook(at->normal, negate(at->ray->direction), to_light,
                                                 material->shine);
    }
    sure_vec3 incoming = sure_light_color_textbook(light, at->point, scene->falloff);
    return sure_phong_mix_textbook(material, incoming, meeting_is_clear(at) ? 0 : intensity,
                                   highlight);
}

/* A plain tier may tell a point or a normal that is none; a point that is too far is none, too. */
static bool is_lightable(const meeting *at)
{
    const sure_vec3 p = at->point, n = at->normal;
    return isfinite(p.x) && isfinite(p.y) && isfinite(p.z) && isfinite(n.x) && isfinite(n.y) &&
           isfinite(n.z) && (n.x != 0 || n.y != 0 || n.z != 0);
}

/* Where rays leave a hit on the side that is seen: found for the first of them. */
typedef struct {
    bool asked, found;
    sure_surface_point from;
} departure;

/* NULL: there is no place. */
static const sure_surface_point *leave(const tracing *t, const meeting *at, departure *seen)
{
    if (!seen->asked)
        seen->found = meeting_leave(t, at, at->side, &seen->from);
    seen->asked = true;
    return seen->found ? &seen->from : NULL;
}

/* A ray, what it meets, and what is seen there. */
typedef struct {
    follow way;
    sure_status met;
    const sure_nearest *nearest;
    meeting at;
    departure seen;
    sure_vec3 own;
    bool goes_on, through, lights; /* own is not all; the ray goes through; lights are asked */
} sight;

/* Where the way to the light starts, and how much of its light would fall there; NULL: none. */
static const sure_surface_point *towards(const tracing *t, sight *s, const sure_light *light,
                                         double *intensity)
{
    if (!s->lights)
        return NULL;
    *intensity = sure_light_intensity_textbook(s->at.point, s->at.normal, light->position);
    if (!meeting_faces(t, &s->at, light->position, *intensity))
        return NULL;
    const sure_surface_point *from = leave(t, &s->at, &s->seen);
    s->lights = from != NULL;
    return from;
}

static void lit_alone(const tracing *t, sight *s, const sure_light *light)
{
    double intensity;
    const sure_surface_point *from = towards(t, s, light, &intensity);
    if (from && shadow_reaches(t, from, light->position))
        s->own = add(s->own, lit_by(t->scene, light, intensity, &s->at));
}

static void lit_together(const tracing *t, sight *all, size_t count, const sure_light *light)
{
    const sure_surface_point *from[PACKET];
    sight *of[PACKET];
    double intensity[PACKET];
    size_t asked = 0;
    for (size_t k = 0; k < count; k++) {
        from[asked] = towards(t, &all[k], light, &intensity[asked]);
        of[asked] = &all[k];
        asked += from[asked] != NULL;
    }
    unsigned reached = shadow_reach(t, from, asked, light->position);
    for (size_t k = 0; k < asked; k++) {
        if (reached >> k & 1)
            of[k]->own = add(of[k]->own, lit_by(t->scene, light, intensity[k], &of[k]->at));
    }
}

/* Step 4: the lights that reach the points on the sides that are seen. */
static void light(const tracing *t, sight *all, size_t count)
{
    const sure_scene *scene = t->scene;
    for (size_t i = 0; i < scene->light_count; i++) {
        if (count == 1)
            lit_alone(t, all, &scene->lights[i]);
        else
            lit_together(t, all, count, &scene->lights[i]);
    }
}

/* And what mirrors and glass send there: of that the map has what a mirror leaves to the matte
 * part, as will be left of all that the surface shows by itself. */
static sure_vec3 lit_by_photons(const sure_scene *scene, const meeting *at)
{
    if (!scene->caustics || !sure_mixed_is_matte(at->material) || !is_lightable(at))
        return (sure_vec3){0, 0, 0};
    const sure_photon_face face = {at->nearest->object, at->side, at->part};
    sure_vec3 light = sure_photon_map_gather(scene->caustics, &face, at->point);
    double left = 1 - at->material->mirror;
    sure_vec3 incoming = {light.x / left, light.y / left, light.z / left};
    return sure_phong_mix_textbook(at->material, incoming, 1, 0);
}

static sure_vec3 seen_along(const tracing *t, const follow *way);

/* What is seen from a place next to a hit (NULL: there is none). */
static sure_vec3 seen_from(const tracing *t, const sure_surface_point *from, sure_ray_kind kind,
                           sure_vec3 direction, int depth)
{
    if (!from)
        return (sure_vec3){0, 0, 0};
    sure_ray ray = {from->point, direction, 0, INFINITY};
    return seen_along(t, &(follow){kind, &ray, from, depth - 1});
}

static sure_vec3 reflected(const tracing *t, const meeting *at, departure *seen, int depth)
{
    return seen_from(t, leave(t, at, seen), SURE_RAY_MIRROR, meeting_reflect(at), depth);
}

/* What comes through the surface, in its colour. */
static sure_vec3 transmitted(const tracing *t, const meeting *at, sure_vec3 direction, int depth)
{
    sure_surface_point beyond;
    bool found = meeting_leave(t, at, meeting_beyond(at), &beyond);
    return product(at->material->color,
                   seen_from(t, found ? &beyond : NULL, SURE_RAY_REFRACTED, direction, depth));
}

/* Fresnel's share and the mirror's are reflected, the rest comes through. */
static sure_vec3 seen_through(const tracing *t, const meeting *at, departure *seen, sure_vec3 own,
                              int depth)
{
    parting into = meeting_part(at);
    if (into.share > 0)
        own = add(own, scaled(into.share, reflected(t, at, seen, depth)));
    if (into.share < 1)
        own = add(own, scaled(1 - into.share, transmitted(t, at, into.direction, depth)));
    return own;
}

/* Without light, mirror or glass nobody asks where it is met, nor for its normal. */
static bool shows_itself_alone(const sure_scene *scene, const sure_material *material, int depth)
{
    bool follows = material->mirror > 0 || material->refract > 0;
    return scene->light_count == 0 && !scene->caustics && !(follows && depth > 0);
}

/* Steps 2 and 3: where it is met, and the colour it has by itself. What is clear has none, but for
 * the last one seen. */
static void look_at(const tracing *t, sight *s)
{
    const sure_scene *scene = t->scene;
    s->own = (sure_vec3){0, 0, 0};
    s->goes_on = s->lights = false;
    if (s->met != SURE_HIT)
        return;
    const sure_material *material = &scene->materials[s->nearest->object];
    sure_vec3 ambient = sure_phong_mix_textbook(material, scene->ambient, 1, 0);
    if (shows_itself_alone(scene, material, s->way.depth)) {
        s->own = ambient;
        return;
    }
    s->goes_on = true;
    meeting_of(t, s->way.ray, s->way.leaving, s->nearest, &s->at);
    s->seen.asked = false;
    s->through = meeting_is_clear(&s->at) && s->way.depth > 0;
    if (!s->through)
        s->own = ambient;
    s->lights = !(meeting_is_clear(&s->at) && !(material->specular > 0)) && is_lightable(&s->at);
}

/* What is lit, and what it mirrors and lets through. */
static sure_vec3 shown(const tracing *t, sight *s)
{
    int depth = s->way.depth;
    if (s->through)
        return seen_through(t, &s->at, &s->seen, s->own, depth);
    sure_vec3 own = add(s->own, lit_by_photons(t->scene, &s->at));
    if (!(s->at.material->mirror > 0) || depth <= 0)
        return own;
    return sure_phong_mirror_textbook(s->at.material, own, reflected(t, &s->at, &s->seen, depth));
}

/* Steps 2 to 4 of rays that go together, from what they have met to what is seen. */
static void show(const tracing *t, sight *all, size_t count)
{
    for (size_t i = 0; i < count; i++)
        look_at(t, &all[i]);
    light(t, all, count);
    for (size_t i = 0; i < count; i++) {
        if (all[i].goes_on)
            all[i].own = shown(t, &all[i]);
    }
}

/* The four steps along one ray. */
static sure_vec3 seen_along(const tracing *t, const follow *way)
{
    sure_nearest nearest = {0};
    sight s;
    s.way = *way;
    s.nearest = &nearest;
    s.met = sure_backward_nearest(t->scene, t->tier, way->ray, way->leaving, &nearest);
    statistics_ray(t, way->kind, way->ray, way->leaving, s.met, nearest.object);
    if (way->kind == SURE_RAY_PIXEL)
        statistics_pixel(t, way->ray, s.met, &nearest);
    show(t, &s, 1);
    return s.own;
}

static sure_ray pixel_ray(const sure_scene *scene, sure_tier tier, int column, int row)
{
    assert(0 <= column && column < scene->width && 0 <= row && row < scene->height);
    sure_ray ray = sure_scene_pixel_ray(scene, column, row);
    ray.t_min = in_front(tier);
    return ray;
}

sure_vec3 sure_backward_pixel_told(const sure_scene *scene, sure_tier tier, int column, int row,
                                   sure_statistics *statistics)
{
    const sure_ray ray = pixel_ray(scene, tier, column, row);
    const tracing t = {scene, tier, statistics, NULL};
    return seen_along(&t, &(follow){SURE_RAY_PIXEL, &ray, NULL, scene->depth});
}

sure_vec3 sure_backward_pixel(const sure_scene *scene, sure_tier tier, int column, int row)
{
    return sure_backward_pixel_told(scene, tier, column, row, NULL);
}

/* The same along the rays of up to PACKET pixels. */
static void seen_together(const tracing *t, size_t count, const int *column, const int *row,
                          sure_vec3 *color)
{
    packet rays;
    sure_ray ray[PACKET];
    sight s[PACKET];
    sure_nearest nearest[PACKET];
    t->together->pixels(t->scene, count, column, row, &rays);
    for (size_t i = 0; i < count; i++) {
        rays.t_min[i] = in_front(t->tier);
        ray[i] = packet_ray(&rays, i);
    }
    unsigned met = t->together->nearest(t->scene, &rays, nearest);
    for (size_t i = 0; i < count; i++) {
        s[i].way = (follow){SURE_RAY_PIXEL, &ray[i], NULL, t->scene->depth};
        s[i].met = met >> i & 1 ? SURE_HIT : SURE_MISS;
        s[i].nearest = &nearest[i];
    }
    show(t, s, count);
    for (size_t i = 0; i < count; i++)
        color[i] = s[i].own;
}

void sure_backward_pixels(const sure_scene *scene, sure_tier tier, size_t count, const int *column,
                          const int *row, sure_vec3 *color)
{
    const packet_walks *together = tier == SURE_TIER_CERTAIN ? packet_walks_here() : NULL;
    const tracing t = {scene, tier, NULL, together};
    for (size_t i = 0; !together && i < count; i++)
        color[i] = sure_backward_pixel(scene, tier, column[i], row[i]);
    for (size_t i = 0; together && i < count; i += PACKET)
        seen_together(&t, count - i < PACKET ? count - i : PACKET, column + i, row + i, color + i);
}
