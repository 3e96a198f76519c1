/* SPDX-License-Identifier: MIT */
/* sphere_filter for several queries (lanes/lanes.h), but for what it looks at closely. */
#include "../lanes/answer.h"
#include "sphere_filter.h"

static inline lanes_answer sphere_lanes(const sure_ray *ray, const sure_sphere *sphere)
{
    sphere_terms of = sphere_terms_of(ray, sphere);
    bool fits = sphere_fits(sphere, &of);
    double root = sqrt(of.discriminant), error = sphere_error(&of, root);
    filter_interval found;
    (void)sphere_found(&of, root, error, &found);
    const uint64_t part = {SURE_PART_SURFACE};
    lanes_end enter = {found.enter.t, error, part}, leave = {found.leave.t, error, part};
    return lanes_first(fits & sphere_crosses(&of), fits & sphere_misses(&of), &enter, &leave, ray);
}

enum { sphere_tells_misses = 1 };

/* Who certainly misses. */
static inline bool sphere_lanes_miss(const sure_ray *ray, const sure_sphere *sphere)
{
    sphere_terms of = sphere_terms_of(ray, sphere);
    return sphere_fits(sphere, &of) & sphere_misses(&of) & filter_range(ray);
}
