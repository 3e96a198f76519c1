#include "../arithmetic/ieee.h"

#include <surehit/backward.h>

#include "account.h"
#include "shadow.h"
#include "visible.h"

#include <surehit/bounds.h>
#include <surehit/pixel_ray.h>
#include <surehit/reflect.h>
#include <surehit/refract.h>
#include <surehit/shadow.h>
#include <surehit/spawn.h>

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

/* Step 1: distance. */
sure_status sure_backward_nearest(const sure_scene *scene, sure_tier tier, const sure_ray *ray,
                                  const sure_surface_point *leaving, sure_nearest *nearest)
{
    return visible_nearest(scene, tier, ray, leaving, nearest);
}

/* Is it refracting? */
static bool is_clear(const sure_material *material)
{
    return material->refract > 0;
}

static bool is_flat(const sure_object *object)
{
    return object->shape == SURE_SHAPE_PLANE || object->shape == SURE_SHAPE_DISC;
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

/* A ray that is to be followed. */
typedef struct {
    sure_ray_kind kind;
    const sure_ray *ray;
    const sure_surface_point *leaving; /* NULL: the eye */
    int depth;
} follow;

/* A hit as the eye sees it. */
typedef struct {
    const sure_ray *ray;
    const sure_nearest *nearest;
    const sure_object *object;
    const sure_material *material;
    sure_vec3 point;  /* o + t d, rounded */
    sure_vec3 normal; /* unit, on the side of the eye */
    sure_side side;   /* the eye's */
} sighting;

/* Step 2: the hit point, and the side of the surface from which it is seen. */
static sighting hit_point(const sure_scene *scene, sure_tier tier, const follow *way,
                          const sure_nearest *nearest)
{
    const sure_ray *ray = way->ray;
    const sure_object *object = &scene->objects[nearest->object];
    const sure_hit *hit = &nearest->hit;
    sure_vec3 normal = sure_object_normal(ray, object, tier, hit);
    double along = dot(normal, ray->direction);
    bool behind = is_flat(object) && along > 0;
    bool still = way->leaving && way->leaving->object == nearest->object && way->leaving->inside;
    bool within = behind || still || sees_inside(ray, object, tier, hit, along);
    return (sighting){
        .ray = ray,
        .nearest = nearest,
        .object = object,
        .material = &scene->materials[nearest->object],
        .point = {ray->origin.x + hit->t * ray->direction.x,
                  ray->origin.y + hit->t * ray->direction.y,
                  ray->origin.z + hit->t * ray->direction.z},
        .normal = within ? negate(normal) : normal,
        .side = within ? SURE_SIDE_INSIDE : SURE_SIDE_OUTSIDE,
    };
}

/* Where further rays start, on the eye's side or the other one; false where there is no place. */
static bool leave(const tracing *t, const sighting *at, sure_side side, sure_surface_point *from)
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
    account_origin(t, at->ray, at->nearest, left ? &from->point : NULL);
    return left;
}

/* What one light gives that reaches the point: a transparent surface shows its highlight only. */
static sure_vec3 lit_by(const sure_scene *scene, const sure_light *light, double intensity,
                        const sighting *at)
{
    const sure_material *material = at->material;
    double highlight = 0;
    if (material->specular > 0) {
        sure_vec3 to_light = add(light->position, negate(at->point));
        highlight = sure_phong_specular_textbook(at->normal, negate(at->ray->direction), to_light,
                                                 material->shine);
    }
    sure_vec3 incoming = sure_light_color_textbook(light, at->point, scene->falloff);
    return sure_phong_mix_textbook(material, incoming, is_clear(material) ? 0 : intensity,
                                   highlight);
}

/* Step 4: the lights that reach the point on the side that is seen. `from` is found for the first
 * one that could. */
static sure_vec3 lit(const tracing *t, const sighting *at, sure_vec3 own)
{
    const sure_scene *scene = t->scene;
    sure_surface_point from;
    bool left = false;
    if (is_clear(at->material) && !(at->material->specular > 0))
        return own;
    for (size_t i = 0; i < scene->light_count; i++) {
        const sure_light *light = &scene->lights[i];
        double intensity = sure_light_intensity_textbook(at->point, at->normal, light->position);
        if (!(intensity > 0))
            continue;
        if (!left && !leave(t, at, at->side, &from))
            return own;
        left = true;
        if (shadow_reaches(t, &from, light->position))
            own = add(own, lit_by(scene, light, intensity, at));
    }
    return own;
}

