#include "cone_filter.h"

#include "../capped/axial_close.h"
#include "../capped/axial_plane.h"
#include "../check.h"
#include "../../stages/ladder.h"
#include "../normal_quick.h"
#include "../touch_polish.h"

/* The slope's two shares: with u the unit vector from the axis to the point, h = |A|, A from apex
 * to base, the normal is (h u - r A / h) / sqrt(h^2 + r^2). */
static inline bool cone_quick_normal(const sure_ray *ray, const sure_cone *cone,
                                     const sure_hit *hit, sure_vec3 *normal)
{
    quick_vector axis = quick_between(cone->apex, cone->base), p;
    if (hit->part == SURE_PART_BASE)
        return quick_unit(axis, 1, normal);
    double error, height_square = quick_dot(axis, axis), r = cone->radius;
    if (!quick_point(ray, hit, cone->apex, &p, &error) || !quick_in_range(height_square) ||
        !quick_in_range(r))
        return false;
    quick_vector radial = quick_radial(p, axis, height_square);
    double distance = sqrt(quick_dot(radial, radial)), height = sqrt(height_square);
    double slant = sqrt(height_square + r * r), share = height / (slant * distance);
    quick_vector outward = {radial.x * share, radial.y * share, radial.z * share};
    outward = quick_plus(outward, -r / (slant * height), axis);
    *normal = (sure_vec3){outward.x, outward.y, outward.z};
    return quick_in_range(distance) && error <= QUICK_POINT_SHARE * distance;
}

/* -m.d/d.d is off by at most this times |m| / |d|. */
#define APEX_SHARE 0x1p-48

/* m is along d, so the line passes through the apex, at t = -m.d/d.d. There it touches the cone, or
 * it goes on to the base. */
static filter_verdict cone_through_apex(const cone_terms *terms, filter_chord *found)
{
    const double bound = SURE_CONE_LEADING_BOUND * SURE_CONE_LEADING_BOUND;
    cone_terms of = *terms;
    double e = filter_dot(of.axis, of.d), f = filter_dot(of.axis, of.m);
    double spread = of.height * of.dd, level = of.height * spread, tilted = of.slant * (e * e);
    double a = level - tilted, far = fabs(of.m.x) + fabs(of.m.y) + fabs(of.m.z);
    double reach = of.height * of.size;
    filter_end apex = {-filter_dot(of.m, of.d) / of.dd,
                       APEX_SHARE * far / sqrt(of.dd) + 0x1p-500,
                       {POINT_TOUCH, SURE_PART_WALL}};
    filter_end base = {(of.height - f) / e,
                       SURE_AXIAL_PLANE_BOUND * sqrt(reach) / fabs(e),
                       {POINT_BASE, SURE_PART_BASE}};
    if (!(a * a > bound * (level + tilted) * (of.slant * spread)))
        return FILTER_UNCERTAIN;
    if (a > 0)
        base = apex;
    else if (!(base.error * base.error * of.dd < AXIAL_LIMIT * AXIAL_LIMIT * of.size))
        return FILTER_UNCERTAIN;
    *found = e > 0 ? (filter_chord){apex, base} : (filter_chord){base, apex};
    return FILTER_CHORD;
}

/* A ray that starts where the cone does meets it at once. */
static bool cone_starts_ray(const sure_ray *ray, const sure_cone *cone, filter_chord *found)
{
    const filter_end apex = {0, 0, {POINT_TOUCH, SURE_PART_WALL}};
    *found = (filter_chord){apex, apex};
    return is_zero_bits(ray->t_min) && same_point(ray->origin, cone->apex);
}

/* Where the filter is uncertain: with a better discriminant, then with more digits of all. */
static filter_verdict cone_filter_known(const sure_ray *ray, const sure_cone *cone,
                                        const cone_terms *of, filter_chord *found,
                                        sure_stage *stage)
{
    quarter known;
    if (cone_starts_ray(ray, cone, found))
        return FILTER_CHORD;
    if (!quarter_of(ray, SURE_SHAPE_CONE, cone, &known))
        return FILTER_UNCERTAIN;
    *stage = known.stage;
    if (known.vanishes)
        return cone_through_apex(of, found);
    known.level = axial_plane_of(ray, cone->apex, cone->base, of->axis, of->m, of->d, of->size) ==
                  AXIAL_PLANE_TO;
    *stage = known.level ? SURE_STAGE_RESIDUE : known.stage;
    filter_verdict verdict = cone_filter_given(ray, cone, of, &known, found);
    if (known.level)
        return axial_plane_chord(verdict, SURE_PART_BASE, ray, found);
    if (verdict == FILTER_UNCERTAIN && known.value > 0)
        TO_NEAREST(verdict, cone_close(ray, cone, of, &known, found));
    if (verdict == FILTER_CHORD && axial_starts(ray, cone->apex, cone->base, of->axis, of->m,
                                                of->size, POINT_TOP, POINT_BASE, found))
        *stage = SURE_STAGE_RESIDUE;
    return verdict;
}

/* At a touch, with p seen from the apex and A the way to the base, K = H + r^2:
 *
 *     s = H^2 p.d - K (A.p)(A.d),  a = H^2 d.d - K (A.d)^2 */
static inline bool cone_touch_polish(const sure_ray *ray, const sure_cone *cone,
                                     const filter_end *end, double *t)
{
    near_context c = {false};
    touch_vector axis = touch_between(&c, cone->apex, cone->base);
    touch_vector d = touch_of(&c, ray->direction);
    touch_vector p = touch_point(&c, ray, cone->apex, end->t);
    near height = touch_dot(&c, axis, axis), speed = touch_dot(&c, axis, d);
    near slant = near_add(&c, height, near_square(&c, near_of(&c, cone->radius)));
    near turned = near_mul(&c, near_mul(&c, slant, touch_dot(&c, axis, p)), speed);
    near s = near_sub(&c, near_mul(&c, near_square(&c, height), touch_dot(&c, p, d)), turned);
    double all = height.hi * touch_dot(&c, d, d).hi;
    double a = height.hi * all - slant.hi * speed.hi * speed.hi;
    return touch_round(end->t, s, a, (height.hi + slant.hi) * all, t);
}

#define SHAPE_HAS_QUARTER
#define SHAPE cone
#define SHAPE_NUMBER SURE_SHAPE_CONE
#include "../../stages/ladder_functions.h"
