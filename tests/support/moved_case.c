/* SPDX-License-Identifier: MIT */
#include "moved_case.h"

bool case_scaled(const sure_case *c, const int powers[NUMBER_KINDS], sure_case *scaled)
{
    bool exact = true;
    *scaled = *c;
    for (int i = 0; i < case_numbers(c->object.shape); i++) {
        int power = powers[case_number_kind(c->object.shape, i)];
        double *x = case_number(scaled, i), was = *x;
        *x = ldexp(was, power);
        exact = exact && (ldexp(*x, -power) == was || isnan(*x));
    }
    return exact;
}

static void turn_numbers(double v[3], const turn *by)
{
    const double was[3] = {v[0], v[1], v[2]};
    for (int i = 0; i < 3; i++)
        v[i] = by->sign[i] < 0 ? -was[by->from[i]] : was[by->from[i]];
}

sure_vec3 vector_turned(sure_vec3 v, const turn *by)
{
    double x[3] = {v.x, v.y, v.z};
    turn_numbers(x, by);
    return (sure_vec3){x[0], x[1], x[2]};
}

/* Seen in a mirror the low corner is the high one. */
static void exchange_corners(double *low, double *high, const turn *by)
{
    for (int i = 0; i < 3; i++) {
        double was = low[i];
        low[i] = by->sign[i] < 0 ? high[i] : was;
        high[i] = by->sign[i] < 0 ? was : high[i];
    }
}

sure_case case_turned(const sure_case *c, const turn *by)
{
    const sure_shape_info *info = sure_shape_info_of(c->object.shape);
    sure_case turned = *c;
    double *object = case_number(&turned, AT_OBJECT);
    turn_numbers(case_number(&turned, AT_O), by);
    turn_numbers(case_number(&turned, AT_D), by);
    for (int i = 0; i < info->field_count; i++) {
        if (info->fields[i].kind != SURE_KIND_RADIUS)
            turn_numbers(object + info->fields[i].at, by);
        if (info->fields[i].kind == SURE_KIND_HIGH)
            exchange_corners(object, object + info->fields[i].at, by);
    }
    return turned;
}
