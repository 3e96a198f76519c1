/* SPDX-License-Identifier: MIT */
/* Law 1 of many.h, and of its like in floats.h: every answer is the single call's. */
#include "case_floats.h"
#include "every_case.h"
#include "many_answers.h"
#include "surroundings.h"

/* A ray and its object, off any alignment. */
typedef struct {
    char odd;
    sure_ray ray;
    char between[3];
    double numbers[SURE_SHAPE_NUMBERS];
} __attribute__((packed)) user_struct;

/* The mask's bits are the statuses; nothing is written behind it. */
static void check_mask(const answers *all, int count, const uint8_t *mask, size_t invalid)
{
    size_t refused = 0;
    for (int i = 0; i < 8 * ((count + 7) / 8); i++) {
        const bool meets = i < count && all->room[i][0] == SURE_HIT;
        ck_assert_int_eq(mask[i / 8] >> i % 8 & 1, meets);
        refused += i < count && all->room[i][0] == SURE_INVALID;
    }
    ck_assert_uint_eq(invalid, refused);
    ck_assert_int_eq(mask[(count + 7) / 8], FILLER);
}

/* Cases of all regimes in turn, `count` at a time from `first` on. */
static void fill(sure_shape shape, uint64_t first, int count, sure_case *cases, user_struct *users)
{
    for (int i = 0; i < count; i++) {
        const uint64_t index = first + (uint64_t)i;
        regime which = (regime)(index % REGIMES);
        if (!regime_applies(shape, which))
            which = REGIME_TYPICAL;
        cases[i] = regime_case(shape, which, 1, index);
        users[i].ray = cases[i].ray;
        memcpy(users[i].numbers, &cases[i].object.as, sizeof users[i].numbers);
    }
}

/* Of `count` rays and objects, each a step from the one before. */
typedef struct {
    const sure_case *ray, *object;
    int ray_step, object_step, count;
    sure_tier tier;
    bool normals;
} many_asked;

static void answers_alone(const many_asked *a, answers *alone)
{
    (void)hits_in(alone, a->normals, false);
    for (int i = 0; i < a->count; i++) {
        const sure_case one = {.ray = a->ray[i * a->ray_step].ray,
                               .object = a->object[i * a->object_step].object};
        answer_alone(&one, a->tier, a->normals, alone->room[i]);
    }
}

static void check_alone(const answers *all, const many_asked *a)
{
    static answers alone;
    answers_alone(a, &alone);
    ck_assert_mem_eq(all, &alone, sizeof alone);
}

static void check_pairs(sure_shape shape, int count, sure_tier tier, bool backward, bool normals)
{
    static sure_case cases[MOST];
    static user_struct users[MOST];
    static answers all;
    fill(shape, (uint64_t)(count * 64 + (int)tier), count, cases, users);
    const int first = backward && count > 0 ? count - 1 : 0, step = backward ? -1 : 1;
    const ptrdiff_t stride = step * (ptrdiff_t)sizeof(user_struct);
    const char *at = (const char *)&users[first];
    sure_rays rays = sure_rays_of(at + offsetof(user_struct, ray), stride);
    sure_objects objects = sure_objects_of(shape, at + offsetof(user_struct, numbers), stride);
    sure_hits hits = hits_in(&all, normals, false);
    sure_objects_hits((size_t)count, &rays, &objects, tier, &hits);
    check_alone(&all,
                &(many_asked){&cases[first], &cases[first], step, step, count, tier, normals});
    uint8_t mask[MOST / 8 + 2];
    memset(mask, FILLER, sizeof mask);
    size_t invalid = sure_objects_occluded((size_t)count, &rays, &objects, tier, mask);
    check_mask(&all, count, mask, invalid);
}

TEST(test_pairs)
{
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++)
        for (int count = 0; count <= MOST; count++)
            for (sure_tier tier = 0; tier < SURE_TIERS; tier++)
                check_pairs(shape, count, tier, count & 1, count & 2);
}

