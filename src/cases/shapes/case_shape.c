#include "case_shape.h"

#include <math.h>

#define DECLARE(name, NAME) extern const case_shape case_##name;
#define ROW(name, NAME) [SURE_SHAPE_##NAME] = &case_##name,
SURE_EACH_SHAPE(DECLARE)
static const case_shape *const rows[SURE_SHAPES] = {SURE_EACH_SHAPE(ROW)};

const case_shape *case_shape_of(sure_shape shape)
{
    return rows[shape];
}

bool case_shape_has(sure_shape shape, unsigned what)
{
    unsigned inside = sure_shape_info_of(shape)->solid ? CASE_HAS_INSIDE : 0;
    return (what & ~(rows[shape]->has | inside)) == 0;
}

sure_mat3 turn_any(const double q[4])
{
    double a = q[0], b = q[1], c = q[2], d = q[3];
    return (sure_mat3){{
        {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
        {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
        {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d},
    }};
}

void points_on_axis(const layout *lay, sure_vec3 point[2])
{
    point[0] = (sure_vec3){0, 0, 0};
    point[1] = (sure_vec3){0, 0, lay->h};
}

double reach_of_rim(const layout *lay)
{
    return sqrt(lay->r * lay->r + lay->h * lay->h);
}

void mend_radius(sure_shape shape, double *object)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    for (int i = 0; i < info->field_count; i++) {
        double *number = object + info->fields[i].at;
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            *number = fabs(*number);
    }
}

/* Points and directions that are drawn. */

sure_vec3 draw_in_circle(draws *d, double r, double z)
{
    for (;;) {
        double x = draw_between(d, -1, 1);
        double y = draw_between(d, -1, 1);
        double square = x * x + y * y;
        if (square > 0 && square < 1)
            return (sure_vec3){r * x, r * y, z};
    }
}

sure_vec3 draw_on_circle(draws *d)
{
    sure_vec3 out;
    double square;
    do {
        out = draw_in_circle(d, 1, 0);
        square = out.x * out.x + out.y * out.y;
    } while (square < 0x1p-10);
    return scaled(1 / sqrt(square), out);
}

sure_vec3 draw_in_base(const layout *lay, draws *d)
{
    return draw_in_circle(d, lay->r, 0);
}

static bool draw_is_top(const layout *lay, draws *d)
{
    return case_shape_has(lay->shape, CASE_HAS_TWO_CAPS) && draw_chance(d, 1, 2);
}

double draw_cap(const layout *lay, draws *d)
{
    return draw_is_top(lay, d) ? lay->h : 0;
}

boundary_point draw_cap_point(const layout *lay, draws *d)
{
    bool top = draw_is_top(lay, d);
    return (boundary_point){draw_in_circle(d, lay->r, top ? lay->h : 0), {0, 0, top ? 1 : -1}};
}

void tangent_at_rim(layout *lay, draws *d)
{
    lay->r = draw_whole_size(d);
    lay->p.x = lay->r;
    lay->d.y = draw_signed(d, WAY_BITS);
}

double draw_side_height(double h, draws *d)
{
    switch (draw_integer(d, 0, 7)) {
    case 0: return 0;
    case 1: return h;
    case 2: return -draw_whole(d, SIZE_BITS);
    case 3: return h + draw_whole(d, SIZE_BITS);
    default: return floor(draw_between(d, 0, h));
    }
}

double draw_within(double r, draws *d)
{
    return draw_chance(d, 1, 8) ? r : floor(draw_between(d, 0, r));
}

void surface_cap(layout *lay, bool unused, draws *d)
{
    (void)unused;
    lay->p.x = draw_within(lay->r, d);
    lay->p.z = draw_cap(lay, d);
}

/* A boundary point that is entered. */

sure_vec3 draw_entering(draws *d, sure_vec3 outwards)
{
    for (;;) {
        sure_vec3 v = draw_whole_vector(d, 2);
        double along_normal = v.x * outwards.x + v.y * outwards.y + v.z * outwards.z;
        if (along_normal != 0)
            return scaled(along_normal < 0 ? 1 : -1, v);
    }
}

void enter_flat(layout *lay, bool top, double x, draws *d)
{
    lay->p.x = x;
    lay->p.z = top ? lay->h : 0;
    lay->d = draw_entering(d, (sure_vec3){0, 0, top ? 1 : -1});
}

void enter_cap(layout *lay, draws *d)
{
    bool top = draw_is_top(lay, d);
    enter_flat(lay, top, floor(draw_between(d, 0, lay->r)), d);
}

void enter_side(layout *lay, draws *d)
{
    lay->p.x = lay->r;
    lay->p.z = floor(draw_between(d, 0, lay->h));
    lay->d = draw_entering(d, (sure_vec3){1, 0, 0});
}

/* Where a ray crosses, as double finds it. */

static void add_crossing(crossings *all, double t)
{
    if (t > 0)
        all->t[all->count++] = t;
}

void cross_flat(crossings *all, const layout *lay, double height)
{
    if (lay->d.z == 0)
        return;
    double t = (height - lay->p.z) / lay->d.z;
    sure_vec3 at = along(lay->p, t, lay->d);
    if (case_shape_has(lay->shape, CASE_HAS_NO_END) || at.x * at.x + at.y * at.y <= lay->r * lay->r)
        add_crossing(all, t);
}

void cross_base(crossings *all, const layout *lay)
{
    cross_flat(all, lay, 0);
}

static void cross_side(crossings *all, const layout *lay, double t)
{
    double z = lay->p.z + t * lay->d.z;
    if (!case_shape_has(lay->shape, CASE_HAS_FLAT) || (z >= 0 && z <= lay->h))
        add_crossing(all, t);
}

void cross_round(crossings *all, const layout *lay, double a, double half_b, double c)
{
    double discriminant = half_b * half_b - a * c;
    if (discriminant < 0)
        return;
    double far = half_b < 0 ? sqrt(discriminant) - half_b : -sqrt(discriminant) - half_b;
    if (a != 0)
        cross_side(all, lay, far / a);
    cross_side(all, lay, c / far);
}

across across_axis(const layout *lay)
{
    sure_vec3 o = lay->p, d = lay->d;
    return (across){d.x * d.x + d.y * d.y, o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y};
}
