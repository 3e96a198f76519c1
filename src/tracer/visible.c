/* SPDX-License-Identifier: MIT */
#include "visible.h"

#include "../hierarchy/bvh_walk.h"
#include "../numbers/environment.h"
#include "../stages/query.h"
#include "../stages/rows.h"
#include "meeting.h"

#include <surehit/backward.h>

typedef struct {
    const sure_scene *scene;
    sure_tier tier;
    const sure_surface_point *leaving;
    const sure_ray *ray;
    const sure_vec3 *light;        /* that the ray leads to, or NULL */
    const sure_float_ray *rounded; /* for the scene's floats; NULL: its objects are asked */
    double farthest; /* as far as the nearest so far: what lies beyond is of no interest */
    sure_status found;
    sure_nearest nearest;
} search;

static search search_of(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                        const sure_surface_point *leaving, sure_float_ray *room)
{
    bool rounds = tier == SURE_TIER_FLOAT32 && scene->floats;
    if (rounds)
        sure_float_ray_of(ray, room);
    return (search){.scene = scene,
                    .tier = tier,
                    .leaving = leaving,
                    .ray = ray,
                    .rounded = rounds ? room : NULL,
                    .farthest = ray->t_max,
                    .found = SURE_MISS};
}

static INLINED bool meets(const search *s, size_t object, sure_hit *hit)
{
    if (s->rounded && !(s->leaving && s->leaving->object == object))
        return sure_float_object_hit(s->rounded, &s->scene->floats[object], hit) == SURE_HIT;
    return visible_meets(s->scene, s->tier, s->ray, s->leaving, object, hit);
}

static int side_of_light(const sure_object *object, sure_vec3 light)
{
    const shape_row *row = row_of(object);
    bool known;
    int side;
    sure_stage unused;
    TO_NEAREST(known, query_side(row, &object->as, light, &side, &unused));
    return known ? side : query_side_exact(row, &object->as, light);
}

/* From a light on a convex surface the way back either enters the solid or never meets it. */
bool visible_is_at_light(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                         const sure_surface_point *leaving, const sure_vec3 *light, size_t object)
{
    const sure_vec3 d = ray->direction;
    const sure_ray back = {*light, {-d.x, -d.y, -d.z}, in_front(tier), 1};
    const int side = side_of_light(&scene->objects[object], *light);
    sure_hit unused;
    if (leaving && leaving->object == object)
        return side <= 0;
    return side == 0 && sure_object_hit(&back, &scene->objects[object], tier, &unused) != SURE_HIT;
}

static bool keep_nearest(search *s, size_t object)
{
    sure_hit hit;
    if (!meets(s, object, &hit))
        return false;
    if (s->found == SURE_HIT &&
        !visible_is_nearer(s->scene, s->tier, s->ray, object, &hit, &s->nearest))
        return false;
    s->found = SURE_HIT;
    s->nearest = (sure_nearest){object, hit};
    s->farthest = visible_as_far_as(s->tier, &hit, s->farthest);
    return false;
}

static INLINED bool stop_at_any(search *s, size_t object)
{
    sure_hit hit;
    if (!meets(s, object, &hit) ||
        (visible_may_be_at_light(s->light, s->tier, &hit) &&
         visible_is_at_light(s->scene, s->tier, s->ray, s->leaving, s->light, object)))
        return false;
    s->found = SURE_HIT;
    s->nearest.object = object;
    return true;
}

/* A question to objects. */
typedef struct {
    bool (*ask)(search *s, size_t object); /* true to stop */
    bool in_order;                         /* near ones first: the rest may not be asked */
} asking;

static INLINED bool ask_slots(search *s, asking how, size_t first, size_t count)
{
    const uint32_t *slots = s->scene->bvh->slots;
    for (size_t i = first; i < first + count; i++) {
        if (how.ask(s, slots[i]))
            return true;
    }
    return false;
}

typedef struct {
    double enter;
    uint32_t first;
    uint8_t count;
} pending;

/* Puts the children that are met on the stack, in order the nearest on top: its height. */
static INLINED int push_children(const sure_bvh_node *node, const bvh_probe *probe, double t_max,
                                 bool in_order, pending *stack, int height)
{
    double enter[SURE_BVH_WIDTH];
    uint64_t met[SURE_BVH_WIDTH];
    int bottom = height;
    bvh_meets(node, probe, t_max, enter, met);
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        if (!met[k])
            continue;
        int at = height++;
        for (; in_order && at > bottom && stack[at - 1].enter < enter[k]; at--)
            stack[at] = stack[at - 1];
        stack[at] = (pending){enter[k], node->first[k], node->count[k]};
    }
    return height;
}

static INLINED bool ask_boxes(search *s, asking how)
{
    const sure_bvh *bvh = s->scene->bvh;
    pending stack[(SURE_BVH_WIDTH - 1) * SURE_BVH_DEPTH + 1];
    bvh_probe probe = bvh_probe_of(s->ray);
    int height = 0;
    if (ask_slots(s, how, 0, bvh->unbounded))
        return true;
    if (bvh->nodes)
        stack[height++] = (pending){s->ray->t_min, 0, SURE_BVH_INNER};
    while (height > 0) {
        pending next = stack[--height];
        if (next.enter > s->farthest + probe.slack)
            continue;
        if (next.count == SURE_BVH_INNER)
            height = push_children(&bvh->nodes[next.first], &probe, s->farthest, how.in_order,
                                   stack, height);
        else if (ask_slots(s, how, next.first, next.count))
            return true;
    }
    return false;
}

static INLINED bool ask_all(search *s, asking how)
{
    if (s->scene->bvh)
        return ask_boxes(s, how);
    for (size_t i = 0; i < s->scene->object_count; i++) {
        if (how.ask(s, i))
            return true;
    }
    return false;
}

/* Step 1 of the backward tracer: distance. */
BVH_WIDE sure_status sure_backward_nearest(const sure_scene *scene, sure_tier tier,
                                           const sure_ray *ray, const sure_surface_point *leaving,
                                           sure_nearest *nearest)
{
    sure_float_ray room;
    search s = search_of(scene, tier, ray, leaving, &room);
    (void)ask_all(&s, (asking){keep_nearest, true});
    if (s.found == SURE_HIT)
        *nearest = s.nearest;
    return s.found;
}

BVH_WIDE sure_status visible_any(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                 const sure_surface_point *leaving, const sure_vec3 *light,
                                 size_t *object)
{
    sure_float_ray room;
    search s = search_of(scene, tier, ray, leaving, &room);
    s.light = light;
    if (ask_all(&s, (asking){stop_at_any, false}))
        *object = s.nearest.object;
    return s.found;
}
