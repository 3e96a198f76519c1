/* SPDX-License-Identifier: MIT */
#include "shape_bytes.h"

#include "case_shape.h"

enum { SECOND = AT_OBJECT + 3 };

/* So many powers of two between the largest and the smallest number cost little. */
enum { NARROW = 256 };

/* A program is a layout in whole numbers: the object stands at the origin, its axis along z, and
 * the ray passes p at t. All of it is exact: the largest number is below 2^40. */

/* The side: the direction of its generator in the xz plane, upwards, and the number of steps from
 * rim to apex, so that whole numbers lie on it. */
typedef struct {
    int parts;
    sure_vec3 generator;
} side;

static side read_sizes(fuzz_bytes *bytes, layout *lay)
{
    side s = {.parts = 1 + fuzz_byte(bytes) % 16};
    double inwards = fuzz_byte(bytes) % 16;
    double upwards = 1 + fuzz_byte(bytes) % 16;
    lay->r = s.parts * inwards;
    lay->h = s.parts * upwards;
    bool narrows = case_shape_has(lay->shape, CASE_HAS_APEX);
    s.generator = (sure_vec3){narrows ? -inwards : 0, 0, upwards};
    return s;
}

/* On the side, or on its continuation below the base and beyond the top or apex. */
static sure_vec3 on_side(const layout *lay, const side *s, double j)
{
    return sum_of((sure_vec3){lay->r, 0, 0}, j, s->generator);
}

/* 0..radius, both often. */
static double read_within(fuzz_bytes *bytes, double radius)
{
    double x = fuzz_byte(bytes);
    return x < radius ? x : radius;
}

static sure_vec3 read_point(fuzz_bytes *bytes, const layout *lay, const side *s)
{
    switch (fuzz_byte(bytes) % 8) {
    case 0: return fuzz_vector(bytes, fuzz_signed);
    case 1: return on_side(lay, s, fuzz_byte(bytes) % (s->parts + 1));
    case 2: return on_side(lay, s, fuzz_signed(bytes));
    case 3: return (sure_vec3){lay->r, 0, 0};
    case 4: return (sure_vec3){0, 0, lay->h};
    case 5: return (sure_vec3){read_within(bytes, lay->r), 0, 0};
    case 6: return (sure_vec3){read_within(bytes, lay->r), 0, lay->h};
    default: return (sure_vec3){0, 0, fuzz_signed(bytes)};
    }
}

static sure_vec3 read_direction(fuzz_bytes *bytes, const sure_vec3 *g)
{
    uint8_t kind = fuzz_byte(bytes);
    double u = fuzz_signed(bytes), v = fuzz_signed(bytes);
    switch (kind % 8) {
    case 0: return (sure_vec3){u, v, fuzz_signed(bytes)};
    case 1: return (sure_vec3){v * g->x, u, v * g->z}; /* touches the side at y = 0 */
    case 2: return scaled(u, *g);
    case 3: return (sure_vec3){-u * g->x, 0, u * g->z}; /* along the generator across */
    case 4: return (sure_vec3){0, 0, u};
    case 5: return (sure_vec3){u, v, 0};
    case 6: return (sure_vec3){0, u, v};
    default: return (sure_vec3){0, u, 0};
    }
}

static layout read_layout(fuzz_bytes *bytes, sure_shape shape)
{
    layout lay = {.shape = shape};
    side s = read_sizes(bytes, &lay);
    lay.p = read_point(bytes, &lay, &s);
    lay.d = read_direction(bytes, &s.generator);
    lay.t = fuzz_signed(bytes);
    return lay;
}

static int read_scale(fuzz_bytes *bytes, bool far)
{
    int scale = (int8_t)fuzz_byte(bytes);
    return far ? 8 * scale : scale / 4;
}

/* By a quaternion of whole numbers, but often not turned at all. */
static pose read_pose(fuzz_bytes *bytes, sure_shape shape)
{
    static const double unturned[4] = {1};
    uint8_t first = fuzz_byte(bytes), second = fuzz_byte(bytes);
    double q[4] = {first % 16, first / 16 - 8, second % 16 - 8, second / 16 - 8};
    pose p = pose_turned(shape, first == 0 ? unturned : q);
    uint8_t sizes = fuzz_byte(bytes);
    p.move = scaled(ldexp(1, sizes / 8), fuzz_vector(bytes, fuzz_signed));
    p.scale = read_scale(bytes, sizes & 1);
    p.d_scale = read_scale(bytes, sizes & 2);
    p.n_scale = read_scale(bytes, sizes & 4);
    return p;
}

/* Open, or ending at the t of the point, or anything. */
static void put_range(sure_ray *ray, fuzz_bytes *bytes, double t)
{
    ray->t_min = 0;
    ray->t_max = INFINITY;
    switch (fuzz_byte(bytes) % 8) {
    case 0: ray->t_min = t; break;
    case 1: ray->t_max = t; break;
    case 2: ray->t_min = ray->t_max = t; break;
    case 3:
        ray->t_min = fuzz_shaped_double(bytes);
        ray->t_max = fuzz_shaped_double(bytes);
        break;
    default: break;
    }
}

/* Up to three numbers from `first` on by a few doubles. */
static void move_some(fuzz_bytes *bytes, sure_case *question, int first)
{
    int count = case_numbers(question->object.shape) - first;
    for (int times = fuzz_byte(bytes) % 4; times > 0; times--) {
        double *x = case_number(question, first + fuzz_byte(bytes) % count);
        int8_t by = (int8_t)fuzz_byte(bytes);
        *x = by == INT8_MIN ? fuzz_shaped_double(bytes) : fuzz_ulps(*x, by);
    }
}

