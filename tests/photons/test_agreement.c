/* SPDX-License-Identifier: MIT */
/* Two tracers that share only the intersection functions give one picture: forward, by photons from
 * the lights, and backward, by rays from the eye. Where they are told apart, one of them is wrong;
 * that right ones are is less likely than FALSE_ALARM, were the seeds chosen anew.
 *
 * Pictures are compared tile by tile and colour by colour. A tile's value is the mean of its
 * pixels; each photon adds to one of them at most, and a ray of the backward tracer goes through a
 * random point of a pixel, so that both have a variance that is known from the run itself. */
#include "suite.h"
#include "objects.h"

#include "caustics.h"
#include "forward_sum.h"
#include "scene_text.h"

#define FALSE_ALARM 1e-6

#define WIDTH 64
#define HEIGHT 32
#define TILE 8 /* pixels a side */
#define TILES ((WIDTH / TILE) * (HEIGHT / TILE))
#define COMPARED (3 * TILES)

#define MOST_PHOTONS 10000000
#define RAYS 400       /* a pixel */
#define FINE (1 << 20) /* places of a ray within a pixel, a side */

typedef struct {
    double value[3], variance[3];
} tile;

/* One of how many photons is traced, for those in haste: SUREHIT_SHARE of the environment. */
static uint64_t most_photons(void)
{
    return MOST_PHOTONS / suite_setting("SUREHIT_SHARE", 1);
}

static sure_scene scene_of(const char *name)
{
    FREED_BY(rt_scene_free) rt_scene file = scene_from_file(suite_file("photons/%s.rt", name));
    sure_scene scene = scene_placed(&file);
    return scene;
}

static tile *tile_at(tile *tiles, int column, int row)
{
    return &tiles[row / TILE * (WIDTH / TILE) + column / TILE];
}

/* A random point of the pixel, by the ray through the middle of a very small one. */
static sure_vec3 seen_at_random(const sure_scene *fine, int column, int row, uint64_t ray)
{
    uint64_t pixel = (uint64_t)(row * WIDTH + column) * RAYS + ray, bits = suite_bits(7, pixel);
    return sure_backward_pixel(fine, SURE_TIER_CERTAIN, column * FINE + (int)(bits % FINE),
                               row * FINE + (int)(bits / FINE % FINE));
}

static void look_at(const sure_scene *fine, int column, int row, tile *to)
{
    double sum[3] = {0}, squares[3] = {0};
    for (uint64_t ray = 0; ray < RAYS; ray++) {
        sure_vec3 seen = seen_at_random(fine, column, row, ray);
        for (int i = 0; i < 3; i++) {
            sum[i] += coordinate(seen, i);
            squares[i] += coordinate(seen, i) * coordinate(seen, i);
        }
    }
    const double pixels = TILE * TILE;
    for (int i = 0; i < 3; i++) {
        double mean = sum[i] / RAYS;
        to->value[i] += mean / pixels;
        to->variance[i] += (squares[i] / RAYS - mean * mean) / (RAYS - 1) / (pixels * pixels);
    }
}

static void see_backward(const sure_scene *scene, tile tiles[TILES])
{
    sure_scene fine = *scene;
    fine.width *= FINE;
    fine.height *= FINE;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        look_at(&fine, i % WIDTH, i / WIDTH, tile_at(tiles, i % WIDTH, i / WIDTH));
}

static double number_of(film_sum sum)
{
    return (double)sum * 0x1p-32;
}

/* Photons first .. first + photons - 1, on a dark film. */
static film traced(const sure_scene *scene, uint64_t first, uint64_t photons)
{
    forward_sum done = {.sum = {.tier = SURE_TIER_CERTAIN, .how = {.seed = 1, .bounces = 1}}};
    const index_range asked = {first, first + photons};
    ck_assert(film_new(WIDTH, HEIGHT, &done.sum.sums));
    ck_assert(forward_sum_trace(scene, &(render_options){0}, asked, &done));
    ck_assert_uint_eq(done.traced, photons);
    film sums = done.sum.sums;
    done.sum.sums = (film){0};
    partial_film_free(&done.sum);
    return sums;
}

