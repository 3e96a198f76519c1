/* The cone: in the frame, from the base around (0, 0, 0) to the apex (0, 0, h). It is the hull of
 * base disc and apex, so those two tell on which side of a plane it is. */
#include "extreme_layout.h"

#include <stdlib.h>

/* A generator is m equal steps, each `run` across and `rise` up: r = m run, h = m rise. */
typedef struct {
    int64_t m, run, rise;
} generator;

/* `run` is a multiple of `factor`. */
static extreme_layout cone_plain(int64_t factor, generator *g, draws *from)
{
    extreme_layout it = lay_plain(from);
    g->m = draw_grid(from, 2, 16);
    g->run = factor * draw_grid(from, 1, 30);
    g->rise = draw_grid(from, 1, 60);
    it.radius = g->m * g->run;
    it.axis.z = g->m * g->rise;
    it.part = SURE_PART_WALL;
    return it;
}

/* The direction lies in the tangent plane along x = 0, y > 0, across that generator. */
static extreme_layout cone_tangent(draws *from)
{
    generator g;
    extreme_layout it = cone_plain(1, &g, from);
    int64_t up = draw_grid(from, 1, g.m - 1);
    int64_t along = draw_grid(from, -3, 3);
    it.point = (grid_vec){0, (g.m - up) * g.run, up * g.rise};
    it.direction = (grid_vec){draw_slope(from), -along * g.run, along * g.rise};
    return it;
}

/* In the plane h y + (r - b) z = h r, b > 0: of base disc and apex only (0, r, 0) is not below. */
static extreme_layout cone_rim(draws *from)
{
    generator g;
    extreme_layout it = cone_plain(1, &g, from);
    it.point = (grid_vec){0, it.radius, 0};
    it.direction.x = draw_slope(from);
    it.direction.y = it.radius - draw_size(from);
    it.direction.z = -it.axis.z;
    it.direction = grid_times(draw_side(from), it.direction);
    it.part = SURE_PART_BASE;
    return it;
}

static extreme_layout cone_tangent_or_missed(draws *from)
{
    extreme_layout it = cone_tangent(from);
    if (kind_of(from, 2) == 1)
        miss_by_radius(&it);
    return it;
}

static extreme_layout cone_touch_or_missed(draws *from)
{
    extreme_layout it = kind_of(from, 4) < 2 ? cone_tangent(from) : cone_rim(from);
    if (kind_of(from, 2) == 1)
        miss_by_radius(&it);
    return it;
}

/* In the plane a y + b z = b h, b rise > a run >= 0: all of the base disc is below. */
static extreme_layout cone_apex(draws *from)
{
    generator g;
    extreme_layout it = cone_plain(1, &g, from);
    int64_t a = draw_grid(from, 0, 9);
    int64_t b = a * g.run / g.rise + draw_grid(from, 1, 9);
    it.point = it.axis;
    it.direction = (grid_vec){draw_grid(from, -9, 9), b, -a};
    it.direction = grid_times(draw_side(from), it.direction);
    it.outward = (grid_vec){0, a, b};
    return it;
}

static extreme_layout cone_generator(draws *from)
{
    generator g;
    extreme_layout it = cone_plain(1, &g, from);
    int64_t step = draw_grid(from, 1, 9);
    it.direction = (grid_vec){0, step * g.run, -step * g.rise};
    switch (kind_of(from, 3)) {
    case 0: /* from beyond the apex */
        it.point = it.axis;
        break;
    case 1: /* from beyond the rim */
        it.direction = grid_times(-1, it.direction);
        it.point = (grid_vec){0, it.radius, 0};
        it.part = SURE_PART_BASE;
        break;
    default: /* from the wall */
        it.point = (grid_vec){0, g.run, (g.m - 1) * g.rise};
        it.at = 0;
        break;
    }
    return it;
}

