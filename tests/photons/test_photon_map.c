/* SPDX-License-Identifier: MIT */
/* What a photon map gathers, against asking every photon. Weights are small whole numbers times a
 * power of two, so that their sums are exact in any order. */
#include "caustics.h"
#include "median.h"
#include "small_scene.h"
#include "suite.h"

enum { MOST = 20000, STREAM = 810 };

static sure_photon photons[MOST];

/* Where they lie. */
typedef sure_vec3 (*layout)(int i);

static double uniform(int i, int axis)
{
    return suite_double(STREAM + (uint64_t)axis, (uint64_t)i, 0);
}

static sure_vec3 in_space(int i)
{
    return suite_doubles(STREAM, (uint64_t)i, 0);
}

static sure_vec3 in_a_plane(int i)
{
    return (sure_vec3){uniform(i, 0), -0.25, uniform(i, 2)};
}

static sure_vec3 on_a_slope(int i)
{
    double x = uniform(i, 0), y = uniform(i, 1);
    return (sure_vec3){x, y, x + y};
}

/* Whole numbers: many at one place, and many at one distance. */
static sure_vec3 on_a_lattice(int i)
{
    return (sure_vec3){floor(8 * uniform(i, 0)), floor(8 * uniform(i, 1)), 3};
}

static sure_vec3 in_one_place(int i)
{
    (void)i;
    return (sure_vec3){-1, 2, 0.5};
}

/* Dense beside sparse, over forty powers of two. */
static sure_vec3 in_clusters(int i)
{
    double size = ldexp(1, -(i % 40));
    return (sure_vec3){size * uniform(i, 0), 0, size * uniform(i, 2)};
}

static const layout layouts[] = {in_space,     in_a_plane,   on_a_slope,
                                 on_a_lattice, in_one_place, in_clusters};
enum { LAYOUTS = sizeof layouts / sizeof *layouts };

/* Three objects, two sides, two parts. */
static sure_photon_face face_of(int i)
{
    return (sure_photon_face){(size_t)(i % 3), (sure_side)(i / 3 % 2),
                              i / 6 % 2 ? SURE_PART_WALL : SURE_PART_SURFACE};
}

/* One in a hundred is heavy. */
static double weight(int i, int channel)
{
    double w = (double)(1 + suite_bits(STREAM + 3, (uint64_t)(3 * i + channel)) % 1000);
    return i % 100 == 7 ? 0x1p30 * w : channel == 2 && i % 5 == 0 ? 0 : w;
}

static void lay(layout how, int count, int faces)
{
    for (int i = 0; i < count; i++) {
        photons[i] = (sure_photon){.face = face_of(i % faces),
                                   .position = how(i),
                                   .weight = {weight(i, 0), weight(i, 1), weight(i, 2)},
                                   .length = 1};
    }
}

static sure_photon_map built(int count, sure_falloff falloff)
{
    sure_photon_map map;
    ck_assert(photon_map_build(photons, (size_t)count, 3, falloff, 2, &map));
    return map;
}

/* By asking each. */

static bool same_face(const sure_photon_face *a, const sure_photon_face *b)
{
    return a->object == b->object && a->side == b->side && a->part == b->part;
}

static double square_of(sure_vec3 p, sure_vec3 q, double scale)
{
    sure_vec3 way = minus(times(scale, p), times(scale, q));
    return way.x * way.x + way.y * way.y + way.z * way.z;
}

/* The square of the radius. */
static double brute_radius(const sure_photon_map *map, int count, const sure_photon_face *face,
                           sure_vec3 q, double reach)
{
    static double squares[MOST];
    uint64_t found = 0;
    for (int i = 0; i < count; i++) {
        double square = square_of(photons[i].position, q, map->scale);
        if (same_face(&photons[i].face, face) && square < reach)
            squares[found++] = square;
    }
    sort_doubles(squares, (int)found);
    return found < map->nearest ? reach : squares[map->nearest - 1];
}

static sure_vec3 brute(const sure_photon_map *map, int count, const sure_photon_face *face,
                       sure_vec3 q, double reach)
{
    double radius = brute_radius(map, count, face, q, reach);
    sure_vec3 sum = {0, 0, 0};
    bool any = false;
    for (int i = 0; i < count; i++) {
        if (!same_face(&photons[i].face, face) ||
            !(square_of(photons[i].position, q, map->scale) < radius))
            continue;
        any = true;
        sum = plus(sum, photons[i].weight);
    }
    double per = any ? pi * radius : 1, scale = map->scale * map->scale;
    return (sure_vec3){sum.x / per * scale, sum.y / per * scale, sum.z / per * scale};
}

