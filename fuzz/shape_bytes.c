#include "shape_bytes.h"

#include <math.h>
#include <string.h>

enum { ORIGIN = 0, DIRECTION = 3, T_MIN = 6, T_MAX = 7, OBJECT = 8, SECOND = 11 };

/* So many powers of two between the largest and the smallest number cost little. */
enum { NARROW = 256 };

/* The program's world is of whole numbers. The object stands at the origin, its axis along z; the
 * ray passes `point` at `t`. All of it is exact: the largest number is below 2^40. */
typedef struct {
    sure_shape shape;
    double radius, height;
    sure_vec3 generator; /* direction of the wall in the xz plane, upwards */
    sure_vec3 point, direction;
    double t;
} world;

static double signed_byte(fuzz_bytes *bytes)
{
    return (int8_t)fuzz_byte(bytes);
}

static sure_vec3 signed_bytes(fuzz_bytes *bytes)
{
    double x = signed_byte(bytes), y = signed_byte(bytes), z = signed_byte(bytes);
    return (sure_vec3){x, y, z};
}

/* The cone has `parts` steps from rim to apex, so that whole numbers lie on its wall. */
typedef struct {
    double parts, inwards, upwards;
} steps;

static steps read_sizes(fuzz_bytes *bytes, world *w)
{
    steps s;
    s.parts = 1 + fuzz_byte(bytes) % 16;
    s.inwards = fuzz_byte(bytes) % 16;
    s.upwards = 1 + fuzz_byte(bytes) % 16;
    w->radius = s.parts * s.inwards;
    w->height = s.parts * s.upwards;
    w->generator = (sure_vec3){w->shape == SURE_SHAPE_CONE ? -s.inwards : 0, 0, s.upwards};
    return s;
}

/* On the wall, or on its continuation below the base and beyond the top or apex. */
static sure_vec3 on_wall(const world *w, double j)
{
    return (sure_vec3){w->radius + j * w->generator.x, 0, j * w->generator.z};
}

/* 0..radius, both often. */
static double read_within(fuzz_bytes *bytes, double radius)
{
    double x = fuzz_byte(bytes);
    return x < radius ? x : radius;
}

static sure_vec3 read_point(fuzz_bytes *bytes, const world *w, const steps *s)
{
    switch (fuzz_byte(bytes) % 8) {
    case 0: return signed_bytes(bytes);
    case 1: return on_wall(w, fuzz_byte(bytes) % ((int)s->parts + 1));
    case 2: return on_wall(w, signed_byte(bytes));
    case 3: return (sure_vec3){w->radius, 0, 0};
    case 4: return (sure_vec3){0, 0, w->height};
    case 5: return (sure_vec3){read_within(bytes, w->radius), 0, 0};
    case 6: return (sure_vec3){read_within(bytes, w->radius), 0, w->height};
    default: return (sure_vec3){0, 0, signed_byte(bytes)};
    }
}

static sure_vec3 read_direction(fuzz_bytes *bytes, const world *w)
{
    uint8_t kind = fuzz_byte(bytes);
    double u = signed_byte(bytes), v = signed_byte(bytes);
    const sure_vec3 *g = &w->generator;
    switch (kind % 8) {
    case 0: return (sure_vec3){u, v, signed_byte(bytes)};
    case 1: return (sure_vec3){v * g->x, u, v * g->z}; /* touches the wall at y = 0 */
    case 2: return (sure_vec3){u * g->x, 0, u * g->z};
    case 3: return (sure_vec3){-u * g->x, 0, u * g->z}; /* along the generator across */
    case 4: return (sure_vec3){0, 0, u};
    case 5: return (sure_vec3){u, v, 0};
    case 6: return (sure_vec3){0, u, v};
    default: return (sure_vec3){0, u, 0};
    }
}

static world read_world(fuzz_bytes *bytes, sure_shape shape)
{
    world w = {.shape = shape};
    steps s = read_sizes(bytes, &w);
    w.point = read_point(bytes, &w, &s);
    w.direction = read_direction(bytes, &w);
    w.t = signed_byte(bytes);
    return w;
}

/* How the world is turned, moved and scaled by powers of two. */
typedef struct {
    sure_mat3 turn; /* a rotation times `stretch` */
    double stretch;
    sure_vec3 move;
    int scale, direction_scale, normal_scale;
} pose;

/* The rotation of a quaternion of whole numbers, times its norm. */
static void read_turn(fuzz_bytes *bytes, pose *p)
{
    uint8_t first = fuzz_byte(bytes), second = fuzz_byte(bytes);
    double a = first % 16, b = first / 16 - 8, c = second % 16 - 8, d = second / 16 - 8;
    if (first == 0) { /* often not turned at all */
        a = 1;
        b = c = d = 0;
    }
    p->stretch = a * a + b * b + c * c + d * d;
    p->turn.row[0] =
        (sure_vec3){a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)};
    p->turn.row[1] =
        (sure_vec3){2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)};
    p->turn.row[2] =
        (sure_vec3){2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d};
}

static int read_scale(fuzz_bytes *bytes, bool far)
{
    int scale = (int8_t)fuzz_byte(bytes);
    return far ? 8 * scale : scale / 4;
}

