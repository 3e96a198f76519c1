/* Normals of `certain` and `exact`. */
#ifndef STAGES_NORMAL_H
#define STAGES_NORMAL_H

#include "normal_quick.h"
#include "surface.h"

/* The normal at a hit, beyond a shape's own first stage. Entry: a hit by certain or exact. */
sure_vec3 stages_normal(const shape_row *row, const sure_ray *ray, const void *shape,
                        const sure_hit *hit, t_wanted wanted);

/* <shape>_quick_normal: in doubles, from the hit's t, where that is good enough. */
#define SURFACE_NORMALS(shape)                                                                     \
    sure_vec3 sure_##shape##_normal_certain(const sure_ray *ray, const sure_##shape *s,            \
                                            const sure_hit *hit)                                   \
    {                                                                                              \
        sure_vec3 normal;                                                                          \
        if (shape##_quick_normal(ray, s, hit, &normal))                                            \
            return normal;                                                                         \
        return stages_normal(&shape##_row, ray, s, hit, T_CERTAIN);                                \
    }                                                                                              \
    sure_vec3 sure_##shape##_normal_exact(const sure_ray *ray, const sure_##shape *s,              \
                                          const sure_hit *hit)                                     \
    {                                                                                              \
        return stages_normal(&shape##_row, ray, s, hit, T_EXACT);                                  \
    }                                                                                              \
    sure_vec3 sure_##shape##_normal_stable(const sure_ray *ray, const sure_##shape *s,             \
                                           const sure_hit *hit)                                    \
    {                                                                                              \
        sure_vec3 normal;                                                                          \
        if (shape##_quick_normal(ray, s, hit, &normal))                                            \
            return normal;                                                                         \
        return sure_##shape##_normal_textbook(ray, s, hit);                                        \
    }

#endif
