/* SPDX-License-Identifier: MIT */
#include "filters.h"

#include "../../src/shapes/cone/cone_filter.h"
#include "../../src/shapes/cylinder/cylinder_filter.h"
#include "../../src/shapes/disc/disc_filter.h"
#include "../../src/shapes/plane/plane_filter.h"
#include "../../src/shapes/sphere/sphere_filter.h"
#include "../../src/stages/rows.h"

#define STEP(shape)                                                                                \
    static polish_step shape##_stepped(const sure_case *c, end_kind at, double t)                  \
    {                                                                                              \
        return shape##_step(&c->ray, &c->object.as, (tagged_end){.at = at}, t);                    \
    }

#define CAPPED(shape)                                                                              \
    STEP(shape)                                                                                    \
    static body_terms shape##_body(const sure_case *c)                                             \
    {                                                                                              \
        axial_terms of = shape##_terms_of(&c->ray, &c->object.as.shape);                           \
        double value = of.inner - of.outer;                                                        \
        bool fits = axial_fits(&of, c->object.as.shape.radius);                                    \
        bool told = value * value > of.certain && fits;                                            \
        return (body_terms){fits, of.measure, {{value, sqrt(of.certain), told}}};                  \
    }

static filter_verdict plane_filtered(const sure_case *c, filter_interval *found)
{
    const sure_plane *plane = &c->object.as.plane;
    flat_terms of = flat_terms_of(&c->ray, &plane->point, &plane->normal);
    return flat_in_range(&of) ? flat_crossing(&of, 0, found) : FILTER_UNCERTAIN;
}

/* As if the ray started where no crossing is behind. */
static filter_verdict disc_filtered(const sure_case *c, filter_interval *found)
{
    const sure_disc *disc = &c->object.as.disc;
    flat_terms of = flat_terms_of(&c->ray, &disc->centre, &disc->normal);
    filter_verdict verdict = disc_filter(&c->ray, disc, found);
    return flat_behind(&of, c->ray.t_min) ? FILTER_UNCERTAIN : verdict;
}

/* Plane and disc begin with place and normal. */
static polish_step flat_stepped(const sure_case *c, end_kind at, double t)
{
    (void)at;
    return crossing_step(&c->ray, &c->object.as.plane.point, &c->object.as.plane.normal, t);
}

STEP(sphere)

/* The second one's bound is for discriminants that exceed it. */
static body_terms sphere_body(const sure_case *c)
{
    const sure_sphere *sphere = &c->object.as.sphere;
    sphere_terms of = sphere_terms_of(&c->ray, sphere);
    sphere_close_terms close = sphere_close_terms_of(&of, sphere->radius);
    double measure = of.a * of.size, error = SURE_SPHERE_CLOSE_BOUND * sqrt(close.sum) * close.all;
    bool fits = sphere_fits(sphere, &of), told = fits && fabs(close.discriminant) > error;
    return (body_terms){fits,
                        measure,
                        {{of.discriminant, SURE_SPHERE_DISCRIMINANT_BOUND * measure, fits},
                         {close.discriminant, error, told}}};
}

CAPPED(cylinder)
CAPPED(cone)

const filter_subject filter_subjects[SURE_SHAPES] = {
    [SURE_SHAPE_PLANE] = {plane_filtered, flat_stepped},
    [SURE_SHAPE_DISC] = {disc_filtered, flat_stepped},
    [SURE_SHAPE_SPHERE] = {NULL, sphere_stepped, sphere_body, 0, SURE_CYLINDER_DISCRIMINANT_BOUND},
    [SURE_SHAPE_CYLINDER] = {NULL, cylinder_stepped, cylinder_body, 1,
                             SURE_CYLINDER_DISCRIMINANT_BOUND},
    [SURE_SHAPE_CONE] = {NULL, cone_stepped, cone_body, 2, SURE_CONE_DISCRIMINANT_BOUND},
};

filter_verdict filter_line(const sure_case *c, filter_interval *found)
{
    const filter_subject *of = &filter_subjects[c->object.shape];
    return of->filter ? of->filter(c, found)
                      : row_of(&c->object)->filter(&c->ray, &c->object.as, found);
}

bool filter_fits(const sure_case *c)
{
    const filter_subject *of = &filter_subjects[c->object.shape];
    return of->body && of->body(c).fits;
}

void true_discriminant(const filter_subject *of, const true_line *line, mpfr_t d)
{
    mpfr_set(d, line->discriminant, MPFR_RNDN);
    for (int i = 0; i < of->powers; i++)
        mpfr_div(d, d, line->height, MPFR_RNDN);
}

end_kind end_kind_of(true_end at)
{
    static const end_kind kinds[] = {END_LESS, END_MORE, END_BASE, END_TOP, END_ENDLESS};
    return kinds[at];
}
