#include "sphere_filter.h"

#include "../../stages/ladder.h"
#include "../normal_quick.h"
#include "../quarter.h"
#include "../touch_polish.h"

static inline bool sphere_quick_normal(const sure_ray *ray, const sure_sphere *sphere,
                                       const sure_hit *hit, sure_vec3 *normal)
{
    quick_vector p;
    double error;
    return quick_point(ray, hit, sphere->centre, &p, &error) && quick_unit(p, 1, normal) &&
           error <= QUICK_POINT_SHARE * sphere->radius;
}

/* Where the filter is uncertain, with a better discriminant: its root is then as good as any
 * product, which the bound allows for. */
static inline filter_verdict sphere_filter_known(const sure_ray *ray, const sure_sphere *sphere,
                                                 const sphere_terms *of, filter_chord *found,
                                                 sure_stage *stage)
{
    quarter known;
    if (!quarter_of(ray, SURE_SHAPE_SPHERE, sphere, &known))
        return FILTER_UNCERTAIN;
    double off = known.error + fabs(known.rest), inner = of->a * (sphere->radius * sphere->radius);
    if (!(off * off <= QUARTER_SHARE * (fabs(known.value) * inner)))
        return FILTER_UNCERTAIN;
    *stage = known.stage;
    if (known.value < 0)
        return filter_miss_if(true, ray);
    double error = SURE_SPHERE_CLOSE_T_BOUND * sqrt(of->a * of->size) / of->a;
    (void)sphere_found(of, sqrt(known.value), error, found);
    if (known.value == 0)
        found->enter.end.at = found->leave.end.at = POINT_TOUCH;
    return FILTER_CHORD;
}

/* At a touch s = p.d, a = d.d. */
static inline bool sphere_touch_polish(const sure_ray *ray, const sure_sphere *sphere,
                                       const filter_end *end, double *t)
{
    near_context c = {false};
    touch_vector d = touch_of(&c, ray->direction);
    touch_vector p = touch_point(&c, ray, sphere->centre, end->t);
    double a = touch_dot(&c, d, d).hi;
    return touch_round(end->t, touch_dot(&c, p, d), a, a, t);
}

#define SHAPE_HAS_QUARTER
#define SHAPE sphere
#define SHAPE_NUMBER SURE_SHAPE_SPHERE
#include "../../stages/ladder_functions.h"
