/* Normals and hit points in double-doubles, from a t that is known so. */
#define SURE_NEAR
#include "wide_stages.h"

#include "../numbers/number.h"
#include "solve.h"

#include <surehit/bounds.h>

static bool component_as_wanted(near x, t_wanted wanted, double *result)
{
    *result = near_is_zero(x) ? 0 : x.hi;
    if (wanted == T_EXACT)
        return near_is_zero(x) || wide_rounds_to(x, result);
    return x.error + fabs(x.lo) <= SURE_NORMAL_ERROR / 2;
}

static bool vector_as_wanted(const context *c, vector v, t_wanted wanted, sure_vec3 *result)
{
    return !c->uncertain && component_as_wanted(v.x, wanted, &result->x) &&
           component_as_wanted(v.y, wanted, &result->y) &&
           component_as_wanted(v.z, wanted, &result->z);
}

static vector divided(context *c, vector v, near by)
{
    return (vector){near_div(c, v.x, by), near_div(c, v.y, by), near_div(c, v.z, by)};
}

static vector opposite(context *c, vector v)
{
    return (vector){near_negate(c, v.x), near_negate(c, v.y), near_negate(c, v.z)};
}

static vector unit(context *c, vector v)
{
    return divided(c, v, near_sqrt(c, vector_square(c, v)));
}

/* o - from + t d */
static vector seen(context *c, const sure_ray *ray, sure_vec3 from, near t)
{
    vector along = vector_scale(c, t, vector_of(c, ray->direction));
    return vector_add(c, vector_between(c, from, ray->origin), along);
}

/* (p - (A.p / A.A) A) / r */
static vector cylinder_wall(context *c, const sure_ray *ray, const sure_cylinder *s, near t)
{
    vector p = seen(c, ray, s->base, t), axis = vector_between(c, s->base, s->top);
    near share = near_div(c, vector_dot(c, axis, p), vector_square(c, axis));
    return divided(c, vector_sub(c, p, vector_scale(c, share, axis)), near_of(c, s->radius));
}

/* (H^2 p - K (A.p) A) / ((A.p) r sqrt(K H)), rounded.c */
static vector cone_wall(context *c, const sure_ray *ray, const sure_cone *s, near t)
{
    vector p = seen(c, ray, s->apex, t), axis = vector_between(c, s->apex, s->base);
    near height = vector_square(c, axis), depth = vector_dot(c, axis, p), r = near_of(c, s->radius);
    near slant = near_add(c, height, near_square(c, r));
    vector inward = vector_scale(c, near_mul(c, slant, depth), axis);
    vector outward = vector_sub(c, vector_scale(c, near_square(c, height), p), inward);
    near length = near_mul(c, near_mul(c, depth, r), near_sqrt(c, near_mul(c, slant, height)));
    return divided(c, outward, length);
}

/* Of faces that are flat: the same wherever they are hit. */
static bool is_flat(sure_shape shape, sure_part part)
{
    return shape == SURE_SHAPE_PLANE || shape == SURE_SHAPE_DISC || part == SURE_PART_BASE ||
           part == SURE_PART_TOP;
}

static vector flat_normal(context *c, const sure_object *object, sure_part part)
{
    switch (object->shape) {
    case SURE_SHAPE_PLANE: return unit(c, vector_of(c, object->as.plane.normal));
    case SURE_SHAPE_DISC: return unit(c, vector_of(c, object->as.disc.normal));
    case SURE_SHAPE_CYLINDER: {
        const sure_cylinder *s = &object->as.cylinder;
        return part == SURE_PART_TOP ? unit(c, vector_between(c, s->base, s->top))
                                     : unit(c, vector_between(c, s->top, s->base));
    }
    case SURE_SHAPE_SPHERE:
    case SURE_SHAPE_CONE: break;
    }
    return unit(c, vector_between(c, object->as.cone.apex, object->as.cone.base));
}

static vector round_normal(context *c, const question *q, const solved_hit *found)
{
    const sure_object *object = q->object;
    vector against = opposite(c, vector_of(c, q->ray->direction));
    if (object->shape == SURE_SHAPE_SPHERE) {
        const sure_sphere *s = &object->as.sphere;
        return s->radius == 0
                   ? unit(c, against)
                   : divided(c, seen(c, q->ray, s->centre, found->t), near_of(c, s->radius));
    }
    if (object->shape == SURE_SHAPE_CYLINDER) {
        const sure_cylinder *s = &object->as.cylinder;
        return s->radius == 0 ? unit(c, against) : cylinder_wall(c, q->ray, s, found->t);
    }
    const sure_cone *s = &object->as.cone;
    return found->end.at == POINT_TOP ? unit(c, vector_between(c, s->base, s->apex))
                                      : cone_wall(c, q->ray, s, found->t);
}

static bool solved(const question *q, solved_hit *found)
{
    return (solve_hit_near(q->ray, q->object, found) ||
            solve_hit_residue(q->ray, q->object, found)) &&
           found->t.error >= 0; /* not a NaN */
}

bool wide_normal(const question *q, sure_part part, t_wanted wanted, sure_vec3 *normal)
{
    context c = {false};
    solved_hit found;
    if (is_flat(q->object->shape, part))
        return vector_as_wanted(&c, flat_normal(&c, q->object, part), wanted, normal);
    return solved(q, &found) && vector_as_wanted(&c, round_normal(&c, q, &found), wanted, normal);
}

static bool coordinate_of(const question *q, near x, double *coordinate)
{
    if (near_is_zero(x)) {
        *coordinate = 0;
        return true;
    }
    return wide_rounds_to(x, coordinate) &&
           question_shift(*coordinate, q->length_exponent, coordinate);
}

bool wide_point(const question *q, sure_vec3 *hit_point)
{
    context c = {false};
    solved_hit found;
    const sure_vec3 world = {0, 0, 0};
    if (!solved(q, &found))
        return false;
    vector p = seen(&c, q->ray, world, found.t);
    return !c.uncertain && coordinate_of(q, p.x, &hit_point->x) &&
           coordinate_of(q, p.y, &hit_point->y) && coordinate_of(q, p.z, &hit_point->z);
}