/* Cases of a shape as they stand in an array. */
static void ask_cases(const sure_case *cases, const sure_hits *hits)
{
    const sure_rays rays = sure_rays_of(&cases->ray, sizeof *cases);
    const sure_objects objects =
        sure_objects_of(cases->object.shape, &cases->object.as, sizeof *cases);
    sure_objects_hits(MOST, &rays, &objects, SURE_TIER_CERTAIN, hits);
}

/* Answers are sought with subnormals flushed where that changes none: in a directed mode a sum
 * tells a subnormal from 0. Who asks finds his environment as it was. */
SHAPE_TEST(environment)
{
    static sure_case cases[MOST];
    static user_struct users[MOST];
    static answers all, alone;
    fill((sure_shape)_i, 0, MOST, cases, users);
    for (int i = 1; i < MOST; i += 2) {
        cases[i].ray.origin.x = i % 4 == 1 ? 0x1p-1074 : -0x1p-1074;
        cases[i].object.as.sphere.centre.x = 0; /* or what is first in another shape */
    }
    for (int e = 0; e < SURROUNDINGS_ALL; e++) {
        const sure_hits hits = hits_in(&all, false, false);
        surroundings_enter(e);
        ask_cases(cases, &hits);
        ck_assert_msg(surroundings_kept(e), "%s", surroundings_name(e));
        answers_alone(&(many_asked){cases, cases, 1, 1, MOST, SURE_TIER_CERTAIN, false}, &alone);
        surroundings_set(0);
        if (e < SURROUNDINGS)
            ck_assert_msg(memcmp(&all, &alone, sizeof all) == 0, "%s", surroundings_name(e));
    }
}

/* Normals are found with t_error, whoever wants it. */
SHAPE_TEST(normals_alone)
{
    static sure_case cases[MOST];
    static user_struct users[MOST];
    static answers all, alone;
    fill((sure_shape)_i, 0, MOST, cases, users);
    sure_hits hits = hits_in(&all, true, false);
    hits.part = hits.leaves = (sure_byte_column){0};
    hits.t = hits.t_error = (sure_number_column){0};
    ask_cases(cases, &hits);
    answers_alone(&(many_asked){cases, cases, 1, 1, MOST, SURE_TIER_CERTAIN, true}, &alone);
    for (int i = 0; i < MOST; i++)
        memset(alone.room[i] + 1, FILLER, AT_NORMAL - 1);
    ck_assert_mem_eq(&all, &alone, sizeof all);
}

/* Columns without gaps are read and written where they stand: no answer stands behind the last of
 * `count`. Rays of all `room` cases, before the first one's object. Of column `apart` every second
 * place counts, if there is one; OBJECTS: each ray before its own object, as they stand; NORMALS:
 * x of the normal in the place of t. */
enum { DENSE_MOST = 2048, T = 8, T_ERROR, STATUS, PART, LEAVES, OBJECTS, NORMALS, APART };
#define STEP(k) (ptrdiff_t)((k) == apart ? 2 : 1)
#define SIZE(k) (STEP(k) * (ptrdiff_t)sizeof(double))

