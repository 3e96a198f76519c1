#include <math.h>

#include "case_shape.h"

/* The larger of two even numbers crowds outwards, nearly as volume does. */
static sure_vec3 inner(const layout *lay, draws *d)
{
    double x = draw_between(d, 0, 1);
    double y = draw_between(d, 0, 1);
    double out = lay->r * fmax(x, y);
    return scaled(out, draw_unit(d));
}

static boundary_point boundary(const layout *lay, draws *d)
{
    sure_vec3 normal = draw_unit(d);
    return (boundary_point){scaled(lay->r, normal), normal};
}

static void tangent(layout *lay, draws *d)
{
    lay->r = draw_whole_size(d);
    lay->p.x = lay->r;
    lay->d.y = draw_offset(d, WAY_BITS);
    lay->d.z = lay->d.y == 0 ? draw_signed(d, WAY_BITS) : draw_offset(d, WAY_BITS);
}

static void surface(layout *lay, bool side, draws *d)
{
    (void)side;
    (void)d;
    lay->p.x = lay->r;
}

static void cross(crossings *all, const layout *lay)
{
    across xy = across_axis(lay);
    double o = lay->p.z, d = lay->d.z;
    cross_round(all, lay, xy.dd + d * d, xy.od + o * d, xy.oo + o * o - lay->r * lay->r);
}

const case_shape case_sphere = {
    CASE_ON_AXIS,         .inner = inner,
    .boundary = boundary, .tangent = tangent,
    .surface = surface,   .enter = enter_side,
    .cross = cross,       .small_objects = 4 * SMALL_VECTORS, /* radii 0 .. 3 */
};
