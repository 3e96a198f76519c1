/* SPDX-License-Identifier: MIT */
/* What the tests know of a shape besides its data: a row each, in shapes/<shape>.c. None of it uses
 * the library's arithmetic. */
#pragma once

#include "true_hit.h"

typedef struct {
    /* Of a surface that passes a point exactly, and of the other one of its parts: place and other
     * end from there and radius, in steps. */
    struct {
        sure_vec3 place, end;
        double radius;
    } through[2];

    /* Another object with the same surface about the hit, up to rounding. */
    sure_object (*companion)(const sure_ray *ray, const sure_object *object);

    /* The quadratic and the axis of true_hit.h, and how an interval is made of them. */
    true_frame (*frame)(const sure_object *object);
    bool (*in_object)(true_line *line);

    /* Its exact answers take thousands of digits where a case's numbers have all exponents. */
    bool long_numbers;
} test_shape;

#define DECLARE(shape, SHAPE) extern const test_shape test_shape_##shape;
SURE_EACH_SHAPE(DECLARE)
#undef DECLARE

const test_shape *test_shape_of(sure_shape shape);

/* Of a place, a normal, another end and a radius what the shape has fields for. */
sure_object object_made(sure_shape shape, sure_vec3 place, sure_vec3 normal, sure_vec3 end,
                        double radius);

/* A surface that passes p.x + half, p.y, p.z exactly, made of whole multiples of s; `cap`: of
 * its parts the other one. */
sure_object object_through(sure_shape shape, sure_vec3 p, double half, double s, bool cap);

/* Its line, valid until the next call. */
const char *case_text(const sure_case *c);

/* From the shape's data: has it a field of that kind? */
bool shape_has(sure_shape shape, sure_kind kind);

/* The first field's point. */
sure_vec3 object_place(const sure_object *object);

/* What decides the sides that spawn tells apart: a disc's are its plane's. */
sure_object object_sided(const sure_object *object);

/* |o - object| + its size, of SURE_T_ERROR_CAP. */
long double object_reach(sure_vec3 o, const sure_object *object);

/* a v + b w, in doubles. */
sure_vec3 vector_sum(double a, sure_vec3 v, double b, sure_vec3 w);
