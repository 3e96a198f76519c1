/* On a plane of normal N through Q, t* = N.(Q - o) / N.d. On a sphere or wall, where
 * f(t) = a t^2 + 2 b t + c is 0 at t*, f(t*) = f(t) + (t* - t) (f'(t) + a (t* - t)) and so
 *
 *     t* = t - f(t) / (f'(t) + x),  |x| <= |a| t_error
 *
 * exactly: a step of Newton's method from the hit's t, whose error is counted to the slope. With p
 * the point at t seen from the object, A the axis, H = A.A, g = A x p and X = A x d:
 *
 *     sphere     f = p.p - r^2                f'/2 = p.d                       a = d.d
 *     cylinder   f = g.g - r^2 H              f'/2 = g.X                       a = X.X
 *     cone       f = H g.g - r^2 (A.p)^2      f'/2 = H g.X - r^2 (A.p)(A.d)    |a| <= H X.X
 *                                                                                     + r^2 (A.d)^2
 * Where the slope is not certain (the ray touches, or lies in the plane or in the wall) nothing
 * is. */
#define SURE_NEAR
#include "hit_point.h"

#include "../numbers/number.h"
#include "wide_stages.h"

static near plane_t(context *c, const sure_ray *ray, vector normal, sure_vec3 q)
{
    near height = vector_dot(c, normal, vector_between(c, ray->origin, q));
    return near_div(c, height, vector_dot(c, normal, vector_of(c, ray->direction)));
}

/* The point at the hit's t, seen from q. */
static vector seen(context *c, const sure_ray *ray, const sure_hit *hit, sure_vec3 q)
{
    vector along = vector_scale(c, near_of(c, hit->t), vector_of(c, ray->direction));
    return vector_add(c, vector_between(c, q, ray->origin), along);
}

static near stepped(context *c, const sure_hit *hit, near f, near half_slope, near bend)
{
    near slope = near_add(c, half_slope, half_slope);
    slope.error += (fabs(bend.hi + bend.lo) + bend.error) * hit->t_error * NEAR_SLACK;
    return near_sub(c, near_of(c, hit->t), near_div(c, f, slope));
}

static near sphere_t(context *c, const sure_ray *ray, const sure_sphere *s, const sure_hit *hit)
{
    vector d = vector_of(c, ray->direction), p = seen(c, ray, hit, s->centre);
    near f = near_sub(c, vector_square(c, p), near_square(c, near_of(c, s->radius)));
    return stepped(c, hit, f, vector_dot(c, p, d), vector_square(c, d));
}

static near cylinder_t(context *c, const sure_ray *ray, const sure_cylinder *s, const sure_hit *hit)
{
    vector axis = vector_between(c, s->base, s->top), p = seen(c, ray, hit, s->base);
    vector g = vector_cross(c, axis, p),
           across = vector_cross(c, axis, vector_of(c, ray->direction));
    near rr = near_square(c, near_of(c, s->radius));
    near f = near_sub(c, vector_square(c, g), near_mul(c, rr, vector_square(c, axis)));
    return stepped(c, hit, f, vector_dot(c, g, across), vector_square(c, across));
}

static near cone_t(context *c, const sure_ray *ray, const sure_cone *s, const sure_hit *hit)
{
    vector axis = vector_between(c, s->apex, s->base), p = seen(c, ray, hit, s->apex);
    vector d = vector_of(c, ray->direction);
    vector g = vector_cross(c, axis, p), across = vector_cross(c, axis, d);
    near rr = near_square(c, near_of(c, s->radius)), height = vector_square(c, axis);
    near depth = vector_dot(c, axis, p), speed = vector_dot(c, axis, d);
    near f = near_sub(c, near_mul(c, height, vector_square(c, g)),
                      near_mul(c, rr, near_square(c, depth)));
    near half_slope = near_sub(c, near_mul(c, height, vector_dot(c, g, across)),
                               near_mul(c, rr, near_mul(c, depth, speed)));
    near bend = near_add(c, near_mul(c, height, vector_square(c, across)),
                         near_mul(c, rr, near_square(c, speed)));
    return stepped(c, hit, f, half_slope, bend);
}

/* Of a plane across a coordinate axis all points have that coordinate of Q, exactly. */
static void set_level(vector *p, sure_vec3 normal, sure_vec3 q)
{
    bool x = normal.x != 0, y = normal.y != 0, z = normal.z != 0;
    if (x + y + z != 1)
        return;
    *(x ? &p->x : y ? &p->y : &p->z) = (near){x ? q.x : y ? q.y : q.z, 0, 0};
}

typedef struct {
    bool flat; /* the part is plane, of this normal and through q */
    sure_vec3 from, to, q;
} surface;

static surface plane_through(sure_vec3 normal, sure_vec3 q)
{
    const sure_vec3 zero = {0, 0, 0};
    return (surface){true, zero, normal, q};
}

/* The normal of plane parts as the difference of two points. */
static surface surface_of(const sure_object *object, sure_part part)
{
    const sure_cylinder *cylinder = &object->as.cylinder;
    const sure_cone *cone = &object->as.cone;
    switch (object->shape) {
    case SURE_SHAPE_PLANE: return plane_through(object->as.plane.normal, object->as.plane.point);
    case SURE_SHAPE_DISC: return plane_through(object->as.disc.normal, object->as.disc.centre);
    case SURE_SHAPE_SPHERE: break;
    case SURE_SHAPE_CYLINDER:
        return (surface){part != SURE_PART_WALL, cylinder->base, cylinder->top,
                         part == SURE_PART_TOP ? cylinder->top : cylinder->base};
    case SURE_SHAPE_CONE:
        return (surface){part != SURE_PART_WALL, cone->apex, cone->base, cone->base};
    }
    return (surface){.flat = false};
}

static near curved_t(context *c, const sure_ray *ray, const sure_object *object,
                     const sure_hit *hit)
{
    if (object->shape == SURE_SHAPE_SPHERE)
        return sphere_t(c, ray, &object->as.sphere, hit);
    return object->shape == SURE_SHAPE_CYLINDER ? cylinder_t(c, ray, &object->as.cylinder, hit)
                                                : cone_t(c, ray, &object->as.cone, hit);
}

static bool rounds_to(near x, double *rounded)
{
    *rounded = 0;
    return near_is_zero(x) || wide_rounds_to(x, rounded);
}

bool hit_point(const sure_ray *ray, const sure_object *object, const sure_hit *hit,
               sure_vec3 *place)
{
    context c = {false};
    surface s = surface_of(object, hit->part);
    near t = s.flat ? plane_t(&c, ray, vector_between(&c, s.from, s.to), s.q)
                    : curved_t(&c, ray, object, hit);
    if (c.uncertain)
        return false;
    vector along = vector_scale(&c, t, vector_of(&c, ray->direction));
    vector p = vector_add(&c, vector_of(&c, ray->origin), along);
    if (s.flat)
        set_level(&p, (sure_vec3){s.to.x - s.from.x, s.to.y - s.from.y, s.to.z - s.from.z}, s.q);
    return rounds_to(p.x, &place->x) && rounds_to(p.y, &place->y) && rounds_to(p.z, &place->z);
}
