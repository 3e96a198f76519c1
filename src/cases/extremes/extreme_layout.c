#include "extreme_layout.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* Draws. */

int64_t draw_grid(draws *from, int64_t lowest, int64_t highest)
{
    return draw_integer(from, (int)lowest, (int)highest);
}

int64_t draw_size(draws *from)
{
    return draw_integer(from, 1, 1000);
}

int64_t draw_side(draws *from)
{
    return (int64_t)draw_sign(from);
}

int64_t draw_slope(draws *from)
{
    int64_t side = draw_side(from);
    return side * draw_integer(from, 1, 99);
}

grid_vec draw_slopes(draws *from)
{
    grid_vec slopes;
    slopes.x = draw_slope(from);
    slopes.y = draw_slope(from);
    slopes.z = draw_slope(from);
    return slopes;
}

grid_vec draw_floor(draws *from)
{
    grid_vec point = {0, 0, 0};
    point.x = draw_integer(from, -999, 999);
    point.y = draw_integer(from, -999, 999);
    return point;
}

int64_t draw_wide(draws *from, int low, int high)
{
    int64_t leading = draw_integer(from, 1 << 14, 1 << 15);
    return leading << draw_integer(from, low - 14, high - 15);
}

triple draw_triple(draws *from)
{
    int64_t p = draw_grid(from, 2, 8);
    int64_t q = draw_grid(from, 1, p - 1);
    int64_t leg[2] = {p * p - q * q, 2 * p * q};
    int first = draw_integer(from, 0, 1);
    return (triple){leg[first], draw_side(from) * leg[1 - first], p * p + q * q};
}

int kind_of(const draws *from, int kinds)
{
    return (int)(from->index % (uint64_t)kinds);
}

/* The grid. */

