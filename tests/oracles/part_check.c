/* SPDX-License-Identifier: MIT */
#include "part_check.h"

#include "hard_points.h"

#include "long_vector.h"
#include "reference.h"
#include "surroundings.h"
#include "tiers.h"

#include <surehit/bounds.h>
#include <surehit/bracket.h>
#include <surehit/cone_height.h>
#include <surehit/cone_normal.h>
#include <surehit/cone_wall.h>
#include <surehit/cylinder_height.h>
#include <surehit/cylinder_wall.h>
#include <surehit/project.h>
#include <surehit/reflect.h>

/* Was nothing rounded in the call? */
#define UNROUNDED(...)                                                                             \
    (feclearexcept(FE_ALL_EXCEPT), (__VA_ARGS__),                                                  \
     fetestexcept(FE_INEXACT | FE_INVALID | FE_DIVBYZERO) == 0)

/* The plain tiers' answer of a solid's wall: `ask` is a macro of its shape and the tier. */
#define PLAIN_OF(solid, tier, ask)                                                                 \
    (is_pointed(solid) ? (tier) == SURE_TIER_FLOAT32 ? ask(cone, float32) : ask(cone, textbook)    \
     : (tier) == SURE_TIER_FLOAT32 ? ask(cylinder, float32)                                        \
                                   : ask(cylinder, textbook))

bool has_parts(sure_shape shape)
{
    return shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
}

int height_of(const sure_object *solid, sure_vec3 p, sure_tier tier)
{
#define ASK(shape, tier) sure_##shape##_height_##tier(p, &solid->as.shape)
    if (tier < SURE_TIER_CERTAIN)
        return PLAIN_OF(solid, tier, ASK);
    if (tier == SURE_TIER_CERTAIN)
        return is_pointed(solid) ? ASK(cone, certain) : ASK(cylinder, certain);
    return is_pointed(solid) ? ASK(cone, exact) : ASK(cylinder, exact);
#undef ASK
}

const char *height_broken(const sure_object *solid, sure_vec3 point, part_unrounded *count)
{
    int right = reference_height(solid, point), given = right;
    for (int i = 0; i < SURROUNDINGS && given == right; i++) {
        surroundings_set(i);
        given = height_of(solid, point, i % 2 ? SURE_TIER_EXACT : SURE_TIER_CERTAIN);
        surroundings_set(0);
    }
    if (given != right || height_of(solid, point, SURE_TIER_EXACT) != right)
        return "a height that is not certain";
    for (sure_tier tier = 0; tier <= SURE_TIER_TEXTBOOK; tier++) {
        if (!UNROUNDED(given = height_of(solid, point, tier)))
            continue;
        count->heights++;
        if (given != right)
            return "an unrounded height";
    }
    return NULL;
}

static sure_status wall_hit(const sure_ray *ray, const sure_object *solid, sure_tier tier,
                            sure_hit *hit)
{
#define ASK(shape, tier) sure_##shape##_wall_hit_##tier(ray, &solid->as.shape, hit)
    return PLAIN_OF(solid, tier, ASK);
#undef ASK
}

static int exact_wall_side(const sure_ray *ray, const sure_object *solid)
{
    return is_pointed(solid) ? sure_cone_wall_side_exact(ray, &solid->as.cone)
                             : sure_cylinder_wall_side_exact(ray, &solid->as.cylinder);
}

static sure_status exact_wall_hit(const sure_ray *ray, const sure_object *solid, sure_hit *hit)
{
    return is_pointed(solid) ? sure_cone_wall_hit_exact(ray, &solid->as.cone, hit)
                             : sure_cylinder_wall_hit_exact(ray, &solid->as.cylinder, hit);
}

/* In any environment. A side of what is invalid is not asked. */
static bool exact_wall_broken(const sure_ray *ray, const sure_object *solid, sure_status right,
                              double t)
{
    bool broken = false, valid = right != SURE_INVALID;
    int side = valid ? reference_wall_side(ray, solid) : 0;
    for (int i = 0; i < SURROUNDINGS && !broken; i++) {
        sure_hit hit;
        surroundings_set(i);
        int given_side = valid ? exact_wall_side(ray, solid) : 0;
        sure_status given = exact_wall_hit(ray, solid, &hit);
        surroundings_set(0);
        broken = given_side != side || given != right ||
                 (given == SURE_HIT && (hit.t != t || hit.part != SURE_PART_WALL));
    }
    return broken;
}

