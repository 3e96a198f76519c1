/* SPDX-License-Identifier: MIT */
/* The first stage of the cylinder; docs/proofs/cylinder_filter.md proves it. With A = top - base, m
 * = o - base, H = A.A, X = A x d:
 *
 *     a = X.X,  b = H m.d - (A.m)(A.d),  D = r^2 a - (X.m)^2
 *     wall   t = (-b -+ sqrt(H D)) / a
 *     planes t = -A.m / A.d and (H - A.m) / A.d
 *
 * As the line is seen along the axis, r^2 a and (X.m)^2 are radius and distance. */
#pragma once

#include "../capped/axial_filter.h"

#define NUMBER f64
#include "cylinder_tmpl.h"

#define CYLINDER_CERTAIN (SURE_CYLINDER_DISCRIMINANT_BOUND * SURE_CYLINDER_DISCRIMINANT_BOUND)
#define CYLINDER_WALL (SURE_CYLINDER_WALL_BOUND * SURE_CYLINDER_WALL_BOUND)

static INLINED axial_terms cylinder_terms_of(const sure_ray *ray, const sure_cylinder *cylinder)
{
    axial_terms of = {.axis = vector_between_f64(NULL, cylinder->base, cylinder->top),
                      .m = vector_between_f64(NULL, cylinder->base, ray->origin),
                      .d = vector_of_f64(NULL, ray->direction)};
    vector_f64 across = vector_cross_f64(NULL, of.axis, of.d);
    double rr = cylinder->radius * cylinder->radius;
    double reach = vector_dot_f64(NULL, of.m, of.m) + rr;
    of.height = vector_dot_f64(NULL, of.axis, of.axis);
    of.d_d = vector_dot_f64(NULL, of.d, of.d);
    of.size = reach + of.height;
    of.a = vector_dot_f64(NULL, across, across);
    two_terms_f64 terms = cylinder_discriminant_f64(NULL, of.a, across, of.m, cylinder->radius);
    of.inner = terms.more;
    of.outer = terms.less;
    of.measure = of.height * of.d_d * reach;
    of.certain = CYLINDER_CERTAIN * (of.inner + of.outer) * of.measure + AXIAL_FLOOR;
    return of;
}

/* Where the line is in the wall's body and between the planes. root, per_a: sqrt(H D), 1 / a;
 * inner: what D is a share of, for its error. */
typedef struct {
    axial_line line;
    double root, per_a;
} cylinder_ends;

static inline cylinder_ends cylinder_ends_of(const axial_terms *terms, double discriminant,
                                             double inner)
{
    double e = vector_dot_f64(NULL, terms->axis, terms->d) + AXIAL_TILT,
           f = vector_dot_f64(NULL, terms->axis, terms->m);
    double m_d = vector_dot_f64(NULL, terms->m, terms->d);
    double b = cylinder_form_f64(NULL, terms->height, m_d, e, f);
    double root = sqrt(terms->height * discriminant);
    double per_a = 1 / terms->a, per_e = 1 / e, reach = terms->height * terms->size;
    return (cylinder_ends){
        {
            .less = (-b - root) * per_a,
            .more = (root - b) * per_a,
            .e = e,
            .base = -f * per_e,
            .top = (terms->height - f) * per_e,
            .wall_error = axial_root(CYLINDER_WALL * (terms->height * terms->d_d) * reach, inner,
                                     discriminant) *
                          per_a,
            .plane_error = SURE_AXIAL_PLANE_BOUND * filter_root_above(reach) * fabs(per_e),
            .leading = true,
        },
        root,
        per_a,
    };
}

#ifndef LANES /* From here on of one ray alone, with branches. */

#include "../capped/axial_polish.h"

#define NUMBER dd
#include "cylinder_tmpl.h"

/* With D as doubles have it, or with a D that is known: what is wrong with its root is then told
 * by its error. */
static inline filter_verdict
cylinder_filter_given(const sure_ray *ray, const sure_cylinder *cylinder, const axial_terms *terms,
                      const known_discriminant *known, filter_interval *found)
{
    double discriminant = known ? known->value : axial_discriminant(terms);
    if (!((known || axial_is_certain(terms, discriminant)) & axial_fits(terms, cylinder->radius)))
        return FILTER_UNCERTAIN;
    if (discriminant < 0)
        return filter_miss_if(true, ray);

    cylinder_ends ends = cylinder_ends_of(terms, discriminant, known ? discriminant : terms->inner);
    axial_line *line = &ends.line;
    line->less_at = END_LESS;
    line->more_at = END_MORE;
    if (known && known->coplanar)
        axial_level(line);
    if (known)
        axial_known(known, known->error + fabs(known->rest),
                    terms->height / ends.root * fabs(ends.per_a), line);
    return axial_chord(line, terms->d_d, terms->size, ray, found);
}

static INLINED filter_verdict cylinder_filter(const sure_ray *ray, const void *shape,
                                              filter_interval *found)
{
    const sure_cylinder *cylinder = (const sure_cylinder *)shape;
    axial_terms terms = cylinder_terms_of(ray, cylinder);
    return cylinder_filter_given(ray, cylinder, &terms, NULL, found);
}

/* |A x p|^2 - r^2 H, whose halved derivative is (A x p).(A x d). */
static inline polish_step cylinder_wall_step(const sure_ray *ray, const sure_cylinder *cylinder,
                                             end_kind at, double t)
{
    axial_point here = axial_point_of(ray, &cylinder->base, &cylinder->top, &cylinder->base, t);
    axial_radius radius = axial_radius_of(&here);
    double r = cylinder->radius;
    two_terms_dd body = cylinder_body_dd(NULL, radius.square, axial_square(here.a), dd_of(NULL, r));
    double residual = dd_value(dd_add_loosely(body.more, dd_negate(NULL, body.less)));
    return axial_wall_step(&here, residual, radius.slope,
                           at == END_LESS ? -radius.slope : radius.slope, radius.curve,
                           radius.most + r * here.a_most);
}

static inline polish_step cylinder_step(const sure_ray *ray, const void *shape, tagged_end end,
                                        double t)
{
    const sure_cylinder *cylinder = (const sure_cylinder *)shape;
    if (end.at == END_LESS || end.at == END_MORE)
        return cylinder_wall_step(ray, cylinder, end.at, t);
    return axial_plane_step(ray, &cylinder->base, &cylinder->top,
                            end.at == END_BASE ? &cylinder->base : &cylinder->top, t);
}

#endif
