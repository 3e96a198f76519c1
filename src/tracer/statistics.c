/* SPDX-License-Identifier: MIT */
/* What lies between a hit P and an origin S next to it is told exactly, though P has no doubles: a
 * surface does if it has the two on different sides. P is where the ray has come from its start
 * without crossing any surface,
 *
 *     solids: P is in the closed solid if the start is,
 *     planes: P is on the start's side,
 *     discs:  P is on the start's side of the disc's plane, or on the other where the ray crosses
 *             that plane (beside the disc) before P; and S lies above or below the disc,
 *     boxes that are flat: as discs
 *
 * and each of these is the status of a hit or the order of two. */
#include "../geometry/coordinate.h"
#include "../numbers/sums.h"
#include "../stages/hits/surface.h"
#include "../stages/rows.h"

#include "statistics.h"

#include "visible.h"

#include <surehit/hit_order.h>

#include <math.h>
#include <stddef.h>

const char *sure_ray_kind_name(sure_ray_kind kind)
{
    static const char *const names[SURE_RAY_KINDS] = {"pixel", "shadow", "mirror", "refracted"};
    return (unsigned)kind < SURE_RAY_KINDS ? names[kind] : NULL;
}

void sure_statistics_add(sure_statistics *sum, const sure_statistics *more)
{
    const size_t first = offsetof(sure_statistics, rays);
    uint64_t *to = (uint64_t *)((char *)sum + first);
    const uint64_t *from = (const uint64_t *)((const char *)more + first);
    sum->seen = more->seen;
    sum->nearest = more->nearest;
    sum->stage = more->stage;
    for (size_t i = 0; i < (sizeof *sum - first) / sizeof *to; i++) /* all of it is counts */
        to[i] += from[i];
}

void statistics_ray(const tracing *t, sure_ray_kind kind, const sure_ray *ray,
                    const sure_surface_point *leaving, sure_status met, size_t object)
{
    sure_statistics *sum = t->statistics;
    if (!sum)
        return;
    sum->rays[kind]++;
    if (met != SURE_HIT) {
        sum->missed++;
        return;
    }
    sum->decided[sure_object_stage(ray, &t->scene->objects[object], t->tier)]++;
    sum->acne += leaving && leaving->object == object && !leaving->inside;
}

void statistics_pixel(const tracing *t, const sure_ray *ray, sure_status seen,
                      const sure_nearest *nearest)
{
    sure_statistics *sum = t->statistics;
    if (!sum)
        return;
    sum->seen = seen;
    if (seen != SURE_HIT)
        return;
    sum->nearest = *nearest;
    sum->stage = sure_object_stage(ray, &t->scene->objects[nearest->object], t->tier);
}

static bool meets(const sure_object *object, sure_vec3 from, sure_vec3 direction)
{
    const sure_ray ray = {from, direction, 0, INFINITY};
    sure_hit unused;
    return sure_object_hit(&ray, object, SURE_TIER_CERTAIN, &unused) == SURE_HIT;
}

/* Is the ray's start in the solid? It is at t_min: the ray of a pixel begins behind what the eye
 * touches. */
static bool contains_start(const sure_object *solid, sure_ray ray)
{
    sure_interval unused;
    ray.t_max = ray.t_min;
    return sure_object_interval(&ray, solid, SURE_TIER_CERTAIN, &unused) == SURE_HIT;
}

/* -1, 0 or +1 as the point is below, on or above: a ray along the normal meets the plane, whose
 * point it starts from, unless it starts above. */
static int side_of(const sure_object *plane, sure_vec3 point)
{
    sure_vec3 n = plane->as.plane.normal;
    return meets(plane, point, negate(n)) - meets(plane, point, n);
}

/* In which a flat object lies; false: it has an inside. Such a plane's normal is `to`. */
static bool plane_of(const sure_object *object, sure_object *plane)
{
    const shape_row *row = row_of(object);
    sure_part part = row->info.parts[0];
    part_plane of;
    if (!surface_flat_part(row, &object->as, &(sure_vec3){1, 1, 1}, &part) && row->info.solid)
        return false;
    row->surface->plane(&object->as, part, &of);
    *plane = (sure_object){SURE_SHAPE_PLANE, {.plane = {of.at, of.to}}};
    return true;
}

