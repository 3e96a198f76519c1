/* The disc for stable, certain and exact: what it gives to the stages, and what is public. */
#include "../bounds.h"
#include "../shapes.h"
#include "../stable.h"
#include "disc_close.h"
#include "disc_guess.h"

#include "../planar/planar_spawn.h"
#include "../planar/planar_stages.h"

#define NUMBER exact
#include "../sphere/sphere_tmpl.h"
#undef NUMBER

STAGES_INLINE filter_verdict filter(const sure_ray *ray, const void *shape, filter_interval *found)
{
    return disc_filter(ray, shape, found);
}

STAGES_INLINE bool polish(const sure_ray *ray, const void *shape, const filter_end *end, double *t)
{
    return disc_polish(ray, shape, end, t);
}

FLAT_APART static filter_verdict refine_hit(const sure_ray *ray, const void *shape, t_wanted wanted,
                                            sure_hit *hit)
{
    return disc_close(ray, shape, wanted, hit);
}

/* A line in the disc's plane is cut by the circle as by a sphere. */
static tagged_interval edge_on(exact_context *c, const planar_line *at, exact r,
                               line_coefficients *l)
{
    l->a = vector_square_exact(c, at->d);
    l->quarter = difference_exact(c, sphere_discriminant_exact(c, l->a, at->d, at->m, r));
    if (exact_sign(c, l->quarter) < 0)
        return interval_empty();
    l->factor = exact_of(c, 1);
    l->b = vector_dot_exact(c, at->m, at->d);
    l->c = difference_exact(c, sphere_body_exact(c, at->m, r));
    return interval_along((tagged_end){END_LESS, SURE_PART_SURFACE},
                          (tagged_end){END_MORE, SURE_PART_SURFACE}, SURE_PART_SURFACE);
}

/* The plane's point, if it is not too far from the centre. */
static tagged_interval exact_interval(exact_context *c, const sure_ray *ray, const void *shape,
                                      line_coefficients *l)
{
    const sure_disc *disc = shape;
    planar_line at = planar_line_of(c, ray, disc->centre, disc->normal, l);
    exact r = exact_of(c, disc->radius);
    if (exact_sign(c, l->speed) == 0)
        return exact_sign(c, at.h) == 0 ? edge_on(c, &at, r, l) : interval_empty();
    two_terms_exact rim = disc_rim_exact(c, l->speed, at.h, at.m, at.d, r);
    if (exact_sign(c, difference_exact(c, rim)) < 0)
        return interval_empty();
    return interval_point((tagged_end){END_BASE, SURE_PART_SURFACE});
}

static sure_vec3 round_normal(exact_context *c, const sure_ray *ray, const void *shape,
                              const line_coefficients *l, tagged_end at)
{
    (void)ray, (void)l, (void)at;
    return round_unit(c, vector_of_exact(c, ((const sure_disc *)shape)->normal));
}

static bool part_of_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_disc *disc = shape;
    (void)part;
    *plane = (part_plane){.to = disc->normal, .at = disc->centre};
    return true;
}

static int side_ddb(ddb_context *c, const void *shape, sure_vec3 p)
{
    const sure_disc *disc = shape;
    return planar_side_ddb(c, disc->normal, disc->centre, p);
}

static int side_exact(exact_context *c, const void *shape, sure_vec3 p)
{
    const sure_disc *disc = shape;
    return planar_side_exact(c, disc->normal, disc->centre, p);
}

static inline bool disc_quick_normal(const sure_ray *ray, const sure_disc *disc,
                                     const sure_hit *hit, sure_vec3 *normal)
{
    (void)ray, (void)hit;
    const sure_vec3 *n = &disc->normal;
    return quick_unit((quick_vector){n->x, n->y, n->z}, 1, normal);
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    (void)part, (void)p;
    return ((const sure_disc *)shape)->normal;
}

static SPAWN_IN_ONE_PIECE spawn_quick(const sure_ray *ray, const void *shape, const sure_hit *hit,
                                      double side, sure_vec3 *origin, sure_hit *nearer)
{
    const sure_disc *disc = shape;
    line_point line = line_point_of(ray, hit->t);
    return spawn_by_surface(ray, hit, side, &line,
                            flat_surface(&line, &disc->centre, &disc->normal), origin, nearer);
}

