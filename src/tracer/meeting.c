#include "../geometry/sums.h"

#include "meeting.h"

#include "visible.h"

#include <surehit/bounds.h>
#include <surehit/reflect.h>
#include <surehit/refract.h>

#include <math.h>

static bool is_flat(const sure_object *object)
{
    return !sure_shape_info_of(object->shape)->solid;
}

/* Does the ray start in the solid? Only where it may leave it: along N.d it does certainly not
 * where that is negative beyond the error of N; a rim can be touched from outside against the
 * normal of its cap. */
static bool starts_inside(const sure_ray *ray, const sure_object *object, sure_tier tier,
                          const sure_hit *hit, double along)
{
    const sure_vec3 *d = &ray->direction;
    double doubt = 2 * SURE_NORMAL_ERROR * (fabs(d->x) + fabs(d->y) + fabs(d->z));
    sure_ray start = *ray;
    sure_interval unused;
    start.t_max = ray->t_min;
    return along >= -doubt && (along > doubt || hit->t > ray->t_min) &&
           sure_object_interval(&start, object, tier, &unused) == SURE_HIT;
}

/* Does the ray meet the solid from within? For tiers that may err: where its chord has begun before
 * the hit. */
static bool sees_inside(const sure_ray *ray, const sure_object *object, sure_tier tier,
                        const sure_hit *hit, double along)
{
    sure_interval chord;
    if (is_flat(object))
        return false;
    if (is_sure(tier))
        return starts_inside(ray, object, tier, hit, along);
    return along > 0 && sure_object_interval(ray, object, tier, &chord) == SURE_HIT &&
           chord.t_enter < hit->t;
}

meeting meeting_of(const tracing *t, const sure_ray *ray, const sure_surface_point *leaving,
                   const sure_nearest *nearest)
{
    const sure_object *object = &t->scene->objects[nearest->object];
    const sure_hit *hit = &nearest->hit;
    sure_vec3 normal = sure_object_normal(ray, object, t->tier, hit);
    double along = dot(normal, ray->direction);
    bool behind = is_flat(object) && along > 0;
    bool still = leaving && leaving->object == nearest->object && leaving->inside;
    bool within = behind || still || sees_inside(ray, object, t->tier, hit, along);
    return (meeting){
        .ray = ray,
        .nearest = nearest,
        .object = object,
        .material = &t->scene->materials[nearest->object],
        .point = {ray->origin.x + hit->t * ray->direction.x,
                  ray->origin.y + hit->t * ray->direction.y,
                  ray->origin.z + hit->t * ray->direction.z},
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
        .inside = side == SURE_SIDE_INSIDE && !is_flat(at->object),
    };
    if (!is_sure(t->tier))
        return true;
    bool left = sure_spawn(at->ray, at->object, &at->nearest->hit, side, &from->point);
    statistics_origin(t, at->ray, at->nearest, left ? &from->point : NULL);
    return left;
}

sure_side meeting_beyond(const meeting *at)
{
    return at->side == SURE_SIDE_INSIDE ? SURE_SIDE_OUTSIDE : SURE_SIDE_INSIDE;
}

/* The index is that of a solid's inside over what surrounds it. A plane or disc is a thin sheet of
 * two faces, between which the light goes to and fro; the way through it is straight. */
parting meeting_part(const meeting *at)
{
    const sure_material *material = at->material;
    sure_vec3 direction = at->ray->direction;
    bool from_within = at->side == SURE_SIDE_INSIDE && !is_flat(at->object);
    double ratio = from_within ? material->refract : 1 / material->refract;
    double fresnel = sure_refract_fresnel_textbook(direction, at->normal, ratio);
    if (is_flat(at->object))
        fresnel = 2 * fresnel / (1 + fresnel);
    double share = material->mirror + (1 - material->mirror) * fresnel;
    bool total = !is_flat(at->object) && sure_refract_textbook(at->ray->direction, at->normal,
                                                               ratio, &direction) != SURE_HIT;
    return (parting){total ? 1 : share, direction};
}

sure_vec3 meeting_reflect(const meeting *at)
{
    return sure_reflect_textbook(negate(at->ray->direction), at->normal);
}
