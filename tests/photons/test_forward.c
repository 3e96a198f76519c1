/* SPDX-License-Identifier: MIT */
#include "suite.h"
#include "test_shape.h"
#include "small_scene.h"

#include <Random123/threefry.h>

static const sure_vec3 black = {0, 0, 0}, white = {1, 1, 1};

/* Of a normal variable no more than one in 10^9 is so many standard deviations off. */
static const double doubt = 6.2;

/* The tiers that the estimates are tested in, as _i. */
static const sure_tier tested[] = {SURE_TIER_TEXTBOOK, SURE_TIER_CERTAIN};
#define TESTED (int)(sizeof tested / sizeof *tested)

enum { PIXELS = 16, ALL = PIXELS }; /* the last one is the sum over all */

/* Sums over samples, or photons, of a pixel's value and its square. */
typedef struct {
    sure_vec3 now, sum, square;
    double count;
} estimate;

typedef struct {
    int width;
    estimate pixel[PIXELS + 1];
    sure_forward_statistics statistics;
} picture;

static void take(void *film, int column, int row, sure_vec3 value)
{
    picture *to = film;
    estimate *pixel = &to->pixel[row * to->width + column];
    ck_assert(column >= 0 && column < to->width && row >= 0 && row * to->width < PIXELS);
    ck_assert(value.x >= 0 && value.y >= 0 && value.z >= 0);
    pixel->now = plus(pixel->now, value);
    to->pixel[ALL].now = plus(to->pixel[ALL].now, value);
}

/* Ends a sample. */
static void settle(estimate *of)
{
    const sure_vec3 now = of->now;
    of->sum = plus(of->sum, now);
    of->square = plus(of->square, by_parts(now, now));
    of->now = black;
    of->count++;
}

static picture traced(const sure_scene *scene, sure_tier tier, const sure_forward_options *options,
                      int photons)
{
    picture of = {.width = scene->width};
    ck_assert_int_le(scene->width * scene->height, PIXELS);
    for (int i = 0; i < photons; i++) {
        const uint64_t before = of.statistics.reached;
        sure_forward_photon(scene, tier, options, (uint64_t)i, take, &of, &of.statistics);
        for (int k = 0; k <= PIXELS && of.statistics.reached > before; k++)
            settle(&of.pixel[k]);
    }
    for (int k = 0; k <= PIXELS; k++) /* all the others gave nothing */
        of.pixel[k].count = photons;
    ck_assert_uint_eq(of.statistics.emitted, (uint64_t)photons);
    return of;
}

static estimate known(sure_vec3 value)
{
    return (estimate){.sum = value, .square = by_parts(value, value), .count = 1};
}

/* Of its mean. */
static double variance(const estimate *of, int color)
{
    double mean = coordinate(of->sum, color) / of->count;
    return fmax(0, coordinate(of->square, color) / of->count - mean * mean) / of->count;
}

static void agree(double off, double variance_of_both, double expected, double sharp,
                  const char *what)
{
    double bound = doubt * sqrt(variance_of_both);
    if (fabs(off) > bound + expected * 0x1p-40) /* where both are the same number, up to rounding */
        ck_abort_msg("%s: %g, off by %g, more than %g", what, expected, off, bound);
    if (bound > sharp * expected)
        ck_abort_msg("%s: %g is told no better than by %g", what, expected, bound);
}

/* The mean is the other one, so far as both are known; and it is known so well that the share
 * `sharp` of it would be missed. */
static void same(const estimate *mean, const estimate *other, double sharp, const char *what)
{
    for (int i = 0; i < 3; i++) {
        double expected = coordinate(other->sum, i) / other->count;
        agree(coordinate(mean->sum, i) / mean->count - expected,
              variance(mean, i) + variance(other, i), expected, sharp, what);
    }
}

static const sure_forward_options once = {1, 1, 0};

/* What is seen in the first pixel, by so many photons. */
static void expect_seen(const sure_scene *scene, sure_tier tier,
                        const sure_forward_options *options, int photons, const estimate *value,
                        double sharp, const char *what)
{
    picture seen = traced(scene, tier, options, photons);
    same(&seen.pixel[0], value, sharp, what);
}