static extreme_layout cone_generator_shrunk(draws *from)
{
    generator g;
    extreme_layout it = cone_plain(1, &g, from);
    int64_t step = draw_slope(from);
    it.direction = (grid_vec){0, step * g.run, -step * g.rise};
    it.point = it.axis;
    it.radius_ulps = -1;
    return it;
}

/* Down along the generator at (0, 1) into the wall at (u, v) / w; or up along it into the base. */
static extreme_layout cone_wall_parallel(draws *from)
{
    generator g;
    triple t = draw_triple(from);
    extreme_layout it = cone_plain(t.w, &g, from);
    int64_t step = draw_grid(from, 1, 9);
    int64_t up = draw_grid(from, 1, g.m - 1);
    int64_t circle = (g.m - up) * g.run / t.w;
    it.direction = (grid_vec){0, step * g.run, -step * g.rise};
    it.point = (grid_vec){t.u * circle, t.v * circle, up * g.rise};
    if (kind_of(from, 2) == 1) {
        it.direction = grid_times(-1, it.direction);
        it.point.z = 0;
        it.part = SURE_PART_BASE;
    }
    return it;
}

static extreme_layout cone_beside_wall(draws *from)
{
    generator g;
    extreme_layout it = cone_plain(1, &g, from);
    int64_t step = draw_slope(from);
    int64_t up = draw_grid(from, 1, g.m - 1);
    it.direction = (grid_vec){0, step * g.run, -step * g.rise};
    it.point = (grid_vec){0, (g.m - up) * g.run, up * g.rise};
    it.outward = (grid_vec){0, g.rise, g.run};
    it.status = SURE_MISS;
    if (kind_of(from, 2) == 0)
        it.point.x = draw_slope(from);
    else
        miss_by_start(&it);
    return it;
}

static extreme_layout cone_nearly_parallel(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    it.radius += llabs(it.point.x) + llabs(it.point.y);
    it.direction = (grid_vec){1, 0, draw_wide(from, 20, 30)};
    it.turn = 8;
    it.part = SURE_PART_BASE;
    return it;
}

static extreme_layout cone_edge_on(draws *from)
{
    extreme_layout it = lay_edge_on(from);
    it.part = SURE_PART_BASE;
    return it;
}

/* Level, from (-u, v) to (u, v) on the wall's circle at one of the m - 1 inner steps. */
static extreme_layout cone_chord(draws *from, grid_vec *leave, int64_t *steps)
{
    generator g;
    triple t = draw_triple(from);
    int64_t step = draw_grid(from, 1, 9);
    extreme_layout it = cone_plain(t.w * step, &g, from);
    int64_t up = draw_grid(from, 1, g.m - 1);
    int64_t circle = (g.m - up) * g.run / t.w;
    it.point = (grid_vec){-t.u * circle, t.v * circle, up * g.rise};
    it.direction = (grid_vec){step, 0, 0};
    it.outward = (grid_vec){-t.u * g.rise, t.v * g.rise, t.w * g.run};
    *leave = (grid_vec){t.u * circle, t.v * circle, up * g.rise};
    *steps = 2 * t.u * circle / step;
    return it;
}

static extreme_layout cone_from_inside(draws *from)
{
    grid_vec leave;
    int64_t steps;
    if (kind_of(from, 2) == 1)
        return lay_exit_through_base(from);
    extreme_layout it = cone_chord(from, &leave, &steps);
    it.point = leave;
    it.at = draw_grid(from, 1, steps - 1);
    return it;
}

static extreme_layout cone_start(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it = cone_chord(from, &leave, &steps);
    switch (draw_integer(from, 0, 3)) {
    case 0: /* on the wall */
        break;
    case 1: /* on the rim */
        it.point = (grid_vec){0, it.radius, 0};
        it.outward = (grid_vec){0, 1, -1};
        it.part = SURE_PART_BASE;
        break;
    case 2: /* in the base */
        it.point.z = 0;
        it.outward = (grid_vec){0, 0, -1};
        it.part = SURE_PART_BASE;
        break;
    default: /* at the apex */
        it.point = it.axis;
        it.outward = (grid_vec){0, 0, 1};
        break;
    }
    lay_start(&it, from);
    return it;
}

