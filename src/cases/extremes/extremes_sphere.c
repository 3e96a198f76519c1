/* The sphere: centred in the frame; as the frame is turned, one direction stands for all. */
#include "extreme_layout.h"

static extreme_layout sphere_tangent(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = (grid_vec){0, it.radius, 0};
    it.direction = (grid_vec){draw_grid(from, 1, 99), 0, 0};
    return it;
}

static extreme_layout sphere_tangent_or_missed(draws *from)
{
    extreme_layout it = sphere_tangent(from);
    if (kind_of(from, 2) == 1)
        miss_by_radius(&it);
    return it;
}

/* From (-u, v, 0) m to (u, v, 0) m, in whole steps of the direction. */
static extreme_layout sphere_chord(draws *from, grid_vec *leave, int64_t *steps)
{
    extreme_layout it = lay_plain(from);
    triple t = draw_triple(from);
    int64_t step = draw_grid(from, 1, 9);
    int64_t m = step * draw_grid(from, 1, 9);
    it.radius = t.w * m;
    it.point = (grid_vec){-t.u * m, t.v * m, 0};
    it.direction = (grid_vec){step, 0, 0};
    *leave = (grid_vec){t.u * m, t.v * m, 0};
    *steps = 2 * t.u * m / step;
    return it;
}

static extreme_layout sphere_from_inside(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it = sphere_chord(from, &leave, &steps);
    it.point = leave;
    it.at = draw_grid(from, 1, steps - 1);
    return it;
}

static extreme_layout sphere_start(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it = sphere_chord(from, &leave, &steps);
    it.outward = it.point;
    lay_start(&it, from);
    return it;
}

static extreme_layout sphere_window(draws *from)
{
    grid_vec leave;
    int64_t steps;
    extreme_layout it = sphere_chord(from, &leave, &steps);
    lay_window(&it, leave, steps, from);
    return it;
}

static extreme_layout sphere_zero(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.radius = 0;
    it.direction = (grid_vec){draw_grid(from, 1, 99), 0, 0};
    it.outward = (grid_vec){0, 1, 0};
    if (kind_of(from, 2) == 1)
        miss_by_start(&it);
    return it;
}

static const extreme_family sphere_families[] = {
    {"tangent", sphere_tangent, NULL,
     "the line's point nearest to the centre is (0, r, 0), the only one at distance r"},
    {"neighbour outside", sphere_tangent, change_to_smaller,
     "the same ray; the radius is an ulp smaller than the line's distance"},
    {"neighbour inside", sphere_tangent, change_to_larger,
     "the same ray; the radius is an ulp larger than the line's distance"},
    {"from inside", sphere_from_inside, NULL,
     "started on the chord from (-u, v) to (u, v), u^2 + v^2 = r^2: met at its far end"},
    {"on surface", sphere_start, NULL,
     "started where u^2 + v^2 = r^2: t = 0; or an ulp further out, heading away"},
    {"interval", sphere_window, NULL,
     "both crossings are integers, and t_max or t_min is one of them or the next double"},
    {"radius zero", sphere_zero, NULL,
     "through the one point; or past it, moved by an ulp across the direction"},
    {"far", sphere_tangent_or_missed, change_to_far,
     "tangent and neighbour outside in turn, started from up to 2^45 further back"},
    {"huge", sphere_tangent_or_missed, change_to_huge,
     "tangent and neighbour outside in turn, lengths multiplied by 2^640 .. 2^960"},
    {"tiny", sphere_tangent_or_missed, change_to_tiny,
     "tangent and neighbour outside in turn, lengths multiplied by 2^-1020 .. 2^-700"},
};

const extreme_family_list sphere_extremes = EXTREME_FAMILIES(sphere_families);
