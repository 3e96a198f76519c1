/* Plane and disc: in the frame, z = 0. */
#include "extreme_layout.h"

#include <stdlib.h>

/* One step to the plane for up to 2^30 along it. */
static void head_nearly_parallel(extreme_layout *it, draws *from)
{
    it->direction.x = draw_wide(from, 20, 30);
    it->direction.y = draw_slope(from);
    it->direction.z = draw_side(from);
    it->turn = 8;
}

static void start_beside(extreme_layout *it, draws *from)
{
    it->outward = (grid_vec){0, 0, draw_side(from)};
}

/* The only crossing is at t*, and t_max or t_min is t* or the next double. */
static void lay_window_at_crossing(extreme_layout *it, draws *from)
{
    static const extreme_window windows[] = {CLOSES_AT, CLOSES_BEFORE, OPENS_AT, OPENS_AFTER};
    it->direction = draw_slopes(from);
    it->window = windows[kind_of(from, 4)];
    if (it->window == CLOSES_BEFORE || it->window == OPENS_AFTER)
        it->status = SURE_MISS;
}

/* The plane. */

static extreme_layout plane_within(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    it.direction = draw_slopes(from);
    it.direction.z = 0;
    start_beside(&it, from);
    it.window = OPENS_AT;
    if (kind_of(from, 2) == 1)
        it.at = 0;
    return it;
}

static extreme_layout plane_nearly_parallel(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    head_nearly_parallel(&it, from);
    if (kind_of(from, 2) == 1) {
        it.at = -it.at;
        it.status = SURE_MISS;
    }
    return it;
}

static extreme_layout plane_start(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    start_beside(&it, from);
    lay_start(&it, from);
    return it;
}

static extreme_layout plane_window(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    lay_window_at_crossing(&it, from);
    return it;
}

static const extreme_family plane_families[] = {
    {"in the plane", plane_within, NULL,
     "start and direction lie in the plane: every t is a hit, the first is t_min"},
    {"beside the plane", plane_within, change_to_outside,
     "the same ray moved off the plane by an ulp of one coordinate, and parallel to it"},
    {"nearly parallel", plane_nearly_parallel, NULL,
     "a step to the plane for up to 2^30 along it: met at step t*, or left t* steps ago"},
    {"on surface", plane_start, NULL,
     "the ray starts in the plane: t = 0; or an ulp off it, heading away"},
    {"interval", plane_window, NULL,
     "the only crossing is at t*, and t_max or t_min is t* or the next double"},
    {"far", plane_window, change_to_far, "as interval, started from up to 2^45 further back"},
    {"huge", plane_window, change_to_huge, "as interval, lengths multiplied by 2^640 .. 2^960"},
    {"tiny", plane_window, change_to_tiny, "as interval, lengths multiplied by 2^-1020 .. 2^-700"},
};

const extreme_family_list plane_extremes = EXTREME_FAMILIES(plane_families);

/* The disc. */

static extreme_layout disc_rim(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = (grid_vec){0, it.radius, 0};
    it.direction = draw_slopes(from);
    return it;
}

/* The disc's plane has not moved, nor has the crossing. */
static void change_to_larger_disc(extreme_layout *it, draws *from)
{
    (void)from;
    hit_by_radius(it);
    it->t_known = true;
}

static extreme_layout disc_rim_or_missed(draws *from)
{
    extreme_layout it = disc_rim(from);
    if (kind_of(from, 2) == 1)
        miss_by_radius(&it);
    return it;
}

static extreme_layout disc_edge_tangent(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = (grid_vec){0, it.radius, 0};
    it.direction = (grid_vec){draw_slope(from), 0, 0};
    if (kind_of(from, 2) == 1)
        miss_by_radius(&it);
    return it;
}

static extreme_layout disc_edge_outside(draws *from)
{
    extreme_layout it = lay_edge_on(from);
    start_beside(&it, from);
    miss_by_start(&it);
    return it;
}

static extreme_layout disc_inner(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    it.radius += llabs(it.point.x) + llabs(it.point.y);
    return it;
}

static extreme_layout disc_nearly_parallel(draws *from)
{
    extreme_layout it = disc_inner(from);
    head_nearly_parallel(&it, from);
    return it;
}

static extreme_layout disc_start(draws *from)
{
    extreme_layout it = disc_inner(from);
    start_beside(&it, from);
    lay_start(&it, from);
    return it;
}

static extreme_layout disc_window(draws *from)
{
    extreme_layout it = disc_inner(from);
    lay_window_at_crossing(&it, from);
    return it;
}

static extreme_layout disc_zero(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.radius = 0;
    it.direction = draw_slopes(from);
    it.outward = (grid_vec){0, it.direction.z, -it.direction.y};
    if (kind_of(from, 2) == 1)
        miss_by_start(&it);
    return it;
}

static const extreme_family disc_families[] = {
    {"rim", disc_rim, NULL, "the ray crosses the disc's plane at a point of the rim"},
    {"rim missed", disc_rim, change_to_smaller,
     "the same ray; the radius is an ulp smaller, and the crossing outside"},
    {"rim inside", disc_rim, change_to_larger_disc,
     "the same ray; the radius is an ulp larger, and the same crossing inside"},
    {"edge on", lay_edge_on, NULL,
     "in the disc's plane; the chord begins at (-u, v), u^2 + v^2 = r^2 in integers"},
    {"edge tangent", disc_edge_tangent, NULL,
     "in the disc's plane at distance r: one point; with r an ulp smaller, none"},
    {"edge outside", disc_edge_outside, NULL,
     "edge on, moved off the disc's plane by an ulp of one coordinate, and parallel to it"},
    {"nearly parallel", disc_nearly_parallel, NULL,
     "a step to the plane for up to 2^30 along it: met inside the rim at step t*"},
    {"on surface", disc_start, NULL,
     "the ray starts in the disc: t = 0; or an ulp off its plane, heading away"},
    {"interval", disc_window, NULL,
     "the only crossing is at t*, and t_max or t_min is t* or the next double"},
    {"radius zero", disc_zero, NULL,
     "through the one point; or past it, moved by an ulp across the direction"},
    {"far", disc_rim_or_missed, change_to_far,
     "rim and rim missed in turn, started from up to 2^45 further back"},
    {"huge", disc_rim_or_missed, change_to_huge,
     "rim and rim missed in turn, lengths multiplied by 2^640 .. 2^960"},
    {"tiny", disc_rim_or_missed, change_to_tiny,
     "rim and rim missed in turn, lengths multiplied by 2^-1020 .. 2^-700"},
};

const extreme_family_list disc_extremes = EXTREME_FAMILIES(disc_families);
