/* SPDX-License-Identifier: MIT */
/* The quick stage of sure_spawn against what is behind it: it runs where the rounding mode is to
 * nearest only, so that in another mode the rest answers alone. Its bounds against numbers wide
 * enough to be exact. */
#include "spawned.h"

#include "../../src/shapes/cone/cone_spawn.h"
#include "../../src/shapes/cylinder/cylinder_spawn.h"
#include "../../src/shapes/planar/planar_spawn.h"
#include "../../src/shapes/sphere/sphere_spawn.h"

/* TYPICAL: at least so many of a hundred ordinary calls are answered at once. */
enum { BITS = 4000, SEED = 31, CASES = 160, TYPICAL = 95, DRAWS = 3000, MEASURED = 120 };

static surface plane_at(const line_point *line, const void *shape, sure_part part)
{
    const sure_plane *s = shape;
    (void)part;
    return flat_surface(line, &s->point, &s->normal);
}

static surface sphere_at(const line_point *line, const void *shape, sure_part part)
{
    (void)part;
    return sphere_surface(line, shape);
}

static surface cylinder_at(const line_point *line, const void *shape, sure_part part)
{
    const sure_cylinder *s = shape;
    return part == SURE_PART_WALL  ? cylinder_surface(line, s)
           : part == SURE_PART_TOP ? cap_surface(line, &s->base, &s->top, s->radius)
                                   : cap_surface(line, &s->top, &s->base, s->radius);
}

static surface cone_at(const line_point *line, const void *shape, sure_part part)
{
    const sure_cone *s = shape;
    return part == SURE_PART_WALL ? cone_surface(line, s)
                                  : cap_surface(line, &s->apex, &s->base, s->radius);
}

/* The surface that the quick stage goes by; of other shapes it shows only that they answer as
 * without it. */
typedef surface surface_at(const line_point *line, const void *shape, sure_part part);
static surface_at *const surfaces[SURE_SHAPES] = {
    [SURE_SHAPE_PLANE] = plane_at,   [SURE_SHAPE_DISC] = plane_at,
    [SURE_SHAPE_SPHERE] = sphere_at, [SURE_SHAPE_CYLINDER] = cylinder_at,
    [SURE_SHAPE_CONE] = cone_at,
};

/* As sure_spawn asks: once more where the hit's t is then known better. A point and a segment have
 * no inside. */
static bool spawn_quick(const sure_case *q, const sure_hit *hit, int side, sure_vec3 *origin)
{
    double wanted = side == SURE_SIDE_INSIDE ? -1 : 1;
    true_frame frame = true_frame_of(&q->object);
    sure_hit at = *hit, nearer = {.t_error = -1};
    if (wanted < 0 && !frame.flat && frame.radius == 0)
        return false;
    for (int i = 0; i < 2; i++) {
        line_point line = line_point_of(&q->ray, at.t);
        surface s = surfaces[q->object.shape](&line, &q->object.as, at.part);
        if (spawn_by_surface(&q->ray, &at, wanted, &line, s, origin, &nearer))
            return true;
        if (nearer.t_error < 0)
            return false;
        at = nearer;
    }
    return false;
}

typedef struct {
    unsigned calls, quick;
} tally;

static void check_same(const sure_case *q, const sure_hit *hit, tally *sum)
{
    for (int side = 0; side < SIDES; side++) {
        spawned slow = spawn_in(q, hit, side, 1), own = {.origin = untouched};
        for (int nearest = 0; nearest < SURROUNDINGS; nearest += SURROUNDINGS_MODES) {
            spawned quick = spawn_in(q, hit, side, nearest);
            ck_assert_msg(same_spawned(&quick, &slow),
                          "%d (%a, %a, %a), not %d (%a, %a, %a), t %a +- %a: %s", quick.found,
                          quick.origin.x, quick.origin.y, quick.origin.z, slow.found, slow.origin.x,
                          slow.origin.y, slow.origin.z, hit->t, hit->t_error, text(q, side));
        }
        if (surfaces[q->object.shape])
            own.found = spawn_quick(q, hit, side, &own.origin);
        ck_assert(memcmp(&own.origin, own.found ? &slow.origin : &untouched, sizeof own.origin) ==
                  0);
        sum->calls++;
        sum->quick += own.found != 0;
    }
}

static void print(int shape, const char *what, const tally *sum)
{
    if (sum->calls > 0)
        printf("%-9s %-14s %4u calls, at once %6.2f %%\n", sure_shape_name((sure_shape)shape), what,
               sum->calls, 100.0 * sum->quick / sum->calls);
    fflush(stdout);
}

