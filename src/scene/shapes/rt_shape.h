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
    const rt_options *options;
    const sure_mat3 *turn; /* the camera's: what must lie along the axes looks at it */
} rt_placing;

typedef struct {
    const char *words[5];     /* that its line may start with, the usual one first; or none */
    rt_shape_field fields[5]; /* that follow, up to one without a name */

    /* What the camera sees of an element whose points and directions are the camera's. NULL, or
     * what is wrong. */
    const char *(*place)(const rt_element *element, const rt_placing *how, sure_object *object);
} rt_shape;

/* A field of a row: its kind, its place in an element, and what errors say of it. */
#define RT_FIELD(kind, member, ...)                                                                \
    {                                                                                              \
        RT_##kind, offsetof(rt_element, member),                                                   \
        {                                                                                          \
            __VA_ARGS__                                                                            \
        }                                                                                          \
    }
#define RT_NAMED(what, numbers) .name = what, .expected = numbers
#define RT_POSITION RT_FIELD(POINT, position, RT_NAMED("position", "x,y,z"))
#define RT_TOWARDS(what) RT_FIELD(DIRECTION, axis, RT_NAMED(what, "x,y,z, not all zero"))
#define RT_SIZE_OF(member) RT_FIELD(NUMBER, member, #member, "a number above 0", 0, INFINITY, true)

extern const rt_shape *const rt_shapes[SURE_SHAPES];

/* Entry: shape is a member. */
static inline const rt_shape *rt_shape_of(sure_shape shape)
{
    return rt_shapes[shape];
}

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
