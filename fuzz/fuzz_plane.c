/* One ray and a plane: hit, interval, occluded and normal of every tier. */
#include "shape_target.h"

const char fuzz_name[] = "plane";

bool fuzz_target(const uint8_t *data, size_t size)
{
    return shape_target(SURE_SHAPE_PLANE, data, size);
}