LOOP_TEST(test_regimes, SURE_SHAPES *REGIMES)
{
    sure_shape shape = (sure_shape)(_i / REGIMES);
    regime which = (regime)(_i % REGIMES);
    tally sum = {0, 0};
    for (uint64_t index = 0; regime_applies(shape, which) && index < CASES; index++) {
        sure_case q = regime_case(shape, which, SEED, index);
        sure_hit hit;
        if (hit_of(&q, index, &hit))
            check_same(&q, &hit, &sum);
    }
    print((int)shape, regime_name(which), &sum);
    if (which == REGIME_TYPICAL && surfaces[shape])
        ck_assert_uint_gt(100 * sum.quick, TYPICAL * sum.calls);
}

/* A hit's t need not be better than t_error says. */
LOOP_TEST(test_far_t, SURE_SHAPES)
{
    const regime regimes[] = {REGIME_TYPICAL, REGIME_INSIDE, REGIME_GRAZING, REGIME_INTEGERS};
    tally sum = {0, 0};
    for (uint64_t index = 0; index < 4 * CASES; index++) {
        regime which = regimes[index % 4];
        sure_hit hit;
        if (!regime_applies((sure_shape)_i, which))
            continue;
        sure_case q = regime_case((sure_shape)_i, which, SEED, index / 4);
        if (!hit_of(&q, 0, &hit))
            continue;
        for (int bits = 3; bits < 56; bits += 4) {
            double off = fabs(hit.t) * power_of_two(-bits) *
                         suite_double(SEED, 64 * index + (uint64_t)bits, 0);
            sure_hit moved = {hit.t + off, fabs(off) + hit.t_error + fabs(hit.t) * 0x1p-52,
                              hit.part, hit.leaves};
            check_same(&q, &moved, &sum);
        }
    }
    print(_i, "t off", &sum);
    ck_assert(sum.quick > sum.calls / 4 || !surfaces[_i]);
}

/* What is between two roots of which the t is nearer to the wrong one, but allowed to be. */
LOOP_TEST(test_other_root, SURE_SHAPES)
{
    if (!sure_shape_info_of((sure_shape)_i)->solid)
        return;
    tally sum = {0, 0};
    for (uint64_t index = 0; index < CASES; index++) {
        sure_case q = regime_case((sure_shape)_i, REGIME_GRAZING, SEED, index);
        sure_interval ends;
        sure_hit hit;
        if (!hit_of(&q, 0, &hit) ||
            sure_object_interval(&q.ray, &q.object, SURE_TIER_EXACT, &ends) != SURE_HIT)
            continue;
        double other = hit.t == ends.t_enter ? ends.t_leave : ends.t_enter;
        hit = (sure_hit){other, fabs(other - hit.t) * 1.5 + hit.t_error, hit.part, hit.leaves};
        check_same(&q, &hit, &sum);
    }
    ck_assert_uint_gt(sum.calls, 0);
}

static double odd(uint64_t index, int bits)
{
    return 2 * floor((double)(suite_bits(SEED, index) >> 11) * power_of_two(bits - 54)) + 1;
}

static int sign_of(uint64_t index)
{
    return suite_bits(SEED, index) % 2 == 0 ? -1 : 1;
}

/* Between 1 and 2, far enough from both. */
static double coordinate_at(uint64_t index)
{
    return 1.25 + 0.5 * ((double)(suite_bits(SEED, index) >> 12) * 0x1p-52);
}

/* The ray reaches the point at t = 1/m. In halves of their doubles' distance: the point's first
 * coordinate is midway between doubles, or the point is on the surface though not the true hit, or
 * the true hit is it. */
static sure_case exact_case(sure_shape shape, uint64_t index, double *t)
{
    uint64_t i = 16 * index;
    const double unit = 0x1p-53;
    const sure_vec3 p = {coordinate_at(i), coordinate_at(i + 1), coordinate_at(i + 2)};
    bool midway = index % 2 == 0;
    int bits = 4 + (int)(suite_bits(SEED, i + 3) % 40), m = 1 + 2 * (int)(index / 2 % 8);
    double scale = odd(i + 4, 4 + (int)(suite_bits(SEED, i + 5) % 38)) * (midway ? 1 : 2);
    double half = midway ? unit : 0;
    /* the way there, in halves: odd where the point is midway */
    double x = odd(i + 6, bits) * sign_of(i + 7) * (midway ? 1 : 2);
    double y = 2 * odd(i + 8, bits) * sign_of(i + 9), z = 2 * odd(i + 10, bits) * sign_of(i + 11);
    sure_case q = {.object = object_through(shape, p, half, scale * unit, index % 3 == 0)};
    q.ray = (sure_ray){{p.x + (half - x * unit), p.y - y * unit, p.z - z * unit},
                       {m * x * unit, m * y * unit, m * z * unit},
                       0,
                       INFINITY};
    *t = 1.0 / m;
    return q;
}

