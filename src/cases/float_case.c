#include "float_case.h"

static bool is_valid(const sure_case *question)
{
    return sure_object_check(&question->ray, &question->object) == SURE_FIELD_NONE;
}

bool float_case(const sure_case *question, sure_case *rounded)
{
    double numbers[CASE_NUMBERS_MAX];
    volatile float kept; /* GCC 12 drops the rounding of neighbouring conversions otherwise */
    case_to_numbers(question, numbers);
    for (int i = 0; i < case_numbers(question->object.shape); i++) {
        kept = (float)numbers[i];
        numbers[i] = kept;
    }
    *rounded = case_from_numbers(question->object.shape, numbers);
    return is_valid(rounded) || !is_valid(question);
}
