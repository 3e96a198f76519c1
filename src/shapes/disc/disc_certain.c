#include "disc_filter.h"

#include "disc_close.h"
#include "../../stages/ladder.h"
#include "../normal_quick.h"

static inline bool disc_quick_normal(const sure_ray *ray, const sure_disc *disc,
                                     const sure_hit *hit, sure_vec3 *normal)
{
    (void)ray;
    (void)hit;
    const sure_vec3 *n = &disc->normal;
    return quick_unit((quick_vector){n->x, n->y, n->z}, 1, normal);
}

#define SHAPE_HAS_CLOSE
#define SHAPE disc
#define SHAPE_NUMBER SURE_SHAPE_DISC
#include "../../stages/ladder_functions.h"
