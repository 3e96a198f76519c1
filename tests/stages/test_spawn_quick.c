/* The quick stage of sure_spawn against what is behind it: it runs where the rounding mode is to
 * nearest only, so that in another mode the rest answers alone. Its bounds against numbers wide
 * enough to be exact. */
#include "../support/suite.h"
#include "../support/true_hit.h"

#include "../../src/shapes/cone/cone_spawn.h"
#include "../../src/shapes/cylinder/cylinder_spawn.h"
#include "../../src/shapes/planar/planar_spawn.h"
#include "../../src/shapes/sphere/sphere_spawn.h"

#include "regimes.h"

#include <surehit/spawn.h>

#include <fenv.h>
#include <stdio.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

/* TYPICAL: at least so many of a hundred ordinary calls are answered at once. */
enum { BITS = 4000, SEED = 31, CASES = 160, TYPICAL = 95, DRAWS = 3000, MEASURED = 120, SIDES = 2 };

static const sure_vec3 untouched = {0x1.5p500, -0x1.5p500, 0x1.7p500};

static const char *text(const sure_case *q, int side)
{
    static char line[CASE_LINE_MAX + 16];
    case_print(q, line);
    strcat(line, side == SURE_SIDE_INSIDE ? ", inside" : ", outside");
    return line;
}

static void set_environment(int mode, bool flushed)
{
    fesetround(mode);
#ifdef __SSE2__
    _mm_setcsr((_mm_getcsr() & ~0x8040U) | (flushed ? 0x8040U : 0));
#else
    (void)flushed;
#endif
}

typedef struct {
    int found;
    sure_vec3 origin;
} spawned;

static spawned spawn_in(const sure_case *q, const sure_hit *hit, int side, int mode, bool flushed)
{
    spawned s = {.origin = untouched};
    set_environment(mode, flushed);
    s.found = sure_spawn(&q->ray, &q->object, hit, (sure_side)side, &s.origin);
    set_environment(FE_TONEAREST, false);
    return s;
}

static bool has_side(const sure_object *object, int side)
{
    const double radius[SURE_SHAPES] = {1, 1, object->as.sphere.radius, object->as.cylinder.radius,
                                        object->as.cone.radius};
    return side == SURE_SIDE_OUTSIDE || radius[object->shape] != 0;
}

static surface surface_at(const sure_case *q, sure_part part, const line_point *line)
{
    const sure_cylinder *cylinder = &q->object.as.cylinder;
    const sure_cone *cone = &q->object.as.cone;
    const sure_disc *disc = &q->object.as.disc;
    switch (q->object.shape) {
    case SURE_SHAPE_PLANE:
        return flat_surface(line, &q->object.as.plane.point, &q->object.as.plane.normal);
    case SURE_SHAPE_DISC: return flat_surface(line, &disc->centre, &disc->normal);
    case SURE_SHAPE_SPHERE: return sphere_surface(line, &q->object.as.sphere);
    case SURE_SHAPE_CYLINDER:
        if (part == SURE_PART_WALL)
            return cylinder_surface(line, cylinder);
        return part == SURE_PART_TOP
                   ? cap_surface(line, &cylinder->base, &cylinder->top, cylinder->radius)
                   : cap_surface(line, &cylinder->top, &cylinder->base, cylinder->radius);
    case SURE_SHAPE_CONE: break;
    }
    return part == SURE_PART_WALL ? cone_surface(line, cone)
                                  : cap_surface(line, &cone->apex, &cone->base, cone->radius);
}

