/* SPDX-License-Identifier: MIT */
/* Law 1 of many.h: every answer is the single call's. */
#include "every_case.h"

#include <surehit/many.h>

enum { MOST = 70, FILLER = 0x5a };

/* What a call may write, and what lies between: all of it is compared. */
typedef struct {
    unsigned char room[MOST][8 * (int)sizeof(double)];
} answers;

/* A ray, its object and two answers beside them, off any alignment. */
typedef struct {
    char odd;
    sure_ray ray;
    char between[3];
    double numbers[SURE_SHAPE_NUMBERS];
} __attribute__((packed)) user_struct;

static sure_hits hits_in(answers *to, bool normals)
{
    unsigned char *at = to->room[0];
    const ptrdiff_t stride = sizeof to->room[0];
#define NUMBER_AT(place) {at + (place), stride}
    sure_hits hits = {
        .status = {at, stride},
        .part = {at + 1, stride},
        .leaves = {at + 2, stride},
        .t = NUMBER_AT(5),
        .t_error = NUMBER_AT(14),
    };
    if (normals)
        for (int k = 0; k < 3; k++)
            hits.normal[k] = (sure_number_column)NUMBER_AT(25 + 10 * k);
    memset(to, FILLER, sizeof *to);
    return hits;
}

static void put(unsigned char *to, const void *from, size_t size)
{
    memcpy(to, from, size);
}

static void answer_alone(const sure_case *c, sure_tier tier, bool normals, unsigned char *to)
{
    sure_hit hit;
    sure_status status = sure_object_hit(&c->ray, &c->object, tier, &hit);
    to[0] = (unsigned char)status;
    if (status != SURE_HIT)
        return;
    to[1] = (unsigned char)hit.part;
    to[2] = (unsigned char)hit.leaves;
    put(to + 5, &hit.t, sizeof hit.t);
    put(to + 14, &hit.t_error, sizeof hit.t_error);
    if (!normals)
        return;
    sure_vec3 normal = sure_object_normal(&c->ray, &c->object, tier, &hit);
    put(to + 25, &normal.x, sizeof normal.x);
    put(to + 35, &normal.y, sizeof normal.y);
    put(to + 45, &normal.z, sizeof normal.z);
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

static void check_pairs(sure_shape shape, int count, sure_tier tier, bool backward, bool normals)
{
    static sure_case cases[MOST];
    static user_struct users[MOST];
    static answers all, alone;
    fill(shape, (uint64_t)(count * 64 + (int)tier), count, cases, users);
    const int first = backward && count > 0 ? count - 1 : 0;
    const ptrdiff_t stride = (backward ? -1 : 1) * (ptrdiff_t)sizeof(user_struct);
    const char *at = (const char *)&users[first];
    sure_rays rays = sure_rays_of(at + offsetof(user_struct, ray), stride);
    sure_objects objects = sure_objects_of(shape, at + offsetof(user_struct, numbers), stride);
    sure_hits hits = hits_in(&all, normals);
    sure_objects_hits((size_t)count, &rays, &objects, tier, &hits);
    (void)hits_in(&alone, normals);
    for (int i = 0; i < count; i++)
        answer_alone(&cases[backward ? count - 1 - i : i], tier, normals, alone.room[i]);
    ck_assert_mem_eq(&all, &alone, sizeof all);
}

TEST(test_pairs)
{
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++)
        for (int count = 0; count <= MOST; count++)
            for (sure_tier tier = 0; tier < SURE_TIERS; tier++)
                check_pairs(shape, count, tier, count & 1, count & 2);
}

/* One object for many rays, and one ray for many objects. */
#define OF_ONE(shape, SHAPE, tier, TIER)                                                           \
    do {                                                                                           \
        sure_hits hits = hits_in(&all, true);                                                      \
        sure_rays rays = sure_rays_of(&cases[0].ray, sizeof *cases);                               \
        sure_##shape##_hits_##tier(MOST, &rays, &cases[0].object.as.shape, &hits);                 \
        (void)hits_in(&alone, true);                                                               \
        for (int i = 0; i < MOST; i++)                                                             \
            answer_alone(&(sure_case){.ray = cases[i].ray, .object = cases[0].object},             \
                         SURE_TIER_##TIER, true, alone.room[i]);                                   \
        ck_assert_mem_eq(&all, &alone, sizeof all);                                                \
        hits = hits_in(&all, true);                                                                \
        rays = sure_rays_of(&cases[0].ray, 0);                                                     \
        sure_objects objects =                                                                     \
            sure_objects_of(SURE_SHAPE_##SHAPE, &cases[0].object.as, sizeof *cases);               \
        sure_objects_hits(MOST, &rays, &objects, SURE_TIER_##TIER, &hits);                         \
        (void)hits_in(&alone, true);                                                               \
        for (int i = 0; i < MOST; i++)                                                             \
            answer_alone(&(sure_case){.ray = cases[0].ray, .object = cases[i].object},             \
                         SURE_TIER_##TIER, true, alone.room[i]);                                   \
        ck_assert_mem_eq(&all, &alone, sizeof all);                                                \
    } while (0);

#define ONE_TEST(shape, SHAPE)                                                                     \
    TEST(test_one_##shape)                                                                         \
    {                                                                                              \
        static answers all, alone;                                                                 \
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