static void bounds(const void *shape, double low[3], double high[3])
{
    const sure_disc *disc = shape;
    double reach[3];
    bounds_reach_of_disc(disc->normal, disc->radius, reach);
    bounds_include(disc->centre, reach, low, high);
}

const shape_row disc_row = {
    .info = {.name = "disc",
             .solid = 0,
             .bounded = 1,
             .numbers = 7,
             .field_count = 3,
             .part_count = 1,
             .fields = {{SURE_FIELD_CENTRE, SURE_KIND_POINT, DOUBLES_BEFORE(sure_disc, centre)},
                        {SURE_FIELD_NORMAL, SURE_KIND_NORMAL, DOUBLES_BEFORE(sure_disc, normal)},
                        {SURE_FIELD_RADIUS, SURE_KIND_RADIUS, DOUBLES_BEFORE(sure_disc, radius)}},
             .parts = {SURE_PART_SURFACE}},
    .filter = filter,
    .polish = polish,
    .refine_hit = refine_hit,
    .exact_interval = exact_interval,
    .round_normal = round_normal,
    .surface = {.plane = part_of_plane},
    .side_ddb = side_ddb,
    .side_exact = side_exact,
    .outward = outward,
    .spawn_quick = spawn_quick,
    .has_inside = planar_has_inside,
    .bounds = bounds,
};

sure_field sure_disc_check(const sure_ray *ray, const sure_disc *disc)
{
    return shape_check(&disc_row, ray, disc);
}

sure_status sure_disc_hit_certain(const sure_ray *ray, const sure_disc *disc, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&disc_row, ray, disc, T_CERTAIN, hit, &unused);
}

sure_status sure_disc_hit_exact(const sure_ray *ray, const sure_disc *disc, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&disc_row, ray, disc, T_EXACT, hit, &unused);
}

sure_status sure_disc_interval_certain(const sure_ray *ray, const sure_disc *disc,
                                       sure_interval *interval)
{
    return stages_interval(&disc_row, ray, disc, T_CERTAIN, interval);
}

sure_status sure_disc_interval_exact(const sure_ray *ray, const sure_disc *disc,
                                     sure_interval *interval)
{
    return stages_interval(&disc_row, ray, disc, T_EXACT, interval);
}

sure_status sure_disc_occluded_certain(const sure_ray *ray, const sure_disc *disc)
{
    sure_hit unused;
    return sure_disc_hit_certain(ray, disc, &unused);
}

sure_status sure_disc_occluded_exact(const sure_ray *ray, const sure_disc *disc)
{
    sure_hit unused;
    return sure_disc_hit_certain(ray, disc, &unused);
}

sure_vec3 sure_disc_normal_certain(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit)
{
    sure_vec3 normal;
    if (disc_quick_normal(ray, disc, hit, &normal))
        return normal;
    return stages_normal(&disc_row, ray, disc, hit, T_CERTAIN);
}

sure_vec3 sure_disc_normal_exact(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit)
{
    return stages_normal(&disc_row, ray, disc, hit, T_EXACT);
}

sure_status sure_disc_hit_stable(const sure_ray *ray, const sure_disc *disc, sure_hit *hit)
{
    return stable_hit(&disc_row, disc_guess, ray, disc, hit);
}

sure_status sure_disc_interval_stable(const sure_ray *ray, const sure_disc *disc,
                                      sure_interval *interval)
{
    return stable_interval(&disc_row, disc_guess, ray, disc, interval);
}

sure_status sure_disc_occluded_stable(const sure_ray *ray, const sure_disc *disc)
{
    sure_hit unused;
    return sure_disc_hit_stable(ray, disc, &unused);
}

sure_vec3 sure_disc_normal_stable(const sure_ray *ray, const sure_disc *disc, const sure_hit *hit)
{
    sure_vec3 normal;
    if (disc_quick_normal(ray, disc, hit, &normal))
        return normal;
    return sure_disc_normal_textbook(ray, disc, hit);
}