/* As sure_spawn asks: once more where the hit's t is then known better. */
static bool spawn_quick(const sure_case *q, const sure_hit *hit, int side, sure_vec3 *origin)
{
    double wanted = side == SURE_SIDE_INSIDE ? -1 : 1;
    sure_hit at = *hit, nearer = {.t_error = -1};
    for (int i = 0; i < 2; i++) {
        line_point line = line_point_of(&q->ray, at.t);
        surface s = surface_at(q, at.part, &line);
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
        spawned slow = spawn_in(q, hit, side, FE_UPWARD, false), own = {.origin = untouched};
        for (int flushed = 0; flushed < 2; flushed++) {
            spawned quick = spawn_in(q, hit, side, FE_TONEAREST, flushed);
            ck_assert_msg(quick.found == slow.found &&
                              memcmp(&quick.origin, &slow.origin, sizeof slow.origin) == 0,
                          "%d (%a, %a, %a), not %d (%a, %a, %a), t %a +- %a: %s", quick.found,
                          quick.origin.x, quick.origin.y, quick.origin.z, slow.found, slow.origin.x,
                          slow.origin.y, slow.origin.z, hit->t, hit->t_error, text(q, side));
        }
        if (has_side(&q->object, side))
            own.found = spawn_quick(q, hit, side, &own.origin);
        ck_assert(memcmp(&own.origin, own.found ? &slow.origin : &untouched, sizeof own.origin) ==
                  0);
        sum->calls++;
        sum->quick += own.found != 0;
    }
}

static bool hit_of(const sure_case *q, uint64_t index, sure_hit *hit)
{
    sure_tier tier = index % 2 == 0 ? SURE_TIER_CERTAIN : SURE_TIER_EXACT;
    return sure_object_hit(&q->ray, &q->object, tier, hit) == SURE_HIT;
}

START_TEST(test_regimes)
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
    if (sum.calls > 0)
        printf("%-9s %-14s %4u calls, at once %6.2f %%\n", sure_shape_name(shape),
               regime_name(which), sum.calls, 100.0 * sum.quick / sum.calls);
    if (which == REGIME_TYPICAL)
        ck_assert_uint_gt(100 * sum.quick, TYPICAL * sum.calls);
    fflush(stdout);
}
END_TEST

/* A hit's t need not be better than t_error says. */
START_TEST(test_far_t)
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
                              hit.part};
            check_same(&q, &moved, &sum);
        }
    }
    printf("%-9s t off, %u calls, at once %6.2f %%\n", sure_shape_name((sure_shape)_i), sum.calls,
           100.0 * sum.quick / sum.calls);
    ck_assert_uint_gt(sum.quick, sum.calls / 4);
}
END_TEST

/* What is between two roots of which the t is nearer to the wrong one, but allowed to be. */
START_TEST(test_other_root)
{
    tally sum = {0, 0};
    for (uint64_t index = 0; index < CASES; index++) {
        sure_case q = regime_case((sure_shape)_i, REGIME_GRAZING, SEED, index);
        sure_interval ends;
        sure_hit hit;
        if (!hit_of(&q, 0, &hit) ||
            sure_object_interval(&q.ray, &q.object, SURE_TIER_EXACT, &ends) != SURE_HIT)
            continue;
        double other = hit.t == ends.t_enter ? ends.t_leave : ends.t_enter;
        hit = (sure_hit){other, fabs(other - hit.t) * 1.5 + hit.t_error, hit.part};
        check_same(&q, &hit, &sum);
    }
    ck_assert_uint_gt(sum.calls, 0);
}
END_TEST

/* A surface through a point with whole coordinates, in halves of their doubles' distance: of p the
 * first coordinate is midway between doubles, or the point is on the surface though not the true
 * hit, or the true hit is it. */
typedef struct {
    double unit; /* half the distance of doubles */
    sure_vec3 offset, direction;
    sure_vec3 p; /* all exact but for p.x + half */
    double half;
} exact_place;

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