/* So many of all, where each is one with that probability. */
static void happens(uint64_t count, uint64_t of, double probability, const char *what)
{
    double off = (double)count - (double)of * probability;
    double bound = doubt * sqrt((double)of * probability * (1 - probability));
    if (fabs(off) > bound)
        ck_abort_msg("%s: %g of %g, off by %g, more than %g", what, (double)count, (double)of, off,
                     bound);
}

/* What is seen backward in places of the pixel. */
static estimate backward(const sure_scene *scene, sure_tier tier, int column, int row, int samples)
{
    enum { FINE = 1 << 12 };
    rng g = rng_of(810, 0, 0, 0);
    estimate of = {.count = 0};
    sure_scene fine = *scene;
    fine.width *= FINE;
    fine.height *= FINE;
    for (int i = 0; i < samples; i++) {
        int x = column * FINE + rng_integer(&g, 0, FINE - 1);
        int y = row * FINE + rng_integer(&g, 0, FINE - 1);
        of.now = sure_backward_pixel(&fine, tier, x, y);
        settle(&of);
    }
    return of;
}

/* The light's power on each unit of area of a sphere about it. */
static double on_sphere(double power, double radius)
{
    return power / (4 * pi * radius * radius);
}

/* Threefry's published first block for zeros; then the next one. */
TEST(test_random)
{
    random_stream s = random_stream_of(0, (random_purpose)0, 0);
    ck_assert_uint_eq(random_bits(&s), UINT64_C(0x09218ebde6c85537));
    ck_assert_uint_eq(random_bits(&s), UINT64_C(0x55941f5266d86105));
    ck_assert_uint_eq(random_bits(&s), UINT64_C(0x4bd25e16282434dc));
    ck_assert_uint_eq(random_bits(&s), UINT64_C(0xee29ec846bd2e40b));
    random_stream again = random_stream_of(0, (random_purpose)0, 0);
    ck_assert_uint_ne(random_bits(&s), random_bits(&again));
    ck_double_same(random_fraction(&again), (double)(0x55941f5266d86105 >> 11) * 0x1p-53);
}

/* Random123's blocks, of any key and counter. */
TEST(test_random123)
{
    for (uint64_t i = 0; i < 1000; i++) {
        const threefry4x64_key_t key = {{suite_bits(3, i), RANDOM_CAUSTIC, 0, 0}};
        const uint64_t number = suite_bits(4, i);
        random_stream s = random_stream_of(key.v[0], RANDOM_CAUSTIC, number);
        for (uint64_t block = 0; block < 3; block++) {
            const threefry4x64_ctr_t counter = {{number, block, 0, 0}};
            const threefry4x64_ctr_t words = threefry4x64(counter, key);
            for (int word = 0; word < 4; word++)
                ck_assert_uint_eq(random_bits(&s), words.v[word]);
        }
    }
}

/* The moments of a uniform direction: each component's mean 0, its square's 1/3. */
TEST(test_direction)
{
    enum { COUNT = 100000 };
    random_stream s = random_stream_of(3, RANDOM_PHOTON, 3);
    estimate first = {.count = 0}, second = {.count = 0};
    for (int i = 0; i < COUNT; i++) {
        sure_vec3 d = random_direction(&s);
        ck_assert(fabs(dot(d, d) - 1) < 0x1p-49); /* a dozen roundings */
        first.now = plus(d, white);
        second.now = by_parts(d, d);
        settle(&first);
        settle(&second);
    }
    const estimate one = known(white), third = known(times(1. / 3, white));
    same(&first, &one, 0.02, "direction");
    same(&second, &third, 0.02, "direction's square");
}

/* A scene of eight objects out of a seed, half of them in a ball. */
typedef struct {
    sure_object objects[9];
    sure_material materials[9];
    sure_light lights[2];
} world;

static sure_vec3 place(rng *g, double reach)
{
    double x = rng_between(g, -reach, reach), y = rng_between(g, -reach, reach);
    return (sure_vec3){x, y, rng_between(g, -reach, reach)};
}

static sure_object random_object(rng *g)
{
    sure_vec3 p = place(g, 4), q = place(g, 4);
    double radius = rng_between(g, 0.5, 1.5);
    return object_made((sure_shape)rng_integer(g, 0, SURE_SHAPES - 1), p, q, q, radius);
}

