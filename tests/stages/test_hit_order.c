/* SPDX-License-Identifier: MIT */
/* The order of two hits against the oracles' order of the real numbers: equal, nearly equal and far
 * apart; by the hits of both tiers. (Of every environment: fuzz/fuzz_hit_order.c.) */
#include "../support/every_case.h"
#include "../support/moved_case.h"
#include "../support/surroundings.h"

#include "../../reference/bisection.h"
#include "../../reference/reference.h"

#include <signal.h>

enum { SEED = 9, CASES = 25, FAMILY = 7, TIES = 1000, NEAR_TIES = 2000 };

static const char *text(const sure_ray *ray, const sure_object *first, const sure_object *second)
{
    static char lines[2 * CASE_LINE_MAX + 8];
    strcpy(lines, case_text(&(sure_case){.ray = *ray, .object = *first}));
    strcat(strcat(lines, "\n  "), case_text(&(sure_case){.ray = *ray, .object = *second}));
    return lines;
}

/* One ray and what it hits. */
typedef struct {
    sure_ray ray;
    sure_object objects[FAMILY];
    sure_hit hits[FAMILY][2]; /* certain, exact */
    int count;
} family;

static void add(family *f, sure_object object)
{
    sure_hit hits[2];
    if (sure_object_hit(&f->ray, &object, SURE_TIER_CERTAIN, &hits[0]) != SURE_HIT)
        return;
    ck_assert_int_eq(sure_object_hit(&f->ray, &object, SURE_TIER_EXACT, &hits[1]), SURE_HIT);
    f->objects[f->count] = object;
    memcpy(f->hits[f->count++], hits, sizeof hits);
}

/* By the hits of tiers `a` and `b`. */
static int order(const family *f, int first, int a, int second, int b)
{
    return sure_hit_order(&f->ray, &f->objects[first], &f->hits[first][a], &f->objects[second],
                          &f->hits[second][b]);
}

typedef struct {
    unsigned pairs, ties, quick;
} tally;

/* Against the truth, with either tier's hits, exchanged (Law 1), and in the order of exact's t (Law
 * 3). */
static int check_pair(const family *f, int first, int second, int truth, tally *sum)
{
    const char *pair = text(&f->ray, &f->objects[first], &f->objects[second]);
    for (int i = 0; i < 4; i++) {
        int forth = order(f, first, i / 2, second, i % 2);
        int back = order(f, second, i % 2, first, i / 2);
        ck_assert_msg(forth == truth && back == -truth, "%d and %d, truly %d: %s", forth, back,
                      truth, pair);
    }
    double t = f->hits[first][1].t, u = f->hits[second][1].t;
    ck_assert_msg(t < u ? truth < 0 : t > u ? truth > 0 : true, "t of exact: %s", pair);
    sum->pairs++;
    sum->ties += truth == 0;
    const sure_hit *a = &f->hits[first][0], *b = &f->hits[second][0];
    sum->quick += fabs(a->t - b->t) > a->t_error + b->t_error; /* told by the errors' sum */
    return truth;
}

static int true_order(const family *f, int first, int second)
{
    int truth = 77;
    ck_assert_int_eq(reference_hit_order(&f->ray, &f->objects[first], &f->objects[second], &truth),
                     SURE_HIT);
    return truth;
}

static void check_family(const family *f, tally *sum)
{
    int is[FAMILY][FAMILY];
    for (int i = 0; i < f->count; i++) {
        for (int k = i; k < f->count; k++) {
            is[i][k] = check_pair(f, i, k, true_order(f, i, k), sum);
            is[k][i] = -is[i][k];
        }
        ck_assert_int_eq(is[i][i], 0);
    }
    for (int i = 0; i < FAMILY * FAMILY * FAMILY; i++) { /* Law 2 */
        int a = i % FAMILY, b = i / FAMILY % FAMILY, c = i / FAMILY / FAMILY;
        if (a < f->count && b < f->count && c < f->count && is[a][b] <= 0 && is[b][c] <= 0)
            ck_assert_int_le(is[a][c], 0);
    }
}

/* The object with one number moved by few doubles. */
static sure_object nudged_object(const sure_case *q, rng *d)
{
    sure_case moved = *q;
    double *number =
        case_number(&moved, rng_integer(d, AT_OBJECT, case_numbers(q->object.shape) - 1));
    int steps = rng_integer(d, 1, 3);
    *number = step_ulps(*number, rng_chance(d, 1, 2) ? steps : -steps);
    return moved.object;
}

static sure_object plane_at(sure_vec3 point, sure_vec3 normal)
{
    return (sure_object){.shape = SURE_SHAPE_PLANE, .as.plane = {point, normal}};
}