const char *wall_hit_broken(const sure_ray *ray, const sure_object *solid, part_unrounded *count)
{
    double t;
    sure_status right = reference_wall_hit(ray, solid, &t);
    if (exact_wall_broken(ray, solid, right, t))
        return "an exact hit of a wall";
    for (sure_tier tier = 0; tier <= SURE_TIER_TEXTBOOK; tier++) {
        sure_hit hit;
        sure_status given = SURE_MISS;
        bool exact = UNROUNDED(given = wall_hit(ray, solid, tier, &hit));
        if ((given == SURE_INVALID) != (right == SURE_INVALID))
            return "a wall's validity";
        if (given == SURE_HIT && !(hit.part == SURE_PART_WALL && isinf(hit.t_error)))
            return "a wall's part or bound";
        if (!exact || right == SURE_INVALID)
            continue;
        count->walls++;
        if (given != right || (right == SURE_HIT && hit.t != t))
            return "an unrounded hit of a wall";
    }
    return NULL;
}

/* Products of eight of them neither over- nor underflow in the tier's numbers. */
static bool is_moderate(sure_tier tier, long double x)
{
    return within_powers(x, tier == SURE_TIER_FLOAT32 ? 14 : 120);
}

static bool is_near(sure_vec3 given, sure_vec3 right, long double most)
{
    return fabsl((long double)given.x - right.x) <= most &&
           fabsl((long double)given.y - right.y) <= most &&
           fabsl((long double)given.z - right.z) <= most;
}

/* The wall's normal is the direction of P - S, S a point of the axis, which is computed from P seen
 * from an end, v, and the axis A. In units of u, the tier's half an ulp:
 *
 *     cylinder   v 1; A 2 of |v|, by its direction; A.v / A.A 7, times A_i 1; the difference 1: 12
 *     cone       v 1 and A 2, as shares; |v|^2 3 + 2, K = A.A + r^2 6, their product 1, its root 7,
 *                over A.A 6, times A_i 2: 15 of |Q - S|; the sum 2, v itself 1: 18
 *
 * of a component; sqrt(3) times that over |P - S| is what the direction is off by, besides 5 of the
 * unit vector and 1 of the reference. Together that is less than 48; and what is so near has of a
 * cone Laws 1 and 2 of cone_normal.h: */
#define NORMAL_ROUNDINGS 48

/* |v| or |Q - S| over |P - S|; infinite where these numbers do not tell. */
static long double cancelled(const sure_object *solid, sure_vec3 p, sure_tier tier)
{
    const sure_cylinder *s = &solid->as.cylinder;
    bool cone = is_pointed(solid);
    long_vector a = long_between(s->base, s->top), v = long_between(cone ? s->top : s->base, p);
    long double axis = long_length(a), far = long_length(v), r = s->radius, share;
    if (!is_moderate(tier, axis) || !is_moderate(tier, far) || !(cone || is_moderate(tier, r + 1)))
        return INFINITY;
    if (cone) {
        if (!is_moderate(tier, r + axis))
            return INFINITY;
        far *= sqrtl(axis * axis + r * r) / axis;
        share = far / axis;
    } else {
        share = -long_dot(v, a) / (axis * axis);
    }
    long double away = long_length(long_sum(1, v, share, a));
    return away > 0x1p-40L * far && is_moderate(tier, away) ? far / away : INFINITY;
}

static sure_vec3 wall_normal(const sure_object *solid, sure_vec3 p, sure_tier tier)
{
#define ASK(shape, tier) sure_##shape##_wall_normal_##tier(p, &solid->as.shape)
    return PLAIN_OF(solid, tier, ASK);
#undef ASK
}

/* As the tier has its numbers; false where these are no solid any more. */
static bool narrowed(const sure_object *solid, sure_tier tier, sure_object *made)
{
    const sure_cylinder *s = &solid->as.cylinder;
    const sure_ray any = {{0, 0, 0}, {1, 0, 0}, 0, 0};
    *made = *solid;
    made->as.cylinder = (sure_cylinder){rounded_vector(tier, s->base), rounded_vector(tier, s->top),
                                        rounded(tier, s->radius)};
    return sure_object_check(&any, made) == SURE_FIELD_NONE;
}