int64_t grid_dot(grid_vec a, grid_vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

grid_vec grid_times(int64_t factor, grid_vec a)
{
    return (grid_vec){factor * a.x, factor * a.y, factor * a.z};
}

static grid_vec grid_plus(grid_vec a, grid_vec b)
{
    return (grid_vec){a.x + b.x, a.y + b.y, a.z + b.z};
}

static int64_t grid_largest(grid_vec a)
{
    int64_t x = llabs(a.x), y = llabs(a.y), z = llabs(a.z);
    int64_t xy = x > y ? x : y;
    return xy > z ? xy : z;
}

/* Laying out. */

extreme_layout lay_plain(draws *from)
{
    extreme_layout it = {.status = SURE_HIT, .part = SURE_PART_SURFACE, .t_known = true};
    it.turn = 1000;
    it.axis.z = draw_grid(from, 2, 1000);
    it.radius = draw_size(from);
    it.at = (int64_t)draw_whole(from, 10);
    it.scale = draw_integer(from, -40, 40);
    it.stride = draw_integer(from, -40, 40);
    return it;
}

extreme_layout lay_edge_on(draws *from)
{
    extreme_layout it = lay_plain(from);
    triple t = draw_triple(from);
    int64_t m = draw_grid(from, 1, 9);
    it.radius = t.w * m;
    it.point = (grid_vec){-t.u * m, t.v * m, 0};
    it.direction = (grid_vec){draw_grid(from, 1, 9), 0, 0};
    return it;
}

extreme_layout lay_exit_through_base(draws *from)
{
    extreme_layout it = lay_plain(from);
    it.point = draw_floor(from);
    it.direction = draw_slopes(from);
    it.direction.z = -llabs(it.direction.z);
    /* The start is at half the height, where a cone is half as wide as its base. */
    it.axis.z = 2 * it.at * -it.direction.z;
    int64_t sideways = it.at * (llabs(it.direction.x) + llabs(it.direction.y));
    it.radius = 2 * (llabs(it.point.x) + llabs(it.point.y) + sideways) + 1;
    it.part = SURE_PART_BASE;
    return it;
}

void turn_upside_down(extreme_layout *it)
{
    it->point.z = it->axis.z - it->point.z;
    it->direction.z = -it->direction.z;
    it->outward.z = -it->outward.z;
    if (it->part == SURE_PART_BASE)
        it->part = SURE_PART_TOP;
}

void lay_window(extreme_layout *it, grid_vec leave, int64_t chord, const draws *from)
{
    switch (kind_of(from, 6)) {
    case 0:
        it->window = CLOSES_AT;
        break;
    case 1:
        it->window = CLOSES_BEFORE;
        it->status = SURE_MISS;
        break;
    case 2:
        it->window = OPENS_AT;
        break;
    case 3:
        it->window = OPENS_AFTER;
        it->later = chord;
        break;
    case 4:
        it->point = leave;
        it->window = OPENS_AT;
        break;
    default:
        it->point = leave;
        it->window = OPENS_AFTER;
        it->status = SURE_MISS;
        break;
    }
}

void lay_start(extreme_layout *it, draws *from)
{
    it->at = 0;
    it->direction = draw_slopes(from);
    if (kind_of(from, 2) == 0)
        return;
    if (grid_dot(it->direction, it->outward) < 0)
        it->direction = grid_times(-1, it->direction);
    miss_by_start(it);
}

void miss_by_radius(extreme_layout *it)
{
    it->radius_ulps = -1;
    it->status = SURE_MISS;
}

void hit_by_radius(extreme_layout *it)
{
    it->radius_ulps = 1;
    it->t_known = false;
}

void miss_by_start(extreme_layout *it)
{
    it->off_outward = true;
    it->status = SURE_MISS;
}

void change_to_smaller(extreme_layout *it, draws *from)
{
    (void)from;
    miss_by_radius(it);
}

void change_to_larger(extreme_layout *it, draws *from)
{
    (void)from;
    hit_by_radius(it);
}

void change_to_outside(extreme_layout *it, draws *from)
{
    (void)from;
    miss_by_start(it);
}

/* A small turn leaves room for the distance. */
void change_to_far(extreme_layout *it, draws *from)
{
    it->at = draw_wide(from, 20, 45) / grid_largest(it->direction);
    it->turn = 3;
}

static void rescale(extreme_layout *it, int lowest, int highest, draws *from)
{
    it->scale = draw_integer(from, lowest, highest);
    it->stride = draw_chance(from, 1, 2) ? it->scale : 0;
}

void change_to_huge(extreme_layout *it, draws *from)
{
    rescale(it, 640, 960, from);
}

/* One unit of the grid stays a normal number, so that an ulp of a radius is small against it. */
void change_to_tiny(extreme_layout *it, draws *from)
{
    rescale(it, -1020, -700, from);
}

/* Into the world. */

typedef struct {
    grid_vec row[3];
    int64_t factor; /* the matrix is `factor` times a rotation */
} grid_turn;

/* A quaternion of integers gives a matrix of integers M with M^T M = factor^2 I. */
static grid_turn draw_turn(int bound, draws *from)
{
    int64_t a = draw_integer(from, 1, bound);
    int64_t b = draw_integer(from, -bound, bound);
    int64_t c = draw_integer(from, -bound, bound);
    int64_t d = draw_integer(from, -bound, bound);
    return (grid_turn){
        {{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
         {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
         {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}},
        a * a + b * b + c * c + d * d};
}

static grid_vec draw_move(draws *from)
{
    grid_vec move;
    move.x = (int64_t)draw_signed(from, 36);
    move.y = (int64_t)draw_signed(from, 36);
    move.z = (int64_t)draw_signed(from, 36);
    return move;
}

static grid_vec turned(const grid_turn *turn, grid_vec a)
{
    return (grid_vec){grid_dot(turn->row[0], a), grid_dot(turn->row[1], a),
                      grid_dot(turn->row[2], a)};
}

/* integer * 2^exponent: below 2^52, and with exponents that leave room for it, nothing rounds. */
static double exactly(int64_t integer, int exponent)
{
    assert(llabs(integer) < INT64_C(1) << 52);
    assert(exponent >= -1022 && exponent <= 1023 - 52);
    return ldexp((double)integer, exponent);
}

static sure_vec3 exactly_vec(grid_vec a, int exponent)
{
    return (sure_vec3){exactly(a.x, exponent), exactly(a.y, exponent), exactly(a.z, exponent)};
}

static double exact_radius(const extreme_layout *it, int64_t factor)
{
    double radius = exactly(it->radius * factor, it->scale);
    if (it->radius_ulps == 0)
        return radius;
    return nextafter(radius, it->radius_ulps < 0 ? 0 : INFINITY);
}

/* Along the coordinate in which `outward` is largest: outward . p grows. */
static void move_outward(sure_vec3 *p, grid_vec outward)
{
    int64_t largest = grid_largest(outward);
    if (llabs(outward.x) == largest)
        p->x = nextafter(p->x, outward.x > 0 ? INFINITY : -INFINITY);
    else if (llabs(outward.y) == largest)
        p->y = nextafter(p->y, outward.y > 0 ? INFINITY : -INFINITY);
    else
        p->z = nextafter(p->z, outward.z > 0 ? INFINITY : -INFINITY);
}

static void set_window(sure_ray *ray, extreme_window window, double t)
{
    ray->t_min = 0;
    ray->t_max = INFINITY;
    switch (window) {
    case WHOLE_RAY:
        break;
    case CLOSES_AT:
        ray->t_max = t;
        break;
    case CLOSES_BEFORE:
        ray->t_max = nextafter(t, 0);
        break;
    case OPENS_AT:
        ray->t_min = t;
        break;
    case OPENS_AFTER:
        ray->t_min = nextafter(t, INFINITY);
        break;
    }
}

static sure_object object_of(sure_shape shape, sure_vec3 place, sure_vec3 normal, sure_vec3 tip,
                             double radius)
{
    sure_object object = {.shape = shape};
    switch (shape) {
    case SURE_SHAPE_PLANE:
        object.as.plane = (sure_plane){place, normal};
        break;
    case SURE_SHAPE_DISC:
        object.as.disc = (sure_disc){place, normal, radius};
        break;
    case SURE_SHAPE_SPHERE:
        object.as.sphere = (sure_sphere){place, radius};
        break;
    case SURE_SHAPE_CYLINDER:
        object.as.cylinder = (sure_cylinder){place, tip, radius};
        break;
    case SURE_SHAPE_CONE:
        object.as.cone = (sure_cone){place, tip, radius};
        break;
    }
    return object;
}

static sure_object carry_object(sure_shape shape, const extreme_layout *it, const grid_turn *turn,
                                grid_vec move)
{
    grid_vec axis = turned(turn, it->axis);
    return object_of(shape, exactly_vec(move, it->scale), exactly_vec(axis, it->scale),
                     exactly_vec(grid_plus(move, axis), it->scale),
                     exact_radius(it, turn->factor));
}

static sure_ray carry_ray(const extreme_layout *it, const grid_turn *turn, grid_vec move)
{
    grid_vec start = grid_plus(it->point, grid_times(-it->at, it->direction));
    sure_ray ray = {
        .origin = exactly_vec(grid_plus(move, turned(turn, start)), it->scale),
        .direction = exactly_vec(turned(turn, it->direction), it->stride),
    };
    if (it->off_outward)
        move_outward(&ray.origin, turned(turn, it->outward));
    set_window(&ray, it->window, exactly(it->at, it->scale - it->stride));
    return ray;
}

extreme carry_into_world(sure_shape shape, const extreme_layout *it, draws *from)
{
    grid_turn turn = draw_turn(it->turn, from);
    grid_vec move = draw_move(from);
    extreme result = {.status = it->status};
    result.question.ray = carry_ray(it, &turn, move);
    result.question.object = carry_object(shape, it, &turn, move);
    if (it->status != SURE_HIT)
        return result;
    result.part = it->part;
    result.t_known = it->t_known;
    if (it->t_known)
        result.t = exactly(it->at + it->later, it->scale - it->stride);
    return result;
}