static void check_dense(const sure_case *cases, int count, int room, int apart)
{
    static double numbers[STATUS][2 * DENSE_MOST];
    static uint8_t bytes[3][2 * DENSE_MOST];
    sure_rays rays;
    for (int k = 0; k < T; k++) {
        for (int i = 0; i < room; i++)
            numbers[k][i * STEP(k)] = ((const double *)(const void *)&cases[i].ray)[k];
        ((sure_numbers *)(void *)&rays)[k] = (sure_numbers){numbers[k], SIZE(k)};
    }
    for (int i = 0; i < 2 * room; i++)
        numbers[T][i] = numbers[T_ERROR][i] = -7;
    memset(bytes, FILLER, sizeof bytes);
    const sure_objects objects = sure_objects_of(cases[0].object.shape, &cases[0].object.as,
                                                 apart == OBJECTS ? sizeof *cases : 0);
    sure_hits hits = {.status = {bytes[0], STEP(STATUS)},
                      .part = {bytes[1], STEP(PART)},
                      .leaves = {bytes[2], STEP(LEAVES)},
                      .t = {numbers[T], SIZE(T)},
                      .t_error = {numbers[T_ERROR], SIZE(T_ERROR)}};
    if (apart == NORMALS) {
        hits.normal[0] = hits.t;
        hits.t.first = NULL;
    }
    sure_objects_hits((size_t)count, &rays, &objects, SURE_TIER_CERTAIN, &hits);
    for (int i = 0; i < room; i++) {
        const sure_object *object = &cases[apart == OBJECTS ? i : 0].object;
        sure_hit hit = {-7, -7, (sure_part)FILLER, FILLER};
        const sure_status is = i < count
                                   ? sure_object_hit(&cases[i].ray, object, SURE_TIER_CERTAIN, &hit)
                                   : (sure_status)FILLER;
        if (apart == NORMALS && is == SURE_HIT)
            hit.t = sure_object_normal(&cases[i].ray, object, SURE_TIER_CERTAIN, &hit).x;
        ck_assert_int_eq(bytes[0][i * STEP(STATUS)], (int)is);
        ck_assert_int_eq(bytes[1][i * STEP(PART)], (int)hit.part);
        ck_assert_int_eq(bytes[2][i * STEP(LEAVES)], hit.leaves);
        ck_assert_mem_eq(&numbers[T][i * STEP(T)], &hit.t, sizeof hit.t);
        ck_assert_mem_eq(&numbers[T_ERROR][i * STEP(T_ERROR)], &hit.t_error, sizeof hit.t);
    }
}

TEST(test_dense)
{
    enum { ROOM = MOST + 16 };
    static sure_case cases[ROOM];
    static user_struct users[ROOM];
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++)
        for (int count = 0; count <= MOST; count++) {
            fill(shape, (uint64_t)count, ROOM, cases, users);
            check_dense(cases, count, ROOM, APART);
        }
}

/* Columns without gaps of the cases' rays. */
static sure_rays dense_rays(const sure_case *cases)
{
    static double columns[T][DENSE_MOST];
    sure_rays rays;
    for (int k = 0; k < T; k++) {
        for (int i = 0; i < DENSE_MOST; i++)
            columns[k][i] = ((const double *)(const void *)&cases[i].ray)[k];
        ((sure_numbers *)(void *)&rays)[k] = (sure_numbers){columns[k], sizeof(double)};
    }
    return rays;
}

/* Of number k of the object every `steps[k]`-th double counts; 0: the first one for all. */
static void check_columns(const sure_case *given, const int steps[SURE_SHAPE_NUMBERS])
{
    static double columns[SURE_SHAPE_NUMBERS][2 * DENSE_MOST], t[DENSE_MOST];
    static uint8_t status[DENSE_MOST];
    static sure_case cases[DENSE_MOST];
    const sure_rays rays = dense_rays(given);
    const sure_hits hits = {.status = {status, 1}, .t = {t, sizeof *t}};
    sure_objects objects = {.shape = given->object.shape};
    memcpy(cases, given, sizeof cases);
    for (int k = 0; k < sure_shape_info_of(objects.shape)->numbers; k++) {
        objects.numbers[k] = (sure_numbers){columns[k], steps[k] * (ptrdiff_t)sizeof(double)};
        for (int i = 0; i < DENSE_MOST; i++) {
            double *number = (double *)(void *)&cases[i].object.as + k;
            if (i == 0 || steps[k] > 0)
                columns[k][i * steps[k]] = *number;
            *number = columns[k][i * steps[k]];
        }
    }
    sure_objects_hits(DENSE_MOST, &rays, &objects, SURE_TIER_CERTAIN, &hits);
    for (int i = 0; i < DENSE_MOST; i++) {
        sure_hit hit;
        ck_assert_int_eq(status[i],
                         sure_object_hit(&cases[i].ray, &cases[i].object, SURE_TIER_CERTAIN, &hit));
        ck_assert(status[i] != SURE_HIT || memcmp(&t[i], &hit.t, sizeof hit.t) == 0);
    }
}

