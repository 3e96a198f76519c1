/* SPDX-License-Identifier: MIT */
/* The surface of plane and disc for certain and exact: what is asked of a hit. Their structs begin
 * with a point Q and the normal N. */
#define MOD128_APART
#include "../../stages/hits/normal.h"
#include "../bounds.h"

#include <surehit/disc.h>
#include <surehit/plane.h>

#define NUMBER mod128
#include "planar_tmpl.h"
#define NUMBER ddb
#include "planar_tmpl.h"
#define NUMBER exact
#include "planar_tmpl.h"

enum { POINT, NORMAL };

static bool part_of_plane(const void *shape, sure_part part, part_plane *plane)
{
    const sure_vec3 *s = shape;
    (void)part;
    *plane = (part_plane){.to = s[NORMAL], .at = s[POINT]};
    return true;
}

static sure_vec3 outward(const void *shape, sure_part part, sure_vec3 p)
{
    (void)part, (void)p;
    return ((const sure_vec3 *)shape)[NORMAL];
}

static void disc_bounds(const void *shape, double low[3], double high[3])
{
    const sure_disc *disc = shape;
    double reach[3];
    bounds_reach_of_disc(disc->normal, disc->radius, reach);
    bounds_include(disc->centre, reach, low, high);
}

#define PLANAR_SURFACE                                                                             \
    .plane = part_of_plane, SURFACE_SIDES(planar), .outward = outward

const surface_row plane_surface_row = {PLANAR_SURFACE};
const surface_row disc_surface_row = {PLANAR_SURFACE, .bounds = disc_bounds};

#define plane_quick_normal(ray, plane, hit, result) quick_unit((plane)->normal, 1, result)
#define disc_quick_normal(ray, disc, hit, result) quick_unit((disc)->normal, 1, result)
SURFACE_NORMALS(plane)
SURFACE_NORMALS(disc)
