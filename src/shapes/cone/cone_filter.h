/* SPDX-License-Identifier: MIT */
/* The first stage of the cone; docs/proofs/cone_filter.md proves it. With A = base - apex, m = o -
 * apex, H = A.A, K = H + r^2, w = d x m, g = A x w:
 *
 *     a = H^2 d.d - K (A.d)^2,  b = H^2 m.d - K (A.m)(A.d),  D = r^2 g.g - H (A.w)^2
 *     wall   t = (-b -+ H sqrt(D)) / a
 *     planes t = (H - A.m) / A.d, and -A.m / A.d through the apex
 *
 * a > 0: both roots are on one nappe; a chord that has points beyond the apex's plane is on the
 * kept one. a < 0: there is a root on each nappe; the line comes from the kept one's and goes on to
 * the base, or the other way round. M = H^2 d.d + K (A.d)^2, a with its terms made positive,
 * measures a. */
#pragma once

#include "../capped/axial_filter.h"

#define NUMBER f64
#include "cone_tmpl.h"

#define CONE_CERTAIN (SURE_CONE_DISCRIMINANT_BOUND * SURE_CONE_DISCRIMINANT_BOUND)
#define CONE_LEADING (SURE_CONE_LEADING_BOUND * SURE_CONE_LEADING_BOUND)
#define CONE_WALL (SURE_CONE_WALL_BOUND * SURE_CONE_WALL_BOUND)

static INLINED axial_terms cone_terms_of(const sure_ray *ray, const sure_cone *cone)
{
    axial_terms of = {.axis = vector_between_f64(NULL, cone->apex, cone->base),
                      .m = vector_between_f64(NULL, cone->apex, ray->origin),
                      .d = vector_of_f64(NULL, ray->direction)};
    of.height = vector_dot_f64(NULL, of.axis, of.axis);
    two_terms_f64 terms = cone_discriminant_f64(NULL, of.axis, of.height, of.d, of.m, cone->radius);
    double rr = cone->radius * cone->radius, mm = vector_dot_f64(NULL, of.m, of.m);
    of.slant = of.height + rr;
    of.d_d = vector_dot_f64(NULL, of.d, of.d);
    of.size = mm + of.slant;
    of.inner = terms.more;
    of.outer = terms.less;
    of.measure = of.slant * (of.height * of.d_d) * mm;
    of.certain = CONE_CERTAIN * (of.inner + of.outer) * of.measure + AXIAL_FLOOR;
    return of;
}

/* As cylinder_ends_of. For a < 0 one end of the wall's body is out of sight, 2^600 away, which is
 * put into b: no branch and no mask, for this is what the one decision waits for that can't be
 * foreseen. */
typedef struct {
    axial_line line;
    double a, root, per_a;
} cone_ends;

static inline cone_ends cone_ends_of(const axial_terms *terms, double discriminant, double inner)
{
    double e = vector_dot_f64(NULL, terms->axis, terms->d) + AXIAL_TILT,
           f = vector_dot_f64(NULL, terms->axis, terms->m);
    double m_d = vector_dot_f64(NULL, terms->m, terms->d);
    two_terms_f64 form = cone_form_f64(NULL, terms->height, terms->slant, terms->d_d, e, e);
    double a = form.more - form.less, all = form.more + form.less;
    double b = difference_f64(NULL, cone_form_f64(NULL, terms->height, terms->slant, m_d, e, f));
    double root = terms->height * sqrt(discriminant);
    double per_a = 1 / a, per_e = 1 / e, reach = terms->height * terms->size;
    double sight = copysign((fabs(a) - a) * 0x1p600, e);
    double b_less = b + (sight - fabs(sight)), b_more = b + (sight + fabs(sight));
    return (cone_ends){
        {
            .less = (-b_less - root) * per_a,
            .more = (root - b_more) * per_a,
            .e = -e,
            .base = (terms->height - f) * per_e,
            .top = -f * per_e,
            .wall_error =
                axial_root(CONE_WALL * all * (terms->slant * reach), inner, discriminant) *
                fabs(per_a),
            .plane_error = SURE_AXIAL_PLANE_BOUND * filter_root_above(reach) * fabs(per_e),
            .leading = a * a > CONE_LEADING * all * (terms->slant * (terms->height * terms->d_d)),
        },
        a,
        root,
        per_a,
    };
}

