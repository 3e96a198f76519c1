#include "reference_answer.h"

#include <math.h>

#include "case_file.h"
#include "every_case.h"
#include "reference.h"

case_answer reference_answer_of(const sure_case *question)
{
    case_answer answer = {0};
    answer.status =
        reference_hit(&question->ray, &question->object, &answer.t, &answer.part, &answer.normal);
    if (answer.status == SURE_INVALID)
        answer.field = reference_check(&question->ray, &question->object);
    return answer;
}

sure_case case_of(const char *line)
{
    sure_case question;
    ck_assert_msg(case_read(line, &question), "not a case: %s", line);
    return question;
}

bool same_number(double value, double expected)
{
    return value == expected && !(value == 0 && signbit(value));
}

bool same_answer(const case_answer *answer, const case_answer *expected)
{
    return case_answers_same(answer, expected) && same_number(answer->t, expected->t) &&
           same_number(answer->normal.x, expected->normal.x) &&
           same_number(answer->normal.y, expected->normal.y) &&
           same_number(answer->normal.z, expected->normal.z);
}

void expect_answer(const sure_case *question, const case_answer *expected, const char *why)
{
    char is[CASE_LINE_MAX], ought[CASE_LINE_MAX];
    case_answer answer = reference_answer_of(question);
    case_answer_print(&answer, is);
    case_answer_print(expected, ought);
    ck_assert_msg(same_answer(&answer, expected), "%s: %s -> %s, expected %s", why,
                  case_text(question), is, ought);
    ck_assert_int_eq(reference_occluded(&question->ray, &question->object), answer.status);
}
