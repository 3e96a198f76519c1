/* One ray and a sphere: hit, interval, occluded and normal of every tier. */
#include "shape_target.h"

const char fuzz_name[] = "sphere";

bool fuzz_target(const uint8_t *data, size_t size)
{
    return shape_target(SURE_SHAPE_SPHERE, data, size);
}