static pose read_pose(fuzz_bytes *bytes)
{
    pose p;
    read_turn(bytes, &p);
    uint8_t sizes = fuzz_byte(bytes);
    p.move = signed_bytes(bytes);
    double far = ldexp(1, sizes / 8);
    p.move = (sure_vec3){p.move.x * far, p.move.y * far, p.move.z * far};
    p.scale = read_scale(bytes, sizes & 1);
    p.direction_scale = read_scale(bytes, sizes & 2);
    p.normal_scale = read_scale(bytes, sizes & 4);
    return p;
}

static sure_vec3 turned(const pose *p, sure_vec3 v)
{
    const sure_vec3 *r = p->turn.row;
    return (sure_vec3){r[0].x * v.x + r[0].y * v.y + r[0].z * v.z,
                       r[1].x * v.x + r[1].y * v.y + r[1].z * v.z,
                       r[2].x * v.x + r[2].y * v.y + r[2].z * v.z};
}

static void put(double *numbers, sure_vec3 v, int scale)
{
    numbers[0] = ldexp(v.x, scale);
    numbers[1] = ldexp(v.y, scale);
    numbers[2] = ldexp(v.z, scale);
}

static void put_point(double *numbers, const pose *p, sure_vec3 v)
{
    v = turned(p, v);
    put(numbers, (sure_vec3){v.x + p->move.x, v.y + p->move.y, v.z + p->move.z}, p->scale);
}

static void put_object(double *numbers, const pose *p, const world *w)
{
    const sure_vec3 origin = {0, 0, 0}, up = {0, 0, 1}, end = {0, 0, w->height};
    double radius = ldexp(w->radius * p->stretch, p->scale);
    put_point(numbers + OBJECT, p, origin);
    if (w->shape == SURE_SHAPE_SPHERE) {
        numbers[SECOND] = radius;
        return;
    }
    if (w->shape == SURE_SHAPE_CYLINDER || w->shape == SURE_SHAPE_CONE)
        put_point(numbers + SECOND, p, end);
    else
        put(numbers + SECOND, turned(p, up), p->normal_scale);
    numbers[SECOND + 3] = radius;
}

static void put_ray(double *numbers, const pose *p, const world *w)
{
    const sure_vec3 *x = &w->point, *d = &w->direction;
    sure_vec3 start = {x->x - w->t * d->x, x->y - w->t * d->y, x->z - w->t * d->z};
    put_point(numbers + ORIGIN, p, start);
    put(numbers + DIRECTION, turned(p, *d), p->direction_scale);
}

/* Open, or ending at the t of the point, or anything. */
static void put_range(double *numbers, fuzz_bytes *bytes, double t)
{
    numbers[T_MIN] = 0;
    numbers[T_MAX] = INFINITY;
    switch (fuzz_byte(bytes) % 8) {
    case 0: numbers[T_MIN] = t; break;
    case 1: numbers[T_MAX] = t; break;
    case 2: numbers[T_MIN] = numbers[T_MAX] = t; break;
    case 3:
        numbers[T_MIN] = fuzz_shaped_double(bytes);
        numbers[T_MAX] = fuzz_shaped_double(bytes);
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
    world w = read_world(bytes, shape);
    pose p = read_pose(bytes);
    put_ray(numbers, &p, &w);
    put_object(numbers, &p, &w);
    put_range(numbers, bytes, ldexp(w.t, p.scale - p.direction_scale));
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
    numbers[T_MIN] = 0;
    numbers[T_MAX] = INFINITY;
    if (shape != SURE_SHAPE_PLANE)
        numbers[count - 1] = fabs(numbers[count - 1]);
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
        numbers[DIRECTION + i] = numbers[OBJECT + i] - numbers[ORIGIN + i];
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

/* Across the ray, at the double nearest to its point at t. */
static void put_plane_across(double *numbers, const sure_ray *ray, double t)
{
    const sure_vec3 *o = &ray->origin, *d = &ray->direction;
    put(numbers + OBJECT, (sure_vec3){o->x + t * d->x, o->y + t * d->y, o->z + t * d->z}, 0);
    put(numbers + SECOND, *d, 0);
}

sure_object fuzz_plane_across(const sure_ray *ray, double t)
{
    double numbers[CASE_NUMBERS_MAX] = {0};
    put_plane_across(numbers, ray, t);
    return case_from_numbers(SURE_SHAPE_PLANE, numbers).object;
}

bool fuzz_other_object(fuzz_bytes *bytes, const sure_case *question, double t, sure_object *other)
{
    double numbers[CASE_NUMBERS_MAX] = {0};
    uint8_t how = fuzz_byte(bytes);
    sure_shape from = question->object.shape, to = from;
    case_to_numbers(question, numbers);
    double radius = numbers[case_numbers(from) - 1];
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
        if (from == SURE_SHAPE_SPHERE)
            put(numbers + SECOND, how & 0x80 ? question->ray.origin : question->ray.direction, 0);
        if (to != SURE_SHAPE_PLANE)
            numbers[case_numbers(to) - 1] = from == SURE_SHAPE_PLANE ? 1 : radius;
        break;
    case 3:
        to = SURE_SHAPE_PLANE;
        put_plane_across(numbers, &question->ray, t);
        break;
    case 4: /* mirrored */
        for (int i = OBJECT + how / 8 % 3; i < case_numbers(from); i += 3)
            numbers[i] = -numbers[i];
        break;
    default: break;
    }
    move_some(bytes, numbers, OBJECT, case_numbers(to));
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
