#include "filters.h"

#include "../../src/shapes/cone/cone_filter.h"
#include "../../src/shapes/cylinder/cylinder_filter.h"
#include "../../src/shapes/disc/disc_filter.h"
#include "../../src/shapes/plane/plane_filter.h"
#include "../../src/shapes/sphere/sphere_filter.h"
#include "../../src/stages/rows.h"

#include <math.h>

#define STEP(shape)                                                                                \
    static polish_step shape##_stepped(const sure_case *c, end_kind at, double t)                  \
    {                                                                                              \
        return shape##_step(&c->ray, &c->object.as.shape, at, t);                                  \
    }

#define CAPPED(shape)                                                                              \
    STEP(shape)                                                                                    \
    static void shape##_discriminants(const sure_case *c, told_number found[2])                    \
    {                                                                                              \
        shape##_terms of = shape##_terms_of(&c->ray, &c->object.as.shape);                         \
        double value = of.inner - of.outer;                                                        \
        bool told = value * value > of.certain && shape##_fits(&c->object.as.shape, &of);          \
        found[0] = (told_number){value, sqrt(of.certain), told};                                   \
        found[1] = (told_number){.told = false};                                                   \
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
static void sphere_discriminants(const sure_case *c, told_number found[2])
{
    const sure_sphere *sphere = &c->object.as.sphere;
    sphere_terms of = sphere_terms_of(&c->ray, sphere);
    sphere_close_terms close = sphere_close_terms_of(&c->ray, sphere, &of);
    bool usual = sphere_fits(sphere, &of);
    double error = SURE_SPHERE_CLOSE_BOUND * sqrt(close.sum) * close.all;
    found[0] =
        (told_number){of.discriminant, SURE_SPHERE_DISCRIMINANT_BOUND * of.a * of.size, usual};
    found[1] = (told_number){close.discriminant, error, usual && fabs(close.discriminant) > error};
}

CAPPED(cylinder)
CAPPED(cone)

const filter_subject filter_subjects[SURE_SHAPES] = {
    [SURE_SHAPE_PLANE] = {plane_filtered, flat_stepped, NULL, 0},
    [SURE_SHAPE_DISC] = {disc_filtered, flat_stepped, NULL, 0},
    [SURE_SHAPE_SPHERE] = {NULL, sphere_stepped, sphere_discriminants, 0},
    [SURE_SHAPE_CYLINDER] = {NULL, cylinder_stepped, cylinder_discriminants, 1},
    [SURE_SHAPE_CONE] = {NULL, cone_stepped, cone_discriminants, 2},
};

filter_verdict filter_line(const sure_case *c, filter_interval *found)
{
    const filter_subject *of = &filter_subjects[c->object.shape];
    return of->filter ? of->filter(c, found)
                      : row_of(&c->object)->filter(&c->ray, &c->object.as, found);
}
