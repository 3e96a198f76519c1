#include "case.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A ray is its eight numbers in a row, and an object its fields'. */
enum { RAY_NUMBERS = 8 };
_Static_assert(sizeof(sure_ray) == RAY_NUMBERS * sizeof(double), "a ray has eight numbers");
_Static_assert(CASE_NUMBERS_MAX == RAY_NUMBERS + SURE_SHAPE_NUMBERS, "a ray and any object");

int case_numbers(sure_shape shape)
{
    return RAY_NUMBERS + sure_shape_info_of(shape)->numbers;
}

static size_t object_size(sure_shape shape)
{
    return sizeof(double) * (size_t)sure_shape_info_of(shape)->numbers;
}

void case_to_numbers(const sure_case *question, double numbers[CASE_NUMBERS_MAX])
{
    const sure_object *object = &question->object;
    memcpy(numbers, &question->ray, sizeof question->ray);
    memcpy(numbers + RAY_NUMBERS, &object->as, object_size(object->shape));
}

sure_case case_from_numbers(sure_shape shape, const double numbers[CASE_NUMBERS_MAX])
{
    sure_case question = {.object.shape = shape};
    memcpy(&question.ray, numbers, sizeof question.ray);
    memcpy(&question.object.as, numbers + RAY_NUMBERS, object_size(shape));
    return question;
}

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

void shuffle_cases(sure_case *cases, int count, rng *g)
{
    for (int i = count - 1; i > 0; i--) {
        int other = rng_integer(g, 0, i);
        sure_case moved = cases[i];
        cases[i] = cases[other];
        cases[other] = moved;
    }
}

case_answer case_answer_of(const sure_case *question, sure_tier tier)
{
    case_answer answer = {0};
    sure_hit hit;
    answer.status = sure_object_hit(&question->ray, &question->object, tier, &hit);
    if (answer.status == SURE_INVALID)
        answer.field = sure_object_check(&question->ray, &question->object);
    if (answer.status == SURE_HIT) {
        answer.t = hit.t;
        answer.part = hit.part;
        answer.normal = sure_object_normal(&question->ray, &question->object, tier, &hit);
    }
    return answer;
}

void case_print(const sure_case *question, char line[CASE_LINE_MAX])
{
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(question, numbers);
    int used = snprintf(line, CASE_LINE_MAX, "%s", sure_shape_name(question->object.shape));
    for (int i = 0; i < case_numbers(question->object.shape); i++)
        used += snprintf(line + used, CASE_LINE_MAX - (size_t)used, " %a", numbers[i]);
}

void case_answer_print(const case_answer *answer, char line[CASE_LINE_MAX])
{
    const char *status = sure_status_name(answer->status);
    if (answer->status == SURE_HIT)
        snprintf(line, CASE_LINE_MAX, "%s %a %s %a %a %a", status, answer->t,
                 sure_part_name(answer->part), answer->normal.x, answer->normal.y,
                 answer->normal.z);
    else if (answer->status == SURE_INVALID)
        snprintf(line, CASE_LINE_MAX, "%s %s", status, sure_field_name(answer->field));
    else
        snprintf(line, CASE_LINE_MAX, "%s", status);
}

/* Takes the word that starts at *at, ended by a blank or the line's end, and steps behind it and
 * one blank. Its length; 0 for none. */
static size_t word(const char **at, const char **start)
{
    *start = *at;
    size_t length = strcspn(*at, " \r\n");
    *at += length;
    if (length > 0 && **at == ' ')
        *at += 1;
    return length;
}

static bool ended(const char *at)
{
    return strcmp(at, "") == 0 || strcmp(at, "\n") == 0 || strcmp(at, "\r\n") == 0;
}

static bool number(const char **at, double *value)
{
    const char *start;
    char *end;
    size_t length = word(at, &start);
    if (length == 0 || isspace((unsigned char)*start)) /* strtod would step over a tab */
        return false;
    *value = strtod(start, &end);
    return end == start + length;
}

/* A trailing blank is no end: `word` would have stepped over it. */
static bool ended_after_word(const char *line, const char *at)
{
    return ended(at) && at > line && at[-1] != ' ';
}

bool case_read(const char *line, sure_case *question)
{
    const char *at = line, *start;
    char name[16] = "";
    sure_shape shape;
    double numbers[CASE_NUMBERS_MAX] = {0};
    size_t length = word(&at, &start);
    if (length >= sizeof name)
        return false;
    memcpy(name, start, length);
    if (!sure_shape_from_name(name, &shape))
        return false;
    for (int i = 0; i < case_numbers(shape); i++) {
        if (!number(&at, &numbers[i]))
            return false;
    }
    if (!ended_after_word(line, at))
        return false;
    *question = case_from_numbers(shape, numbers);
    return true;
}

/* Index of the word among names 0, 1, ...; -1 for none of them. */
static int named(const char **at, const char *(*name_of)(int))
{
    const char *start, *name;
    size_t length = word(at, &start);
    for (int i = 0; (name = name_of(i)) != NULL; i++) {
        if (strlen(name) == length && memcmp(name, start, length) == 0)
            return i;
    }
    return -1;
}

#define NAME_OF(what)                                                                              \
    static const char *what##_name(int i)                                                          \
    {                                                                                              \
        return sure_##what##_name((sure_##what)i);                                                 \
    }
NAME_OF(status)
NAME_OF(part)
NAME_OF(field)

bool case_answer_read(const char *line, case_answer *answer)
{
    const char *at = line;
    case_answer read = {0};
    int member = named(&at, status_name);
    if (member < 0)
        return false;
    read.status = (sure_status)member;
    if (read.status == SURE_HIT) {
        if (!number(&at, &read.t) || (member = named(&at, part_name)) < 0 ||
            !number(&at, &read.normal.x) || !number(&at, &read.normal.y) ||
            !number(&at, &read.normal.z))
            return false;
        read.part = (sure_part)member;
    } else if (read.status == SURE_INVALID) {
        if ((member = named(&at, field_name)) <= SURE_FIELD_NONE)
            return false;
        read.field = (sure_field)member;
    }
    if (!ended_after_word(line, at))
        return false;
    *answer = read;
    return true;
}