/* Of two objects; a box has the last parts. */
TEST(faces_have_places_of_their_own)
{
    bool taken[2 * SURE_PHOTON_FACES] = {false};
    for (int i = 0; i < 2 * SURE_PHOTON_FACES; i++) {
        sure_photon_face face = {(size_t)(i % 2), (sure_side)(i / 2 % 2), (sure_part)(i / 4)};
        size_t place = sure_photon_face_index(&face);
        ck_assert_uint_lt(place, 2 * SURE_PHOTON_FACES);
        ck_assert_ptr_nonnull(sure_part_name(face.part));
        ck_assert(!taken[place]);
        taken[place] = true;
    }
    ck_assert_ptr_null(sure_part_name((sure_part)SURE_PARTS));
}

static double reach_of(const sure_photon_map *map, const sure_photon_face *face)
{
    uint32_t group = map->group_of[sure_photon_face_index(face)];
    return group > 0 ? map->groups[group - 1].reach : 1;
}

static void set_reach(const sure_photon_map *map, double reach)
{
    for (size_t i = 0; i < 3 * SURE_PHOTON_FACES; i++) {
        if (map->group_of[i] > 0)
            ((sure_photon_group *)&map->groups[map->group_of[i] - 1])->reach = reach;
    }
}

/* Among the photons, at one of them, and far off. */
static sure_vec3 point_of(layout how, int i)
{
    sure_vec3 p = how(i);
    if (i % 3 == 1)
        p.x += 0.5 * uniform(i, 1);
    if (i % 7 == 2)
        p = (sure_vec3){30 * uniform(i, 0), 30 * uniform(i, 1), 30 * uniform(i, 2)};
    return p;
}

static void expect_brute(const sure_photon_map *map, layout how, int count, int points)
{
    for (int i = 0; i < points; i++) {
        sure_photon_face face = face_of(i % 12);
        sure_vec3 q = point_of(how, i);
        sure_vec3 got = sure_photon_map_gather(map, &face, q);
        ck_vector_same(got, brute(map, count, &face, q, reach_of(map, &face)));
    }
}

/* Law 1. Any number that is gathered: fewer, as many and more than there are. */
LOOP_TEST(as_if_each_were_asked, LAYOUTS)
{
    static const int counts[] = {1, 2, 7, 8, 9, 17, 100, 1000, 6000};
    static const uint64_t nearest[] = {1, 2, 8, 9, 60, 513, 200, 1500};
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        for (int faces = 1; faces <= 12; faces += 11) {
            lay(layouts[_i], counts[c], faces);
            FREED_BY(photon_map_free)
            sure_photon_map map = built(counts[c], SURE_FALLOFF_INVERSE_SQUARE);
            expect_brute(&map, layouts[_i], counts[c], 12);
            for (size_t k = 0; k < sizeof nearest / sizeof *nearest; k++) {
                map.nearest = nearest[k];
                set_reach(&map, k % 2 ? INFINITY : 0x1p-4);
                expect_brute(&map, layouts[_i], counts[c], 24);
            }
        }
    }
}

/* Whatever the light, in any order, the same bits. */

enum { POINTS = 60, COUNT = 3000 };
static sure_vec3 before[POINTS];

static void gather_all(const sure_photon_map *map, layout how, sure_vec3 light[POINTS],
                       sure_vec3 factor)
{
    for (int i = 0; i < POINTS; i++) {
        sure_photon_face face = face_of(i % 12);
        sure_vec3 q = point_of(how, i);
        light[i] = sure_photon_map_gather(map, &face, by_parts(factor, q));
    }
}

static void expect_as_before(sure_falloff falloff, layout how, sure_vec3 factor)
{
    sure_vec3 light[POINTS];
    FREED_BY(photon_map_free) sure_photon_map map = built(COUNT, falloff);
    gather_all(&map, how, light, factor);
    for (int i = 0; i < POINTS; i++)
        ck_vector_same(light[i], before[i]);
}

