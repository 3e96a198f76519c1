#include "shape_bytes.h"

#include "case_shape.h"

#include <math.h>
#include <string.h>

enum { SECOND = AT_OBJECT + 3 };

/* So many powers of two between the largest and the smallest number cost little. */
enum { NARROW = 256 };

/* A program is a layout in whole numbers: the object stands at the origin, its axis along z, and
 * the ray passes p at t. All of it is exact: the largest number is below 2^40. */

static double signed_byte(fuzz_bytes *bytes)
{
    return (int8_t)fuzz_byte(bytes);
}

static sure_vec3 signed_bytes(fuzz_bytes *bytes)
{
    double x = signed_byte(bytes), y = signed_byte(bytes), z = signed_byte(bytes);
    return (sure_vec3){x, y, z};
}

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
    return along((sure_vec3){lay->r, 0, 0}, j, s->generator);
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
    case 0: return signed_bytes(bytes);
    case 1: return on_side(lay, s, fuzz_byte(bytes) % (s->parts + 1));
    case 2: return on_side(lay, s, signed_byte(bytes));
    case 3: return (sure_vec3){lay->r, 0, 0};
    case 4: return (sure_vec3){0, 0, lay->h};
    case 5: return (sure_vec3){read_within(bytes, lay->r), 0, 0};
    case 6: return (sure_vec3){read_within(bytes, lay->r), 0, lay->h};
    default: return (sure_vec3){0, 0, signed_byte(bytes)};
    }
}

static sure_vec3 read_direction(fuzz_bytes *bytes, const sure_vec3 *g)
{
    uint8_t kind = fuzz_byte(bytes);
    double u = signed_byte(bytes), v = signed_byte(bytes);
    switch (kind % 8) {
    case 0: return (sure_vec3){u, v, signed_byte(bytes)};
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
    lay.t = signed_byte(bytes);
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
    p.move = scaled(ldexp(1, sizes / 8), signed_bytes(bytes));
    p.scale = read_scale(bytes, sizes & 1);
    p.d_scale = read_scale(bytes, sizes & 2);
    p.n_scale = read_scale(bytes, sizes & 4);
    return p;
}

/* Open, or ending at the t of the point, or anything. */
static void put_range(double *numbers, fuzz_bytes *bytes, double t)
{
    numbers[AT_T_MIN] = 0;
    numbers[AT_T_MAX] = INFINITY;
    switch (fuzz_byte(bytes) % 8) {
    case 0: numbers[AT_T_MIN] = t; break;
    case 1: numbers[AT_T_MAX] = t; break;
    case 2: numbers[AT_T_MIN] = numbers[AT_T_MAX] = t; break;
    case 3:
        numbers[AT_T_MIN] = fuzz_shaped_double(bytes);
        numbers[AT_T_MAX] = fuzz_shaped_double(bytes);
        break;
    default: break;
    }
}

/* Up to three numbers from `first` on by a few doubles. */
static void move_some(fuzz_bytes *bytes, double *numbers, int first, int count)
{
    for (int times = fuzz_byte(bytes) % 4; times > 0; times--) {
        double *x = &numbers[first + fuzz_byte(bytes) % (count - first)];
        int8_t by = (int8_t)fuzz_byte(bytes);
        *x = by == INT8_MIN ? fuzz_shaped_double(bytes) : fuzz_ulps(*x, by);
    }
}

static void run_program(fuzz_bytes *bytes, sure_shape shape, double *numbers)
{
    layout lay = read_layout(bytes, shape);
    pose where = read_pose(bytes, shape);
    numbered placed = place(&lay, &where);
    memcpy(numbers, placed.number, sizeof placed.number);
    put_range(numbers, bytes, ldexp(lay.t, where.scale - where.d_scale));
    move_some(bytes, numbers, 0, case_numbers(shape));
}

bool fuzz_case(fuzz_bytes *bytes, sure_shape shape, sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX + 1] = {0};
    uint8_t how = fuzz_byte(bytes);
    int count = case_numbers(shape);
    if (how % 4 >= 2) {
        run_program(bytes, shape, numbers);
    } else {
        for (int i = 0; i < count; i++)
            numbers[i] = how % 4 == 0 ? fuzz_double(bytes) : fuzz_shaped_double(bytes);
    }
    *question = case_from_numbers(shape, numbers);
    /* A program may leave its end to zeros. */
    return !bytes->short_of || how % 4 >= 2;
}

static bool is_hit(const sure_case *question, sure_tier tier, sure_hit *hit)
{
    return sure_object_hit(&question->ray, &question->object, tier, hit) == SURE_HIT;
}