static extreme_layout cone_window(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it = cone_chord(from, &leave, &steps);
    lay_window(&it, leave, steps, from);
    return it;
}

static extreme_layout cone_zero(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.radius = 0;
    it.part = SURE_PART_WALL;
    switch (draw_integer(from, 0, 2)) {
    case 0: /* across the segment */
        it.point.z = draw_grid(from, 1, it.axis.z);
        it.direction = draw_slopes(from);
        it.outward = (grid_vec){-it.direction.y, it.direction.x, 0};
        break;
    case 1: /* along it, up */
        it.direction = (grid_vec){0, 0, draw_grid(from, 1, 99)};
        it.outward = (grid_vec){1, 0, 0};
        it.part = SURE_PART_BASE;
        break;
    default: /* along it, down */
        it.point = it.axis;
        it.direction = (grid_vec){0, 0, -draw_grid(from, 1, 99)};
        it.outward = (grid_vec){1, 0, 0};
        break;
    }
    if (kind_of(from, 2) == 1)
        miss_by_start(&it);
    return it;
}

static const extreme_family cone_families[] = {
    {"tangent", cone_tangent, NULL,
     "in the tangent plane along a generator, across it between rim and apex"},
    {"neighbour outside", cone_tangent, change_to_smaller,
     "the same ray; the radius is an ulp smaller, and only the apex left in that plane"},
    {"neighbour inside", cone_tangent, change_to_larger,
     "the same ray; the radius is an ulp larger, the crossing still between rim and apex"},
    {"rim", cone_rim, NULL,
     "in a plane that touches the solid in one point of the rim, through that point"},
    {"rim missed", cone_rim, change_to_smaller,
     "the same ray; the radius is an ulp smaller, and the solid short of that plane"},
    {"apex", cone_apex, NULL,
     "in a plane that touches the solid in the apex only, through the apex"},
    {"apex missed", cone_apex, change_to_outside,
     "the same ray moved out of that plane by an ulp of one coordinate, parallel to it"},
    {"generator", cone_generator, NULL,
     "along a generator, which is all boundary: first at the apex, the rim or the start"},
    {"generator shrunk", cone_generator_shrunk, NULL,
     "the same line; the radius is an ulp smaller, and only the apex left on it"},
    {"wall parallel", cone_wall_parallel, NULL,
     "parallel to a generator, so once through the wall, at (u, v) / w, and through the base"},
    {"beside the wall", cone_beside_wall, NULL,
     "parallel to a generator, beside it in its tangent plane or an ulp outside that plane"},
    {"nearly parallel", cone_nearly_parallel, NULL,
     "a step aside for up to 2^30 along the axis, from below: met in the base at step t*"},
    {"edge on", cone_edge_on, NULL,
     "in the base's plane; the chord begins at (-u, v), u^2 + v^2 = r^2 in integers"},
    {"from inside", cone_from_inside, NULL,
     "started inside, towards an integer point of the wall or of the base"},
    {"on surface", cone_start, NULL,
     "started on wall, rim, base or apex: t = 0; or an ulp further out, heading away"},
    {"interval", cone_window, NULL,
     "both crossings are integers, and t_max or t_min is one of them or the next double"},
    {"radius zero", cone_zero, NULL,
     "across the segment or along it; or past it, moved by an ulp across both"},
    {"far", cone_tangent_or_missed, change_to_far,
     "tangent and neighbour outside in turn, started from up to 2^45 further back"},
    {"huge", cone_touch_or_missed, change_to_huge,
     "tangent, rim and their misses in turn, lengths multiplied by 2^640 .. 2^960"},
    {"tiny", cone_touch_or_missed, change_to_tiny,
     "tangent, rim and their misses in turn, lengths multiplied by 2^-1020 .. 2^-700"},
};

const extreme_family_list cone_extremes = EXTREME_FAMILIES(cone_families);
