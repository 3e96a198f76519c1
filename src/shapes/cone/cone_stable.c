/* SPDX-License-Identifier: MIT */
/* What the tier stable answers where the first stage of the cone is uncertain: by the same D, with
 * a, b, c by the second form of cone_tmpl.h. A line along a generator, or what overflows, is left
 * to textbook's formula. Where a < 0 there are roots, whatever is computed. */
#include "../stable.h"
#include "cone_filter.h"
#include "cone_height.h"

/* [u, v] by its second form. */
static inline double cone_guess_form(const axial_terms *of, double r, vector_f64 u, vector_f64 v)
{
    double arms = vector_dot_f64(NULL, vector_cross_f64(NULL, of->axis, u),
                                 vector_cross_f64(NULL, of->axis, v));
    return difference_f64(
        NULL, cone_body_f64(NULL, of->height, r, arms,
                            vector_dot_f64(NULL, of->axis, u) * vector_dot_f64(NULL, of->axis, v)));
}

static span cone_guess(const sure_ray *ray, const void *shape)
{
    const sure_cone *cone = shape;
    cone_line line = cone_line_from(ray, shape);
    axial_terms of = cone_terms_of(ray, cone);
    double a = cone_guess_form(&of, cone->radius, of.d, of.d), roots[2];
    double b = cone_guess_form(&of, cone->radius, of.m, of.d);
    double c = cone_guess_form(&of, cone->radius, of.m, of.m);
    double discriminant = of.inner - of.outer;
    if (discriminant < 0 && a > 0)
        return span_empty();
    quadratic_pair(a, b, c, of.height * sqrt(discriminant < 0 ? 0 : discriminant), roots);
    bool finite = surely_finite(roots[0]) && surely_finite(roots[1]);
    span body = finite ? cone_height_kept(a, roots, line.n_d) : cone_height_nappe(&line);
    return span_within(body, cone_height_span(&line));
}

STABLE_QUESTIONS(cone)
