/* The cylinder: in the frame, from the base around (0, 0, 0) to the top around (0, 0, h). What is
 * laid out at the base happens at the top in half of the members. */
#include "extreme_layout.h"

#include <stdlib.h>

static void take_either_end(extreme_layout *it, draws *from)
{
    if (draw_chance(from, 1, 2))
        turn_upside_down(it);
}

static extreme_layout cylinder_tangent(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = (grid_vec){0, it.radius, draw_grid(from, 1, it.axis.z - 1)};
    it.direction.x = draw_slope(from);
    it.direction.z = draw_grid(from, -9, 9);
    it.part = SURE_PART_WALL;
    return it;
}

/* (a, b, c), b and c > 0, is in the plane c y - b z = c r, which the solid touches at (0, r, 0). */
static extreme_layout cylinder_rim(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = (grid_vec){0, it.radius, 0};
    it.direction = draw_slopes(from);
    it.direction.y = llabs(it.direction.y);
    it.direction.z = llabs(it.direction.z);
    it.direction = grid_times(draw_side(from), it.direction);
    it.part = SURE_PART_BASE;
    take_either_end(&it, from);
    return it;
}

static extreme_layout cylinder_tangent_or_missed(draws *from)
{
    extreme_layout it = cylinder_tangent(from);
    if (kind_of(from, 2) == 1)
        miss_by_radius(&it);
    return it;
}

static extreme_layout cylinder_touch_or_missed(draws *from)
{
    extreme_layout it = kind_of(from, 4) < 2 ? cylinder_tangent(from) : cylinder_rim(from);
    if (kind_of(from, 2) == 1)
        miss_by_radius(&it);
    return it;
}

static extreme_layout cylinder_along_wall(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = (grid_vec){0, it.radius, 0};
    it.direction = (grid_vec){0, 0, draw_grid(from, 1, 99)};
    it.part = SURE_PART_BASE;
    take_either_end(&it, from);
    return it;
}

static extreme_layout cylinder_nearly_parallel(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    it.radius += llabs(it.point.x) + llabs(it.point.y);
    it.direction = (grid_vec){1, 0, draw_wide(from, 20, 30)};
    it.turn = 8;
    it.part = SURE_PART_BASE;
    take_either_end(&it, from);
    return it;
}

static extreme_layout cylinder_edge_on(draws *from)
{
    extreme_layout it = lay_edge_on(from);
    it.part = SURE_PART_BASE;
    take_either_end(&it, from);
    return it;
}

/* From (-u, v) m to (u, v) m, in whole steps that climb or fall, far from both ends. */
static extreme_layout cylinder_chord(draws *from, grid_vec *leave, int64_t *steps)
{
    extreme_layout it = lay_plain(from);
    triple t = draw_triple(from);
    int64_t step = draw_grid(from, 1, 9);
    int64_t m = step * draw_grid(from, 1, 9);
    int64_t climb = draw_grid(from, -2, 2);
    *steps = 2 * t.u * m / step;
    it.axis.z += 4 * *steps + 2;
    it.radius = t.w * m;
    it.point = (grid_vec){-t.u * m, t.v * m, it.axis.z / 2};
    it.direction = (grid_vec){step, 0, climb};
    it.part = SURE_PART_WALL;
    *leave = (grid_vec){t.u * m, t.v * m, it.point.z + climb * *steps};
    return it;
}

static extreme_layout cylinder_from_inside(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it;
    if (kind_of(from, 2) == 0) {
        it = cylinder_chord(from, &leave, &steps);
        it.point = leave;
        it.at = draw_grid(from, 1, steps - 1);
    } else {
        it = lay_exit_through_base(from);
        take_either_end(&it, from);
    }
    return it;
}

static extreme_layout cylinder_start(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it = cylinder_chord(from, &leave, &steps);
    it.outward = (grid_vec){it.point.x, it.point.y, 0};
    switch (draw_integer(from, 0, 2)) {
    case 0: /* on the wall */
        break;
    case 1: /* on the rim */
        it.point.z = 0;
        it.outward.z = -it.radius;
        it.part = SURE_PART_BASE;
        break;
    default: /* in the base */
        it.point = (grid_vec){it.point.x / 2, it.point.y / 2, 0};
        it.outward = (grid_vec){0, 0, -1};
        it.part = SURE_PART_BASE;
        break;
    }
    take_either_end(&it, from);
    lay_start(&it, from);
    return it;
}

static extreme_layout cylinder_window(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it = cylinder_chord(from, &leave, &steps);
    lay_window(&it, leave, steps, from);
    return it;
}

static extreme_layout cylinder_zero(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.radius = 0;
    if (draw_chance(from, 1, 2)) { /* across the segment */
        it.point.z = draw_grid(from, 1, it.axis.z - 1);
        it.direction = draw_slopes(from);
        it.outward = (grid_vec){-it.direction.y, it.direction.x, 0};
        it.part = SURE_PART_WALL;
    } else { /* along it */
        it.direction = (grid_vec){0, 0, draw_grid(from, 1, 99)};
        it.outward = (grid_vec){1, 0, 0};
        it.part = SURE_PART_BASE;
        take_either_end(&it, from);
    }
    if (kind_of(from, 2) == 1)
        miss_by_start(&it);
    return it;
}

static const extreme_family cylinder_families[] = {
    {"tangent", cylinder_tangent, NULL,
     "the line's point nearest to the axis is (0, r, z), 0 < z < h: no other is at distance r"},
    {"neighbour outside", cylinder_tangent, change_to_smaller,
     "the same ray; the radius is an ulp smaller than the line's distance from the axis"},
    {"neighbour inside", cylinder_tangent, change_to_larger,
     "the same ray; the radius is an ulp larger, the crossing still between the caps"},
    {"rim", cylinder_rim, NULL,
     "in a plane that touches the solid in one point of a rim, through that point"},
    {"rim missed", cylinder_rim, change_to_smaller,
     "the same ray; the radius is an ulp smaller, and the solid short of that plane"},
    {"along the wall", cylinder_along_wall, NULL,
     "parallel to the axis at distance r: first at the rim of the cap that comes first"},
    {"beside the wall", cylinder_along_wall, change_to_smaller,
     "the same ray; the radius is an ulp smaller than the distance from the axis"},
    {"nearly parallel", cylinder_nearly_parallel, NULL,
     "a step aside for up to 2^30 along the axis, from beyond a cap: met in it at step t*"},
    {"edge on", cylinder_edge_on, NULL,
     "in a cap's plane; the chord begins at (-u, v), u^2 + v^2 = r^2 in integers"},
    {"from inside", cylinder_from_inside, NULL,
     "started inside, towards an integer point of the wall or of a cap"},
    {"on surface", cylinder_start, NULL,
     "started on wall, rim or cap: t = 0; or an ulp further out, heading away"},
    {"interval", cylinder_window, NULL,
     "both crossings are integers, and t_max or t_min is one of them or the next double"},
    {"radius zero", cylinder_zero, NULL,
     "across the segment or along it; or past it, moved by an ulp across both"},
    {"far", cylinder_tangent_or_missed, change_to_far,
     "tangent and neighbour outside in turn, started from up to 2^45 further back"},
    {"huge", cylinder_touch_or_missed, change_to_huge,
     "tangent, rim and their misses in turn, lengths multiplied by 2^640 .. 2^960"},
    {"tiny", cylinder_touch_or_missed, change_to_tiny,
     "tangent, rim and their misses in turn, lengths multiplied by 2^-1020 .. 2^-700"},
};

const extreme_family_list cylinder_extremes = EXTREME_FAMILIES(cylinder_families);
