/* The plane for stable, certain and exact: what it gives to the stages, and what is public. */
#include "../shapes.h"
#include "../stable.h"
#include "plane_close.h"
#include "plane_guess.h"

#include "../planar/planar_spawn.h"
#include "../planar/planar_stages.h"

STAGES_INLINE filter_verdict filter(const sure_ray *ray, const void *shape, filter_interval *found)
{
    return plane_filter(ray, shape, found);
}

STAGES_INLINE bool polish(const sure_ray *ray, const void *shape, const filter_end *end, double *t)
{
    return plane_polish(ray, shape, end, t);
}

FLAT_APART static filter_verdict refine_hit(const sure_ray *ray, const void *shape, t_wanted wanted,
                                            sure_hit *hit)
{
    return plane_close(ray, shape, wanted, hit);
}

/* e = 0: the whole line when h = 0, nothing otherwise. */
static tagged_interval exact_interval(exact_context *c, const sure_ray *ray, const void *shape,
                                      line_coefficients *l)
{
    const sure_plane *plane = shape;
    const tagged_end none = {END_ENDLESS, SURE_PART_SURFACE};
    planar_line at = planar_line_of(c, ray, plane->point, plane->normal, l);
    if (exact_sign(c, l->speed) != 0)
        return interval_point((tagged_end){END_BASE, SURE_PART_SURFACE});
    return exact_sign(c, at.h) == 0 ? interval_along(none, none, SURE_PART_SURFACE)
                                    : interval_empty();
}

static sure_vec3 round_normal(exact_context *c, const sure_ray *ray, const void *shape,
                              const line_coefficients *l, tagged_end at)
{
    (void)ray, (void)l, (void)at;
    return round_unit(c, vector_of_exact(c, ((const sure_plane *)shape)->normal));
}

static bool part_of_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_plane *s = shape;
    (void)part;
    *plane = (part_plane){.to = s->normal, .at = s->point};
    return true;
}

static int side_ddb(ddb_context *c, const void *shape, sure_vec3 p)
{
    const sure_plane *plane = shape;
    return planar_side_ddb(c, plane->normal, plane->point, p);
}

static int side_exact(exact_context *c, const void *shape, sure_vec3 p)
{
    const sure_plane *plane = shape;
    return planar_side_exact(c, plane->normal, plane->point, p);
}

static inline bool plane_quick_normal(const sure_ray *ray, const sure_plane *plane,
                                      const sure_hit *hit, sure_vec3 *normal)
{
    (void)ray, (void)hit;
    const sure_vec3 *n = &plane->normal;
    return quick_unit((quick_vector){n->x, n->y, n->z}, 1, normal);
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    (void)part, (void)p;
    return ((const sure_plane *)shape)->normal;
}

static SPAWN_IN_ONE_PIECE spawn_quick(const sure_ray *ray, const void *shape, const sure_hit *hit,
                                      double side, sure_vec3 *origin, sure_hit *nearer)
{
    const sure_plane *plane = shape;
    line_point line = line_point_of(ray, hit->t);
    return spawn_by_surface(ray, hit, side, &line,
                            flat_surface(&line, &plane->point, &plane->normal), origin, nearer);
}

const shape_row plane_row = {
    .info = {.name = "plane",
             .solid = 0,
             .bounded = 0,
             .numbers = 6,
             .field_count = 2,
             .part_count = 1,
             .fields = {{SURE_FIELD_POINT, SURE_KIND_POINT, DOUBLES_BEFORE(sure_plane, point)},
                        {SURE_FIELD_NORMAL, SURE_KIND_NORMAL, DOUBLES_BEFORE(sure_plane, normal)}},
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
};

sure_field sure_plane_check(const sure_ray *ray, const sure_plane *plane)
{
    return shape_check(&plane_row, ray, plane);
}

sure_status sure_plane_hit_certain(const sure_ray *ray, const sure_plane *plane, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&plane_row, ray, plane, T_CERTAIN, hit, &unused);
}

sure_status sure_plane_hit_exact(const sure_ray *ray, const sure_plane *plane, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&plane_row, ray, plane, T_EXACT, hit, &unused);
}

sure_status sure_plane_interval_certain(const sure_ray *ray, const sure_plane *plane,
                                        sure_interval *interval)
{
    return stages_interval(&plane_row, ray, plane, T_CERTAIN, interval);
}

sure_status sure_plane_interval_exact(const sure_ray *ray, const sure_plane *plane,
                                      sure_interval *interval)
{
    return stages_interval(&plane_row, ray, plane, T_EXACT, interval);
}

sure_status sure_plane_occluded_certain(const sure_ray *ray, const sure_plane *plane)
{
    sure_hit unused;
    return sure_plane_hit_certain(ray, plane, &unused);
}

sure_status sure_plane_occluded_exact(const sure_ray *ray, const sure_plane *plane)
{
    sure_hit unused;
    return sure_plane_hit_certain(ray, plane, &unused);
}

sure_vec3 sure_plane_normal_certain(const sure_ray *ray, const sure_plane *plane,
                                    const sure_hit *hit)
{
    sure_vec3 normal;
    if (plane_quick_normal(ray, plane, hit, &normal))
        return normal;
    return stages_normal(&plane_row, ray, plane, hit, T_CERTAIN);
}

sure_vec3 sure_plane_normal_exact(const sure_ray *ray, const sure_plane *plane, const sure_hit *hit)
{
    return stages_normal(&plane_row, ray, plane, hit, T_EXACT);
}

sure_status sure_plane_hit_stable(const sure_ray *ray, const sure_plane *plane, sure_hit *hit)
{
    return stable_hit(&plane_row, plane_guess, ray, plane, hit);
}

sure_status sure_plane_interval_stable(const sure_ray *ray, const sure_plane *plane,
                                       sure_interval *interval)
{
    return stable_interval(&plane_row, plane_guess, ray, plane, interval);
}

sure_status sure_plane_occluded_stable(const sure_ray *ray, const sure_plane *plane)
{
    sure_hit unused;
    return sure_plane_hit_stable(ray, plane, &unused);
}

sure_vec3 sure_plane_normal_stable(const sure_ray *ray, const sure_plane *plane,
                                   const sure_hit *hit)
{
    sure_vec3 normal;
    if (plane_quick_normal(ray, plane, hit, &normal))
        return normal;
    return sure_plane_normal_textbook(ray, plane, hit);
}