/* Numbers instead of what is none, and a radius that is not negative. */
static void mend(double *numbers, sure_shape shape)
{
    int count = case_numbers(shape);
    for (int i = 0; i < count; i++)
        numbers[i] = isfinite(numbers[i]) ? numbers[i] : i + 1;
    numbers[AT_T_MIN] = 0;
    numbers[AT_T_MAX] = INFINITY;
    case_shape_of(shape)->mend(shape, numbers + AT_OBJECT);
}

/* Exponents an eighth as large. */
static void squeeze(double *numbers, sure_shape shape)
{
    for (int i = 0; i < case_numbers(shape); i++) {
        int exponent;
        double digits = frexp(numbers[i], &exponent);
        numbers[i] = isfinite(numbers[i]) ? ldexp(digits, exponent / 8) : numbers[i];
    }
}

static void aim(double *numbers)
{
    for (int i = 0; i < 3; i++)
        numbers[AT_D + i] = numbers[AT_OBJECT + i] - numbers[AT_O + i];
}

bool fuzz_hit(sure_case *question, sure_tier tier, sure_hit *hit)
{
    double numbers[CASE_NUMBERS_MAX];
    sure_shape shape = question->object.shape;
    if (is_hit(question, tier, hit))
        return true;
    case_to_numbers(question, numbers);
    mend(numbers, shape);
    *question = case_from_numbers(shape, numbers);
    if (is_hit(question, tier, hit))
        return true;
    aim(numbers);
    *question = case_from_numbers(shape, numbers);
    return is_hit(question, tier, hit);
}

void fuzz_cheapen(sure_case *question, uint64_t *draws)
{
    double numbers[CASE_NUMBERS_MAX];
    if (fuzz_drawn(draws, fuzz_cost(question)))
        return;
    case_to_numbers(question, numbers);
    squeeze(numbers, question->object.shape);
    *question = case_from_numbers(question->object.shape, numbers);
}

static void put(double *numbers, sure_vec3 v)
{
    memcpy(numbers, &v, sizeof v);
}

/* Across the ray, at the double nearest to its point at t. */
static void put_plane_across(double *numbers, const sure_ray *ray, double t)
{
    put(numbers + AT_OBJECT, along(ray->origin, t, ray->direction));
    put(numbers + SECOND, ray->direction);
}

sure_object fuzz_plane_across(const sure_ray *ray, double t)
{
    double numbers[CASE_NUMBERS_MAX] = {0};
    put_plane_across(numbers, ray, t);
    return case_from_numbers(SURE_SHAPE_PLANE, numbers).object;
}

/* NULL for none. */
static double *radius_of(sure_shape shape, double *numbers)
{
    int last = case_numbers(shape) - 1;
    return field_at(shape, last)->kind == SURE_KIND_RADIUS ? numbers + last : NULL;
}

bool fuzz_other_object(fuzz_bytes *bytes, const sure_case *question, double t, sure_object *other)
{
    double numbers[CASE_NUMBERS_MAX] = {0};
    uint8_t how = fuzz_byte(bytes);
    sure_shape from = question->object.shape, to = from;
    case_to_numbers(question, numbers);
    double *from_radius = radius_of(from, numbers), *to_radius;
    double radius = from_radius ? *from_radius : 1;
    switch (how % 8) {
    case 0: {
        sure_case another;
        to = (sure_shape)(how / 8 % SURE_SHAPES);
        bool made = fuzz_case(bytes, to, &another);
        *other = another.object;
        return made;
    }
    case 1:
    case 2:
        to = (sure_shape)(how / 8 % SURE_SHAPES);
        if (from_radius == numbers + SECOND) /* no second vector */
            put(numbers + SECOND, how & 0x80 ? question->ray.origin : question->ray.direction);
        to_radius = radius_of(to, numbers);
        if (to_radius)
            *to_radius = radius;
        break;
    case 3:
        to = SURE_SHAPE_PLANE;
        put_plane_across(numbers, &question->ray, t);
        break;
    case 4: /* mirrored */
        for (int i = AT_OBJECT + how / 8 % 3; i < case_numbers(from); i += 3)
            numbers[i] = -numbers[i];
        break;
    default: break;
    }
    move_some(bytes, numbers, AT_OBJECT, case_numbers(to));
    *other = case_from_numbers(to, numbers).object;
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

const char *fuzz_case_text(const sure_case *question)
{
    static char line[CASE_LINE_MAX];
    case_print(question, line);
    return line;
}
