/* SPDX-License-Identifier: MIT */
/* sphere_filter for several queries (lanes/lanes.h). */
#include "../lanes/answer.h"
#include "sphere_filter.h"

/* What takes long: the root and the division. */
typedef struct {
    sphere_terms of;
    double root, minus_per_a;
    bool crosses, misses;
} sphere_begun;

static inline sphere_begun sphere_begin(const sure_ray *ray, const sure_sphere *sphere)
{
    sphere_terms of = sphere_terms_of(ray, sphere);
    bool fits = sphere_fits(sphere, &of);
    return (sphere_begun){of, sqrt(of.discriminant), -1 / of.a, fits & sphere_crosses(&of),
                          fits & sphere_misses(&of)};
}

static inline lanes_answer sphere_end(const sure_ray *ray, const sphere_begun *begun)
{
    const double error = sphere_error(&begun->of, begun->root);
    filter_interval found = sphere_ends(&begun->of, begun->root, begun->minus_per_a, error);
    const uint64_t part = {SURE_PART_SURFACE};
    lanes_end enter = {found.enter.t, error, part}, leave = {found.leave.t, error, part};
    return lanes_first(begun->crosses, begun->misses, &enter, &leave, ray);
}

/* Where the first look is uncertain: sphere_filter_closely. */
static inline lanes_answer sphere_lanes_closely(const sure_ray *ray, const sure_sphere *sphere)
{
    sphere_terms of = sphere_terms_of(ray, sphere);
    sphere_close_terms close = sphere_close_terms_of(&of, sphere->radius);
    double off = sphere_close_off(&close), root = sqrt(close.discriminant);
    double error = sphere_close_error(&of, &close, off, root);
    filter_interval found = sphere_ends(&of, root, -1 / of.a, error);
    bool open = sphere_fits(sphere, &of) & ~(sphere_crosses(&of) | sphere_misses(&of));
    const uint64_t part = {SURE_PART_SURFACE};
    lanes_end enter = {found.enter.t, error, part}, leave = {found.leave.t, error, part};
    return lanes_first(open & (close.discriminant > off), open & (-close.discriminant > off),
                       &enter, &leave, ray);
}

enum { sphere_ends_later = 1, sphere_looks_closely = 1 };
enum { sphere_tells_misses = 1 };

/* Who certainly misses. */
static inline bool sphere_lanes_miss(const sure_ray *ray, const sure_sphere *sphere)
{
    sphere_terms of = sphere_terms_of(ray, sphere);
    return sphere_fits(sphere, &of) & sphere_misses(&of) & filter_range(ray);
}
