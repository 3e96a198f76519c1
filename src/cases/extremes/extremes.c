#include "extremes.h"

#include <stddef.h>

#include "extreme_layout.h"

/* Any fixed number: other members of the same families, none better than the rest. */
#define EXTREMES_SEED 1

static const extreme_family_list *families_of(sure_shape shape)
{
    switch (shape) {
    case SURE_SHAPE_PLANE:
        return &plane_extremes;
    case SURE_SHAPE_DISC:
        return &disc_extremes;
    case SURE_SHAPE_SPHERE:
        return &sphere_extremes;
    case SURE_SHAPE_CYLINDER:
        return &cylinder_extremes;
    case SURE_SHAPE_CONE:
        return &cone_extremes;
    }
    return NULL;
}

int extreme_families(sure_shape shape)
{
    return families_of(shape)->count;
}

const char *extreme_family_name(sure_shape shape, int family)
{
    return families_of(shape)->list[family].name;
}

const char *extreme_family_reason(sure_shape shape, int family)
{
    return families_of(shape)->list[family].reason;
}

extreme extreme_case(sure_shape shape, int family, uint64_t index)
{
    const extreme_family *made = &families_of(shape)->list[family];
    draws from = draws_of(EXTREMES_SEED, (uint64_t)shape, (uint64_t)family, index);
    extreme_layout it = made->lay(&from);
    if (made->change)
        made->change(&it, &from);
    return carry_into_world(shape, &it, &from);
}