/* A hit, the origin next to it, and a box that has both. */
typedef struct {
    const sure_ray *ray;
    const sure_nearest *hit;
    sure_vec3 origin;
    sure_bounds near;
} place;

/* Wide enough for SURE_SPAWN_STEPS to either side. */
static sure_bounds around(sure_vec3 origin)
{
    sure_bounds box;
    for (int i = 0; i < 3; i++) {
        double at = coordinate(origin, i), wide = fabs(at) * 0x1p-48 + 0x1p-1022;
        box.low[i] = at - wide;
        box.high[i] = at + wide;
    }
    return box;
}

static bool separates_flat(const tracing *t, const sure_object *plane, const place *at)
{
    sure_object parallel = *plane;
    parallel.as.plane.point = (sure_vec3){0, 0, 0};
    int start = side_of(plane, at->ray->origin), end = side_of(plane, at->origin);
    if (start == 0) /* the side that it leaves to */
        start = side_of(&parallel, at->ray->direction);
    if (start == 0 || end == 0)
        return false;
    const sure_object *object = &t->scene->objects[at->hit->object];
    sure_hit there;
    bool crossed = sure_object_hit(at->ray, plane, SURE_TIER_CERTAIN, &there) == SURE_HIT &&
                   sure_hit_order(at->ray, plane, &there, object, &at->hit->hit) < 0;
    return (start != end) != crossed; /* crossed: before the hit */
}

static bool separates(const tracing *t, size_t object, const place *at)
{
    const sure_object *other = &t->scene->objects[object];
    if (object == at->hit->object)
        return false;
    sure_object plane;
    if (!plane_of(other, &plane))
        return contains_start(other, *at->ray) !=
               contains_start(other, (sure_ray){at->origin, {1, 0, 0}, 0, 0});
    sure_vec3 n = plane.as.plane.normal;
    /* Only what lies above or below the flat object, not beside it. */
    return (meets(other, at->origin, n) || meets(other, at->origin, negate(n))) &&
           separates_flat(t, &plane, at);
}

/* Any of these objects; slots NULL: of the first `count`. */
static bool any_separates(const tracing *t, const uint32_t *slots, size_t count, const place *at)
{
    for (size_t i = 0; i < count; i++) {
        if (separates(t, slots ? slots[i] : i, at))
            return true;
    }
    return false;
}

static bool overlaps(const sure_bvh_node *node, int child, const sure_bounds *box)
{
    for (int i = 0; i < 3; i++) {
        if (box->high[i] < node->bound[2 * i][child] || box->low[i] > node->bound[2 * i + 1][child])
            return false;
    }
    return true;
}

/* Of objects in boxes far from both none is between them. */
static bool is_covered_within(const tracing *t, uint32_t index, const place *at)
{
    const sure_bvh *bvh = t->scene->bvh;
    const sure_bvh_node *node = &bvh->nodes[index];
    for (int k = 0; k < SURE_BVH_WIDTH; k++) {
        bool inner = node->count[k] == SURE_BVH_INNER;
        if (overlaps(node, k, &at->near) &&
            (inner ? is_covered_within(t, node->first[k], at)
                   : any_separates(t, bvh->slots + node->first[k], node->count[k], at)))
            return true;
    }
    return false;
}

static bool is_covered(const tracing *t, const place *at)
{
    const sure_bvh *bvh = t->scene->bvh;
    if (!bvh)
        return any_separates(t, NULL, t->scene->object_count, at);
    return any_separates(t, bvh->slots, bvh->unbounded, at) ||
           (bvh->nodes && is_covered_within(t, 0, at));
}

void statistics_origin(const tracing *t, const sure_ray *ray, const sure_nearest *hit,
                       const sure_vec3 *origin)
{
    sure_statistics *sum = t->statistics;
    if (!sum)
        return;
    if (!origin) {
        sum->without_origin++;
        return;
    }
    const place at = {ray, hit, *origin, around(*origin)};
    sum->origins++;
    sum->covered += is_covered(t, &at);
}
