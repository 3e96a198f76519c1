#include "cylinder_filter.h"

#include "../capped/axial_close.h"
#include "../capped/axial_plane.h"
#include "../../stages/ladder.h"
#include "../normal_quick.h"
#include "../touch_polish.h"

static inline bool cylinder_quick_normal(const sure_ray *ray, const sure_cylinder *cylinder,
                                         const sure_hit *hit, sure_vec3 *normal)
{
    quick_vector axis = quick_between(cylinder->base, cylinder->top), p;
    if (hit->part != SURE_PART_WALL)
        return quick_unit(axis, hit->part == SURE_PART_TOP ? 1 : -1, normal);
    double error, height_square = quick_dot(axis, axis);
    return quick_point(ray, hit, cylinder->base, &p, &error) && quick_in_range(height_square) &&
           quick_unit(quick_radial(p, axis, height_square), 1, normal) &&
           error <= QUICK_POINT_SHARE * cylinder->radius;
}

/* Where the filter is uncertain: with a better discriminant, then with more digits of all. */
static filter_verdict cylinder_filter_known(const sure_ray *ray, const sure_cylinder *cylinder,
                                            const cylinder_terms *of, filter_chord *found,
                                            sure_stage *stage)
{
    quarter known;
    if (!quarter_of(ray, SURE_SHAPE_CYLINDER, cylinder, &known))
        return FILTER_UNCERTAIN;
    axial_plane plane =
        axial_plane_of(ray, cylinder->base, cylinder->top, of->axis, of->m, of->d, of->size);
    known.level = plane != AXIAL_PLANE_UNKNOWN;
    *stage = known.level ? SURE_STAGE_RESIDUE : known.stage;
    filter_verdict verdict = cylinder_filter_given(ray, cylinder, of, &known, found);
    if (known.level)
        return axial_plane_chord(
            verdict, plane == AXIAL_PLANE_FROM ? SURE_PART_BASE : SURE_PART_TOP, ray, found);
    if (verdict == FILTER_UNCERTAIN && known.value > 0)
        TO_NEAREST(verdict, cylinder_close(ray, cylinder, of, &known, found));
    if (verdict == FILTER_CHORD && axial_starts(ray, cylinder->base, cylinder->top, of->axis, of->m,
                                                of->size, POINT_BASE, POINT_TOP, found))
        *stage = SURE_STAGE_RESIDUE;
    return verdict;
}

/* At a touch, with p seen from the base: s = H p.d - (A.p)(A.d), a = H d.d - (A.d)^2. */
static inline bool cylinder_touch_polish(const sure_ray *ray, const sure_cylinder *cylinder,
                                         const filter_end *end, double *t)
{
    near_context c = {false};
    touch_vector axis = touch_between(&c, cylinder->base, cylinder->top);
    touch_vector d = touch_of(&c, ray->direction);
    touch_vector p = touch_point(&c, ray, cylinder->base, end->t);
    near height = touch_dot(&c, axis, axis), speed = touch_dot(&c, axis, d);
    near turned = near_mul(&c, touch_dot(&c, axis, p), speed);
    near s = near_sub(&c, near_mul(&c, height, touch_dot(&c, p, d)), turned);
    double all = height.hi * touch_dot(&c, d, d).hi;
    return touch_round(end->t, s, all - speed.hi * speed.hi, all, t);
}

#define SHAPE_HAS_QUARTER
#define SHAPE cylinder
#define SHAPE_NUMBER SURE_SHAPE_CYLINDER
#include "../../stages/ladder_functions.h"
