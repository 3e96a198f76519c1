#include "ladder.h"

#include "../numbers/environment.h"
#include "rounded.h"
#include "wide_stages.h"

#include <stddef.h>

sure_status ladder_hit(const sure_ray *ray, const sure_object *object, const question *asked,
                       t_wanted wanted, sure_hit *hit, sure_stage *stage)
{
    sure_status status;
    if (asked != NULL) {
        bool answered;
        TO_NEAREST(answered, wide_hit(asked, wanted, &status, hit, stage));
        if (answered)
            return status;
    }
    *stage = SURE_STAGE_EXACT;
    chord_end first;
    double t;
    bool whole;
    status = rounded_hit(ray, object, &first, &t, &whole);
    if (status == SURE_HIT) {
        bool known = first.at == POINT_START || (whole && wanted == T_CERTAIN);
        *hit = (sure_hit){t, known ? 0 : ladder_half_ulp(t), first.part};
    }
    return status;
}

sure_status ladder_interval(const sure_ray *ray, const sure_object *object, t_wanted wanted,
                            sure_interval *interval)
{
    if (sure_object_check(ray, object) != SURE_FIELD_NONE)
        return SURE_INVALID;
    question asked;
    if (question_of(ray, object, &asked)) {
        bool answered;
        sure_status status;
        TO_NEAREST(answered, wide_interval(&asked, wanted, &status, interval));
        if (answered)
            return status;
    }
    return rounded_interval(ray, object, interval);
}

sure_vec3 ladder_normal(const sure_ray *ray, const sure_object *object, sure_part part,
                        t_wanted wanted)
{
    question asked;
    if (question_of(ray, object, &asked)) {
        bool answered;
        sure_vec3 normal;
        TO_NEAREST(answered, wide_normal(&asked, part, wanted, &normal));
        if (answered)
            return normal;
    }
    return rounded_normal(ray, object);
}

sure_vec3 ladder_point(const sure_ray *ray, const sure_object *object)
{
    question asked;
    if (question_of(ray, object, &asked)) {
        bool answered;
        sure_vec3 hit_point;
        TO_NEAREST(answered, wide_point(&asked, &hit_point));
        if (answered)
            return hit_point;
    }
    return rounded_point(ray, object);
}

int ladder_order(const sure_ray *ray, const sure_object *first, const sure_object *second)
{
    return rounded_order(ray, first, second);
}