const char *wall_normal_broken(const sure_object *solid, sure_vec3 point, part_unrounded *count)
{
    for (sure_tier tier = 0; tier <= SURE_TIER_TEXTBOOK; tier++) {
        sure_object narrow;
        sure_vec3 p = rounded_vector(tier, point), given = {0, 0, 0};
        if (!narrowed(solid, tier, &narrow) || !all_finite(p))
            continue;
        sure_vec3 right = reference_wall_normal(&narrow, p);
        bool exact = UNROUNDED(given = wall_normal(&narrow, p, tier));
        long double most = NORMAL_ROUNDINGS * unit(tier) * cancelled(&narrow, p, tier);
        count->others += exact;
        if (!all_finite(given))
            return "a wall's normal that is not finite";
        if (exact ? !is_near(given, right, 0) : !is_near(given, right, most))
            return exact ? "an unrounded normal of a wall" : "a wall's normal";
    }
    return NULL;
}

static sure_field from_axis(sure_tier tier, sure_vec3 centre, sure_vec3 axis, double radius,
                            double height, sure_object *made)
{
#define ASK(shape, tier)                                                                           \
    sure_##shape##_from_axis_##tier(centre, axis, radius, height, &made->as.shape)
    return PLAIN_OF(made, tier, ASK);
#undef ASK
}

/* Ulps of the larger of |c| and half the height, the reference's rounding included. */
static bool is_near_end(double given, double right, double c, double half)
{
    int exponent;
    (void)frexp(fmax(fabs(c), half), &exponent);
    long double ulp = ldexpl(1, exponent - 53), least_ulp = 0x1p-1074L;
    return fabsl((long double)given - right) <=
           (SURE_END_POINT_ULPS + 0.5L) * (ulp > least_ulp ? ulp : least_ulp);
}

static bool are_near_ends(sure_vec3 given, sure_vec3 right, sure_vec3 c, double half)
{
    return is_near_end(given.x, right.x, c.x, half) && is_near_end(given.y, right.y, c.y, half) &&
           is_near_end(given.z, right.z, c.z, half);
}

/* Ends so far apart that no rounding makes them one, and none infinite. */
static bool are_apart(sure_vec3 low, sure_vec3 high, sure_vec3 c, double half)
{
    double size = fmax(half, fmax(fabs(c.x), fmax(fabs(c.y), fabs(c.z))));
    double apart = fmax(fabs(low.x - high.x), fmax(fabs(low.y - high.y), fabs(low.z - high.z)));
    return size < DBL_MAX / 8 && apart > 0x1p-40 * size && apart > 0x1p-1000;
}

const char *end_points_broken(sure_shape shape, sure_vec3 centre, sure_vec3 axis, double radius,
                              double height, part_unrounded *count)
{
    bool fine = all_finite(centre) && all_finite(axis) && isfinite(height) && height > 0 &&
                !(axis.x == 0 && axis.y == 0 && axis.z == 0) && isfinite(radius);
    sure_vec3 low, high;
    if (fine)
        reference_end_points(centre, axis, height, &low, &high);
    for (sure_tier tier = 0; tier <= SURE_TIER_TEXTBOOK; tier++) {
        const sure_vec3 untouched = {7, 7, 7};
        const double r = tier == SURE_TIER_FLOAT32 ? (float)radius : radius; /* -2^-1074 is 0 */
        sure_object solid = {shape, {.cylinder = {untouched, untouched, 7}}};
        const sure_cylinder *made = &solid.as.cylinder; /* a cone has its numbers there, too */
        sure_field field = SURE_FIELD_NONE;
        bool exact = UNROUNDED(field = from_axis(tier, centre, axis, radius, height, &solid));
        if (field != SURE_FIELD_NONE) {
            if (!same_place(made->base, untouched) || !same_place(made->top, untouched))
                return "end points written of what is none";
            if (fine && r >= 0 && tier == SURE_TIER_TEXTBOOK &&
                are_apart(low, high, centre, height / 2))
                return "end points refused";
            continue;
        }
        if (!fine || !(r >= 0))
            return "end points of what is none";
        count->others += exact;
        if (exact && !(same_place(made->base, low) && same_place(made->top, high)))
            return "unrounded end points";
        if (tier == SURE_TIER_TEXTBOOK && !(are_near_ends(made->base, low, centre, height / 2) &&
                                            are_near_ends(made->top, high, centre, height / 2)))
            return "SURE_END_POINT_ULPS";
    }
    return NULL;
}

/* n.v is off by 3 u |n| |v|, n.n by 3 u of itself; their quotient, u, times n_i, u, is off by 8 u
 * |v|; twice that, and 1 for the difference, is the mirrored vector. The reference adds 1. */
