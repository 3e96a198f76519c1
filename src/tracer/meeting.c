/* SPDX-License-Identifier: MIT */
#include "../numbers/sums.h"
#include "../numbers/valid.h"
#include "../shapes/capped/height.h"
#include "../stages/hits/surface.h"
#include "../stages/rows.h"

#include "meeting.h"

#include "visible.h"

#include <surehit/reflect.h>
#include <surehit/refract.h>

#include <math.h>

void meeting_of(const tracing *t, const sure_ray *ray, const sure_surface_point *leaving,
                const sure_nearest *nearest, meeting *at)
{
    const sure_object *object = &t->scene->objects[nearest->object];
    sure_hit hit = nearest->hit;
    const shape_row *row = row_of(object);
    bool flat_box = surface_flat_part(row, &object->as, &ray->direction, &hit.part);
    sure_vec3 normal = sure_object_normal(ray, object, t->tier, &hit);
    double along = dot(normal, ray->direction);
    bool behind = !row->info.solid && along > 0;
    bool still = leaving && leaving->object == nearest->object && leaving->inside;
    bool from_within = hit.leaves && (is_sure(t->tier) || along > 0);
    bool within = !flat_box && (behind || still || from_within);
    *at = (meeting){
        .ray = ray,
        .nearest = nearest,
        .object = object,
        .material = &t->scene->materials[nearest->object],
        .point = sum_of(ray->origin, hit.t, ray->direction),
        .normal = within ? negate(normal) : normal,
        .side = within ? SURE_SIDE_INSIDE : SURE_SIDE_OUTSIDE,
        .part = hit.part,
        .flat_box = flat_box,
    };
}

bool meeting_faces(const tracing *t, const meeting *at, sure_vec3 light, double intensity)
{
    const shape_row *row = row_of(at->object);
    part_plane plane;
    if (!is_sure(t->tier) || !(at->material->specular > 0) || !row->surface->plane ||
        !row->surface->plane(&at->object->as, at->part, &plane))
        return intensity > 0;
    int side = part_plane_side(plane.from, plane.to, plane.at, light);
    return (at->side == SURE_SIDE_INSIDE ? side < 0 : side > 0) &&
           direction_ok(difference_of(light, at->point));
}

static bool is_sheet(const meeting *at)
{
    return at->flat_box || !row_of(at->object)->info.solid;
}

/* Of a flat box. Each face has its outside alone: to the side that is not seen leads the other. */
static sure_hit hit_beside(const meeting *at, sure_side *side)
{
    const sure_vec3 back = negate(at->ray->direction);
    sure_hit hit = at->nearest->hit;
    hit.part = at->part;
    if (*side != at->side &&
        surface_flat_part(row_of(at->object), &at->object->as, &back, &hit.part))
        *side = SURE_SIDE_OUTSIDE;
    return hit;
}

bool meeting_leave(const tracing *t, const meeting *at, sure_side side, sure_surface_point *from)
{
    *from = (sure_surface_point){
        .object = at->nearest->object,
        .point = at->point,
        .normal = side == at->side ? at->normal : negate(at->normal),
        .inside = side == SURE_SIDE_INSIDE && !is_sheet(at),
    };
    if (!is_sure(t->tier))
        return true;
    const sure_hit *hit = &at->nearest->hit;
    sure_hit beside;
    if (at->flat_box) {
        beside = hit_beside(at, &side);
        hit = &beside;
    }
    bool left = sure_spawn(at->ray, at->object, hit, side, &from->point);
    statistics_origin(t, at->ray, at->nearest, left ? &from->point : NULL);
    return left;
}

sure_side meeting_beyond(const meeting *at)
{
    return at->side == SURE_SIDE_INSIDE ? SURE_SIDE_OUTSIDE : SURE_SIDE_INSIDE;
}

/* The index is that of a solid's inside over what surrounds it. A plane, a disc or a flat box is a
 * thin sheet of two faces, between which the light goes to and fro; the way through it is
 * straight. */
parting meeting_part(const meeting *at)
{
    const sure_material *material = at->material;
    sure_vec3 direction = at->ray->direction;
    bool sheet = is_sheet(at);
    bool from_within = at->side == SURE_SIDE_INSIDE && !sheet;
    double ratio = from_within ? material->refract : 1 / material->refract;
    double fresnel = sure_refract_fresnel_textbook(direction, at->normal, ratio);
    if (sheet)
        fresnel = 2 * fresnel / (1 + fresnel);
    double share = material->mirror + (1 - material->mirror) * fresnel;
    bool total = !sheet && sure_refract_textbook(at->ray->direction, at->normal, ratio,
                                                 &direction) != SURE_HIT;
    return (parting){total ? 1 : share, direction};
}

sure_vec3 meeting_reflect(const meeting *at)
{
    return sure_reflect_textbook(negate(at->ray->direction), at->normal);
}