/* From t = 1/m, and from places around it. */
LOOP_TEST(test_exact_places, SURE_SHAPES)
{
    tally sum = {0, 0};
    for (uint64_t index = 0; index < DRAWS; index++) {
        double t;
        sure_hit hit;
        sure_case q = exact_case((sure_shape)_i, index, &t);
        if (sure_object_hit(&q.ray, &q.object, SURE_TIER_EXACT, &hit) != SURE_HIT || hit.t != t)
            continue;
        check_same(&q, &hit, &sum);
        double off = suite_double(SEED + 3, index, 0) * power_of_two(-(int)(index % 50));
        hit = (sure_hit){t + t * off, fabs(t * off) + hit.t_error + 0x1p-52, hit.part, hit.leaves};
        check_same(&q, &hit, &sum);
    }
    print(_i, "exact places", &sum);
    ck_assert_uint_gt(sum.calls, DRAWS / 4);
}

/* 1 to 2, with some 40 binary digits. */
static double coarse(uint64_t index)
{
    return 1.25 + 0.5 * (double)(suite_bits(SEED + 4, index) >> 24) * 0x1p-40;
}

static sure_vec3 flattened(uint64_t index, double shift)
{
    double y = coarse(index + 1);
    return (sure_vec3){coarse(index), y, y / 2 + shift};
}

/* Everything is in a plane where z is y/2 and some more, which has the next exponent, and so is the
 * normal: steps in y and z lead as far, but for what is rounded. */
static sure_case flattened_case(sure_shape shape, uint64_t index)
{
    uint64_t i = 16 * index;
    double shift = 1.75 + (double)suite_integer(SEED + 4, i, 4096) * 0x1p-20;
    sure_vec3 centre = flattened(i + 2, shift), at = flattened(i + 4, shift);
    sure_vec3 end = flattened(i + 6, shift), n = flattened(i + 8, 0);
    double r = 0x1p-3 * coarse(i + 10);
    double reach = shape_has(shape, SURE_KIND_NORMAL) ? 64 : r;
    sure_case q = {.object = object_made(shape, centre, n, end, reach)};
    sure_vec3 o = {2 * coarse(i + 12), 3 * coarse(i + 13), 0};
    o.z = o.y / 2 + shift;
    q.ray = (sure_ray){o, {at.x - o.x, at.y - o.y, (at.y - o.y) / 2}, 0, INFINITY};
    return q;
}

LOOP_TEST(test_equal_steps, SURE_SHAPES)
{
    tally sum = {0, 0};
    for (uint64_t index = 0; index < DRAWS; index++) {
        sure_case q = flattened_case((sure_shape)_i, index);
        sure_hit hit;
        if (!hit_of(&q, index, &hit))
            continue;
        double off = fabs(hit.t) * power_of_two(-36 - (int)(index % 18));
        hit = (sure_hit){hit.t + off, 2 * off + hit.t_error, hit.part, hit.leaves};
        check_same(&q, &hit, &sum);
    }
    print(_i, "equal steps", &sum);
    ck_assert_uint_gt(sum.calls, DRAWS / 16);
}

/* Across a coordinate axis, or nearly so, by as little as a double can say. */
LOOP_TEST(test_nearly_level, 3)
{
    const double least[] = {0, 0x1p-1074, 0x1p-1000, 0x1p-300, 0x1p-60, 0x1p-40};
    tally sum = {0, 0};
    for (uint64_t index = 0; index < DRAWS; index++) {
        uint64_t i = 16 * index;
        double small = least[index % 6] * sign_of(i);
        double height = index % 4 == 0 ? 0 : coordinate_at(i + 1) - 1.5;
        double n[3] = {0};
        n[_i] = _i == 2 ? -1 : 1;
        n[(_i + 1) % 3] = small;
        double at[] = {coordinate_at(i + 2), -coordinate_at(i + 3), coordinate_at(i + 4)};
        at[_i] = height;
        sure_case q = {
            .ray = {{4 * coordinate_at(i + 5), 3 * coordinate_at(i + 6), coordinate_at(i + 7)},
                    {-coordinate_at(i + 8), -coordinate_at(i + 9), -coordinate_at(i + 10)},
                    0,
                    INFINITY},
            .object = {.shape = SURE_SHAPE_PLANE,
                       .as.plane = {{at[0], at[1], at[2]}, {n[0], n[1], n[2]}}}};
        sure_hit hit;
        if (hit_of(&q, index, &hit))
            check_same(&q, &hit, &sum);
    }
    ck_assert_uint_gt(sum.quick, sum.calls / 4);
}

