/* SPDX-License-Identifier: MIT */
#include "claim.h"

#include <surehit/backward.h>
#include <surehit/bounds.h>

#include <math.h>
#include <string.h>

/* A sum of magnitudes: it is not below the length, and nothing underflows. */
static double distance(sure_vec3 a, sure_vec3 b)
{
    return fabs(a.x - b.x) + fabs(a.y - b.y) + fabs(a.z - b.z);
}

/* At least |o - object| + size of SURE_T_ERROR_CAP, but for roundings. */
static double extent(sure_vec3 o, const sure_object *object)
{
    const sure_shape_info *info = sure_shape_info_of(object->shape);
    const double *numbers = (const double *)&object->as;
    const sure_vec3 *point = (const sure_vec3 *)(numbers + info->fields[0].at);
    double sum = distance(o, *point);
    for (int i = 1; i < info->field_count; i++) {
        const double *field = numbers + info->fields[i].at;
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            sum += *field;
        else if (info->fields[i].kind != SURE_KIND_NORMAL)
            sum += distance(*(const sure_vec3 *)field, *point);
    }
    return sum;
}

/* Surely larger than the contract allows? Twice its bound: what is rounded here does not count.
 * Half an ulp, which is exact's, is allowed where t is t* rounded. */
static bool is_vague(const pixel_record *claim, sure_tier tier, const sure_ray *ray,
                     const sure_object *object, const sure_hit *right)
{
    if (claim->t == right->t && claim->t_error <= right->t_error)
        return false;
    const sure_vec3 *d = &ray->direction;
    double longest = fmax(fabs(d->x), fmax(fabs(d->y), fabs(d->z)));
    return tier == SURE_TIER_EXACT ||
           claim->t_error * longest > 2 * SURE_T_ERROR_CAP * extent(ray->origin, object);
}

/* Does the ray meet the surface there, in the same way as at t*? */
static bool meets_at(double t, const sure_ray *ray, const sure_object *object,
                     const sure_hit *right)
{
    sure_ray there = *ray;
    sure_hit hit;
    there.t_min = there.t_max = t;
    return sure_object_hit(&there, object, SURE_TIER_EXACT, &hit) == SURE_HIT &&
           hit.part == right->part && hit.leaves == right->leaves;
}

/* |t - t*| <= t_error says that t* lies between t - t_error and t + t_error. Rounding keeps that
 * order, and exact's t is t* rounded: the claim is never blamed for a rounding of ours, and what is
 * let pass is off by half an ulp at most; where the error is 0, nothing is. In tier exact t is t*
 * rounded itself, and an infinite t has an infinite error. */
static bool is_off(const pixel_record *claim, sure_tier tier, const sure_ray *ray,
                   const sure_object *object, const sure_hit *right)
{
    const double t = claim->t, error = claim->t_error;
    if (tier == SURE_TIER_EXACT || isinf(t))
        return t != right->t || error < right->t_error;
    if (error == 0)
        return t != right->t || !meets_at(t, ray, object, right);
    return !(t - error <= right->t && right->t <= t + error);
}

claim_verdict claim_check(const sure_scene *scene, const certificate *of, size_t i,
                          sure_status *seen, sure_nearest *nearest)
{
    const pixel_record *claim = &of->claims[i].pixel;
    const sure_ray ray = certificate_ray(scene, &of->part, i);
    const sure_vec3 claimed[] = {of->eye, of->claims[i].direction};
    *seen = sure_backward_nearest(scene, SURE_TIER_EXACT, &ray, NULL, nearest);
    if (memcmp(claimed, &ray, sizeof claimed) != 0)
        return CLAIM_RAY;
    if (*seen != (sure_status)claim->seen)
        return CLAIM_OBJECT;
    if (*seen != SURE_HIT)
        return CLAIM_RIGHT;
    if (nearest->object != claim->object)
        return CLAIM_OBJECT;
    if (nearest->hit.part != (sure_part)claim->part)
        return CLAIM_PART;
    const sure_object *object = &scene->objects[claim->object];
    if (is_off(claim, of->tier, &ray, object, &nearest->hit))
        return CLAIM_T;
    return is_vague(claim, of->tier, &ray, object, &nearest->hit) ? CLAIM_VAGUE : CLAIM_RIGHT;
}