LOOP_TEST(test_regimes, SURE_SHAPES)
{
    sure_shape shape = (sure_shape)_i;
    tally sum = {0};
    for (case_walk w = walk_regimes(shape, SEED, CASES); walk_next(&w);) {
        rng d = rng_of(SEED, shape, w.which, w.index);
        family f = {.ray = w.asked.ray};
        add(&f, w.asked.object);
        if (f.count == 0)
            continue;
        add(&f, w.asked.object);
        for (int i = 0; i < 3; i++)
            add(&f, nudged_object(&w.asked, &d));
        add(&f, plane_at(vector_sum(1, f.ray.origin, f.hits[0][1].t, f.ray.direction),
                         f.ray.direction));
        add(&f, regime_case(shape, w.which, SEED, w.index + 1).object);
        check_family(&f, &sum);
    }
    printf("%-8s %u pairs, %u tie, %u told by t alone\n", sure_shape_name((sure_shape)_i),
           sum.pairs, sum.ties, sum.quick);
    fflush(stdout);
    ck_assert_uint_gt(sum.ties, 0);
    ck_assert_uint_gt(sum.quick, 0);
    ck_assert_uint_lt(sum.quick + sum.ties, sum.pairs);
}

/* A ray in z = 0 towards an object of whole or of any coordinates about the origin. */
static sure_case draw_in_plane(sure_shape shape, rng *d)
{
    sure_case c = {.object.shape = shape};
    bool whole = rng_chance(d, 1, 2);
    for (int i = 0; i < case_numbers(shape); i++)
        *case_number(&c, i) = whole ? rng_integer(d, -9, 9) : rng_between(d, -9, 9);
    c.ray.origin.x = -rng_integer(d, 20, 40);
    c.ray.origin.z = c.ray.direction.z = c.ray.t_min = 0;
    c.ray.direction.x = rng_integer(d, 2, 9);
    c.ray.t_max = INFINITY;
    object_mend(shape, case_number(&c, AT_OBJECT));
    return c;
}

/* Objects that are mirror images in the ray's plane are hit together, at irrational t too. */
LOOP_TEST(test_mirrored, SURE_SHAPES)
{
    static const turn mirror = {{0, 1, 2}, {1, 1, -1}}; /* which leaves the ray as it is */
    sure_shape shape = (sure_shape)_i;
    tally sum = {0};
    for (uint64_t index = 0; sum.ties < 2 * TIES; index++) {
        rng d = rng_of(SEED, shape, 101, index);
        sure_case q = draw_in_plane(shape, &d);
        family f = {.ray = q.ray};
        add(&f, q.object);
        add(&f, case_turned(&q, &mirror).object);
        if (f.count == 2)
            check_pair(&f, 0, 1, 0, &sum);
        ck_assert_uint_lt(index, 100 * TIES);
    }
}

/* Several shapes with one face in common, hit there: a plane, discs, a cylinder's cap of whichever
 * end, a cone's base. */
static void draw_shared_face(family *f, rng *d)
{
    double x = rng_integer(d, -4, 4), y = rng_integer(d, -4, 4), z = rng_integer(d, -4, 4);
    double ax = rng_integer(d, 1, 5), ay = rng_integer(d, -5, 5), az = rng_integer(d, -5, 5);
    const sure_vec3 q = {x, y, z}, axis = {ax, ay, az}, far = {x + ax, y + ay, z + az};
    double vx = rng_integer(d, -2, 2), vy = rng_integer(d, -2, 2), vz = rng_integer(d, -2, 2);
    f->ray = (sure_ray){{x - 20 * ax + vx, y - 20 * ay + vy, z - 20 * az + vz},
                        {rng_between(d, 1, 2) * ax, ay, az},
                        0,
                        INFINITY};
    add(f, plane_at(q, axis));
    add(f, (sure_object){.shape = SURE_SHAPE_DISC, .as.disc = {q, axis, 400}});
    add(f, (sure_object){.shape = SURE_SHAPE_CYLINDER, .as.cylinder = {q, far, 500}});
    add(f, (sure_object){.shape = SURE_SHAPE_CYLINDER, .as.cylinder = {far, q, 450}});
    add(f, (sure_object){.shape = SURE_SHAPE_CONE, .as.cone = {q, far, 300}});
}

TEST(test_shared_face)
{
    tally sum = {0};
    for (uint64_t index = 0; sum.ties < TIES; index++) {
        rng d = rng_of(SEED, 0, 102, index);
        family f = {.count = 0};
        draw_shared_face(&f, &d);
        ck_assert_int_eq(f.count, 5);
        for (int i = 0; i < f.count; i++) {
            for (int k = 0; k < i; k++)
                check_pair(&f, i, k, 0, &sum);
        }
        ck_assert_int_eq(bisection_order(&f.ray, &f.objects[1], &f.objects[4]), 0);
    }
}

static sure_object sphere_at(double y, double z, double radius)
{
    return (sure_object){.shape = SURE_SHAPE_SPHERE, .as.sphere = {{0, y, z}, radius}};
}