static sure_case run_program(fuzz_bytes *bytes, sure_shape shape)
{
    layout lay = read_layout(bytes, shape);
    pose where = read_pose(bytes, shape);
    sure_case placed = place(&lay, &where);
    put_range(&placed.ray, bytes, ldexp(lay.t, where.scale - where.d_scale));
    move_some(bytes, &placed, 0);
    return placed;
}

bool fuzz_case(fuzz_bytes *bytes, sure_shape shape, sure_case *question)
{
    uint8_t how = fuzz_byte(bytes);
    *question = (sure_case){.object.shape = shape};
    if (how % 4 >= 2)
        *question = run_program(bytes, shape);
    for (int i = 0; i < case_numbers(shape) && how % 4 < 2; i++)
        *case_number(question, i) = how % 4 == 0 ? fuzz_double(bytes) : fuzz_shaped_double(bytes);
    /* A program may leave its end to zeros. */
    return !bytes->short_of || how % 4 >= 2;
}

static bool is_hit(const sure_case *question, sure_tier tier, sure_hit *hit)
{
    return sure_object_hit(&question->ray, &question->object, tier, hit) == SURE_HIT;
}

/* Numbers instead of what is none, and a radius that is not negative. */
static void mend(sure_case *question)
{
    for (int i = 0; i < case_numbers(question->object.shape); i++) {
        double *x = case_number(question, i);
        *x = isfinite(*x) ? *x : i + 1;
    }
    question->ray.t_min = 0;
    question->ray.t_max = INFINITY;
    object_mend(question->object.shape, case_number(question, AT_OBJECT));
}

bool fuzz_hit(sure_case *question, sure_tier tier, sure_hit *hit)
{
    if (is_hit(question, tier, hit))
        return true;
    mend(question);
    if (is_hit(question, tier, hit))
        return true;
    for (int i = 0; i < 3; i++)
        *case_number(question, AT_D + i) =
            *case_number(question, AT_OBJECT + i) - *case_number(question, AT_O + i);
    return is_hit(question, tier, hit);
}

/* Exponents an eighth as large. */
void fuzz_cheapen(sure_case *question, uint64_t *draws)
{
    if (fuzz_drawn(draws, fuzz_cost(question)))
        return;
    for (int i = 0; i < case_numbers(question->object.shape); i++) {
        int exponent;
        double *x = case_number(question, i), digits = frexp(*x, &exponent);
        *x = isfinite(*x) ? ldexp(digits, exponent / 8) : *x;
    }
}

sure_object fuzz_plane_across(const sure_ray *ray, double t)
{
    sure_vec3 place = sum_of(ray->origin, t, ray->direction);
    return (sure_object){SURE_SHAPE_PLANE, {.plane = {place, ray->direction}}};
}

/* NULL for none. */
static double *radius_of(sure_case *c)
{
    int last = case_numbers(c->object.shape) - 1;
    bool radius = field_at(c->object.shape, last)->kind == SURE_KIND_RADIUS;
    return radius ? case_number(c, last) : NULL;
}

bool fuzz_other_object(fuzz_bytes *bytes, const sure_case *question, double t, sure_object *other)
{
    uint8_t how = fuzz_byte(bytes);
    sure_shape to = (sure_shape)(how / 8 % SURE_SHAPES);
    sure_case made = *question;
    double *old_radius = radius_of(&made), radius = old_radius ? *old_radius : 1, *new_radius;
    switch (how % 8) {
    case 0: {
        bool enough = fuzz_case(bytes, to, &made);
        *other = made.object;
        return enough;
    }
    case 1:
    case 2:
        if (old_radius == case_number(&made, SECOND)) /* no second vector */
            memcpy(old_radius, how & 0x80 ? &made.ray.origin : &made.ray.direction,
                   sizeof made.ray.origin);
        made.object.shape = to;
        new_radius = radius_of(&made);
        if (new_radius)
            *new_radius = radius;
        break;
    case 3: made.object = fuzz_plane_across(&made.ray, t); break;
    case 4: /* mirrored */
        for (int i = AT_OBJECT + how / 8 % 3; i < case_numbers(made.object.shape); i += 3)
            *case_number(&made, i) = -*case_number(&made, i);
        break;
    default: break;
    }
    move_some(bytes, &made, AT_OBJECT);
    *other = made.object;
    return true;
}

/* FNV-1a, its high bits mixed in. */
uint64_t fuzz_draws(const uint8_t *data, size_t size)
{
    uint64_t hash = 0xcbf29ce484222325;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ data[i]) * 0x100000001b3;
    return (hash ^ hash >> 32) * 0x9e3779b97f4a7c15 >> 16;
}

bool fuzz_drawn(uint64_t *draws, uint64_t of)
{
    bool drawn = *draws % of == 0;
    *draws /= of;
    return drawn;
}

uint64_t fuzz_cost(const sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX], least = INFINITY, most = 0;
    case_to_numbers(question, numbers);
    for (int i = 0; i < case_numbers(question->object.shape); i++) {
        double x = fabs(numbers[i]);
        if (x > 0 && isfinite(x)) {
            least = fmin(least, x);
            most = fmax(most, x);
        }
    }
    uint64_t width = most > 0 ? (uint64_t)(ilogb(most) - ilogb(least)) : 0;
    return 1 + width * width / (NARROW * NARROW);
}