/* One column of the object is not like the others. */
SHAPE_TEST(columns_apart)
{
    static sure_case cases[DENSE_MOST];
    for (int i = 0; i < DENSE_MOST; i++)
        cases[i] = regime_case((sure_shape)_i, REGIME_TYPICAL, 1, (uint64_t)i);
    for (int apart = 0; apart < SURE_SHAPE_NUMBERS; apart++)
        for (int others = 0; others < 2; others++) {
            int steps[SURE_SHAPE_NUMBERS];
            for (int k = 0; k < SURE_SHAPE_NUMBERS; k++)
                steps[k] = k == apart ? others + 1 : others;
            check_columns(cases, steps);
        }
}

/* Most rays miss, and long runs of them, which are asked in another way; some of a run meet the
 * object or are invalid. Far more than a block's room holds. */
SHAPE_TEST(runs)
{
    static sure_case cases[DENSE_MOST];
    uint64_t next = 0;
    const sure_case hitting = case_that((sure_shape)_i, NULL, SURE_HIT, &next);
    cases[0] = hitting;
    for (int i = 1; i < DENSE_MOST; i++) {
        const bool meets = i % 389 == 388 || i % 512 >= 480;
        cases[i] = meets ? hitting : case_that((sure_shape)_i, &hitting.object, SURE_MISS, &next);
        if (i % 311 == 310)
            cases[i].ray.t_max = -1;
    }
    for (int apart = 0; apart <= APART; apart++)
        check_dense(cases, DENSE_MOST, DENSE_MOST, apart);
}