#ifndef LANES /* From here on of one ray alone, with branches. */

#include "../capped/axial_polish.h"

#define NUMBER dd
#include "cone_tmpl.h"

/* As cylinder_filter_given. */
static inline filter_verdict cone_filter_given(const sure_ray *ray, const sure_cone *cone,
                                               const axial_terms *terms,
                                               const known_discriminant *known,
                                               filter_interval *found)
{
    double discriminant = known ? known->value : axial_discriminant(terms);
    if (!((known || axial_is_certain(terms, discriminant)) & axial_fits(terms, cone->radius)))
        return FILTER_UNCERTAIN;
    if (discriminant < 0)
        return filter_miss_if(true, ray);

    cone_ends ends = cone_ends_of(terms, discriminant, known ? discriminant : terms->inner);
    axial_line *line = &ends.line;
    uint64_t steep = bits_of(ends.a) >> 63;
    line->less_at = (end_kind)(END_LESS + steep);
    line->more_at = (end_kind)(END_MORE - steep);
    if (known && known->coplanar)
        axial_level(line);
    if (known && (discriminant > 0 || ends.a > 0))
        axial_known(known, known->error + fabs(known->rest),
                    terms->height * terms->height / ends.root * fabs(ends.per_a), line);
    return axial_chord(line, terms->d_d, terms->size, ray, found);
}

static INLINED filter_verdict cone_filter(const sure_ray *ray, const void *shape,
                                          filter_interval *found)
{
    const sure_cone *cone = (const sure_cone *)shape;
    axial_terms terms = cone_terms_of(ray, cone);
    return cone_filter_given(ray, cone, &terms, NULL, found);
}

/* S of the wall (bounds.h). */
static inline double cone_measure(const axial_point *at, const axial_radius *radius, double height,
                                  double rr, double depth)
{
    return height * radius->most + rr * (fabs(depth) + axial_cancelled(at));
}

/* H |A x p|^2 - r^2 (A.p)^2, which rises where the line leaves the double cone: at the greater
 * root, or for a < 0 at the lesser. */
static inline polish_step cone_wall_step(const sure_ray *ray, const sure_cone *cone, end_kind at,
                                         double t)
{
    axial_point here = axial_point_of(ray, &cone->apex, &cone->base, &cone->apex, t);
    axial_radius radius = axial_radius_of(&here);
    dd height = axial_square(here.a), along = axial_along(&here);
    two_terms_dd body = cone_body_dd(NULL, height, dd_of(NULL, cone->radius), radius.square,
                                     dd_square(NULL, along));
    double rr = cone->radius * cone->radius, depth = dd_value(along);
    double e = dot(axial_axis(&here), here.d);
    double residual = dd_value(dd_add_loosely(body.more, dd_negate(NULL, body.less)));
    two_terms_f64 curve = cone_body_f64(NULL, height.head, cone->radius, radius.curve, e * e);
    double a = curve.more - curve.less;
    double slope = difference_f64(
        NULL, cone_body_f64(NULL, height.head, cone->radius, radius.slope, depth * e));
    double way_out = (at == END_LESS) == (a > 0) ? -slope : slope;
    polish_step way = axial_wall_step(&here, residual, slope, way_out, curve.more + curve.less,
                                      cone_measure(&here, &radius, height.head, rr, depth));
    double turn = here.a_most * here.d_most * (height.head * radius.turn + rr * fabs(e));
    way.certain = way.certain && fabs(a) > SURE_AXIAL_LEADING_CERTAIN * turn;
    return way;
}

static inline polish_step cone_step(const sure_ray *ray, const void *shape, tagged_end end,
                                    double t)
{
    const sure_cone *cone = (const sure_cone *)shape;
    if (end.at == END_LESS || end.at == END_MORE)
        return cone_wall_step(ray, cone, end.at, t);
    return axial_plane_step(ray, &cone->apex, &cone->base, &cone->base, t);
}

#endif
