/* Seen from the object, m = p - Q:
 *
 *     plane, disc   N.m
 *     sphere        m.m - r^2
 *     cylinder      Q the base's centre, A = top - base, H = A.A:
 *                   -A.m, A.m - H and |A x m|^2 - r^2 H, whichever is the greatest
 *     cone          Q the apex, A = base - Q:
 *                   -A.m, A.m - H and H |A x m|^2 - r^2 (A.m)^2; at A.m = 0 the last is not
 *                   negative, and 0 at the apex alone
 *
 * Only signs are compared: inside is where all are negative, outside where any is positive. */
#include "where.h"

#include "../numbers/number.h"

static int greatest(int a, int b, int c)
{
    int greater = a > b ? a : b;
    return greater > c ? greater : c;
}

static int of_plane(context *c, sure_vec3 normal, sure_vec3 point, sure_vec3 p)
{
    return number_sign(c, vector_dot(c, vector_of(c, normal), vector_between(c, point, p)));
}

static int of_sphere(context *c, const sure_sphere *sphere, sure_vec3 p)
{
    vector m = vector_between(c, sphere->centre, p);
    number rr = number_square(c, number_of(c, sphere->radius));
    return number_sign(c, number_sub(c, vector_square(c, m), rr));
}

static int of_cylinder(context *c, const sure_cylinder *cylinder, sure_vec3 p)
{
    vector axis = vector_between(c, cylinder->base, cylinder->top);
    vector m = vector_between(c, cylinder->base, p);
    number rr = number_square(c, number_of(c, cylinder->radius));
    number height = vector_square(c, axis), above = vector_dot(c, axis, m);
    number away = vector_square(c, vector_cross(c, axis, m));
    return greatest(-number_sign(c, above), number_sign(c, number_sub(c, above, height)),
                    number_sign(c, number_sub(c, away, number_mul(c, rr, height))));
}

static int of_cone(context *c, const sure_cone *cone, sure_vec3 p)
{
    vector axis = vector_between(c, cone->apex, cone->base);
    vector m = vector_between(c, cone->apex, p);
    number rr = number_square(c, number_of(c, cone->radius));
    number height = vector_square(c, axis), depth = vector_dot(c, axis, m);
    number away = number_mul(c, height, vector_square(c, vector_cross(c, axis, m)));
    number wall = number_sub(c, away, number_mul(c, rr, number_square(c, depth)));
    return greatest(-number_sign(c, depth), number_sign(c, number_sub(c, depth, height)),
                    number_sign(c, wall));
}

static int of_object(context *c, const sure_object *object, sure_vec3 p)
{
    switch (object->shape) {
    case SURE_SHAPE_PLANE: return of_plane(c, object->as.plane.normal, object->as.plane.point, p);
    case SURE_SHAPE_DISC: return of_plane(c, object->as.disc.normal, object->as.disc.centre, p);
    case SURE_SHAPE_SPHERE: return of_sphere(c, &object->as.sphere, p);
    case SURE_SHAPE_CYLINDER: return of_cylinder(c, &object->as.cylinder, p);
    case SURE_SHAPE_CONE: break;
    }
    return of_cone(c, &object->as.cone, p);
}

bool STAGE(where)(const sure_object *object, sure_vec3 p, int *side)
{
#ifdef NUMBER_RANGE
    context c = {false};
#else
    exact_arena room;
    context c = exact_start(&room);
#endif
    *side = of_object(&c, object, p);
    return !c.uncertain;
}