static sure_object exact_object(sure_shape shape, const exact_place *at, double scale, bool cap)
{
    double x = at->p.x, y = at->p.y, z = at->p.z, s = scale * at->unit, h = at->half;
    sure_object object = {.shape = shape};
    sure_vec3 centre = {x + (h - 3 * s), y - 4 * s, z};
    switch (shape) {
    case SURE_SHAPE_PLANE:
        object.as.plane = (sure_plane){{x + (h - 3 * s), y - 4 * s, z - 2 * s}, {4, -3, 0}};
        break;
    case SURE_SHAPE_DISC:
        object.as.disc = (sure_disc){{x + (h - 3 * s), y - 4 * s, z - 2 * s}, {4, -3, 0}, 64 * s};
        break;
    case SURE_SHAPE_SPHERE:
        object.as.sphere = (sure_sphere){{x + (h - 3 * s), y - 2 * s, z - 6 * s}, 7 * s};
        break;
    case SURE_SHAPE_CYLINDER:
        object.as.cylinder = (sure_cylinder){centre, centre, 5 * s};
        object.as.cylinder.base.z = z - (cap ? 0 : 4 * s);
        object.as.cylinder.top.z = z + 8 * s;
        object.as.cylinder.radius *= cap ? 2 : 1;
        break;
    case SURE_SHAPE_CONE:
        object.as.cone = (sure_cone){centre, centre, 10 * s};
        object.as.cone.apex.z = z + 8 * s;
        object.as.cone.base.z = z - (cap ? 0 : 8 * s);
        break;
    }
    return object;
}

/* The ray reaches the point at t = 1/m. */
static sure_case exact_case(sure_shape shape, uint64_t index, double *t)
{
    uint64_t i = 16 * index;
    exact_place at = {.unit = 0x1p-53,
                      .p = {coordinate_at(i), coordinate_at(i + 1), coordinate_at(i + 2)}};
    bool midway = index % 2 == 0;
    int bits = 4 + (int)(suite_bits(SEED, i + 3) % 40), m = 1 + 2 * (int)(index / 2 % 8);
    double scale = odd(i + 4, 4 + (int)(suite_bits(SEED, i + 5) % 38)) * (midway ? 1 : 2);
    at.half = midway ? at.unit : 0;
    /* the way there, in halves: odd where the point is midway */
    double x = odd(i + 6, bits) * sign_of(i + 7) * (midway ? 1 : 2);
    double y = 2 * odd(i + 8, bits) * sign_of(i + 9), z = 2 * odd(i + 10, bits) * sign_of(i + 11);
    sure_case q = {.object = exact_object(shape, &at, scale, index % 3 == 0)};
    q.ray =
        (sure_ray){{at.p.x + (at.half - x * at.unit), at.p.y - y * at.unit, at.p.z - z * at.unit},
                   {m * x * at.unit, m * y * at.unit, m * z * at.unit},
                   0,
                   INFINITY};
    *t = 1.0 / m;
    return q;
}

/* From t = 1/m, and from places around it. */
START_TEST(test_exact_places)
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
        hit = (sure_hit){t + t * off, fabs(t * off) + hit.t_error + 0x1p-52, hit.part};
        check_same(&q, &hit, &sum);
    }
    printf("%-9s exact places, %u calls, at once %6.2f %%\n", sure_shape_name((sure_shape)_i),
           sum.calls, 100.0 * sum.quick / sum.calls);
    ck_assert_uint_gt(sum.calls, DRAWS / 4);
}
END_TEST

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
    sure_case q = {.object = {.shape = shape}};
    switch (shape) {
    case SURE_SHAPE_PLANE: q.object.as.plane = (sure_plane){centre, n}; break;
    case SURE_SHAPE_DISC: q.object.as.disc = (sure_disc){centre, n, 64}; break;
    case SURE_SHAPE_SPHERE: q.object.as.sphere = (sure_sphere){centre, r}; break;
    case SURE_SHAPE_CYLINDER: q.object.as.cylinder = (sure_cylinder){centre, end, r}; break;
    case SURE_SHAPE_CONE: q.object.as.cone = (sure_cone){centre, end, r}; break;
    }
    sure_vec3 o = {2 * coarse(i + 12), 3 * coarse(i + 13), 0};
    o.z = o.y / 2 + shift;
    q.ray = (sure_ray){o, {at.x - o.x, at.y - o.y, (at.y - o.y) / 2}, 0, INFINITY};
    return q;
}

