/* From p, the hit point correctly rounded, to a neighbour that is on the side asked for. The true
 * hit point P is in a plane that has the whole solid on one side, with the outward normal n. The
 * next double q_i of p_i towards n_i lies beyond P_i, which rounds to p_i, so the corner q has
 *
 *     n.(q - P) = sum of n_i (q_i - P_i) > 0
 *
 * over all i with n_i not 0: one step in every coordinate leads out. Fewer do in most cases, and
 * are tried before; inside, where a solid may be thinner than the doubles lie apart, and where n is
 * known too badly, the box of all neighbours is tried. Every point is tested exactly. */
#include <surehit/spawn.h>

#include "../numbers/bits.h"
#include "../numbers/environment.h"
#include "hit_point.h"
#include "ladder.h"
#include "question.h"
#include "spawn_quick.h"
#include "../shapes/where.h"

#include <surehit/bounds.h>

#include <stdlib.h>

#ifdef __GNUC__
#define OUT_OF_LINE __attribute__((noinline))
#else
#define OUT_OF_LINE
#endif

typedef struct {
    const sure_object *object;
    sure_part part;
    int wanted; /* the side, as where.h counts */
    double p[3];
    double origin[3]; /* the candidate */
} search;

/* The point and the object, scaled where that helps (question.h). */
typedef struct {
    sure_ray ray;
    question asked;
    bool scaled;
} view;

static sure_vec3 vector_at(const double p[3])
{
    return (sure_vec3){p[0], p[1], p[2]};
}

static bool view_of(const sure_object *object, const double p[3], view *v)
{
    v->ray = (sure_ray){vector_at(p), {1, 0, 0}, 0, 0};
    return question_of(&v->ray, object, &v->asked);
}

/* The stages of bounded range also hold outside it, where they tell little; scaled, they tell more,
 * but not every question can be scaled. */
static int side_of(const sure_object *object, const double p[3])
{
    int side;
    view v;
    sure_vec3 at = vector_at(p);
    if (where_near(object, at, &side) || where_residue(object, at, &side))
        return side;
    if (view_of(object, p, &v) && v.asked.object != object &&
        (where_near(v.asked.object, v.asked.ray->origin, &side) ||
         where_residue(v.asked.object, v.asked.ray->origin, &side)))
        return side;
    (void)where_exact(object, at, &side);
    return side;
}

/* The double that lies `steps` away from x in the order of doubles; false where that is none. */
static bool stepped(double x, int steps, double *result)
{
    int64_t magnitude = (int64_t)magnitude_bits(x);
    int64_t place = (is_negative_bits(x) ? -magnitude : magnitude) + steps;
    *result = place < 0 ? double_of((uint64_t)-place | BITS_SIGN) : double_of((uint64_t)place);
    return is_finite_bits(*result);
}

static bool succeeds(search *s, const int steps[3])
{
    for (int i = 0; i < 3; i++) {
        if (!stepped(s->p[i], steps[i], &s->origin[i]))
            return false;
    }
    return side_of(s->object, s->origin) == s->wanted;
}

