/* SPDX-License-Identifier: MIT */
/* What the tier stable answers where the first stage of the cylinder is uncertain: by the same D.
 * With X and F of cylinder_tmpl.h, Y = A x m:
 *
 *     a = X.X,  b = X.Y,  c = F(m)
 *
 * A line along the axis, or what overflows, is left to textbook's formula. */
#include "../stable.h"
#include "cylinder_filter.h"
#include "cylinder_height.h"

static span cylinder_guess(const sure_ray *ray, const void *shape)
{
    const sure_cylinder *cylinder = shape;
    cylinder_line line = cylinder_line_from(ray, shape);
    axial_terms of = cylinder_terms_of(ray, cylinder);
    vector_f64 x = vector_cross_f64(NULL, of.axis, of.d), y = vector_cross_f64(NULL, of.axis, of.m);
    double c = difference_f64(
        NULL, cylinder_body_f64(NULL, vector_square_f64(NULL, y), of.height, cylinder->radius));
    double discriminant = of.inner - of.outer, roots[2];
    if (discriminant < 0)
        return span_empty();
    quadratic_pair(of.a, vector_dot_f64(NULL, x, y), c, sqrt(of.height * discriminant), roots);
    bool finite = surely_finite(roots[0]) && surely_finite(roots[1]);
    span body = finite ? span_of(roots[0], roots[1], SURE_PART_WALL) : cylinder_wall_span(&line);
    return span_within(body, cylinder_height_span(&line));
}

STABLE_QUESTIONS(cylinder)
