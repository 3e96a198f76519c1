/* SPDX-License-Identifier: MIT */
#include "../numbers/sums.h"
#include "../stages/hits/surface.h"
#include "../stages/rows.h"

#include "meeting.h"

#include "visible.h"

#include <surehit/reflect.h>
#include <surehit/refract.h>

#include <math.h>

/* Is it a flat box? *part is then the face that is seen along the direction, from its outside. */
static bool is_flat_box(const sure_object *object, sure_vec3 direction, sure_part *part)
{
    const surface_row *surface = row_of(object)->surface;
    return surface->flat_part && surface->flat_part(&object->as, direction, part);
}

void meeting_of(const tracing *t, const sure_ray *ray, const sure_surface_point *leaving,
                const sure_nearest *nearest, meeting *at)
{
    const sure_object *object = &t->scene->objects[nearest->object];
    sure_hit hit = nearest->hit;
    bool flat_box = is_flat_box(object, ray->direction, &hit.part);
    bool solid = row_of(object)->info.solid;
    sure_vec3 normal = sure_object_normal(ray, object, t->tier, &hit);
    double along = dot(normal, ray->direction);
    bool behind = !solid && along > 0;
    bool still = leaving && leaving->object == nearest->object && leaving->inside;
    bool from_within = hit.leaves && (is_sure(t->tier) || along > 0);
    bool within = !flat_box && (behind || still || from_within);
    *at = (meeting){
        .ray = ray,
        .nearest = nearest,
        .object = object,
        .material = &t->scene->materials[nearest->object],
        .hit = hit,
        .sheet = flat_box || !solid,
        .point = sum_of(ray->origin, hit.t, ray->direction),
        .normal = within ? negate(normal) : normal,
        .side = within ? SURE_SIDE_INSIDE : SURE_SIDE_OUTSIDE,
    };
}

bool meeting_leave(const tracing *t, const meeting *at, sure_side side, sure_surface_point *from)
{
    *from = (sure_surface_point){
        .object = at->nearest->object,
        .point = at->point,
        .normal = side == at->side ? at->normal : negate(at->normal),
        .inside = side == SURE_SIDE_INSIDE && !at->sheet,
    };
    if (!is_sure(t->tier))
        return true;
    sure_hit hit = at->hit;
    if (side != at->side && is_flat_box(at->object, negate(at->ray->direction), &hit.part))
        side = SURE_SIDE_OUTSIDE;
    bool left = sure_spawn(at->ray, at->object, &hit, side, &from->point);
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
    bool from_within = at->side == SURE_SIDE_INSIDE && !at->sheet;
    double ratio = from_within ? material->refract : 1 / material->refract;
    double fresnel = sure_refract_fresnel_textbook(direction, at->normal, ratio);
    if (at->sheet)
        fresnel = 2 * fresnel / (1 + fresnel);
    double share = material->mirror + (1 - material->mirror) * fresnel;
    bool total = !at->sheet && sure_refract_textbook(at->ray->direction, at->normal, ratio,
                                                     &direction) != SURE_HIT;
    return (parting){total ? 1 : share, direction};
}

sure_vec3 meeting_reflect(const meeting *at)
{
    return sure_reflect_textbook(negate(at->ray->direction), at->normal);
}
