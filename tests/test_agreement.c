/* Two tracers that share only the intersection functions give one picture: forward, by photons from
 * the lights, and backward, by rays from the eye. Where they are told apart, one of them is wrong;
 * that right ones are is less likely than FALSE_ALARM, were the seeds chosen anew.
 *
 * Pictures are compared tile by tile and colour by colour. A tile's value is the mean of its
 * pixels; each photon adds to one of them at most, and a ray of the backward tracer goes through a
 * random point of a pixel, so that both have a variance that is known from the run itself. */
#include "suite.h"

#include "placement.h"
#include "render_forward.h"
#include "scene_text.h"

#include <math.h>
#include <stdlib.h>
#include <surehit/backward.h>

#define FALSE_ALARM 1e-6

#define WIDTH 64
#define HEIGHT 32
#define TILE 8 /* pixels a side */
#define TILES ((WIDTH / TILE) * (HEIGHT / TILE))
#define COMPARED (3 * TILES)

#define MOST_PHOTONS 10000000
#define RAYS 400       /* a pixel */
#define FINE (1 << 20) /* places of a ray within a pixel, a side */

/* A matte world with what can go wrong in it: shadows, every solid, a surface seen from behind, a
 * lamp in front of a wall and two of different powers and colours. */
static const char scene_lines[] = "A 0 255,255,255\n"
                                  "C 0,1,8 0,-0.1,-1 70\n"
                                  "L -4,5,3 900 255,240,200\n"
                                  "L 3,1.5,1 150 120,160,255\n"
                                  "pl 0,-1,0 0,1,0 200,200,190\n"
                                  "pl 0,0,-6 0,0,-1 150,170,200\n"
                                  "sp -2,0,-1 2 220,90,80\n"
                                  "cy 0.5,0,-2 0.2,1,0.1 1.2 2 90,200,110\n"
                                  "co 2.6,0,-1 0,1,0 1.8 2 230,200,90\n"
                                  "#! falloff inverse-square\n"
                                  "R 64 32\n";

typedef struct {
    double value[3], variance[3];
} tile;

static sure_scene scene_of(const char *text)
{
    rt_scene file = scene_from_text(text, "agreement.rt");
    sure_scene scene = scene_placed(&file);
    rt_scene_free(&file);
    return scene;
}

static tile *tile_at(tile *tiles, int column, int row)
{
    return &tiles[row / TILE * (WIDTH / TILE) + column / TILE];
}

static double component(sure_vec3 v, int i)
{
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
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
            sum[i] += component(seen, i);
            squares[i] += component(seen, i) * component(seen, i);
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
    return (double)sum.high * 0x1p32 + (double)sum.low * 0x1p-32;
}

static void see_forward(const sure_scene *scene, uint64_t first, uint64_t photons,
                        tile tiles[TILES])
{
    film sums;
    sure_forward_account account = {0};
    const forward_run run = {.tier = SURE_TIER_CERTAIN,
                             .how = {.seed = 1, .bounces = 1},
                             .first = first,
                             .end = first + photons};
    const double pixels = TILE * TILE, count = (double)photons;
    ck_assert(film_new(WIDTH, HEIGHT, &sums));
    ck_assert_uint_eq(render_forward(scene, &run, &sums, &account).end, run.end);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        tile *to = tile_at(tiles, i % WIDTH, HEIGHT - 1 - i / WIDTH);
        for (int c = 0; c < 3; c++) {
            to->value[c] += number_of(sums.pixels[i].value[c]) / count / pixels;
            to->variance[c] += number_of(sums.pixels[i].square[c]) / count / (pixels * pixels);
        }
    }
    film_free(&sums);
    for (int i = 0; i < COMPARED; i++) {
        tile *of = &tiles[i / 3];
        double mean = of->value[i % 3];
        of->variance[i % 3] = (of->variance[i % 3] - mean * mean) / (count - 1);
    }
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
START_TEST(test_tiles)
{
    sure_scene scene = scene_of(scene_lines);
    tile forward[TILES] = {0}, backward[TILES] = {0};
    double limit = limit_of(FALSE_ALARM / COMPARED), worst = 0, all = 0;
    see_backward(&scene, backward);
    see_forward(&scene, 0, MOST_PHOTONS, forward);
    for (int i = 0; i < COMPARED; i++) {
        double z = deviation(&forward[i / 3], &backward[i / 3], i % 3);
        worst = fmax(worst, fabs(z));
        all += z * z / COMPARED;
        ck_assert_msg(fabs(z) <= limit, "tile %d, colour %d: forward %g, backward %g, %.2f sigma",
                      i / 3, i % 3, forward[i / 3].value[i % 3], backward[i / 3].value[i % 3], z);
    }
    printf("%d tiles and colours, %d photons: at most %.2f sigma apart (limit %.2f), rms %.3f\n",
           COMPARED, MOST_PHOTONS, worst, limit, sqrt(all));
    placement_free(&scene);
}
END_TEST