/* The picture of so many photons. */
static void tiles_of(const film *sums, uint64_t photons, tile tiles[TILES])
{
    const double pixels = TILE * TILE, count = (double)photons;
    memset(tiles, 0, TILES * sizeof *tiles);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        tile *to = tile_at(tiles, i % WIDTH, HEIGHT - 1 - i / WIDTH);
        for (int c = 0; c < 3; c++) {
            to->value[c] += number_of(sums->pixels[i].value[c]) / count / pixels;
            to->variance[c] += number_of(sums->pixels[i].square[c]) / count / (pixels * pixels);
        }
    }
    for (int i = 0; i < COMPARED; i++) {
        tile *of = &tiles[i / 3];
        double mean = of->value[i % 3];
        of->variance[i % 3] = (of->variance[i % 3] - mean * mean) / (count - 1);
    }
}

static void see_forward(const sure_scene *scene, uint64_t first, uint64_t photons,
                        tile tiles[TILES])
{
    film sums = traced(scene, first, photons);
    tiles_of(&sums, photons, tiles);
    film_free(&sums);
}

/* How far apart, in standard deviations. */
static double deviation(const tile *a, const tile *b, int color)
{
    return (a->value[color] - b->value[color]) / sqrt(a->variance[color] + b->variance[color]);
}

/* Farther than this a normally distributed number gets, to either side, with the chance of a false
 * alarm shared among all that are compared. */
static double limit_of(double alarm)
{
    double low = 0, high = 40;
    while (high - low > 0x1p-40) {
        double middle = (low + high) / 2;
        *(erfc(middle / sqrt(2)) > alarm ? &low : &high) = middle;
    }
    return high;
}

/* Every tile, in every colour. */
static void compare_tiles(const tile forward[TILES], const tile backward[TILES])
{
    double limit = limit_of(FALSE_ALARM / COMPARED), worst = 0, all = 0;
    for (int i = 0; i < COMPARED; i++) {
        double z = deviation(&forward[i / 3], &backward[i / 3], i % 3);
        worst = fmax(worst, fabs(z));
        all += z * z / COMPARED;
        ck_assert_msg(fabs(z) <= limit, "tile %d, colour %d: forward %g, backward %g, %.2f sigma",
                      i / 3, i % 3, forward[i / 3].value[i % 3], backward[i / 3].value[i % 3], z);
    }
    printf("%d tiles and colours, %.0f photons: at most %.2f sigma apart (limit %.2f), rms %.3f\n",
           COMPARED, (double)most_photons(), worst, limit, sqrt(all));
}

/* A sum of squares of normal numbers, by its mean over what is expected and its degrees of freedom,
 * as a normal number itself. (E. Wilson, M. Hilferty, The distribution of chi-square, 1931.) */
static double deviation_of_squares(double ratio, double freedom)
{
    double spread = 2 / (9 * freedom);
    return (cbrt(ratio) - (1 - spread)) / sqrt(spread);
}

/* What is known of the variance of one photon: over tiles, its sum and that of its square. */
typedef struct {
    double sum, squares;
} scatter;

/* Runs of so many photons, other ones in each; all together are MOST_PHOTONS at most. */
typedef struct {
    uint64_t photons;
    int runs;
} decade;

static const decade decades[] = {
    {1000, 1000}, {10000, 400}, {100000, 60}, {1000000, 10}, {MOST_PHOTONS, 1}};
enum { DECADES = sizeof decades / sizeof *decades, TIMES = 10 /* the decade before */ };

/* Of each decade's runs the squared error times N, summed, and the square of that. */
typedef struct {
    const sure_scene *scene;
    const tile *backward;
    double runs[DECADES], sum[DECADES], squares[DECADES];
} falling;

static bool is_wanted(int which, uint64_t first)
{
    return which >= 0 && first < decades[which].photons * (uint64_t)decades[which].runs;
}

