#include "plane_filter.h"

#include "../../stages/ladder.h"
#include "../normal_quick.h"
#include "plane_close.h"

static inline bool plane_quick_normal(const sure_ray *ray, const sure_plane *plane,
                                      const sure_hit *hit, sure_vec3 *normal)
{
    (void)ray;
    (void)hit;
    const sure_vec3 *n = &plane->normal;
    return quick_unit((quick_vector){n->x, n->y, n->z}, 1, normal);
}

#define SHAPE_HAS_CLOSE
#define SHAPE plane
#define SHAPE_NUMBER SURE_SHAPE_PLANE
#include "../../stages/ladder_functions.h"
