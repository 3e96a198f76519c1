#include "cone_filter.h"

#include "ladder.h"
#include "normal_quick.h"
#include "touch_polish.h"

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
#include "ladder_functions.h"