static sure_vec3 seen_along(const tracing *t, const follow *way);

/* What is seen from a hit in a direction to one of its sides. */
static sure_vec3 seen_from(const tracing *t, const sighting *at, sure_side side, sure_ray_kind kind,
                           sure_vec3 direction, int depth)
{
    sure_surface_point from;
    if (!leave(t, at, side, &from))
        return (sure_vec3){0, 0, 0};
    sure_ray ray = {from.point, direction, 0, INFINITY};
    return seen_along(t, &(follow){kind, &ray, &from, depth - 1});
}

static sure_vec3 reflected(const tracing *t, const sighting *at, int depth)
{
    sure_vec3 direction = sure_reflect_textbook(negate(at->ray->direction), at->normal);
    return seen_from(t, at, at->side, SURE_RAY_MIRROR, direction, depth);
}

/* What comes through the surface, in its colour. */
static sure_vec3 transmitted(const tracing *t, const sighting *at, sure_vec3 direction, int depth)
{
    sure_vec3 color = at->material->color;
    sure_side beyond = at->side == SURE_SIDE_INSIDE ? SURE_SIDE_OUTSIDE : SURE_SIDE_INSIDE;
    sure_vec3 light = seen_from(t, at, beyond, SURE_RAY_REFRACTED, direction, depth);
    return (sure_vec3){color.x * light.x, color.y * light.y, color.z * light.z};
}

/* How a surface parts what arrives. */
typedef struct {
    double share;        /* that is reflected */
    sure_vec3 direction; /* in which the rest goes on, where there is a rest */
} parting;

/* The index is that of a solid's inside over what surrounds it. A plane or disc is a thin sheet of
 * two faces, between which the light goes to and fro; the way through it is straight. */
static parting part(const sighting *at)
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

static sure_vec3 scaled(double k, sure_vec3 v)
{
    return (sure_vec3){k * v.x, k * v.y, k * v.z};
}

/* Fresnel's share and the mirror's are reflected, the rest comes through. */
static sure_vec3 seen_through(const tracing *t, const sighting *at, sure_vec3 own, int depth)
{
    parting into = part(at);
    if (into.share > 0)
        own = add(own, scaled(into.share, reflected(t, at, depth)));
    if (into.share < 1)
        own = add(own, scaled(1 - into.share, transmitted(t, at, into.direction, depth)));
    return own;
}

/* The four steps along one ray. */
static sure_vec3 seen_along(const tracing *t, const follow *way)
{
    const sure_scene *scene = t->scene;
    sure_nearest nearest = {0};
    sure_status met = visible_nearest(scene, t->tier, way->ray, way->leaving, &nearest);
    account_ray(t, way->kind, way->ray, way->leaving, met, nearest.object);
    if (way->kind == SURE_RAY_PIXEL)
        account_pixel(t, way->ray, met, &nearest);
    if (met != SURE_HIT)
        return (sure_vec3){0, 0, 0};
    sighting at = hit_point(scene, t->tier, way, &nearest);

    /* Step 3: the colour it has by itself. What is clear has none, but for the last one seen. */
    bool through = is_clear(at.material) && way->depth > 0;
    sure_vec3 ambient = sure_phong_mix_textbook(at.material, scene->ambient, 1, 0);
    sure_vec3 own = lit(t, &at, through ? (sure_vec3){0, 0, 0} : ambient);
    if (through)
        return seen_through(t, &at, own, way->depth);
    if (!(at.material->mirror > 0) || way->depth <= 0)
        return own;
    return sure_phong_mirror_textbook(at.material, own, reflected(t, &at, way->depth));
}

/* What the eye touches is not in front of it: a pixel ray's t starts at the tier's least number
 * above 0. */
static double in_front(sure_tier tier)
{
    return tier == SURE_TIER_FLOAT32 ? 0x1p-149 : 0x1p-1074;
}

sure_vec3 sure_backward_pixel_told(const sure_scene *scene, sure_tier tier, int column, int row,
                                   sure_account *account)
{
    sure_ray ray =
        sure_pixel_ray_textbook(&scene->camera, scene->width, scene->height, column, row);
    ray.t_min = in_front(tier);
    const tracing t = {scene, tier, account};
    return seen_along(&t, &(follow){SURE_RAY_PIXEL, &ray, NULL, scene->depth});
}

sure_vec3 sure_backward_pixel(const sure_scene *scene, sure_tier tier, int column, int row)
{
    return sure_backward_pixel_told(scene, tier, column, row, NULL);
}