#define PROJECT_ROUNDINGS 9
#define REFLECT_ROUNDINGS 18

static sure_vec3 (*const projected[])(sure_vec3, sure_vec3) = OF_TIERS(sure_project);
static sure_vec3 (*const mirrored[])(sure_vec3, sure_vec3) = OF_TIERS(sure_reflect);

static const char *vector_broken(sure_tier tier, sure_vec3 v, sure_vec3 n, bool mirror,
                                 part_unrounded *count)
{
    long double length = long_length(long_of(v));
    sure_vec3 right = mirror ? reference_reflect(v, n) : reference_project(v, n), given = {0, 0, 0};
    bool asked =
        is_moderate(tier, long_length(long_of(n))) && (length == 0 || is_moderate(tier, length));
    bool counted = tier == SURE_TIER_STABLE ? length < DBL_MAX / 2 : length > 0;
    if (!asked && tier != SURE_TIER_STABLE)
        return NULL;
    bool exact = UNROUNDED(given = (mirror ? mirrored : projected)[tier](v, n));
    long double most =
        (mirror ? REFLECT_ROUNDINGS : PROJECT_ROUNDINGS) * unit(tier) * length + 4 * least(tier);
    count->others += exact;
    if (exact && !is_near(given, right, 0))
        return mirror ? "an unrounded reflection" : "an unrounded projection";
    if (counted && !is_near(given, right, most))
        return mirror ? "a reflection" : "a projection";
    return NULL;
}

const char *vectors_broken(sure_vec3 v, sure_vec3 n, part_unrounded *count)
{
    const char *broken = NULL;
    for (sure_tier tier = 0; tier <= SURE_TIER_STABLE && !broken; tier++) {
        sure_vec3 w = rounded_vector(tier, v), m = rounded_vector(tier, n);
        if (!all_finite(w) || !all_finite(m) || (m.x == 0 && m.y == 0 && m.z == 0))
            continue;
        broken = vector_broken(tier, w, m, false, count);
        if (!broken)
            broken = vector_broken(tier, w, m, true, count);
    }
    return broken;
}

/* On a line on which the coordinate x is t, so that no point is rounded. */
typedef struct {
    const sure_ray *ray;
    const sure_object *object;
    int before; /* the side that the ray comes from */
} crossing;

static double side_at(const void *surface, sure_vec3 p)
{
    const crossing *c = surface;
    return c->before * reference_where_at(c->ray, c->object, p.x);
}

/* A t of the range shortly behind the hit where the other side is: false where there is none. */
static bool is_crossed(const crossing *c, double t, double *behind)
{
    for (int k = 50; k > 1; k -= 6) {
        *behind = fmin(c->ray->t_max, t + fmax(fabs(t), 0x1p-1000) * ldexp(1, -k));
        if (isfinite(*behind) && *behind > t && side_at(c, (sure_vec3){*behind, 0, 0}) < 0)
            return true;
    }
    return false;
}

const char *bracket_broken(const sure_ray *ray, const sure_object *object, unsigned long *asked)
{
    static sure_status (*const brackets[])(sure_implicit *, const void *, const sure_ray *, int,
                                           double *) = {sure_bracket_textbook, sure_bracket_stable};
    sure_hit hit;
    double behind;
    if (object->shape == SURE_SHAPE_DISC ||
        sure_object_hit(ray, object, SURE_TIER_EXACT, &hit) != SURE_HIT || !isfinite(hit.t))
        return NULL;
    crossing c = {ray, object, 1};
    c.before = reference_where_at(ray, object, ray->t_min);
    if (c.before == 0 || !is_crossed(&c, hit.t, &behind))
        return NULL;
    ++*asked;
    const sure_ray line = {{0, 0, 0}, {1, 0, 0}, ray->t_min, behind};
    for (size_t i = 0; i < sizeof brackets / sizeof *brackets; i++) {
        double t[2] = {NAN, NAN};
        if (brackets[i](side_at, &c, &line, 1, t) != SURE_HIT)
            return "a crossing that the bracket does not see";
        if (nextafter(t[0], INFINITY) != t[1] || !(side_at(&c, (sure_vec3){t[0], 0, 0}) > 0 &&
                                                   side_at(&c, (sure_vec3){t[1], 0, 0}) <= 0))
            return "Law 1 of the bracket";
        if (hit.t != t[0] && hit.t != t[1])
            return "a hit that the bracket does not enclose";
    }
    return NULL;
}
