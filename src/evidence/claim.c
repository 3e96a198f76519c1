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

/* Surely larger than the contract allows? Twice its bound: what is rounded here does not count. Of
 * exact it is half an ulp, whatever that is. */
static bool is_vague(const pixel_record *claim, sure_tier tier, const sure_ray *ray,
                     const sure_object *object)
{
    if (tier == SURE_TIER_EXACT)
        return isfinite(claim->t) && claim->t_error > nextafter(claim->t, INFINITY) - claim->t;
    const sure_vec3 *d = &ray->direction;
    double longest = fmax(fabs(d->x), fmax(fabs(d->y), fabs(d->z)));
    return claim->t_error * longest > 2 * SURE_T_ERROR_CAP * extent(ray->origin, object);
}

/* |t - t*| <= t_error says that t* lies between t - t_error and t + t_error. Rounding keeps that
 * order, and exact's t is t* rounded: the claim is never blamed for a rounding of ours, and what is
 * let pass is off by half an ulp at most. In tier exact t is t* rounded itself. */
static bool is_off(const pixel_record *claim, sure_tier tier, double t)
{
    if (tier == SURE_TIER_EXACT)
        return claim->t != t;
    return !(claim->t - claim->t_error <= t && t <= claim->t + claim->t_error);
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
    if (is_off(claim, of->tier, nearest->hit.t))
        return CLAIM_T;
    return is_vague(claim, of->tier, &ray, &scene->objects[claim->object]) ? CLAIM_VAGUE
                                                                           : CLAIM_RIGHT;
}
