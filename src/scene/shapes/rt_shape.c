/* SPDX-License-Identifier: MIT */
#include "rt_shape.h"

#include <float.h>

#define DECLARE(name, NAME) extern const rt_shape rt_##name;
#define ROW(name, NAME) [SURE_SHAPE_##NAME] = &rt_##name,
SURE_EACH_SHAPE(DECLARE)
const rt_shape *const rt_shapes[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};

const char *rt_wrong(sure_field field)
{
    switch (field) {
    case SURE_FIELD_NONE: return NULL;
    case SURE_FIELD_TOP:
    case SURE_FIELD_APEX:
        return "end points coincide once rounded; expected a height that can be told from 0 there";
    case SURE_FIELD_NORMAL: return "direction underflows to zero; expected a larger one";
    case SURE_FIELD_RADIUS: return "diameter is not a size; expected a finite one";
    default:
        return "lies out of range of the camera; expected coordinates whose differences are finite";
    }
}

/* An end point is the middle of a body of twice the height. */
const char *rt_ends(rt_position at, const rt_element *element, sure_vec3 axis, sure_vec3 *low,
                    sure_vec3 *high)
{
    sure_cylinder body;
    sure_vec3 position = element->position;
    double height = at == RT_POSITION_MIDDLE ? element->height : 2 * element->height;
    if (height > DBL_MAX)
        return rt_wrong(SURE_FIELD_CENTRE);
    sure_field bad = sure_cylinder_from_axis_textbook(position, axis, 0, height, &body);
    if (bad != SURE_FIELD_NONE)
        return rt_wrong(bad);
    *low = at == RT_POSITION_BASE ? position : body.base;
    *high = at == RT_POSITION_APEX ? position : body.top;
    bool same = low->x == high->x && low->y == high->y && low->z == high->z;
    return same ? rt_wrong(SURE_FIELD_TOP) : NULL;
}
