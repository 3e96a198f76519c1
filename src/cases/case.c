/* SPDX-License-Identifier: MIT */
#include "case.h"
#include "../geometry/coordinate.h"

#include "../numbers/digits/hex_float.h"
#include "../numbers/places.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A ray is its eight numbers in a row, and an object its fields'. */
_Static_assert(sizeof(sure_ray) == AT_OBJECT * sizeof(double), "a ray has eight numbers");
_Static_assert((int)CASE_NUMBERS_MAX == AT_OBJECT + SURE_SHAPE_NUMBERS, "a ray and any object");

int case_numbers(sure_shape shape)
{
    return AT_OBJECT + sure_shape_info_of(shape)->numbers;
}

double *case_number(sure_case *question, int place)
{
    return place < AT_OBJECT ? (double *)(void *)&question->ray + place
                             : (double *)(void *)&question->object.as + (place - AT_OBJECT);
}

sure_vec3 *case_vector(sure_case *question, int place)
{
    return (sure_vec3 *)(void *)case_number(question, place);
}

const sure_shape_field *field_at(sure_shape shape, int place)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    const sure_shape_field *found = NULL;
    for (int i = 0; i < info->field_count && info->fields[i].at <= place - AT_OBJECT; i++)
        found = &info->fields[i];
    return found;
}

number_kind case_number_kind(sure_shape shape, int place)
{
    if (place >= AT_OBJECT)
        return field_at(shape, place)->kind == SURE_KIND_NORMAL ? IS_NORMAL : IS_LENGTH;
    return place < AT_D ? IS_LENGTH : place < AT_T_MIN ? IS_STEP : IS_TIME;
}

void object_mend(sure_shape shape, double *object)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    for (int i = 0; i < info->field_count; i++) {
        double *at = object + info->fields[i].at;
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            *at = fabs(*at);
        for (int k = 0; k < 3 && info->fields[i].kind == SURE_KIND_HIGH; k++) {
            double low = object[k], high = at[k];
            object[k] = low > high ? high : low;
            at[k] = low > high ? low : high;
        }
    }
}

void case_to_numbers(const sure_case *question, double numbers[CASE_NUMBERS_MAX])
{
    const size_t object = (size_t)(case_numbers(question->object.shape) - AT_OBJECT);
    memcpy(numbers, &question->ray, sizeof question->ray);
    memcpy(numbers + AT_OBJECT, &question->object.as, object * sizeof *numbers);
}

sure_case case_from_numbers(sure_shape shape, const double numbers[CASE_NUMBERS_MAX])
{
    sure_case question = {.object.shape = shape};
    const size_t object = (size_t)(case_numbers(shape) - AT_OBJECT);
    memcpy(&question.ray, numbers, sizeof question.ray);
    memcpy(&question.object.as, numbers + AT_OBJECT, object * sizeof *numbers);
    return question;
}

static bool is_valid(const sure_case *question)
{
    return sure_object_check(&question->ray, &question->object) == SURE_FIELD_NONE;
}

bool float_case(const sure_case *question, sure_case *rounded)
{
    volatile float kept; /* GCC 12 drops the rounding of neighbouring conversions otherwise */
    *rounded = *question;
    for (int i = 0; i < case_numbers(question->object.shape); i++) {
        kept = (float)*case_number(rounded, i);
        *case_number(rounded, i) = kept;
    }
    return is_valid(rounded) || !is_valid(question);
}