static sure_material material_of(rng *g)
{
    int kind = rng_integer(g, 0, 3);
    sure_material made = {.color = {rng_between(g, 0, 1), 0.5, 0.9}};
    if (kind == 0)
        made.mirror = rng_between(g, 0, 1);
    if (kind == 1)
        made.refract = rng_between(g, 1, 2);
    return made;
}

static sure_scene world_of(uint64_t stream, world *of)
{
    rng g = rng_of(stream, 0, 0, 0);
    for (int i = 0; i < 9; i++) {
        of->objects[i] = random_object(&g);
        of->materials[i] = material_of(&g);
    }
    of->objects[8] = sphere(0, 0, 0, 20);
    of->lights[0] = (sure_light){place(&g, 3), {1, 0.5, 0.25}, 2};
    of->lights[1] = (sure_light){place(&g, 3), {0, 0.5, 1}, 1};
    sure_scene made = falling_off(of->objects, of->materials, stream % 2 ? 9 : 8, of->lights, 2);
    made.camera.position.z = 4;
    made.depth = 3;
    return made;
}

static sure_forward_statistics sum_of_worlds(sure_tier tier, double aperture)
{
    enum { WORLDS = 40, PHOTONS = 250 };
    sure_forward_statistics sum = {0};
    for (uint64_t i = 0; i < WORLDS; i++) {
        world of;
        sure_scene scene = world_of(820 + i, &of);
        const sure_forward_options options = {i, 1 + (int)(i % 4), aperture};
        const sure_forward_statistics a = traced(&scene, tier, &options, PHOTONS).statistics;
        ck_assert_uint_eq(a.emitted, a.escaped + a.absorbed + a.stopped + a.entered);
        ck_assert_uint_le(a.reached, a.through);
        ck_assert_uint_le(a.absorbed, a.lit);
        ck_assert_uint_le(a.lit, (uint64_t)options.bounces * a.emitted);
        sure_forward_statistics_add(&sum, &a);
    }
    ck_assert_uint_eq(sum.emitted, WORLDS * PHOTONS);
    return sum;
}

/* Law 2: whatever there is to meet. */
LOOP_TEST(test_law_2, SURE_TIERS)
{
    const sure_forward_statistics joined = sum_of_worlds((sure_tier)_i, 0);
    ck_assert(joined.escaped && joined.absorbed && joined.stopped && joined.lit);
    ck_assert(joined.reached && joined.reached < joined.through);
    ck_assert_uint_eq(joined.entered, 0);
    const sure_forward_statistics open = sum_of_worlds((sure_tier)_i, 1);
    ck_assert(open.escaped && open.absorbed && open.stopped && open.lit);
    ck_assert(open.reached && open.reached < open.through && open.reached < open.entered);
}

/* Nothing gets out of a white box: into the eye, or until the last surface; of a black one it does
 * not get further than to the first. */
LOOP_TEST(test_box, SURE_TIERS)
{
    enum { PHOTONS = 5000 };
    const sure_object box[] = {plane(-3, 0, 0, 1, 0, 0), plane(3, 0, 0, 1, 0, 0),
                               plane(0, -3, 0, 0, 1, 0), plane(0, 3, 0, 0, 1, 0),
                               plane(0, 0, -3, 0, 0, 1), plane(0, 0, 3, 0, 0, 1)};
    sure_material walls[6];
    const sure_light light = {{1, 0.5, -1}, {1, 1, 1}, 1};
    const sure_forward_options options = {1, 8, 1};
    for (int i = 0; i < 6; i++)
        walls[i] = (sure_material){.color = white};
    sure_scene scene = falling_off(box, walls, 6, &light, 1);
    sure_forward_statistics a = traced(&scene, (sure_tier)_i, &options, PHOTONS).statistics;
    ck_assert_uint_eq(a.entered + a.stopped, PHOTONS);
    ck_assert(a.entered > 0 && a.stopped > 0);
    for (int i = 0; i < 6; i++)
        walls[i].color = black;
    a = traced(&scene, (sure_tier)_i, &(sure_forward_options){1, 8, 0}, PHOTONS).statistics;
    ck_assert_uint_eq(a.absorbed, PHOTONS);
    ck_assert_uint_eq(a.lit, PHOTONS);
}

