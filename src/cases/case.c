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

/* What stands between single blanks. */
typedef struct {
    const char *start;
    size_t length;
} word;

enum { WORDS_MOST = 1 + CASE_NUMBERS_MAX };

/* The words of a line, an empty one where two blanks meet or one stands at its end: how many. 0 for
 * too many, or where the line's end is not the text's. */
static int split(const char *line, word words[WORDS_MOST])
{
    int count = 0;
    for (;; line++) {
        words[count].start = line;
        words[count].length = strcspn(line, " \r\n");
        line += words[count++].length;
        if (*line != ' ' || count == WORDS_MOST)
            break;
    }
    bool ended = strcmp(line, "") == 0 || strcmp(line, "\n") == 0 || strcmp(line, "\r\n") == 0;
    return ended ? count : 0;
}

static bool number(word of, double *value)
{
    char *end;
    if (of.length == 0 || isspace((unsigned char)*of.start)) /* strtod would step over a tab */
        return false;
    *value = strtod(of.start, &end);
    return end == of.start + of.length;
}

/* Index of the word among names 0, 1, ...; -1 for none of them. */
static int named(word of, const char *(*name_of)(int))
{
    const char *name;
    for (int i = 0; (name = name_of(i)) != NULL; i++) {
        if (strlen(name) == of.length && memcmp(name, of.start, of.length) == 0)
            return i;
    }
    return -1;
}

#define NAME_OF(what)                                                                              \
    static const char *what##_name(int i)                                                          \
    {                                                                                              \
        return sure_##what##_name((sure_##what)i);                                                 \
    }
NAME_OF(shape)
NAME_OF(status)
NAME_OF(part)
NAME_OF(field)

bool case_read(const char *line, sure_case *question)
{
    word words[WORDS_MOST];
    double numbers[CASE_NUMBERS_MAX] = {0};
    int count = split(line, words), shape = named(words[0], shape_name);
    if (shape < 0 || count != 1 + case_numbers((sure_shape)shape))
        return false;
    for (int i = 1; i < count; i++) {
        if (!number(words[i], &numbers[i - 1]))
            return false;
    }
    *question = case_from_numbers((sure_shape)shape, numbers);
    return true;
}

bool case_answer_read(const char *line, case_answer *answer)
{
    word words[WORDS_MOST];
    int count = split(line, words), status = named(words[0], status_name);
    case_answer read = {.status = (sure_status)status};
    if (status == SURE_HIT) {
        int part = count == 6 ? named(words[2], part_name) : -1;
        if (part < 0 || !number(words[1], &read.t) || !number(words[3], &read.normal.x) ||
            !number(words[4], &read.normal.y) || !number(words[5], &read.normal.z))
            return false;
        read.part = (sure_part)part;
    } else if (status == SURE_INVALID) {
        int field = count == 2 ? named(words[1], field_name) : -1;
        if (field <= SURE_FIELD_NONE)
            return false;
        read.field = (sure_field)field;
    } else if (status < 0 || count != 1) {
        return false;
    }
    *answer = read;
    return true;
}
