/* One ray and a disc: hit, interval, occluded and normal of every tier. */
#include "shape_target.h"

const char fuzz_name[] = "disc";

bool fuzz_target(const uint8_t *data, size_t size)
{
    return shape_target(SURE_SHAPE_DISC, data, size);
}