/* Law 1: alone, in any order, again; and other numbers and seeds have other ways. */
LOOP_TEST(test_law_1, SURE_TIERS)
{
    enum { PHOTONS = 200 };
    world of;
    sure_scene scene = world_of(910, &of);
    sure_forward_options options = {5, 3, 0};
    sure_vec3 ways[PHOTONS];
    int others = 0, seen = 0;
    for (int i = 0; i < 3 * PHOTONS; i++) {
        int number = i < PHOTONS ? i : PHOTONS - 1 - i % PHOTONS;
        picture alone = {.width = 1};
        options.seed = i < 2 * PHOTONS ? 5 : 6;
        sure_forward_photon(&scene, (sure_tier)_i, &options, (uint64_t)number, take, &alone,
                            &alone.statistics);
        sure_vec3 sum = alone.pixel[0].now;
        if (i < PHOTONS)
            ways[number] = sum;
        else if (i < 2 * PHOTONS)
            ck_vector_same(sum, ways[number]);
        else
            others += sum.y != ways[number].y;
        seen += sum.y > 0;
        if (i > 0 && i < PHOTONS && sum.y > 0)
            ck_assert(sum.y != ways[number - 1].y);
    }
    ck_assert_int_gt(seen, 100);
    ck_assert_int_gt(others, 50);
}

/* A lamp in a wall lights the other one, of its own wall nothing. */
LOOP_TEST(test_lamp_in_a_wall, SURE_TIERS)
{
    const sure_object walls[] = {plane(0, 0, -4, 0, 0, 1), plane(1, 0, 0, -1, 0, 0)};
    const sure_material materials[] = {{.color = {1, 1, 1}}, {.color = {1, 1, 1}}};
    const sure_light light = {{1, 0, -3}, {1, 1, 1}, 1};
    sure_scene scene = falling_off(walls, materials, 2, &light, 1);
    const sure_forward_statistics a = traced(&scene, (sure_tier)_i, &once, 500).statistics;
    ck_assert_uint_eq(a.lit + a.escaped, 500);
    ck_assert(a.lit > 200 && a.lit < 300 && a.reached > 20);
}

