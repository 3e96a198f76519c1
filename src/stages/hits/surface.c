/* SPDX-License-Identifier: MIT */
#include "surface.h"

/* p + s d */
static vector_ddb moved(ddb_context *c, vector_ddb p, ddb s, const sure_ray *ray)
{
    return vector_add_ddb(c, p, vector_scale_ddb(c, s, vector_of_ddb(c, ray->direction)));
}

vector_ddb surface_point(ddb_context *c, const sure_ray *ray, sure_vec3 from, ddb t)
{
    const sure_vec3 o = ray->origin, d = ray->direction;
    vector_ddb p = {ddb_along(o.x, from.x, t.hi, d.x), ddb_along(o.y, from.y, t.hi, d.y),
                    ddb_along(o.z, from.z, t.hi, d.z)};
    ddb rest = ddb_of(c, t.lo);
    rest.error += t.error;
    return moved(c, p, rest, ray);
}

vector_ddb surface_point_after(ddb_context *c, const sure_ray *ray, sure_vec3 from, ddb at,
                               ddb step)
{
    return moved(c, surface_point(c, ray, from, at), step, ray);
}

part_slope surface_slope(ddb_context *c, const shape_row *row, const sure_ray *ray,
                         const void *shape, ddb t)
{
    vector_ddb p = surface_point(c, ray, surface_anchor(row, shape), t);
    return row->surface->slope(c, shape, p, vector_of_ddb(c, ray->direction));
}
