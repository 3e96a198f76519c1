/* SPDX-License-Identifier: MIT */
#include "bisection_result.h"

#include "suite.h"

static bool same_bits(double x, double y)
{
    return memcmp(&x, &y, sizeof x) == 0;
}

bool bisection_same_vector(sure_vec3 v, sure_vec3 w)
{
    return same_bits(v.x, w.x) && same_bits(v.y, w.y) && same_bits(v.z, w.z);
}

static bool same_interval(const sure_interval *x, const sure_interval *y)
{
    return same_bits(x->t_enter, y->t_enter) && same_bits(x->t_leave, y->t_leave) &&
           x->enter_part == y->enter_part && x->leave_part == y->leave_part;
}

bool bisection_same(const bisection_result *x, const bisection_result *y)
{
    return x->status == y->status && x->field == y->field && x->part == y->part &&
           same_bits(x->t, y->t) && bisection_same_vector(x->normal, y->normal) &&
           x->interval_status == y->interval_status && same_interval(&x->interval, &y->interval);
}

bisection_result bisection_of(const sure_case *question)
{
    bisection_result result;
    memset(&result, 0xff, sizeof result);
    sure_status status = bisection_answer(&question->ray, &question->object, &result);
    ck_assert_int_eq(status, result.status);
    return result;
}

enum { TEXT_MOST = 2 * CASE_LINE_MAX };

/* The answer line, then the chord. */
static void print(const bisection_result *result, char text[TEXT_MOST])
{
    case_answer said = {result->status, result->field, result->t, result->part, result->normal, 0};
    char line[CASE_LINE_MAX];
    case_answer_print(&said, line);
    snprintf(text, TEXT_MOST, "%s; chord %s %a %a %s %s", line,
             sure_status_name(result->interval_status), result->interval.t_enter,
             result->interval.t_leave, sure_part_name(result->interval.enter_part),
             sure_part_name(result->interval.leave_part));
}

void bisection_expect(const sure_case *question, const bisection_result *got,
                      const bisection_result *expected, const char *why)
{
    if (bisection_same(got, expected))
        return;
    char line[CASE_LINE_MAX], was[TEXT_MOST], should[TEXT_MOST];
    case_print(question, line);
    print(got, was);
    print(expected, should);
    ck_abort_msg("%s: %s\n  %s\n  expected %s", why, line, was, should);
}