/* Nothing of a wall's dark side, of a wall behind the eye, or with a disc in between. */
LOOP_TEST(test_dark, SURE_TIERS)
{
    static const struct {
        size_t objects;
        double light, eye; /* their z; the wall's is -4 */
        bool passes, seen;
    } rows[] = {
        {1, -3, 0, true, true},    {2, -3, 0, true, false},  {1, -5, 0, false, false},
        {1, -3, -3.5, true, true}, /* its window is beyond the wall, which is seen all the same */
        {1, -3, -4, false, false}, {1, -9, -6, false, false}};
    const sure_object objects[] = {plane(0, 0, -4, 0, 0, 1),
                                   {SURE_SHAPE_DISC, {.disc = {{0, 0, -1}, {0, 0, 1}, 2}}}};
    const sure_material materials[] = {{.color = {1, 1, 1}}, {.color = {1, 1, 1}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const sure_light light = {{0, 0, rows[i].light}, {1, 1, 1}, 1};
        sure_scene scene = falling_off(objects, materials, rows[i].objects, &light, 1);
        scene.camera.position.z = rows[i].eye;
        picture made = traced(&scene, (sure_tier)_i, &once, 500);
        const sure_forward_statistics *a = &made.statistics;
        ck_assert_msg(a->lit > 0 && (a->through > 0) == rows[i].passes &&
                          a->reached == (rows[i].seen ? a->through : 0) &&
                          (made.pixel[0].sum.x > 0) == rows[i].seen,
                      "row %zu", i);
    }
}

/* The opening is entered from the front alone. What comes straight from the light is not drawn. */
LOOP_TEST(test_entering, SURE_TIERS)
{
    enum { PHOTONS = 20000 };
    sure_light light = {{0, 0, -1}, {1, 1, 1}, 1};
    const sure_scene scene = falling_off(NULL, NULL, 0, &light, 1);
    const sure_forward_options options = {1, 1, 1};
    picture seen = traced(&scene, (sure_tier)_i, &options, PHOTONS);
    happens(seen.statistics.entered, PHOTONS, (1 - sqrt(0.5)) / 2, "straight into the opening");
    ck_assert_uint_eq(seen.statistics.entered + seen.statistics.escaped, PHOTONS);
    ck_assert_uint_eq(seen.statistics.reached,
                      seen.statistics.entered); /* from the window's plane */
    ck_double_same(seen.pixel[ALL].sum.x, 0);
    light.position.z = -3; /* in the opening 1 of 3 from the axis, in the window 2 by 2 */
    seen = traced(&scene, (sure_tier)_i, &options, PHOTONS);
    happens(seen.statistics.entered, PHOTONS, (1 - 3 / sqrt(10)) / 2, "into the opening");
    happens(seen.statistics.through, PHOTONS, 4 * asin(1. / 5) / (4 * pi), "through the window");
    ck_assert_uint_eq(seen.statistics.reached, seen.statistics.entered);
    light.position.z = -0.5; /* behind the window */
    seen = traced(&scene, (sure_tier)_i, &options, PHOTONS);
    ck_assert(seen.statistics.entered > 0 && seen.statistics.through == 0);
    for (int z = 0; z < 2; z++) { /* in the opening itself, and behind it */
        light.position.z = z;
        seen = traced(&scene, (sure_tier)_i, &options, PHOTONS);
        ck_assert_uint_eq(seen.statistics.escaped, PHOTONS);
        ck_assert_uint_eq(seen.statistics.through, 0);
    }
}

/* A disc just before the opening: nothing enters, exactly in its plane nothing either, behind it
 * all does. Before the window nothing passes that. */
TEST(test_covered_opening)
{
    enum { PHOTONS = 2000 };
    const sure_light light = {{0, 0, -3}, {1, 1, 1}, 1};
    const sure_material lid = {.color = {0, 0, 0}};
    const double places[] = {-2, -0x1p-40, 0, 0x1p-40};
    for (int i = 0; i < 4; i++) {
        const sure_object disc = {SURE_SHAPE_DISC, {.disc = {{0, 0, places[i]}, {0, 0, 1}, 2}}};
        const sure_scene scene = falling_off(&disc, &lid, 1, &light, 1);
        sure_forward_statistics a =
            traced(&scene, SURE_TIER_CERTAIN, &(sure_forward_options){1, 1, 1}, PHOTONS).statistics;
        ck_assert(a.absorbed > 0);
        ck_assert_int_eq(a.through > 0, i > 0);
        ck_assert_int_eq(a.entered > 0, i == 3);
    }
}

/* No light has any power: no photon. */
TEST(test_no_power)
{
    const sure_light light = {{0, 0, -3}, {0, 0, 0}, 1};
    const sure_scene scene = falling_off(NULL, NULL, 0, &light, 1);
    sure_forward_statistics statistics = {0};
    sure_forward_photon(&scene, SURE_TIER_CERTAIN, &once, 0, take, NULL, &statistics);
    ck_assert_uint_eq(statistics.emitted, 0);
}

/* Two lights, each in a ball of its own: by power, which is brightness times the mean colour; and
 * each gives what it has. */
LOOP_TEST(test_lights, TESTED)
{
    enum { PHOTONS = 100000 };
    const sure_object objects[] = {sphere(0, 0, 0, 4), sphere(9, 0, 0, 4)};
    const sure_material materials[] = {{.color = {1, 1, 1}}, {.color = {0, 0, 0}}};
    const sure_light lights[] = {{{0, 0, 0}, {1, 0.25, 0.25}, 2}, /* power 1 */
                                 {{9, 0, 0}, {1, 1, 1}, 3},
                                 {{0, 1, 0}, {0, 0, 0}, 9}};
    sure_scene scene = falling_off(objects, materials, 2, lights, 3);
    picture seen = traced(&scene, tested[_i], &once, PHOTONS);
    happens(seen.statistics.absorbed, PHOTONS, 0.75, "photons of the stronger light");
    estimate value = known(times(on_sphere(2, 4), lights[0].color));
    same(&seen.pixel[0], &value, 0.2, "the weaker light");
    scene.camera.position.x = 9;
    seen = traced(&scene, tested[_i], &once, 1000);
    ck_assert(seen.statistics.reached > 0 && seen.pixel[0].sum.x == 0);
}

/* A ball lit from its middle is as bright everywhere, and so it stays however often the light is
 * scattered: albedo E (1 + albedo + albedo^2 + ...), from any eye, in any pixel. */
static sure_scene ball_scene(const sure_object *ball, const sure_material *wall,
                             const sure_light *light)
{
    sure_scene scene = falling_off(ball, wall, 1, light, 1);
    scene.camera = (sure_camera){{2, -1, 1.5}, 1, 2.5, 2};
    scene.width = 4;
    scene.height = 3;
    return scene;
}

static estimate ball_value(const sure_material *wall, const sure_light *light, int bounces)
{
    sure_vec3 value = black, direct = times(on_sphere(light->brightness, 4), light->color);
    for (int k = 0; k < bounces; k++)
        value = by_parts(wall->color, plus(direct, value));
    return known(value);
}

/* A clear ball in it that bends nothing changes nothing: each way from wall to wall has a depth of
 * its own. */
LOOP_TEST(test_ball_in_ball, TESTED)
{
    const sure_object balls[] = {sphere(0, 0, 0, 4), sphere(0, 0, 0, 3)};
    const sure_material materials[] = {{.color = {0.75, 0.5, 0.25}},
                                       {.color = {1, 1, 1}, .refract = 1}};
    const sure_light light = {{0, 0, 0}, {1, 0.5, 0.75}, 64};
    sure_scene scene = falling_off(balls, materials, 2, &light, 1);
    scene.camera.position.z = -3.25;
    scene.depth = 2;
    estimate value = ball_value(&materials[0], &light, 3);
    expect_seen(&scene, tested[_i], &(sure_forward_options){1, 3, 0}, 200000, &value, 0.15,
                "ball around a clear one");
}

/* Law 3: objects, lights of different powers and colours, shadows, a wall seen aslant; of the last
 * object the mirror isn't followed at depth 0. */
LOOP_TEST(test_law_3, TESTED)
{
    const sure_object objects[] = {
        plane(0, -2, 0, 0.1, 1, 0.2),
        sphere(0.5, -0.5, -5, 1),
        {SURE_SHAPE_CYLINDER, {.cylinder = {{-2, -2, -5}, {-1, 1, -6}, 0.5}}},
        plane(0, 0, -9, -0.5, 0, 1)};
    const sure_material materials[] = {{.color = {1, 0.5, 0.5}},
                                       {.color = {0.5, 1, 0.5}},
                                       {.color = {0.5, 0.5, 1}},
                                       {.color = {0.75, 0.5, 0.75}, .mirror = 0.5}};
    const sure_light lights[] = {{{3, 3, -2}, {1, 1, 0.5}, 100}, {{-4, 2, -4}, {0.25, 0.5, 1}, 50}};
    sure_scene scene = falling_off(objects, materials, 4, lights, 2);
    scene.width = scene.height = 3;
    scene.depth = 0;
    for (int falloff = 0; falloff < 2; falloff++) {
        scene.falloff = falloff ? SURE_FALLOFF_INVERSE_SQUARE : SURE_FALLOFF_NONE;
        picture seen = traced(&scene, tested[_i], &once, 200000);
        for (int i = 0; i < 9; i++) {
            estimate value = backward(&scene, tested[_i], i % 3, i / 3, 2000);
            same(&seen.pixel[i], &value, 0.3, "pixel against backward");
        }
    }
}

/* What one light gives a point of the wall at z = -4, without its colour. */
static double on_wall(const sure_light *light, double x, double y)
{
    sure_vec3 way = plus(light->position, (sure_vec3){-x, -y, 4});
    double square = dot(way, way);
    return light->brightness / (4 * pi * square) * way.z / sqrt(square);
}

/* The wall seen through places of the window from places of an opening. */
static estimate wall_through(const sure_scene *scene, double aperture, int samples)
{
    rng g = rng_of(811, 0, 0, 0);
    estimate of = {.count = 0};
    while (of.count < samples) {
        double x = rng_between(&g, -1, 1), y = rng_between(&g, -1, 1);
        double column = rng_between(&g, -0.5, 0.5), row = rng_between(&g, -0.5, 0.5);
        if (x * x + y * y > 1)
            continue;
        sure_vec3 from = {aperture * x, aperture * y, 0};
        sure_vec3 at = {column * scene->camera.viewport_width, row * scene->camera.viewport_height,
                        0};
        double light =
            on_wall(&scene->lights[0], from.x + 4 * (at.x - from.x), from.y + 4 * (at.y - from.y));
        of.now = times(light, scene->materials[0].color);
        settle(&of);
    }
    return of;
}

/* The wider the opening the more of the wall is mixed; a pinhole is its limit. The same where the
 * camera stands elsewhere and looks along -x. */
LOOP_TEST(test_openings, TESTED)
{
    const sure_object walls[] = {plane(0, 0, -4, 0, 0, 1), plane(-2, 3, 5, 1, 0, 0)};
    const sure_material matte = {.color = {0.5, 1, 0.75}};
    const sure_light lights[] = {{{1, 0.5, -3}, {1, 1, 1}, 10}, {{-1, 4, 5.5}, {1, 1, 1}, 10}};
    const double apertures[] = {0, 0.25, 0.75}, sharp[] = {0.05, 0.5, 0.2};
    sure_scene scene = falling_off(walls, &matte, 1, lights, 1);
    scene.camera.viewport_width = scene.camera.viewport_height = 1;
    sure_scene elsewhere = scene;
    elsewhere.objects++;
    elsewhere.lights++;
    elsewhere.camera.position = (sure_vec3){2, 3, 5};
    elsewhere.turn = (sure_mat3){{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
    for (int i = 0; i < 6; i++) {
        double aperture = apertures[i / 2];
        estimate value = wall_through(&scene, aperture, 20000);
        expect_seen(i % 2 ? &elsewhere : &scene, tested[_i],
                    &(sure_forward_options){1, 1, aperture}, 300000, &value, sharp[i / 2],
                    "opening");
    }
}

/* The light before a mirror lights the wall once more, from behind it. */
LOOP_TEST(test_mirror, TESTED)
{
    const sure_object objects[] = {plane(0, 0, -4, 0, 0, 1), plane(-3, 0, 0, -1, 0, 0)};
    const sure_material materials[] = {{.color = {0.5, 1, 0.75}}, {.mirror = 0.5}};
    const sure_light lights[] = {{{1, 0.5, -2}, {1, 1, 1}, 10}, {{-7, 0.5, -2}, {1, 1, 1}, 5}};
    sure_scene scene = falling_off(objects, materials, 2, lights, 1);
    scene.camera.viewport_width = scene.camera.viewport_height = 1;
    for (int falloff = 0; falloff < 2; falloff++) {
        scene.falloff = falloff ? SURE_FALLOFF_INVERSE_SQUARE : SURE_FALLOFF_NONE;
        sure_scene doubled = scene;
        doubled.object_count = 1;
        doubled.light_count = 2;
        estimate value = backward(&doubled, tested[_i], 0, 0, 20000);
        expect_seen(&scene, tested[_i], &once, 200000, &value, 0.06, "wall beside a mirror");
    }
}

/* A clear sheet lets through what it doesn't reflect, in its colour. */
LOOP_TEST(test_sheet, TESTED)
{
    const sure_object objects[] = {plane(0, 0, -4, 0, 0, 1), plane(3, 0, 0, 1, 0, 0)};
    const sure_light light = {{4, 0, -2}, {1, 1, 1}, 100};
    sure_material materials[] = {{.color = {0.5, 1, 0.75}}, {.color = {1, 0.5, 0.75}}};
    sure_scene scene = falling_off(objects, materials, 2, &light, 1);
    scene.camera.viewport_width = scene.camera.viewport_height = 1;
    for (int n = 1; n <= 3; n++) {
        rng g = rng_of(812, 0, 0, 0);
        estimate value = {.count = 0};
        materials[1].refract = n;
        for (int i = 0; i < 20000; i++) {
            sure_vec3 at = place(&g, 2);
            at.z = -4;
            sure_vec3 way = plus(at, times(-1, light.position));
            double face = sure_refract_fresnel_textbook(way, (sure_vec3){1, 0, 0}, 1. / n);
            double through = 1 - 2 * face / (1 + face);
            double lit = through * on_wall(&light, at.x, at.y);
            value.now = times(lit, by_parts(materials[0].color, materials[1].color));
            settle(&value);
        }
        expect_seen(&scene, tested[_i], &once, 200000, &value, 0.12, "wall behind a sheet");
    }
}

/* A light in the middle of a ball of glass: a share F stays inside each time. The depth ends it. */
LOOP_TEST(test_glass_ball, TESTED)
{
    enum { PHOTONS = 100000 };
    const sure_object objects[] = {sphere(0, 0, 0, 4), sphere(0, 0, 0, 1)};
    const sure_material materials[] = {{.color = {0.5, 0.5, 0.5}},
                                       {.color = {1, 0.5, 0.75}, .refract = 4}};
    const sure_light light = {{0, 0, 0}, {1, 1, 1}, 64};
    const double face = 0.36; /* ((4 - 1) / (4 + 1))^2 */
    sure_scene scene = falling_off(objects, materials, 2, &light, 1);
    scene.camera.position.z = -2;
    for (int depth = 0; depth < 4; depth++) {
        double out = 1 - pow(face, depth), lit = 0.5 * out * on_sphere(64, 4);
        estimate value = known(times(lit, materials[1].color));
        scene.depth = depth;
        picture seen = traced(&scene, tested[_i], &once, PHOTONS);
        same(&seen.pixel[0], &value, 0.12, "around a ball of glass");
        happens(seen.statistics.lit, PHOTONS, out, "out of a ball of glass");
        happens(seen.statistics.absorbed, PHOTONS, out / 2, "absorbed around a ball of glass");
    }
}

/* Lit from beside the middle, what the walls scatter is even all the same. */
LOOP_TEST(test_ball_beside, TESTED)
{
    const sure_object ball = sphere(0, 0, 0, 4);
    const sure_material wall = {.color = {0.75, 0.75, 0.75}};
    const sure_light light = {{0, 2, -2.5}, {1, 1, 1}, 64};
    sure_scene scene = ball_scene(&ball, &wall, &light);
    picture seen = traced(&scene, tested[_i], &(sure_forward_options){1, 2, 0}, 200000);
    scene.width = scene.height = 1;
    estimate value = backward(&scene, tested[_i], 0, 0, 20000);
    /* both times twelve pixels; the rest is known */
    double more = 0.75 * 0.75 * on_sphere(64, 4);
    for (int i = 0; i < 3; i++) {
        const estimate *all = &seen.pixel[ALL];
        double expected = coordinate(value.sum, i) / value.count + more;
        agree(coordinate(all->sum, i) / all->count / 12 - expected,
              variance(&value, i) + variance(all, i) / 144, expected, 0.06, "ball lit from beside");
    }
}

/* An opening takes light away, which is missing on the wall behind the eye. */
LOOP_TEST(test_ball, TESTED)
{
    static const struct {
        int bounces, photons;
        double aperture, each, all; /* how sharp */
    } rows[] = {{1, 100000, 0, 0.35, 0.05},
                {2, 100000, 0, 0.35, 0.05},
                {3, 100000, 0, 0.35, 0.05},
                {1, 1600000, 1, 0.5, 0.1}};
    const sure_object ball = sphere(0, 0, 0, 4);
    const sure_material wall = {.color = {0.75, 0.5, 0.25}};
    const sure_light light = {{0, 0, 0}, {1, 0.5, 0.75}, 64};
    const sure_scene scene = ball_scene(&ball, &wall, &light);
    for (size_t row = 0; row < sizeof rows / sizeof *rows; row++) {
        const sure_forward_options options = {1, rows[row].bounces, rows[row].aperture};
        picture seen = traced(&scene, tested[_i], &options, rows[row].photons);
        estimate value = ball_value(&wall, &light, rows[row].bounces);
        for (int i = 0; i < 12; i++)
            same(&seen.pixel[i], &value, rows[row].each, "pixel of a ball");
        value = known(times(12, value.sum));
        same(&seen.pixel[ALL], &value, rows[row].all, "ball");
    }
}

SUITE("forward")