START_TEST(test_equal_steps)
{
    tally sum = {0, 0};
    for (uint64_t index = 0; index < DRAWS; index++) {
        sure_case q = flattened_case((sure_shape)_i, index);
        sure_hit hit;
        if (!hit_of(&q, index, &hit))
            continue;
        double off = fabs(hit.t) * power_of_two(-36 - (int)(index % 18));
        hit = (sure_hit){hit.t + off, 2 * off + hit.t_error, hit.part};
        check_same(&q, &hit, &sum);
    }
    printf("%-9s equal steps, %u calls, at once %6.2f %%\n", sure_shape_name((sure_shape)_i),
           sum.calls, 100.0 * sum.quick / sum.calls);
    ck_assert_uint_gt(sum.calls, DRAWS / 16);
}
END_TEST

/* Across a coordinate axis, or nearly so, by as little as a double can say. */
START_TEST(test_nearly_level)
{
    const double least[] = {0, 0x1p-1074, 0x1p-1000, 0x1p-300, 0x1p-60, 0x1p-40};
    tally sum = {0, 0};
    for (uint64_t index = 0; index < DRAWS; index++) {
        uint64_t i = 16 * index;
        double small = least[index % 6] * sign_of(i);
        double height = index % 4 == 0 ? 0 : coordinate_at(i + 1) - 1.5;
        sure_vec3 n = {_i == 0   ? 1
                       : _i == 2 ? small
                                 : 0,
                       _i == 1   ? 1
                       : _i == 0 ? small
                                 : 0,
                       _i == 2   ? -1
                       : _i == 1 ? small
                                 : 0};
        sure_vec3 at = {_i == 0 ? height : coordinate_at(i + 2),
                        _i == 1 ? height : -coordinate_at(i + 3),
                        _i == 2 ? height : coordinate_at(i + 4)};
        sure_case q = {{{4 * coordinate_at(i + 5), 3 * coordinate_at(i + 6), coordinate_at(i + 7)},
                        {-coordinate_at(i + 8), -coordinate_at(i + 9), -coordinate_at(i + 10)},
                        0,
                        INFINITY},
                       {.shape = SURE_SHAPE_PLANE, .as.plane = {at, n}}};
        sure_hit hit;
        if (hit_of(&q, index, &hit))
            check_same(&q, &hit, &sum);
    }
    ck_assert_uint_gt(sum.quick, sum.calls / 4);
}
END_TEST

/* The function whose zeros are the part that is hit, of p seen from `from`, with A = to - back. */
typedef struct {
    enum { FLAT, BALL, PIPE, SPIKE } kind;
    sure_vec3 from, back, to;
    double radius;
} exact_surface;

static exact_surface exact_surface_of(const sure_object *object, sure_part part)
{
    const sure_vec3 zero = {0, 0, 0};
    const sure_plane *plane = &object->as.plane;
    const sure_disc *disc = &object->as.disc;
    const sure_cylinder *cylinder = &object->as.cylinder;
    const sure_cone *cone = &object->as.cone;
    switch (object->shape) {
    case SURE_SHAPE_PLANE: return (exact_surface){FLAT, plane->point, zero, plane->normal, 0};
    case SURE_SHAPE_DISC: return (exact_surface){FLAT, disc->centre, zero, disc->normal, 0};
    case SURE_SHAPE_SPHERE:
        return (exact_surface){BALL, object->as.sphere.centre, zero, zero,
                               object->as.sphere.radius};
    case SURE_SHAPE_CYLINDER:
        if (part == SURE_PART_WALL)
            return (exact_surface){PIPE, cylinder->base, cylinder->base, cylinder->top,
                                   cylinder->radius};
        return part == SURE_PART_TOP
                   ? (exact_surface){FLAT, cylinder->top, cylinder->base, cylinder->top, 0}
                   : (exact_surface){FLAT, cylinder->base, cylinder->top, cylinder->base, 0};
    case SURE_SHAPE_CONE: break;
    }
    if (part == SURE_PART_WALL)
        return (exact_surface){SPIKE, cone->apex, cone->apex, cone->base, cone->radius};
    return (exact_surface){FLAT, cone->base, cone->apex, cone->base, 0};
}