double step_ulps(double x, int steps)
{
    return at_place(place_of(x) + steps);
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

case_answer case_hit_of(const sure_case *question, sure_tier tier, bool with_normal)
{
    case_answer answer = {0};
    sure_hit hit;
    if (question->wall)
        return case_wall_answer(question);
    answer.status = sure_object_hit(&question->ray, &question->object, tier, &hit);
    if (answer.status == SURE_INVALID)
        answer.field = sure_object_check(&question->ray, &question->object);
    if (answer.status == SURE_HIT) {
        answer.t = hit.t;
        answer.part = hit.part;
    }
    if (answer.status == SURE_HIT && with_normal)
        answer.normal = sure_object_normal(&question->ray, &question->object, tier, &hit);
    return answer;
}

case_answer case_answer_of(const sure_case *question, sure_tier tier)
{
    return case_hit_of(question, tier, true);
}

void case_print(const sure_case *question, char line[CASE_LINE_MAX])
{
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(question, numbers);
    int used = snprintf(line, CASE_LINE_MAX, "%s", sure_shape_name(question->object.shape));
    for (int i = 0; i < case_numbers(question->object.shape); i++)
        used += snprintf(line + used, CASE_LINE_MAX - (size_t)used, " %s", HEX(numbers[i]));
}

void case_answer_print(const case_answer *answer, char line[CASE_LINE_MAX])
{
    const char *status = sure_status_name(answer->status);
    if (answer->status == SURE_HIT)
        snprintf(line, CASE_LINE_MAX, "%s %s %s %s %s %s", status, HEX(answer->t),
                 sure_part_name(answer->part), HEX(answer->normal.x), HEX(answer->normal.y),
                 HEX(answer->normal.z));
    else if (answer->status == SURE_INVALID)
        snprintf(line, CASE_LINE_MAX, "%s %s", status, sure_field_name(answer->field));
    else
        snprintf(line, CASE_LINE_MAX, "%s", status);
}

/* A line is read from left to right: each of these takes where it stands, NULL where all is wrong
 * already, and gives where it goes on, or NULL. */

static const char *blank(const char *at)
{
    return at && *at == ' ' ? at + 1 : NULL;
}

static const char *number(const char *at, double *value)
{
    char *end;
    if (!at || isspace((unsigned char)*at)) /* strtod would step over a tab */
        return NULL;
    *value = strtod(at, &end);
    return end == at ? NULL : end;
}

/* *found: the name's index among names 0, 1, ... */
static const char *named(const char *at, const char *(*name_of)(int), int *found)
{
    const char *name;
    size_t length = at ? strcspn(at, " \r\n") : 0;
    for (int i = 0; at && (name = name_of(i)) != NULL; i++) {
        if (strlen(name) == length && memcmp(name, at, length) == 0) {
            *found = i;
            return at + length;
        }
    }
    return NULL;
}

static bool ends(const char *at)
{
    return at && (strcmp(at, "") == 0 || strcmp(at, "\n") == 0 || strcmp(at, "\r\n") == 0);
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

/* A remark may follow. */
static bool ends_case(const char *at)
{
    return ends(at) || (at && strncmp(at, " #", 2) == 0);
}

bool case_read(const char *line, sure_case *question)
{
    sure_case read = {.ray.t_min = 0};
    int shape = 0;
    const char *at = named(line, shape_name, &shape);
    read.object.shape = (sure_shape)shape;
    for (int i = 0; at && i < case_numbers(read.object.shape); i++)
        at = number(blank(at), case_number(&read, i));
    if (!ends_case(at))
        return false;
    *question = read;
    return true;
}

bool case_answer_read(const char *line, case_answer *answer)
{
    case_answer read = {.t = 0};
    int status = 0, part = 0, field = SURE_FIELD_NONE;
    const char *at = named(line, status_name, &status);
    if (at && status == SURE_HIT) {
        at = named(blank(number(blank(at), &read.t)), part_name, &part);
        for (int i = 0; i < 3; i++)
            at = number(blank(at), coordinate_of(&read.normal, i));
    } else if (at && status == SURE_INVALID) {
        at = named(blank(at), field_name, &field);
        at = field == SURE_FIELD_NONE ? NULL : at;
    }
    if (!ends(at))
        return false;
    read.status = (sure_status)status;
    read.part = (sure_part)part;
    read.field = (sure_field)field;
    *answer = read;
    return true;
}
