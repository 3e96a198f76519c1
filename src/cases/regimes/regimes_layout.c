#include "regimes_layout.h"

#include <math.h>
#include <string.h>

sure_vec3 along(sure_vec3 p, double s, sure_vec3 d)
{
    return (sure_vec3){p.x + s * d.x, p.y + s * d.y, p.z + s * d.z};
}

static sure_vec3 scaled(double k, sure_vec3 v)
{
    return (sure_vec3){k * v.x, k * v.y, k * v.z};
}

static double dot(sure_vec3 a, sure_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* x 2^exponent. */
static double raised(double x, int exponent)
{
    bool normal = exponent >= -1022 && exponent <= 1023;
    return normal ? x * draw_power(exponent) : ldexp(x, exponent);
}

static sure_vec3 turned(const pose *where, sure_vec3 v)
{
    const sure_vec3 *row = where->turn.row;
    return (sure_vec3){dot(row[0], v), dot(row[1], v), dot(row[2], v)};
}

static sure_vec3 placed(const pose *where, double size, sure_vec3 p)
{
    return scaled(size, along(where->move, 1, turned(where, p)));
}

static sure_object placed_object(const layout *lay, const pose *where, double size)
{
    sure_object object = {.shape = lay->shape};
    sure_vec3 middle = placed(where, size, (sure_vec3){0, 0, 0});
    sure_vec3 end = placed(where, size, (sure_vec3){0, 0, lay->h});
    sure_vec3 normal = scaled(raised(1, where->n_scale), turned(where, (sure_vec3){0, 0, 1}));
    double radius = raised(where->stretch * lay->r, where->scale);
    switch (lay->shape) {
    case SURE_SHAPE_PLANE:
        object.as.plane = (sure_plane){middle, normal};
        break;
    case SURE_SHAPE_DISC:
        object.as.disc = (sure_disc){middle, normal, radius};
        break;
    case SURE_SHAPE_SPHERE:
        object.as.sphere = (sure_sphere){middle, radius};
        break;
    case SURE_SHAPE_CYLINDER:
        object.as.cylinder = (sure_cylinder){middle, end, radius};
        break;
    case SURE_SHAPE_CONE:
        object.as.cone = (sure_cone){middle, end, radius};
        break;
    }
    return object;
}

sure_case place(const layout *lay, const pose *where)
{
    sure_vec3 start = along(lay->p, -lay->t, lay->d);
    int t_scale = where->scale - where->d_scale;
    double size = raised(1, where->scale);
    return (sure_case){
        .ray = {.origin = placed(where, size, start),
                .direction = scaled(raised(1, where->d_scale), turned(where, lay->d)),
                .t_min = raised(lay->t_min, t_scale),
                .t_max = raised(lay->t_max, t_scale)},
        .object = placed_object(lay, where, size),
    };
}

static double square_of(const double q[4])
{
    return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
}

pose pose_turned(const double q[4])
{
    double a = q[0], b = q[1], c = q[2], d = q[3];
    sure_mat3 turn = {{
        {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
        {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
        {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d},
    }};
    return (pose){.turn = turn, .stretch = square_of(q)};
}

double draw_whole_size(draws *d)
{
    return draw_chance(d, 1, 4) ? 1 : draw_whole(d, SIZE_BITS);
}

static pose pose_as_in_scenes(draws *d)
{
    double q[4] = {1, 0, 0, 0};
    if (draw_chance(d, 1, 2)) {
        q[0] = draw_integer(d, 0, 3);
        int axis = draw_integer(d, 1, 3);
        q[axis] = draw_integer(d, 1, 3);
    }
    pose where = pose_turned(q);
    where.move.x = draw_offset(d, 4);
    where.move.y = draw_offset(d, 4);
    where.move.z = draw_offset(d, 4);
    where.scale = draw_chance(d, 1, 2) ? 0 : draw_integer(d, -4, 1);
    return where;
}

static void scale_anyhow(pose *where, draws *d)
{
    where->scale = draw_integer(d, -60, 60);
    where->d_scale = draw_integer(d, -60, 60);
    where->n_scale = draw_integer(d, -60, 60);
}

pose pose_exact(draws *d)
{
    if (draw_chance(d, 1, 4))
        return pose_as_in_scenes(d);
    double q[4];
    int bits = draw_integer(d, 4, 6);
    do {
        for (int i = 0; i < 4; i++)
            q[i] = draw_offset(d, bits);
    } while (square_of(q) == 0);
    pose where = pose_turned(q);
    if (!draw_chance(d, 1, 4)) {
        where.move.x = draw_offset(d, 46);
        where.move.y = draw_offset(d, 46);
        where.move.z = draw_offset(d, 46);
    }
    scale_anyhow(&where, d);
    return where;
}

pose pose_exact_far(draws *d)
{
    double q[4];
    do {
        for (int i = 0; i < 4; i++)
            q[i] = draw_integer(d, -3, 3);
    } while (square_of(q) == 0);
    pose where = pose_turned(q);
    where.move.x = draw_offset(d, 36);
    where.move.y = draw_offset(d, 36);
    where.move.z = draw_offset(d, 36);
    scale_anyhow(&where, d);
    return where;
}

static double draw_move(draws *d, int bits)
{
    double sign = draw_sign(d);
    return sign * draw_magnitude(d, -10, bits);
}

pose pose_general(draws *d, int move_bits)
{
    double q[4];
    do {
        for (int i = 0; i < 4; i++)
            q[i] = draw_between(d, -1, 1);
    } while (square_of(q) < 0x1p-4);
    pose where = pose_turned(q);
    for (int i = 0; i < 3; i++)
        where.turn.row[i] = scaled(1 / where.stretch, where.turn.row[i]);
    where.stretch = 1;
    if (!draw_chance(d, 1, 4)) {
        where.move.x = draw_move(d, move_bits);
        where.move.y = draw_move(d, move_bits);
        where.move.z = draw_move(d, move_bits);
    }
    return where;
}

bool is_solid(sure_shape shape)
{
    return shape == SURE_SHAPE_SPHERE || has_axis(shape);
}

bool has_axis(sure_shape shape)
{
    return shape == SURE_SHAPE_CYLINDER || shape == SURE_SHAPE_CONE;
}

bool has_radius(sure_shape shape)
{
    return shape != SURE_SHAPE_PLANE;
}

layout draw_body(sure_shape shape, draws *d, int low, int high)
{
    layout lay = {.shape = shape, .r = draw_magnitude(d, low, high)};
    if (has_axis(shape))
        lay.h = draw_magnitude(d, low, high);
    return lay;
}

static sure_vec3 draw_in_circle(draws *d, double r, double z)
{
    for (;;) {
        double x = draw_between(d, -1, 1);
        double y = draw_between(d, -1, 1);
        double square = x * x + y * y;
        if (square > 0 && square < 1)
            return (sure_vec3){r * x, r * y, z};
    }
}

/* The radius of the body at height f h. */
static double radius_at(const layout *lay, double f)
{
    return lay->shape == SURE_SHAPE_CONE ? lay->r * (1 - f) : lay->r;
}

sure_vec3 draw_inner_point(const layout *lay, draws *d)
{
    if (lay->shape == SURE_SHAPE_SPHERE) {
        double x = draw_between(d, 0, 1);
        double y = draw_between(d, 0, 1);
        /* The larger of two even numbers crowds outwards, nearly as volume does. */
        return scaled(lay->r * fmax(x, y), draw_unit(d));
    }
    double f = has_axis(lay->shape) ? draw_between(d, 0, 1) : 0;
    return draw_in_circle(d, radius_at(lay, f), f * lay->h);
}

static boundary_point draw_wall_point(const layout *lay, draws *d)
{
    bool cone = lay->shape == SURE_SHAPE_CONE;
    double slant = sqrt(lay->h * lay->h + lay->r * lay->r);
    double normal_out = cone ? lay->h / slant : 1, normal_up = cone ? lay->r / slant : 0;
    double f = draw_between(d, 0, 1);
    double r = radius_at(lay, f);
    sure_vec3 out;
    do
        out = draw_in_circle(d, 1, 0);
    while (dot(out, out) < 0x1p-10);
    out = scaled(1 / sqrt(dot(out, out)), out);
    return (boundary_point){{r * out.x, r * out.y, f * lay->h},
                            {normal_out * out.x, normal_out * out.y, normal_up}};
}

boundary_point draw_boundary_point(const layout *lay, draws *d)
{
    if (lay->shape == SURE_SHAPE_SPHERE) {
        sure_vec3 normal = draw_unit(d);
        return (boundary_point){scaled(lay->r, normal), normal};
    }
    if (has_axis(lay->shape) && draw_chance(d, 1, 2))
        return draw_wall_point(lay, d);
    bool top = lay->shape == SURE_SHAPE_CYLINDER && draw_chance(d, 1, 2);
    return (boundary_point){draw_in_circle(d, lay->r, top ? lay->h : 0), {0, 0, top ? 1 : -1}};
}

double reach(const layout *lay)
{
    return sqrt(lay->r * lay->r + lay->h * lay->h);
}

void range_usual(layout *lay, draws *d, double about)
{
    lay->t_min = 0;
    lay->t_max = HUGE_VAL;
    if (draw_chance(d, 3, 4))
        return;
    if (draw_chance(d, 1, 2))
        lay->t_min = about * draw_between(d, 0, 1);
    if (lay->t_min == 0 || draw_chance(d, 1, 2))
        lay->t_max = lay->t_min + about * draw_between(d, 0, 4);
}

void range_at_t(layout *lay, draws *d)
{
    double t = lay->t;
    lay->t_min = 0;
    lay->t_max = HUGE_VAL;
    if (t < 0)
        return;
    switch (draw_integer(d, 0, 11)) {
    case 0:
        lay->t_max = t;
        break;
    case 1:
        lay->t_min = t;
        break;
    case 2:
        lay->t_min = t;
        lay->t_max = t;
        break;
    case 3:
        lay->t_min = t / 2;
        lay->t_max = t * 2;
        break;
    case 4:
    case 5:
        lay->t_max = t > 0 ? step_ulps(t, -1) : 0;
        break;
    case 6:
    case 7:
        lay->t_min = step_ulps(t, 1);
        break;
    default:
        break;
    }
}

double step_ulps(double x, int steps)
{
    /* Sign and magnitude, turned into one order in which -0 and 0 are both 0. */
    int64_t bits, order;
    memcpy(&bits, &x, sizeof bits);
    order = (bits < 0 ? INT64_MIN - bits : bits) + steps;
    bits = order < 0 ? INT64_MIN - order : order;
    memcpy(&x, &bits, sizeof x);
    return x;
}

void nudge(sure_case *c, draws *d)
{
    sure_shape shape = c->object.shape;
    int count = case_numbers(shape), moved;
    double number[CASE_NUMBERS_MAX];
    case_to_numbers(c, number);
    do
        moved = draw_integer(d, 0, count - 1);
    while (!isfinite(number[moved]));
    int steps = draw_integer(d, 1, 4);
    number[moved] = step_ulps(number[moved], draw_chance(d, 1, 2) ? steps : -steps);
    /* What may not be negative moves up from 0 instead. */
    if (moved == AT_T_MIN || (has_radius(shape) && moved == count - 1))
        number[moved] = fabs(number[moved]);
    if (number[AT_T_MAX] < number[AT_T_MIN])
        number[AT_T_MAX] = number[AT_T_MIN];
    *c = case_from_numbers(shape, number);
}