/* The squared error in green, summed over tiles. */
static void add_error(falling *to, int which, const film *sums)
{
    tile forward[TILES];
    double sum = 0;
    tiles_of(sums, decades[which].photons, forward);
    for (int i = 0; i < TILES; i++) {
        double error = forward[i].value[1] - to->backward[i].value[1];
        sum += error * error;
    }
    sum *= (double)decades[which].photons;
    to->runs[which]++;
    to->sum[which] += sum;
    to->squares[which] += sum * sum;
}

/* A decade's run, as runs of the decade before where these are wanted. */
static film run_of(falling *to, int which, uint64_t first)
{
    film sums;
    if (is_wanted(which - 1, first)) {
        ck_assert(film_new(WIDTH, HEIGHT, &sums));
        for (uint64_t i = 0; i < TIMES; i++) {
            film part = run_of(to, which - 1, first + i * decades[which - 1].photons);
            film_merge(&sums, &part);
            film_free(&part);
        }
    } else {
        sums = traced(to->scene, first, decades[which].photons);
    }
    if (is_wanted(which, first))
        add_error(to, which, &sums);
    return sums;
}

/* Few runs are those of many photons, whose tiles are normally distributed; the mean of many runs
 * is so itself. */
static void check_decade(const falling *of, int which, double known, scatter one, double limit)
{
    double n = (double)decades[which].photons, runs = of->runs[which];
    double mean = of->sum[which] / runs, expected = one.sum + known * n;
    double z = (mean - expected) / sqrt((of->squares[which] / runs - mean * mean) / (runs - 1));
    if (runs < 30)
        z = deviation_of_squares(mean / expected, runs * one.sum * one.sum / one.squares);
    printf("%8.0f photons, %4.0f runs: error %.6f, times root N %.4f, expected %.4f\n", n, runs,
           sqrt(mean / n), sqrt(mean), sqrt(expected));
    ck_assert_msg(fabs(z) <= limit, "%g photons: %g, expected %g: %.2f sigma", n, mean, expected,
                  z);
}

/* The error of N photons falls as the root of N: its square times N is one number for all N, the
 * variance of one photon, which others tell. */
static void check_fall(const sure_scene *scene, const tile backward[TILES], const tile whole[TILES])
{
    falling of = {.scene = scene, .backward = backward};
    scatter one = {0, 0};
    double known = 0;
    int last = DECADES - 1;
    for (int i = 0; i < TILES; i++) {
        double v = whole[i].variance[1] * (double)most_photons();
        one.sum += v;
        one.squares += v * v;
        known += backward[i].variance[1];
    }
    while (decades[last].photons > most_photons())
        last--;
    for (uint64_t photons = decades[last].photons, end = photons; end <= most_photons();
         end += photons) {
        film sums = run_of(&of, last, end - photons);
        film_free(&sums);
    }
    for (int i = 0; i <= last; i++)
        check_decade(&of, i, known, one, limit_of(FALSE_ALARM / DECADES));
}

TEST(test_photons)
{
    FREED_BY(placement_free) sure_scene scene = scene_of("agreement");
    tile forward[TILES], backward[TILES] = {0};
    see_backward(&scene, backward);
    see_forward(&scene, MOST_PHOTONS, most_photons(), forward);
    compare_tiles(forward, backward);
    check_fall(&scene, backward, forward);
}

/* Mixed, where it is needed: a ball of coloured glass over a floor, and a mirror beside it. */

#define SEEDS 16
#define STUDENT 2      /* Student's t with 15 degrees allows less than twice the normal limit */
#define CAUSTIC_RAYS 8 /* a pixel, others for each seed */
#define CAUSTIC_PHOTONS 160000
#define FEWER 16 /* times */

/* Is it matte what the ray meets, or nothing? No photon comes to a pinhole from anything else. */
static bool is_plain(const sure_scene *scene, const sure_statistics *told)
{
    if (told->seen != SURE_HIT)
        return true;
    const sure_material *material = &scene->materials[told->nearest.object];
    return !(material->mirror > 0) && !(material->refract > 0);
}

