#include "moved_case.h"

#include <math.h>

enum { ORIGIN = 0, DIRECTION = 3, T_MIN = 6, OBJECT = 8 };

number_kind case_number_kind(sure_shape shape, int place)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    for (int i = 0; i < info->field_count; i++) {
        int at = place - OBJECT - info->fields[i].at;
        if (info->fields[i].kind == SURE_KIND_NORMAL && at >= 0 && at < 3)
            return IS_NORMAL;
    }
    return place < DIRECTION || place >= OBJECT ? IS_LENGTH : place < T_MIN ? IS_STEP : IS_TIME;
}

bool case_scaled(const sure_case *c, const int powers[NUMBER_KINDS], sure_case *scaled)
{
    double numbers[CASE_NUMBERS_MAX];
    bool exact = true;
    case_to_numbers(c, numbers);
    for (int i = 0; i < case_numbers(c->object.shape); i++) {
        int power = powers[case_number_kind(c->object.shape, i)];
        double x = ldexp(numbers[i], power);
        exact = exact && (ldexp(x, -power) == numbers[i] || isnan(x));
        numbers[i] = x;
    }
    *scaled = case_from_numbers(c->object.shape, numbers);
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
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(c, numbers);
    turn_numbers(numbers + ORIGIN, by);
    turn_numbers(numbers + DIRECTION, by);
    for (int i = 0; i < info->field_count; i++) {
        if (info->fields[i].kind != SURE_KIND_RADIUS)
            turn_numbers(numbers + OBJECT + info->fields[i].at, by);
        if (info->fields[i].kind == SURE_KIND_HIGH)
            exchange_corners(numbers + OBJECT, numbers + OBJECT + info->fields[i].at, by);
    }
    return case_from_numbers(c->object.shape, numbers);
}
