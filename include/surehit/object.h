/* Any of the five shapes, for those who hold several. */
#ifndef SUREHIT_OBJECT_H
#define SUREHIT_OBJECT_H

#include <surehit/cone.h>
#include <surehit/cylinder.h>
#include <surehit/disc.h>
#include <surehit/plane.h>
#include <surehit/sphere.h>
#include <surehit/tier.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    SURE_SHAPE_PLANE,
    SURE_SHAPE_DISC,
    SURE_SHAPE_SPHERE,
    SURE_SHAPE_CYLINDER,
    SURE_SHAPE_CONE
} sure_shape;

#define SURE_SHAPES 5

typedef struct {
    sure_shape shape;
    union {
        sure_plane plane;
        sure_disc disc;
        sure_sphere sphere;
        sure_cylinder cylinder;
        sure_cone cone;
    } as;
} sure_object;

/* "plane", "disc", "sphere", "cylinder", "cone": the shapes of the case format; NULL for a number
 * that is no shape. */
const char *sure_shape_name(sure_shape shape);

/* Finds the shape of that name: 1 and *shape written, or 0 and *shape untouched. */
int sure_shape_from_name(const char *name, sure_shape *shape);

/* The functions of the object's own header, by tier. Entry: shape and tier are members. */
sure_field sure_object_check(const sure_ray *ray, const sure_object *object);
sure_status sure_object_hit(const sure_ray *ray, const sure_object *object, sure_tier tier,
                            sure_hit *hit);
sure_status sure_object_interval(const sure_ray *ray, const sure_object *object, sure_tier tier,
                                 sure_interval *interval);
sure_status sure_object_occluded(const sure_ray *ray, const sure_object *object, sure_tier tier);
sure_vec3 sure_object_normal(const sure_ray *ray, const sure_object *object, sure_tier tier,
                             const sure_hit *hit);

/* Which stage answers sure_object_hit. Those who don't ask don't pay: it is found out by going
 * through the stages again. The plain tiers have one, SURE_STAGE_DOUBLE, and invalid input is told
 * by it. */
sure_stage sure_object_stage(const sure_ray *ray, const sure_object *object, sure_tier tier);

#ifdef __cplusplus
}
#endif
#endif
