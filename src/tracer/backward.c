#include "../arithmetic/ieee.h"

#include <surehit/backward.h>

#include <surehit/pixel_ray.h>
#include <surehit/reflect.h>
#include <surehit/shadow.h>

#include <math.h>

static double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static sure_vec3 add(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static sure_vec3 negate(sure_vec3 v)
{
    return (sure_vec3){-v.x, -v.y, -v.z};
}

/* Step 1: distance. The range shrinks to what is nearer, so later objects must beat the best; on a
 * tie the earlier one stays. */
sure_status sure_backward_nearest(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                  const sure_surface_point *leaving, sure_nearest *nearest)
{
    sure_ray rest = *ray;
    sure_status found = SURE_MISS;
    for (size_t i = 0; i < scene->object_count; i++) {
        sure_hit hit;
        sure_status status =
            leaving && leaving->object == i
                ? sure_scene_meets_again(scene, tier, &rest, leaving, &hit)
                : sure_object_hit(&rest, &scene->objects[i], tier, &hit);
        if (status != SURE_HIT || (found == SURE_HIT && !(hit.t < rest.t_max)))
            continue;
        *nearest = (sure_nearest){i, hit};
        rest.t_max = hit.t;
        found = SURE_HIT;
    }
    return found;
}

/* Does the ray meet the solid from within? It does where its chord has begun before the hit; a rim
 * can be touched from outside against the normal of its cap. */
static int sees_inside(const sure_ray *ray, const sure_object *object, sure_tier tier,
                       const sure_hit *hit, sure_vec3 normal)
{
    sure_interval chord;
    return dot(normal, ray->direction) > 0 && object->shape != SURE_SHAPE_PLANE &&
           object->shape != SURE_SHAPE_DISC &&
           sure_object_interval(ray, object, tier, &chord) == SURE_HIT && chord.t_enter < hit->t;
}

/* Step 2: the hit point, and the side of the surface from which it is seen. */
static sure_surface_point hit_point(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                    const sure_nearest *nearest)
{
    const sure_object *object = &scene->objects[nearest->object];
    double t = nearest->hit.t;
    sure_vec3 normal = sure_object_normal(ray, object, tier, &nearest->hit);
    int inside = sees_inside(ray, object, tier, &nearest->hit, normal);
    int flat = object->shape == SURE_SHAPE_PLANE || object->shape == SURE_SHAPE_DISC;
    int behind = flat && dot(normal, ray->direction) > 0;
    return (sure_surface_point){
        .object = nearest->object,
        .point = {ray->origin.x + t * ray->direction.x, ray->origin.y + t * ray->direction.y,
                  ray->origin.z + t * ray->direction.z},
        .normal = behind || inside ? negate(normal) : normal,
        .inside = inside,
    };
}

/* Step 4: one light, if it reaches the point on the side that is seen. */
static sure_vec3 lit_by(const sure_scene *scene, sure_tier tier, const sure_light *light,
                        const sure_surface_point *at, sure_vec3 to_eye)
{
    double intensity = sure_light_intensity_textbook(at->point, at->normal, light->position);
    if (!(intensity > 0) || !sure_shadow_reaches(scene, tier, at, light->position))
        return (sure_vec3){0, 0, 0};
    const sure_material *material = &scene->materials[at->object];
    double highlight = 0;
    if (material->specular > 0) {
        sure_vec3 to_light = add(light->position, negate(at->point));
        highlight =
            sure_phong_specular_textbook(at->normal, to_eye, to_light, material->shine);
    }
    sure_vec3 incoming = sure_light_color_textbook(light, at->point, scene->falloff);
    return sure_phong_mix_textbook(material, incoming, intensity, highlight);
}

/* The four steps along one ray; `leaving` is the mirror it comes from, if any. */
static sure_vec3 seen_along(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                            const sure_surface_point *leaving, int depth)
{
    sure_nearest nearest;
    if (sure_backward_nearest(scene, tier, ray, leaving, &nearest) != SURE_HIT)
        return (sure_vec3){0, 0, 0};
    sure_surface_point at = hit_point(scene, tier, ray, &nearest);
    const sure_material *material = &scene->materials[at.object];
    sure_vec3 to_eye = negate(ray->direction);

    /* Step 3: the colour it has by itself. */
    sure_vec3 own = sure_phong_mix_textbook(material, scene->ambient, 1, 0);
    for (size_t i = 0; i < scene->light_count; i++)
        own = add(own, lit_by(scene, tier, &scene->lights[i], &at, to_eye));
    if (!(material->mirror > 0) || depth <= 0)
        return own;
    sure_ray mirrored = {at.point, sure_reflect_textbook(to_eye, at.normal), 0, INFINITY};
    sure_vec3 reflected = seen_along(scene, tier, &mirrored, &at, depth - 1);
    return sure_phong_mirror_textbook(material, own, reflected);
}

/* What the eye touches is not in front of it: a pixel ray's t starts at the tier's least number
 * above 0. */
static double in_front(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1p-149 : 0x1p-1074;
}

sure_vec3 sure_backward_pixel(const sure_scene *scene, sure_tier tier, int column, int row)
{
    sure_ray ray =
        sure_pixel_ray_textbook(&scene->camera, scene->width, scene->height, column, row);
    ray.t_min = in_front(tier);
    return seen_along(scene, tier, &ray, NULL, scene->depth);
}