/* A.p; half of p.p - r^2, of H p.p - (A.p)^2 - r^2 H, of H (H p.p - (A.p)^2) - r^2 (A.p)^2. */
static void exact_value(mpfr_t value, const exact_surface *s, true_vector p)
{
    true_vector axis;
    mpfr_t height, along, rr;
    true_vector_init(axis, BITS);
    mpfr_inits2(BITS, height, along, rr, (mpfr_ptr)NULL);
    true_vector_between(axis, s->back, s->to);
    true_dot(height, axis, axis);
    true_dot(along, axis, p);
    true_dot(value, p, p);
    mpfr_set_d(rr, s->radius, MPFR_RNDN);
    mpfr_sqr(rr, rr, MPFR_RNDN);
    if (s->kind == PIPE || s->kind == SPIKE) {
        mpfr_fmms(value, height, value, along, along, MPFR_RNDN);
        mpfr_mul(rr, rr, height, MPFR_RNDN);
    }
    if (s->kind == SPIKE) {
        mpfr_mul(value, value, height, MPFR_RNDN);
        mpfr_div(rr, rr, height, MPFR_RNDN);
        mpfr_mul(rr, rr, along, MPFR_RNDN);
        mpfr_mul(rr, rr, along, MPFR_RNDN);
    }
    if (s->kind == FLAT)
        mpfr_mul_2ui(value, along, 1, MPFR_RNDN);
    mpfr_sub(value, value, rr, MPFR_RNDN);
    mpfr_div_2ui(value, value, 1, MPFR_RNDN);
    true_vector_clear(axis);
    mpfr_clears(height, along, rr, (mpfr_ptr)NULL);
}

/* o + t d, seen from `from`. */
static void exact_point(true_vector p, const sure_ray *ray, sure_vec3 from, mpfr_t t)
{
    const double d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    mpfr_t way;
    mpfr_init2(way, BITS);
    true_vector_between(p, from, ray->origin);
    for (int i = 0; i < 3; i++) {
        mpfr_mul_d(way, t, d[i], MPFR_RNDN);
        mpfr_add(p[i], p[i], way, MPFR_RNDN);
    }
    mpfr_clear(way);
}

static void exact_t(mpfr_t t, const sure_case *q)
{
    true_line line;
    true_line_init(&line, BITS);
    true_line_set(&line, q);
    ck_assert(true_first(&line, t));
    true_line_clear(&line);
}

/* Worst error/bound. */
typedef struct {
    double place, sign;
    unsigned certain;
} worst_shares;

static void raise_share(double *worst, mpfr_t error, double bound)
{
    mpfr_abs(error, error, MPFR_RNDN);
    mpfr_div_d(error, error, bound, MPFR_RNDN);
    *worst = fmax(*worst, mpfr_get_d(error, MPFR_RNDU));
}

static void measure_place(const sure_case *q, const true_place *at, worst_shares *worst)
{
    const double_pair x[3] = {at->x, at->y, at->z};
    const sure_vec3 zero = {0, 0, 0};
    true_vector p;
    mpfr_t t;
    true_vector_init(p, BITS);
    mpfr_init2(t, BITS);
    exact_t(t, q);
    exact_point(p, &q->ray, zero, t);
    for (int i = 0; i < 3; i++) {
        mpfr_sub_d(p[i], p[i], x[i].head, MPFR_RNDN);
        mpfr_sub_d(p[i], p[i], x[i].tail, MPFR_RNDN);
        raise_share(&worst->place, p[i], at->error);
    }
    mpfr_clear(t);
    true_vector_clear(p);
}