/* Adds a picture by photons of that seed; a tile in which anything else is seen is not plain. */
static void see_mixed(const sure_scene *scene, uint64_t photons, uint64_t seed, tile tiles[TILES],
                      bool plain[TILES])
{
    const render_settings how = {.how.tier = SURE_TIER_CERTAIN, .photons = photons, .seed = seed};
    FREED_BY(photon_map_free) sure_photon_map map;
    sure_scene fine = *scene;
    ck_assert_int_eq(caustics_build(scene, &how, &map).state, CAUSTICS_ON);
    fine.caustics = &map;
    fine.width *= FINE;
    fine.height *= FINE;
    for (int i = 0; i < WIDTH * HEIGHT * CAUSTIC_RAYS; i++) {
        int column = i / CAUSTIC_RAYS % WIDTH, row = i / CAUSTIC_RAYS / WIDTH;
        uint64_t bits = suite_bits(100 + seed, (uint64_t)i);
        sure_statistics told = {0};
        sure_vec3 seen =
            sure_backward_pixel_told(&fine, SURE_TIER_CERTAIN, column * FINE + (int)(bits % FINE),
                                     row * FINE + (int)(bits / FINE % FINE), &told);
        tile *to = tile_at(tiles, column, row);
        for (int c = 0; c < 3; c++)
            to->value[c] += coordinate(seen, c) / (CAUSTIC_RAYS * TILE * TILE);
        plain[to - tiles] = plain[to - tiles] && is_plain(scene, &told);
    }
}

/* The mean over seeds, and its variance. */
static void see_mixed_often(const sure_scene *scene, uint64_t photons, tile tiles[TILES],
                            bool plain[TILES])
{
    tile of[SEEDS][TILES] = {0};
    for (uint64_t seed = 0; seed < SEEDS; seed++)
        see_mixed(scene, photons, seed, of[seed], plain);
    for (int i = 0; i < COMPARED; i++) {
        double sum = 0, squares = 0;
        for (int seed = 0; seed < SEEDS; seed++) {
            double value = of[seed][i / 3].value[i % 3];
            sum += value;
            squares += value * value;
        }
        double mean = sum / SEEDS;
        tiles[i / 3].value[i % 3] = mean;
        tiles[i / 3].variance[i % 3] = (squares / SEEDS - mean * mean) / (SEEDS - 1);
    }
}

/* Gathering blurs, over a disc whose area falls as the root of the number of photons: with a
 * sixteenth of the photons it is four times as large. So pictures of many and of few photons differ
 * by three times the blur of the one of many, which is allowed on top of what is random. */
TEST(test_caustic)
{
    FREED_BY(placement_free) sure_scene scene = scene_of("caustic");
    tile forward[TILES] = {0}, few[TILES] = {0}, many[TILES] = {0};
    bool plain[TILES];
    const double limit = limit_of(FALSE_ALARM / COMPARED);
    int compared = 0, lit = 0;
    for (int i = 0; i < TILES; i++)
        plain[i] = true;
    see_forward(&scene, 0, most_photons(), forward);
    see_mixed_often(&scene, CAUSTIC_PHOTONS / FEWER, few, plain);
    see_mixed_often(&scene, CAUSTIC_PHOTONS, many, plain);
    tile without[TILES] = {0};
    see_backward(&scene, without);
    for (int i = 0; i < COMPARED; i++) {
        const tile *f = &forward[i / 3], *m = &many[i / 3];
        const int c = i % 3;
        if (!plain[i / 3])
            continue;
        double spread = f->variance[c] + STUDENT * STUDENT * m->variance[c];
        double random = limit * sqrt(spread);
        double blur = fabs(m->value[c] - few[i / 3].value[c]);
        compared++;
        lit += f->value[c] > without[i / 3].value[c] + 2 * random;
        ck_assert_msg(fabs(f->value[c] - m->value[c]) <= random + blur,
                      "tile %d, colour %d: forward %g, mixed %g, random %g, blur %g", i / 3, c,
                      f->value[c], m->value[c], random, blur);
    }
    printf("%d tiles and colours of a caustic, %d of them brighter than backward\n", compared, lit);
    if (most_photons() == MOST_PHOTONS) /* a tile in all colours: else nothing was compared */
        ck_assert_int_ge(lit, 3);
}

SUITE("agreement")
