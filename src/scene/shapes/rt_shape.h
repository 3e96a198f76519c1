/* SPDX-License-Identifier: MIT */
/* How a shape stands in a scene: a row a shape, src/scene/shapes/<shape>.c. */
#pragma once

#include "../rt_notes.h"

#include <math.h>
#include <stddef.h>

typedef enum { RT_POINT, RT_DIRECTION, RT_COLOR, RT_NUMBER, RT_WHOLE } rt_kind;

/* A field of a line: where its value goes, what it is called and which numbers it takes. */
typedef struct {
    rt_kind kind;
    size_t at; /* so many bytes of what the line describes stand before its value */
    const char *name, *expected;
    double low, high;
    bool open; /* low and high themselves are refused */

    /* In dialect 42: what a direction of zeros is taken for; so far inside low and high is taken
     * what is one of them, 0: it is refused. */
    sure_vec3 usual;
    double inside;
} rt_field;

/* A line of dialect 42 that describes the shape in another way. */
typedef struct {
    const char *words[5]; /* that it may start with; none: the end of a list */
    rt_field fields[4];   /* as of an rt_shape */
    const char *guess;    /* a warning */

    /* Makes the shape's own fields of them, or says why not; NULL: they are the same. */
    const char *(*take)(rt_element *element);
} rt_form;

typedef struct {
    const char *words[5]; /* that its line may start with, the usual one first; or none */
    rt_field fields[5];   /* that follow, up to one without a name */
    rt_form forms[4];     /* up to one without words */

    /* The object that the element describes. NULL, or what is wrong. */
    const char *(*place)(const rt_element *element, const rt_options *options, sure_object *object);
} rt_shape;

/* clang-format off */
#define RT_FIELD(what, of, member, ...) \
    {.kind = RT_##what, .at = offsetof(of, member), __VA_ARGS__}
/* clang-format on */
#define RT_AT(what, member, ...) RT_FIELD(what, rt_element, member, __VA_ARGS__)
#define RT_POSITION RT_AT(POINT, position, "position", "x,y,z")
#define RT_TOWARDS(what) RT_AT(DIRECTION, axis, what, "x,y,z, not all zero", .usual = {0, 1, 0})
#define RT_SIZE_OF(member) RT_AT(NUMBER, member, #member, "a number above 0", 0, INFINITY, true)

extern const rt_shape *const rt_shapes[SURE_SHAPES];

/* The field's value: a vector, or a number. */
static inline void *rt_value(const rt_element *element, const rt_field *field)
{
    return (char *)element + field->at;
}

/* What is wrong with that field of an object, in words; NULL for SURE_FIELD_NONE. */
const char *rt_wrong(sure_field field);

/* Both end points of a body whose `position` is one of them or the middle; `axis` points from low
 * to high. NULL, or what is wrong. */
const char *rt_ends(rt_position at, const rt_element *element, sure_vec3 axis, sure_vec3 *low,
                    sure_vec3 *high);
