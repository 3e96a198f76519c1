/* SPDX-License-Identifier: MIT */
/* One question to an intersection function, and its numbers in the order of the case format. */
#pragma once

#include <stdbool.h>

#include <surehit/object.h>

#include "rng.h"

typedef struct {
    sure_ray ray;
    sure_object object;
    bool wall; /* of a cylinder or cone the infinite wall is meant (cylinder_wall.h, cone_wall.h) */
} sure_case;

/* Numbers of a case of that shape: eight of the ray, then the object's fields. */
enum { AT_O = 0, AT_D = 3, AT_T_MIN = 6, AT_T_MAX = 7, AT_OBJECT = 8, CASE_NUMBERS_MAX = 15 };
int case_numbers(sure_shape shape);

/* One of them. */
double *case_number(sure_case *question, int place);

/* The vector that begins there. */
sure_vec3 *case_vector(sure_case *question, int place);

void case_to_numbers(const sure_case *question, double numbers[CASE_NUMBERS_MAX]);
sure_case case_from_numbers(sure_shape shape, const double numbers[CASE_NUMBERS_MAX]);

/* The field of the object that the number is of, NULL for one of the ray. */
const sure_shape_field *field_at(sure_shape shape, int place);

/* What a number measures. */
typedef enum { IS_LENGTH, IS_STEP, IS_TIME, IS_NORMAL, NUMBER_KINDS } number_kind;
number_kind case_number_kind(sure_shape shape, int place);

/* Makes an object's numbers valid where they can be so by a sign or an exchange. */
void object_mend(sure_shape shape, double *object);

/* Every number rounded to the nearest float: what a routine in float can be asked. False if that
 * makes a valid case invalid: nothing was asked then. */
bool float_case(const sure_case *question, sure_case *rounded);

/* The double `steps` neighbours above x, counted by its bits: beyond an infinity is no number. */
double step_ulps(double x, int steps);

/* In another order, for times: a branch predictor learns even thousands of cases that come in the
 * same order, by one routine or by another. */
void shuffle_cases(sure_case *cases, int count, rng *g);

/* What a routine answers: t, part and normal on a hit, the field when invalid. */
typedef struct {
    sure_status status;
    sure_field field;
    double t;
    sure_part part;
    sure_vec3 normal;
    double t_leave; /* of an interval, whose first end is t then */
} case_answer;

/* The answer of a tier, normal included; of a wall by exact alone, without a normal. */
case_answer case_answer_of(const sure_case *question, sure_tier tier);

/* The same; where no normal is wanted, it is 0. */
case_answer case_hit_of(const sure_case *question, sure_tier tier, bool with_normal);

/* Has the shape a wall? Entry for its answer: the question is of one. */
bool case_has_wall(sure_shape shape);
case_answer case_wall_answer(const sure_case *question);

/* By exact: is there a hit for another ray, and does its range start in the closed body? Not of
 * what is invalid. */
bool case_is_hit(const sure_case *question, const sure_ray *ray);
bool case_starts_within(const sure_case *question, const sure_ray *ray);

/* Large enough for any line below, its end included. */
#define CASE_LINE_MAX 512

/* `<shape> ox oy oz dx dy dz t_min t_max <fields>`, numbers as hex_float.h has them. */
void case_print(const sure_case *question, char line[CASE_LINE_MAX]);

/* `miss`, `hit <t> <part> <nx> <ny> <nz>` or `invalid <field>`. */
void case_answer_print(const case_answer *answer, char line[CASE_LINE_MAX]);

/* Reads such lines; hexadecimal and decimal numbers, single blanks, nothing before or after (a line
 * end is allowed, and behind a case a remark: a blank, # and anything). Returns true, or false and
 * *question or *answer untouched. */
bool case_read(const char *line, sure_case *question);
bool case_answer_read(const char *line, case_answer *answer);