static void measure_sign(const exact_surface *s, const true_place *at, sure_vec3 n, uint64_t index,
                         worst_shares *worst)
{
    true_vector p;
    mpfr_t value;
    true_vector_init(p, BITS);
    mpfr_init2(value, BITS);
    for (uint64_t i = 0; i < 8; i++) {
        uint64_t bits = suite_bits(SEED + 1, 8 * index + i);
        sure_vec3 q = {double_of(bits_of(nearest(at->x)) + bits % 5 - 2),
                       double_of(bits_of(nearest(at->y)) + bits / 5 % 5 - 2),
                       double_of(bits_of(nearest(at->z)) + bits / 25 % 5 - 2)};
        true_vector_between(p, s->from, q);
        exact_value(value, s, p);
        mpfr_sub_d(value, value, ahead(at, n, q), MPFR_RNDN);
        raise_share(&worst->sign, value, at->doubt);
    }
    mpfr_clear(value);
    true_vector_clear(p);
}

static void measure(const sure_case *q, const sure_hit *hit, uint64_t index, worst_shares *worst)
{
    line_point line = line_point_of(&q->ray, hit->t);
    surface s = surface_at(q, hit->part, &line);
    true_place at = true_place_of(&q->ray, hit, &line, &s);
    sure_vec3 p = {nearest(at.x), nearest(at.y), nearest(at.z)};
    if (!at.certain || s.level.axis >= 0 || !rounds_to(&at, p))
        return;
    exact_surface exact = exact_surface_of(&q->object, hit->part);
    measure_place(q, &at, worst);
    measure_sign(&exact, &at, s.n, index, worst);
    worst->certain++;
}

START_TEST(test_bounds)
{
    const regime regimes[] = {REGIME_TYPICAL, REGIME_FAR,      REGIME_GRAZING,
                              REGIME_INSIDE,  REGIME_INTEGERS, REGIME_NEEDLE};
    worst_shares worst = {0, 0, 0};
    for (uint64_t index = 0; index < 6 * MEASURED; index++) {
        sure_hit hit;
        if (!regime_applies((sure_shape)_i, regimes[index % 6]))
            continue;
        sure_case q = regime_case((sure_shape)_i, regimes[index % 6], SEED, index / 6);
        for (uint64_t k = 0; k < 3 && hit_of(&q, index, &hit); k++) {
            double off =
                fabs(hit.t) * power_of_two(-16 * (int)k) * suite_double(SEED + 2, 4 * index + k, 0);
            off = k == 0 ? 0 : off;
            sure_hit moved = {hit.t + off, fabs(off) + hit.t_error + fabs(hit.t) * 0x1p-52,
                              hit.part};
            measure(&q, &moved, index, &worst);
        }
    }
    printf("%-9s error/bound of %u hits: place %.3f, sign %.3f\n", sure_shape_name((sure_shape)_i),
           worst.certain, worst.place, worst.sign);
    ck_assert_uint_gt(worst.certain, MEASURED / 2);
    ck_assert(worst.place <= 1 && worst.sign <= 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("spawn_quick");
    TCase *all = tcase_create("all");
    tcase_add_loop_test(all, test_regimes, 0, SURE_SHAPES * REGIMES);
    tcase_add_loop_test(all, test_far_t, 0, SURE_SHAPES);
    tcase_add_loop_test(all, test_other_root, SURE_SHAPE_SPHERE, SURE_SHAPES);
    tcase_add_loop_test(all, test_exact_places, 0, SURE_SHAPES);
    tcase_add_loop_test(all, test_equal_steps, 0, SURE_SHAPES);
    tcase_add_loop_test(all, test_nearly_level, 0, 3);
    tcase_add_loop_test(all, test_bounds, 0, SURE_SHAPES);
    tcase_set_timeout(all, 120);
    suite_add_tcase(suite, all);
    return suite_run(suite);
}