static sure_vec3 difference(sure_vec3 a, sure_vec3 b)
{
    return (sure_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* v - k axis */
static sure_vec3 less(sure_vec3 v, double k, sure_vec3 axis)
{
    return (sure_vec3){v.x - k * axis.x, v.y - k * axis.y, v.z - k * axis.z};
}

/* A direction of the outward normal, so far as doubles tell: it decides what is tried first, which
 * spawn_quick.c foresees by its roundings as docs/proofs/spawn.md counts them. */
static sure_vec3 outward(const sure_object *object, sure_part part, sure_vec3 p)
{
    switch (object->shape) {
    case SURE_SHAPE_PLANE: return object->as.plane.normal;
    case SURE_SHAPE_DISC: return object->as.disc.normal;
    case SURE_SHAPE_SPHERE: return difference(p, object->as.sphere.centre);
    case SURE_SHAPE_CYLINDER: {
        const sure_cylinder *s = &object->as.cylinder;
        sure_vec3 axis = difference(s->top, s->base), m = difference(p, s->base);
        if (part != SURE_PART_WALL)
            return part == SURE_PART_TOP ? axis : difference(s->base, s->top);
        return less(m, dot(axis, m) / dot(axis, axis), axis);
    }
    case SURE_SHAPE_CONE: break;
    }
    const sure_cone *s = &object->as.cone;
    sure_vec3 axis = difference(s->base, s->apex), m = difference(p, s->apex);
    double height = dot(axis, axis), slope = 1 + s->radius * s->radius / height;
    return part == SURE_PART_BASE ? axis : less(m, slope * dot(axis, m) / height, axis);
}

/* +-1 in every coordinate towards the side, and the coordinate in which one step leads farthest
 * along the normal: the greatest |n_i| 2^(exponent of p_i). */
static int directions(const search *s, int towards[3])
{
    view v;
    bool scaled = view_of(s->object, s->p, &v);
    sure_vec3 normal = scaled ? outward(v.asked.object, s->part, v.asked.ray->origin)
                              : outward(s->object, s->part, vector_at(s->p));
    const double n[3] = {normal.x, normal.y, normal.z};
    int exponents[3], highest = -1023, best = 0;
    double most = -1;
    for (int i = 0; i < 3; i++) {
        exponents[i] = exponent_of(s->p[i]);
        highest = exponents[i] > highest ? exponents[i] : highest;
    }
    for (int i = 0; i < 3; i++) {
        int lower = exponents[i] - highest;
        double reach = fabs(n[i]) * power_of_two(lower < -1022 ? -1022 : lower);
        towards[i] = n[i] > 0 ? s->wanted : n[i] < 0 ? -s->wanted : 0;
        if (reach > most) {
            most = reach;
            best = i;
        }
    }
    return best;
}

/* All of the box, the fewest steps first. */
static bool search_box(search *s)
{
    const int most = SURE_SPAWN_STEPS;
    for (int all = 1; all <= 3 * most; all++) {
        for (int x = -most; x <= most; x++) {
            for (int y = -most; y <= most; y++) {
                int z = all - abs(x) - abs(y);
                if (z < 0 || z > most)
                    continue;
                if (succeeds(s, (int[3]){x, y, z}) || (z > 0 && succeeds(s, (int[3]){x, y, -z})))
                    return true;
            }
        }
    }
    return false;
}

static bool search_all(search *s)
{
    int towards[3];
    if (succeeds(s, (int[3]){0, 0, 0}))
        return true;
    int best = directions(s, towards);
    for (int count = 1; count <= 2; count++) {
        int steps[3] = {0, 0, 0};
        steps[best] = count * towards[best];
        if (succeeds(s, steps))
            return true;
    }
    return succeeds(s, towards) || search_box(s);
}

static bool has_inside(const sure_object *object)
{
    switch (object->shape) {
    case SURE_SHAPE_SPHERE: return !is_zero_bits(object->as.sphere.radius);
    case SURE_SHAPE_CYLINDER: return !is_zero_bits(object->as.cylinder.radius);
    case SURE_SHAPE_CONE: return !is_zero_bits(object->as.cone.radius);
    default: return true;
    }
}

/* Not inlined where the environment changes (environment.h). */
static OUT_OF_LINE bool spawn(const sure_ray *ray, const sure_object *object, const sure_hit *hit,
                              int wanted, sure_vec3 *origin)
{
    sure_vec3 p;
    if (!hit_point(ray, object, hit, &p))
        p = ladder_point(ray, object);
    search s = {.object = object, .part = hit->part, .wanted = wanted, .p = {p.x, p.y, p.z}};
    if (!search_all(&s))
        return false;
    *origin = vector_at(s.origin);
    return true;
}

int sure_spawn(const sure_ray *ray, const sure_object *object, const sure_hit *hit, sure_side side,
               sure_vec3 *origin)
{
    int wanted = side == SURE_SIDE_INSIDE ? -1 : 1;
    if (wanted < 0 && !has_inside(object))
        return 0;
    if (environment_is_nearest() && spawn_quick(ray, object, hit, wanted, origin))
        return 1;
    environment saved;
    environment_enter(&saved); /* so that what is tried first is the same in every one */
    bool found = spawn(ray, object, hit, wanted, origin);
    environment_leave(&saved);
    return found;
}
