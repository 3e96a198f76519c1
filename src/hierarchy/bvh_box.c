/* SPDX-License-Identifier: MIT */
#include <surehit/bvh.h>

int sure_bvh_box(const sure_object *object, sure_bounds *box)
{
    sure_vec3 low, high;
    if (!sure_shape_info_of(object->shape)->bounded)
        return 0;
    sure_object_bounds(object, &low, &high);
    *box = (sure_bounds){{low.x, low.y, low.z}, {high.x, high.y, high.z}};
    return 1;
}