/* F at q, which is 0 on the part that is hit: half of the body's quadratic, or A.p of a plane with
 * an outward A. A cone's axis leads to its base. */
static void exact_value(mpfr_t value, true_line *line, const sure_case *c, sure_part part,
                        sure_vec3 q)
{
    sure_case at = *c;
    at.ray.origin = q;
    true_line_coefficients(line, &at);
    mpfr_set(value, line->level, MPFR_RNDN);
    if (part == SURE_PART_BASE && !line->tapers)
        mpfr_neg(value, value, MPFR_RNDN);
    else if (part == SURE_PART_BASE || part == SURE_PART_TOP)
        mpfr_sub(value, value, line->height, MPFR_RNDN);
    else if (!line->flat)
        mpfr_div_2ui(value, line->c, 1, MPFR_RNDN);
}

/* Worst error/bound. */
typedef struct {
    double place, sign;
    unsigned certain;
} worst_shares;

static void measure_place(true_line *line, const sure_case *q, const true_place *at,
                          worst_shares *worst)
{
    const sure_vec3 o = q->ray.origin, d = q->ray.direction;
    const double from[3] = {o.x, o.y, o.z}, way[3] = {d.x, d.y, d.z};
    const double_pair found[3] = {at->x, at->y, at->z};
    TRUE_NUMBERS(BITS, t, x);
    true_line_set(line, q);
    ck_assert(true_first(line, t));
    for (int i = 0; i < 3; i++) {
        mpfr_mul_d(x, t, way[i], MPFR_RNDN);
        mpfr_add_d(x, x, from[i], MPFR_RNDN);
        worst->place =
            fmax(worst->place, share_of_pair(x, found[i].head, found[i].tail, at->error));
    }
}

static void measure_sign(true_line *line, const sure_case *c, sure_part part, const true_place *at,
                         sure_vec3 n, uint64_t index, worst_shares *worst)
{
    TRUE_NUMBERS(BITS, value);
    for (uint64_t i = 0; i < 8; i++) {
        uint64_t bits = suite_bits(SEED + 1, 8 * index + i);
        sure_vec3 q = {double_of(bits_of(nearest(at->x)) + bits % 5 - 2),
                       double_of(bits_of(nearest(at->y)) + bits / 5 % 5 - 2),
                       double_of(bits_of(nearest(at->z)) + bits / 25 % 5 - 2)};
        exact_value(value, line, c, part, q);
        worst->sign = fmax(worst->sign, share_of_error(value, ahead(at, n, q), at->doubt));
    }
}

static void measure(true_line *truth, const sure_case *q, const sure_hit *hit, uint64_t index,
                    worst_shares *worst)
{
    line_point line = line_point_of(&q->ray, hit->t);
    surface s = surfaces[q->object.shape](&line, &q->object.as, hit->part);
    true_place at = true_place_of(&q->ray, hit, &line, &s);
    sure_vec3 p = {nearest(at.x), nearest(at.y), nearest(at.z)};
    if (!at.certain || s.level.axis >= 0 || !rounds_to(&at, p))
        return;
    measure_place(truth, q, &at, worst);
    measure_sign(truth, q, hit->part, &at, s.n, index, worst);
    worst->certain++;
}

LOOP_TEST(test_bounds, SURE_SHAPES)
{
    const regime regimes[] = {REGIME_TYPICAL, REGIME_FAR,      REGIME_GRAZING,
                              REGIME_INSIDE,  REGIME_INTEGERS, REGIME_NEEDLE};
    sure_shape shape = (sure_shape)_i;
    if (!surfaces[_i])
        return;
    worst_shares worst = {0, 0, 0};
    TRUE_LINE(BITS, truth);
    for (uint64_t index = 0; index < 6 * MEASURED; index++) {
        sure_hit hit;
        if (!regime_applies(shape, regimes[index % 6]))
            continue;
        sure_case q = regime_case(shape, regimes[index % 6], SEED, index / 6);
        for (uint64_t k = 0; k < 3 && hit_of(&q, index, &hit); k++) {
            double off =
                fabs(hit.t) * power_of_two(-16 * (int)k) * suite_double(SEED + 2, 4 * index + k, 0);
            off = k == 0 ? 0 : off;
            sure_hit moved = {hit.t + off, fabs(off) + hit.t_error + fabs(hit.t) * 0x1p-52,
                              hit.part, hit.leaves};
            measure(&truth, &q, &moved, index, &worst);
        }
    }
    printf("%-9s error/bound of %u hits: place %.3f, sign %.3f\n", sure_shape_name(shape),
           worst.certain, worst.place, worst.sign);
    ck_assert_uint_gt(worst.certain, MEASURED / 2);
    ck_assert(worst.place <= 1 && worst.sign <= 1);
}

SUITE("spawn_quick")