/* The sum over tiles of the squared error in green, of photons first .. first + photons - 1. */
static double square_error(const sure_scene *scene, uint64_t first, uint64_t photons,
                           const tile backward[TILES])
{
    tile forward[TILES] = {0};
    double sum = 0;
    see_forward(scene, first, photons, forward);
    for (int i = 0; i < TILES; i++) {
        double error = forward[i].value[1] - backward[i].value[1];
        sum += error * error;
    }
    return sum;
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

typedef struct {
    uint64_t photons;
    int runs;
} decade;

/* So many runs, other photons in each. Few runs are those of many photons, whose tiles are normally
 * distributed; the mean of many runs is so itself. */
static void check_decade(const sure_scene *scene, const decade *of, const tile backward[TILES],
                         double known, scatter one, double limit)
{
    double n = (double)of->photons, runs = of->runs, sum = 0, squares = 0;
    for (int r = 0; r < of->runs; r++) {
        double e = n * square_error(scene, (uint64_t)r * of->photons, of->photons, backward);
        sum += e;
        squares += e * e;
    }
    double mean = sum / runs, expected = one.sum + known * n;
    double z = (mean - expected) / sqrt((squares / runs - mean * mean) / (runs - 1));
    if (of->runs < 30)
        z = deviation_of_squares(mean / expected, runs * one.sum * one.sum / one.squares);
    printf("%8.0f photons, %4.0f runs: error %.6f, times root N %.4f, expected %.4f\n", n, runs,
           sqrt(mean / n), sqrt(mean), sqrt(expected));
    ck_assert_msg(fabs(z) <= limit, "%g photons: %g, expected %g: %.2f sigma", n, mean, expected,
                  z);
}

/* The error of N photons falls as the root of N: its square times N is one number for all N, the
 * variance of one photon. */
START_TEST(test_error_falls)
{
    static const decade decades[] = {
        {1000, 1000}, {10000, 400}, {100000, 60}, {1000000, 10}, {MOST_PHOTONS, 1}};
    enum { DECADES = sizeof decades / sizeof *decades };
    sure_scene scene = scene_of(scene_lines);
    tile backward[TILES] = {0}, whole[TILES] = {0};
    scatter one = {0, 0};
    double known = 0;
    see_backward(&scene, backward);
    see_forward(&scene, MOST_PHOTONS, MOST_PHOTONS, whole);
    for (int i = 0; i < TILES; i++) {
        double v = whole[i].variance[1] * MOST_PHOTONS;
        one.sum += v;
        one.squares += v * v;
        known += backward[i].variance[1];
    }
    for (int k = 0; k < DECADES; k++)
        check_decade(&scene, &decades[k], backward, known, one, limit_of(FALSE_ALARM / DECADES));
    placement_free(&scene);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("agreement");
    TCase *tiles = tcase_create("tiles"), *falls = tcase_create("error falls");
    tcase_set_timeout(tiles, 600);
    tcase_set_timeout(falls, 600);
    tcase_add_test(tiles, test_tiles);
    tcase_add_test(falls, test_error_falls);
    suite_add_tcase(suite, tiles);
    suite_add_tcase(suite, falls);
    return suite_run(suite);
}
