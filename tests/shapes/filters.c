#include "filters.h"

#include "../../src/shapes/cone/cone_filter.h"
#include "../../src/shapes/cylinder/cylinder_filter.h"
#include "../../src/shapes/disc/disc_filter.h"
#include "../../src/shapes/plane/plane_filter.h"
#include "../../src/shapes/sphere/sphere_filter.h"

#include <math.h>

#define PLACE(shape, field)                                                                        \
    static sure_vec3 shape##_place(const sure_case *c)                                             \
    {                                                                                              \
        return c->object.as.shape.field;                                                           \
    }

#define POLISH(shape)                                                                              \
    static bool shape##_polished(const sure_case *c, const filter_end *end, double *t)             \
    {                                                                                              \
        return shape##_polish(&c->ray, &c->object.as.shape, end, t);                               \
    }

#define FILTER(shape)                                                                              \
    static filter_verdict shape##_filtered(const sure_case *c, filter_interval *found)             \
    {                                                                                              \
        return shape##_filter(&c->ray, &c->object.as.shape, found);                                \
    }                                                                                              \
    static polish_step shape##_stepped(const sure_case *c, end_kind at, double t)                  \
    {                                                                                              \
        return shape##_step(&c->ray, &c->object.as.shape, at, t);                                  \
    }

#define CAPPED(shape, other_end)                                                                   \
    static double shape##_size(const sure_case *c)                                                 \
    {                                                                                              \
        const sure_##shape *s = &c->object.as.shape;                                               \
        vector_f64 axis = vector_between_f64(NULL, s->base, s->other_end);                         \
        return s->radius + sqrt(vector_dot_f64(NULL, axis, axis));                                 \
    }                                                                                              \
    static void shape##_discriminants(const sure_case *c, told_number found[2])                    \
    {                                                                                              \
        shape##_terms of = shape##_terms_of(&c->ray, &c->object.as.shape);                         \
        double value = of.inner - of.outer;                                                        \
        bool told = value * value > of.certain && shape##_fits(&c->object.as.shape, &of);          \
        found[0] = (told_number){value, sqrt(of.certain), told};                                   \
        found[1] = (told_number){.told = false};                                                   \
    }

PLACE(plane, point)
POLISH(plane)

static double plane_size(const sure_case *c)
{
    (void)c;
    return 0;
}

static filter_verdict plane_filtered(const sure_case *c, filter_interval *found)
{
    const sure_plane *plane = &c->object.as.plane;
    flat_terms of = flat_terms_of(&c->ray, &plane->point, &plane->normal);
    return flat_in_range(&of) ? flat_crossing(&of, 0, found) : FILTER_UNCERTAIN;
}

static polish_step plane_stepped(const sure_case *c, end_kind at, double t)
{
    (void)at;
    return crossing_step(&c->ray, &c->object.as.plane.point, &c->object.as.plane.normal, t);
}

PLACE(disc, centre)
POLISH(disc)

static double disc_size(const sure_case *c)
{
    return c->object.as.disc.radius;
}

/* As if the ray started where no crossing is behind. */
static filter_verdict disc_filtered(const sure_case *c, filter_interval *found)
{
    const sure_disc *disc = &c->object.as.disc;
    flat_terms of = flat_terms_of(&c->ray, &disc->centre, &disc->normal);
    filter_verdict verdict = disc_filter(&c->ray, disc, found);
    return flat_behind(&of, c->ray.t_min) ? FILTER_UNCERTAIN : verdict;
}

static polish_step disc_stepped(const sure_case *c, end_kind at, double t)
{
    (void)at;
    return crossing_step(&c->ray, &c->object.as.disc.centre, &c->object.as.disc.normal, t);
}

PLACE(sphere, centre)
POLISH(sphere)
FILTER(sphere)

static double sphere_size(const sure_case *c)
{
    return c->object.as.sphere.radius;
}

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

PLACE(cylinder, base)
POLISH(cylinder)
FILTER(cylinder)
CAPPED(cylinder, top)
PLACE(cone, base)
POLISH(cone)
FILTER(cone)
CAPPED(cone, apex)

const filter_subject filter_subjects[SURE_SHAPES] = {
    {plane_place, plane_size, plane_filtered, plane_polished, plane_stepped, NULL, 0},
    {disc_place, disc_size, disc_filtered, disc_polished, disc_stepped, NULL, 0},
    {sphere_place, sphere_size, sphere_filtered, sphere_polished, sphere_stepped,
     sphere_discriminants, 0},
    {cylinder_place, cylinder_size, cylinder_filtered, cylinder_polished, cylinder_stepped,
     cylinder_discriminants, 1},
    {cone_place, cone_size, cone_filtered, cone_polished, cone_stepped, cone_discriminants, 2},
};
