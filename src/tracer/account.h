/* Counting for sure_account. Who does not ask passes NULL and pays a comparison. */
#ifndef TRACER_ACCOUNT_H
#define TRACER_ACCOUNT_H

#include <surehit/account.h>

/* What is drawn and how. */
typedef struct {
    const sure_scene *scene;
    sure_tier tier;
    sure_account *account; /* or NULL */
} tracing;

/* A ray that has met scene->objects[object], or none. */
void account_ray(const tracing *t, sure_ray_kind kind, const sure_ray *ray,
                 const sure_surface_point *leaving, sure_status met, size_t object);

void account_pixel(const tracing *t, const sure_ray *ray, sure_status seen,
                   const sure_nearest *nearest);

/* A start for further rays next to a hit of the ray, or (NULL) none. */
void account_origin(const tracing *t, const sure_ray *ray, const sure_nearest *hit,
                    const sure_vec3 *origin);

#endif