/* One object for many rays, and one ray for many objects. */
#define OF_ONE(shape, SHAPE, tier, TIER)                                                           \
    do {                                                                                           \
        sure_hits hits = hits_in(&all, true, false);                                               \
        sure_rays rays = sure_rays_of(&cases[0].ray, sizeof *cases);                               \
        sure_##shape##_hits_##tier(MOST, &rays, &cases[0].object.as.shape, &hits);                 \
        check_alone(&all, &(many_asked){cases, cases, 1, 0, MOST, SURE_TIER_##TIER, true});        \
        hits = hits_in(&all, true, false);                                                         \
        rays = sure_rays_of(&cases[0].ray, 0);                                                     \
        sure_objects objects =                                                                     \
            sure_objects_of(SURE_SHAPE_##SHAPE, &cases[0].object.as, sizeof *cases);               \
        sure_objects_hits(MOST, &rays, &objects, SURE_TIER_##TIER, &hits);                         \
        check_alone(&all, &(many_asked){cases, cases, 0, 1, MOST, SURE_TIER_##TIER, true});        \
    } while (0);

#define ONE_TEST(shape, SHAPE)                                                                     \
    TEST(test_one_##shape)                                                                         \
    {                                                                                              \
        static answers all;                                                                        \
        static sure_case cases[MOST];                                                              \
        for (int i = 0; i < MOST; i++)                                                             \
            cases[i] = regime_case(SURE_SHAPE_##SHAPE, REGIME_TYPICAL, 1, (uint64_t)(i / 2));      \
        for (int i = 0; i < MOST; i++)                                                             \
            cases[i].ray.t_max *= i % 7 < 6 ? 1 : -1; /* invalid */                                \
        OF_ONE(shape, SHAPE, float32, FLOAT32)                                                     \
        OF_ONE(shape, SHAPE, textbook, TEXTBOOK)                                                   \
        OF_ONE(shape, SHAPE, stable, STABLE)                                                       \
        OF_ONE(shape, SHAPE, certain, CERTAIN)                                                     \
        OF_ONE(shape, SHAPE, exact, EXACT)                                                         \
    }
SURE_EACH_SHAPE(ONE_TEST)

/* The same of floats. */

typedef struct {
    char odd;
    sure_ray_f ray;
    char between[3];
    float numbers[SURE_SHAPE_NUMBERS];
} __attribute__((packed)) user_floats;

/* Each with its own object, or all with the first one's. */
typedef struct {
    sure_shape shape;
    int count;
    bool backward, normals, one_object;
    int surroundings;
} floats_asked;

static void check_floats(const floats_asked *how)
{
    static sure_case cases[MOST];
    static user_struct unused[MOST];
    static user_floats users[MOST];
    static answers all, alone;
    float_query queries[MOST];
    void (*volatile many)(size_t, const sure_rays *, const sure_objects *, const sure_hits *) =
        sure_objects_hits_certain_f;
    const int count = how->count;
    fill(how->shape, (uint64_t)(count * 64), count, cases, unused);
    for (int i = 0; i < count; i++) {
        queries[i] = float_query_of(&cases[how->backward ? count - 1 - i : i]);
        if (how->one_object)
            memcpy(queries[i].object, queries[0].object, sizeof queries[i].object);
    }
    for (int i = 0; i < count; i++) {
        const float_query *q = &queries[how->backward ? count - 1 - i : i];
        users[i].ray = q->ray;
        memcpy(users[i].numbers, q->object, sizeof users[i].numbers);
    }
    const int first = how->backward && count > 0 ? count - 1 : 0;
    const ptrdiff_t stride = (how->backward ? -1 : 1) * (ptrdiff_t)sizeof(user_floats);
    const char *at = (const char *)&users[first];
    sure_rays rays = sure_rays_of_f(at + offsetof(user_floats, ray), stride);
    sure_objects objects = sure_objects_of_f(how->shape, at + offsetof(user_floats, numbers),
                                             how->one_object ? 0 : stride);
    sure_hits hits = hits_in(&all, how->normals, true);
    surroundings_set(how->surroundings);
    many((size_t)count, &rays, &objects, &hits);
    (void)hits_in(&alone, how->normals, true);
    for (int i = 0; i < count; i++)
        answer_floats(&queries[i], SURE_TIER_CERTAIN, how->normals, alone.room[i]);
    uint8_t mask[MOST / 8 + 2];
    memset(mask, FILLER, sizeof mask);
    size_t invalid = sure_objects_occluded_certain_f((size_t)count, &rays, &objects, mask);
    surroundings_set(0);
    ck_assert_mem_eq(&all, &alone, sizeof all);
    check_mask(&alone, count, mask, invalid);
}

TEST(test_floats)
{
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (int count = 0; count <= MOST; count++) {
            floats_asked how = {shape, count, count & 1, count & 2, count & 4, 0};
            check_floats(&how);
        }
        for (int e = 0; e < SURROUNDINGS_ALL; e++) {
            floats_asked how = {shape, MOST, false, e & 1, e & 2, e};
            check_floats(&how);
        }
    }
}

/* As they stand, whole blocks without a gap between columns' numbers. */
#define FLOATS_OF(shape, SHAPE)                                                                    \
    TEST(test_floats_of_##shape)                                                                   \
    {                                                                                              \
        enum { COUNT = 3 * 64 + 5 };                                                               \
        static float numbers[8][COUNT], t[COUNT];                                                  \
        static uint8_t status[COUNT], part[COUNT], leaves[COUNT];                                  \
        const sure_case first = regime_case(SURE_SHAPE_##SHAPE, REGIME_TYPICAL, 1, 0);             \
        const float_query object = float_query_of(&first);                                         \
        sure_rays rays;                                                                            \
        sure_numbers *column = (void *)&rays;                                                      \
        for (int k = 0; k < 8; k++)                                                                \
            column[k] = (sure_numbers){numbers[k], sizeof(float)};                                 \
        for (int i = 0; i < COUNT; i++) {                                                          \
            const sure_case c = regime_case(SURE_SHAPE_##SHAPE, REGIME_TYPICAL, 1, (uint64_t)i);   \
            const float_query q = float_query_of(&c);                                              \
            for (int k = 0; k < 8; k++)                                                            \
                numbers[k][i] = ((const float *)(const void *)&q.ray)[k];                          \
            numbers[7][i] *= i % 7 == 6 ? -1 : 1;                                                  \
        }                                                                                          \
        const sure_hits hits = {{status, 1},        {part, 1}, {leaves, 1},                        \
                                {t, sizeof(float)}, {NULL, 0}, {{NULL, 0}}};                       \
        sure_##shape##_hits_certain_f(COUNT, &rays, (const void *)object.object, &hits);           \
        for (int i = 0; i < COUNT; i++) {                                                          \
            sure_hit_f hit = {t[i], (sure_part)part[i], leaves[i]};                                \
            float_query q = object;                                                                \
            for (int k = 0; k < 8; k++)                                                            \
                ((float *)(void *)&q.ray)[k] = numbers[k][i];                                      \
            ck_assert_int_eq(float_query_hit(&q, SURE_TIER_CERTAIN, &hit), status[i]);             \
            ck_assert(memcmp(&hit.t, &t[i], sizeof hit.t) == 0 && hit.part == part[i] &&           \
                      hit.leaves == leaves[i]);                                                    \
        }                                                                                          \
    }
SURE_EACH_SHAPE(FLOATS_OF)

/* Without its y, which is a subnormal float, the ray would hit. */
/* Of a corner that a block flushes, in the last bits of its way from the ray's start. */
static sure_case case_of_flushed_corner(rng *g)
{
    const double low = rng_magnitude(g, -1052, -1022), start = rng_magnitude(g, -1018, -968);
    const double step = rng_magnitude(g, -255, -250);
    return (sure_case){
        .ray = {{-start, 0, 0}, {step, 0, 0}, 0, HUGE_VAL},
        .object = {SURE_SHAPE_BOX, {.box = {{low, -1, -1}, {1, 1, 1}}}},
    };
}

TEST(test_flushed_corners)
{
    for (uint64_t n = 0; n < 20; n++) {
        static sure_case cases[MOST];
        static answers all;
        rng g = rng_of(1, 0, 0, n);
        for (int i = 0; i < MOST; i++)
            cases[i] = case_of_flushed_corner(&g);
        const sure_hits hits = hits_in(&all, false, false);
        ask_cases(cases, &hits);
        check_alone(&all, &(many_asked){cases, cases, 1, 1, MOST, SURE_TIER_CERTAIN, false});
    }
}

TEST(test_subnormal_floats)
{
    const sure_ray_f ray = {{0x1.fffcp-121F, 0x1p-127F, -0x1.8p-119F}, {0, 0, 1}, 0, 1};
    const sure_sphere_f ball = {{0, 0, 0}, 0x1p-120F};
    const sure_rays rays = sure_rays_of_f(&ray, 0);
    uint8_t status[8];
    sure_sphere_hits_certain_f(8, &rays, &ball, &(sure_hits){.status = {status, 1}});
    ck_assert(status[0] == SURE_MISS && status[7] == SURE_MISS);
}

/* A coordinate of the normal is written where it alone is wanted. */
TEST(test_coordinate)
{
    const sure_ray ray = {{0.25, 0.5, 9}, {0, 0, -1}, 0, INFINITY};
    const sure_sphere ball = {{0, 0, 0}, 1};
    const sure_rays rays = sure_rays_of(&ray, 0);
    for (int k = 0; k < 3; k++) {
        uint8_t status;
        double coordinate = 9;
        sure_hits hits = {.status = {&status, 0}};
        hits.normal[k].first = &coordinate;
        sure_sphere_hits_exact(1, &rays, &ball, &hits);
        sure_hit hit;
        ck_assert_int_eq(sure_sphere_hit_exact(&ray, &ball, &hit), SURE_HIT);
        sure_vec3 normal = sure_sphere_normal_exact(&ray, &ball, &hit);
        const double alone[] = {normal.x, normal.y, normal.z};
        ck_assert_double_eq(coordinate, alone[k]);
    }
}

SUITE("many")