/* Along the x axis a sphere at (0, y, z) is hit at t = 2^10 - sqrt(r^2 - y^2 - z^2). With z below
 * 2^-90 a sphere's t is within 2^-180 of that for z = 0: they agree to 54 digits and up to 240. A
 * cylinder along y is hit where the sphere at y = 0 is. */
TEST(test_nearly)
{
    tally sum = {0};
    for (uint64_t index = 0; index < NEAR_TIES; index++) {
        rng d = rng_of(SEED, 0, 103, index);
        double radius = rng_between(&d, 2, 3), y = rng_between(&d, 0, 1);
        double z = rng_magnitude(&d, -400, -90);
        family f = {.ray = {{-0x1p10, 0, 0}, {1, 0, 0}, 0, INFINITY}};
        add(&f, sphere_at(y, 0, radius));
        add(&f, sphere_at(-y, z, radius));
        add(&f, sphere_at(0, z, radius));
        add(&f, (sure_object){.shape = SURE_SHAPE_CYLINDER,
                              .as.cylinder = {{0, -1, z}, {0, 1, z}, radius}});
        ck_assert_int_eq(f.count, 4);
        check_pair(&f, 0, 1, -1, &sum);
        check_pair(&f, 2, 3, 0, &sum);
        check_pair(&f, 0, 2, 1, &sum);
        if (index % 20 == 0)
            ck_assert_int_eq(bisection_order(&f.ray, &f.objects[0], &f.objects[1]), -1);
    }
    ck_assert_uint_eq(sum.ties, NEAR_TIES);
}

/* t and t_error at the ends of the range: hits far and near, and beyond the greatest double. */
TEST(test_ends)
{
    const sure_ray ray = {{0, 0, 0}, {0x1p-1000, 0, 0}, 0, INFINITY};
    const sure_vec3 x = {1, 0, 0};
    const double places[] = {0x1p-1074, 0x1p-1060, 1, 0x1p20, 0x1p50, 0x1p1023};
    for (int i = 0; i < 36; i++) {
        family f = {.ray = ray};
        tally sum = {0};
        int a = i / 6, b = i % 6;
        add(&f, plane_at((sure_vec3){places[a], 0, 0}, x));
        add(&f, plane_at((sure_vec3){places[b], 0, 0}, x));
        ck_assert_int_eq(f.count, 2);
        check_pair(&f, 0, 1, a < b ? -1 : a > b, &sum);
    }
}

/* Two hits of one plane whose t differ by no more than the sum of the errors, in every environment:
 * the difference's magnitude is rounded up where the sum is rounded down, and subnormals that are
 * flushed make the one larger and the other smaller. */
LOOP_TEST(test_limits, SURROUNDINGS)
{
    const sure_vec3 x = {1, 0, 0};
    const sure_object unit = plane_at((sure_vec3){1 - 0x1p-53, 0, 0}, x);
    const sure_ray ray = {{-0x1p-60, 0, 0}, {1, 0, 0}, 0, INFINITY};
    const sure_hit early = {0x1p-60, 1 - 0x1p-53, SURE_PART_SURFACE, 0};
    const sure_hit late = {1, 0x1p-53 - 0x1p-60, SURE_PART_SURFACE, 0};
    const sure_object close = plane_at((sure_vec3){0x1.8p-1022, 0, 0}, x);
    const sure_ray other = {{0, 0, 0}, {1, 0, 0}, 0, INFINITY};
    const sure_hit low = {0x1p-1022 - 0x1p-1074, 0x1p-1022 - 0x1p-1074, SURE_PART_SURFACE, 0};
    const sure_hit high = {0x1p-1021, 0x1p-1022 - 0x1p-1074, SURE_PART_SURFACE, 0};
    surroundings_set(_i);
    int orders[] = {sure_hit_order(&ray, &unit, &early, &unit, &late),
                    sure_hit_order(&ray, &unit, &late, &unit, &early),
                    sure_hit_order(&other, &close, &low, &close, &high),
                    sure_hit_order(&other, &close, &high, &close, &low)};
    surroundings_set(0);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(orders[i], 0);
}

/* What a ray does not hit is no question. */
SIGNAL_TEST(test_not_hit, SIGABRT)
{
    const sure_ray ray = {{0, 0, 0}, {1, 0, 0}, 0, INFINITY};
    const sure_object met = plane_at((sure_vec3){1, 0, 0}, (sure_vec3){1, 0, 0});
    const sure_object beside = plane_at((sure_vec3){0, 0, 1}, (sure_vec3){0, 0, 1});
    const sure_hit made_up = {1, INFINITY, SURE_PART_SURFACE, 0};
    sure_hit_order(&ray, &beside, &made_up, &met, &made_up);
}

SUITE("hit order")
