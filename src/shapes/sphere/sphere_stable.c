/* SPDX-License-Identifier: MIT */
/* What the tier stable answers where the first stage of the sphere is uncertain: by the same D. */
#include "../stable.h"
#include "../../geometry/quadratic.h"
#include "../span.h"
#include "sphere_filter.h"

static span sphere_guess(const sure_ray *ray, const void *shape)
{
    const sure_sphere *sphere = shape;
    sphere_terms of = sphere_terms_of(ray, sphere);
    double c = difference_f64(NULL, sphere_body_f64(NULL, of.m, sphere->radius));
    double discriminant = of.discriminant, roots[2];
    if (!sphere_crosses(&of))
        discriminant = sphere_close_terms_of(&of, sphere->radius).discriminant;
    if (!(discriminant >= 0))
        return span_empty();
    quadratic_pair(of.a, of.b, c, sqrt(discriminant), roots);
    return span_of(roots[0], roots[1], SURE_PART_SURFACE);
}

STABLE_QUESTIONS(sphere)
