/* The plane for certain and exact: what it gives to the stages. */
#include "plane_close.h"

#include "../planar/planar_stages.h"

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
    .filter = plane_filter,
    .refine_hit = refine_hit,
    .step = plane_step,
    .steps = 1,
    .exact_interval = exact_interval,
    .round_normal = planar_round_normal,
    .surface = &plane_surface_row,
};

sure_status sure_plane_hit_certain(const sure_ray *ray, const sure_plane *plane, sure_hit *hit)
{
    sure_stage unused;
    return stages_hit(&plane_row, ray, plane, T_CERTAIN, hit, &unused);
}

STAGES_QUESTIONS(plane)