/* Weights that fill a double. */
static void lay_any(layout how, sure_falloff falloff)
{
    lay(how, COUNT, 12);
    for (int i = 0; i < COUNT; i++) {
        photons[i].weight.x *= fabs(uniform(i, 2));
        photons[i].weight.y *= fabs(uniform(i, 1));
        photons[i].length = 1 + fabs(uniform(i, 0));
    }
    FREED_BY(photon_map_free) sure_photon_map map = built(COUNT, falloff);
    gather_all(&map, how, before, (sure_vec3){1, 1, 1});
    bool any = false;
    for (int i = 0; i < POINTS; i++)
        any = any || before[i].x > 0;
    ck_assert(any || how == in_one_place);
}

/* Law 2. */
LOOP_TEST(in_any_order, LAYOUTS)
{
    lay_any(layouts[_i], SURE_FALLOFF_NONE);
    for (int order = 0; order < 3; order++) {
        for (size_t i = COUNT - 1; i > 0; i--) {
            size_t j = suite_bits(STREAM + 4 + (uint64_t)order, i) % (i + 1);
            sure_photon other = photons[i];
            photons[i] = photons[j];
            photons[j] = other;
        }
        expect_as_before(SURE_FALLOFF_NONE, layouts[_i], (sure_vec3){1, 1, 1});
    }
}

/* Law 3. */
LOOP_TEST(scaled, LAYOUTS)
{
    static const int powers[] = {300, -300, 1, -7, 151};
    for (int falls = 0; falls < 2; falls++) {
        const sure_falloff falloff = falls ? SURE_FALLOFF_INVERSE_SQUARE : SURE_FALLOFF_NONE;
        for (size_t p = 0; p < sizeof powers / sizeof *powers; p++) {
            double by = ldexp(1, powers[p]), heavier = falls ? by * by : 1;
            lay_any(layouts[_i], falloff);
            for (int i = 0; i < COUNT; i++) {
                sure_photon *photon = &photons[i];
                photon->position = times(by, photon->position);
                photon->weight = times(heavier, photon->weight);
                photon->length *= by;
            }
            expect_as_before(falloff, layouts[_i], (sure_vec3){by, by, by});
        }
    }
}

/* Without fall-off the weight grows with the square of the way: at twice the way four times the
 * light. */
TEST(the_way_without_falloff)
{
    sure_photon_face face = face_of(0);
    sure_vec3 light[2], q = {0.25, -0.25, 0.125};
    for (int twice = 0; twice < 2; twice++) {
        lay(in_a_plane, COUNT, 1);
        for (int i = 0; i < COUNT; i++) {
            photons[i].weight = (sure_vec3){1, 1, 1};
            photons[i].length = twice ? 6 : 3;
        }
        FREED_BY(photon_map_free) sure_photon_map map = built(COUNT, SURE_FALLOFF_NONE);
        double radius = brute_radius(&map, COUNT, &face, q, INFINITY);
        set_reach(&map, INFINITY);
        light[twice] = sure_photon_map_gather(&map, &face, q);
        double way = light[0].x * pi * (radius / (map.scale * map.scale)) /
                     (4 * pi * (double)(map.nearest - 1));
        ck_assert_msg(fabs(way - 9) <= 9 * 16 * DBL_EPSILON, "%a", way);
    }
    ck_vector_same(light[1], (sure_vec3){4 * light[0].x, 4 * light[0].y, 4 * light[0].z});
}

/* So that the estimate is consistent: more and more, and an ever smaller share. */
TEST(how_many_are_gathered)
{
    for (uint64_t n = 1; n < UINT64_C(1) << 40; n *= 16) {
        ck_assert_uint_gt(photon_map_nearest(16 * n), n > 4096 ? photon_map_nearest(n) : 0);
        double before_share = (double)photon_map_nearest(n) / (double)n;
        ck_assert((double)photon_map_nearest(16 * n) / (16 * (double)n) < before_share);
    }
}

/* What k of the heaviest photons light at the reach is half a step of 1/255. */
TEST(the_reach)
{
    for (int falls = 0; falls < 2; falls++) {
        sure_photon_face face = face_of(0);
        photons[0] = (sure_photon){
            .face = face, .position = {3, 0, 0}, .weight = {1, 5, 2}, .length = falls ? 77 : 1};
        FREED_BY(photon_map_free)
        sure_photon_map map = built(1, falls ? SURE_FALLOFF_INVERSE_SQUARE : SURE_FALLOFF_NONE);
        sure_vec3 light = sure_photon_map_gather(&map, &face, photons[0].position);
        ck_assert(fabs((double)map.nearest * light.y * 510 - 1) <= 16 * DBL_EPSILON);
    }
}

SUITE("photon_map")
