/* How a shape stands in a scene: a row a shape, src/scene/shapes/<shape>.c. */
#ifndef SCENE_RT_SHAPE_H
#define SCENE_RT_SHAPE_H

#include "../rt_notes.h"

#include <math.h>
#include <stddef.h>

typedef enum { RT_POINT, RT_DIRECTION, RT_NUMBER } rt_kind;

typedef struct {
    rt_kind kind;
    size_t at; /* so many bytes of an rt_element stand before its value */
    rt_field field;
} rt_shape_field;

typedef struct {
    const char *words[5];     /* that its line may start with, the usual one first; or none */
    rt_shape_field fields[5]; /* that follow, up to one without a name */

    /* What the camera sees of an element whose points and directions are the camera's. NULL, or
     * what is wrong. */
    const char *(*place)(const rt_element *element, const rt_options *options, sure_object *object);
} rt_shape;

#define RT_POSITION                                                                                \
    {                                                                                              \
        RT_POINT, offsetof(rt_element, position),                                                  \
        {                                                                                          \
            .name = "position", .expected = "x,y,z"                                                \
        }                                                                                          \
    }
#define RT_DIRECTION_AS(what)                                                                      \
    {                                                                                              \
        RT_DIRECTION, offsetof(rt_element, axis),                                                  \
        {                                                                                          \
            .name = what, .expected = "x,y,z, not all zero"                                        \
        }                                                                                          \
    }
#define RT_SIZE_AS(what)                                                                           \
    {                                                                                              \
        RT_NUMBER, offsetof(rt_element, what),                                                     \
        {                                                                                          \
#what, "a number above 0", 0, INFINITY, true                                           \
        }                                                                                          \
    }

/* Entry: shape is a member. */
const rt_shape *rt_shape_of(sure_shape shape);

/* The field's value: a vector, or a number. */
static inline void *rt_value(const rt_element *element, const rt_shape_field *field)
{
    return (char *)element + field->at;
}

/* What is wrong with that field of an object, in words; NULL for SURE_FIELD_NONE. */
const char *rt_wrong(sure_field field);

/* Both end points of a body whose `position` is one of them or the middle; `axis` points from low
 * to high. NULL, or what is wrong. */
const char *rt_ends(rt_position at, const rt_element *element, sure_vec3 axis, sure_vec3 *low,
                    sure_vec3 *high);

#endif
