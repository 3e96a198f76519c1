/* SPDX-License-Identifier: MIT */
/* The discriminant by double-doubles and by the low bits (src/stages/discriminant.c), held against
 * exact numbers: is its sign right, is it within its error, does it vanish when it says so? */
#include "../shapes/filters.h"
#include "../support/every_case.h"
#include "../support/objects.h"

#include "../../src/stages/query.h"
#include "../../src/stages/close.h"
#include "../../src/stages/hits/surface.h"
#include "../../src/stages/rows.h"

enum { CASES = 300, HOSTILE = 60000, SEED = 23, CLIMBS = 24, STEPS = 1500 };

/* Of the query: D = inner - outer, neither term below 0. */
static mpfr_t true_d, true_outer;

static void set_up(void)
{
    mpfr_inits(true_d, true_outer, (mpfr_ptr)NULL);
}

static void tear_down(void)
{
    mpfr_clears(true_d, true_outer, (mpfr_ptr)NULL);
}

/* What was answered, and a tally. */
typedef struct {
    const filter_subject *of;
    known_discriminant found;
    bool told;
    double worst;
    long all, by_dd, by_mod128, tangents, vanishing;
} watch;

/* |d x m|^2, of cylinder and cone (A.(d x m))^2 by Gram's determinant, of a cone times A.A. */
static void set_outer(mpfr_t outer, true_line *l)
{
    TRUE_NUMBERS(l->bits, x);
    mpfr_fmms(outer, l->dd, l->mm, l->md, l->md, MPFR_RNDN);
    if (l->capped) {
        mpfr_mul(outer, outer, l->height, MPFR_RNDN);
        mpfr_fmms(x, l->level, l->md, l->slope, l->mm, MPFR_RNDN);
        mpfr_fma(outer, x, l->slope, outer, MPFR_RNDN);
        mpfr_fmms(x, l->slope, l->md, l->level, l->dd, MPFR_RNDN);
        mpfr_fma(outer, x, l->level, outer, MPFR_RNDN);
    }
    if (l->tapers)
        mpfr_mul(outer, outer, l->height, MPFR_RNDN);
}

/* The quotient that D is rounds. */
static void set_terms(true_line *line, void *context)
{
    watch *w = context;
    mpfr_set_prec(true_outer, line->bits);
    mpfr_set_prec(true_d, line->bits);
    set_outer(true_outer, line);
    if (mpfr_inexflag_p() != 0)
        return;
    true_discriminant(w->of, line, true_d);
    mpfr_clear_inexflag();
}

static void watch_case(watch *w, const sure_case *c)
{
    true_exactly(c, set_terms, w);
}

static void ask(const sure_case *c, void *context)
{
    watch *w = context;
    w->told = discriminant_of(row_of(&c->object), &c->ray, &c->object.as, w->of->body(c).measure,
                              w->of->bound, &w->found);
}

static void judge(const sure_case *c, void *context)
{
    watch *w = context;
    const known_discriminant *found = &w->found;
    w->all++;
    if (!w->told)
        return;
    int truth = mpfr_sgn(true_d);
    bool nothing = truth == 0 && mpfr_zero_p(true_outer);
    double share = share_of_pair(true_d, found->value, found->rest, found->error);
    case_require(c, (found->value > 0) - (found->value < 0) == (truth > 0) - (truth < 0), "sign");
    case_require(c, share <= 1, "beyond the error");
    case_require(c, found->error <= fabs(found->value), "an error above the value");
    case_require(c, fabs(found->rest) <= 0x1p-53 * fabs(found->value), "a long rest");
    case_require(c, truth != 0 || (found->value == 0 && found->error == 0),
                 "a tangent of some size");
    case_require(c, !found->coplanar, "coplanar");
    if (found->stage == SURE_STAGE_DOUBLE_DOUBLE) {
        w->by_dd++;
        w->worst = fmax(w->worst, share);
        case_require(c, !found->vanishes && truth != 0, "a zero by double-doubles");
    } else {
        w->by_mod128++;
        w->tangents += truth == 0;
        w->vanishing += nothing;
        case_require(c, found->stage == SURE_STAGE_MOD128, "stage");
        case_require(c, found->vanishes == nothing, "both terms");
    }
}

static void print(const watch *w, const char *shape, const char *of)
{
    printf("%-8s %-13s error/bound %.4f  dd %.1f %%, mod128 %.1f %% (0: %ld, both: %ld), open "
           "%.1f %%\n",
           shape, of, w->worst, 100. * (double)w->by_dd / (double)w->all,
           100. * (double)w->by_mod128 / (double)w->all, w->tangents, w->vanishing,
           100. * (double)(w->all - w->by_dd - w->by_mod128) / (double)w->all);
}

/* The case as it stands where it fits, else as query_of scales it; false for neither. */
static bool as_asked(const sure_case *c, sure_case *asked)
{
    query q;
    *asked = *c;
    if (!case_is_valid(c))
        return false;
    if (filter_fits(c))
        return true;
    if (!query_of(&c->ray, row_of(&c->object), &c->object.as, &q))
        return false;
    *asked = (sure_case){.ray = *q.ray, .object.shape = c->object.shape};
    memcpy(&asked->object.as, q.scaled_shape, sizeof q.scaled_shape);
    return filter_fits(asked);
}

/* Mantissas of 53 bits. */
static double full(int index, int exponent)
{
    uint64_t bits = suite_bits(9, (uint64_t)index);
    double mantissa = (double)(bits >> 11 | UINT64_C(1) << 52 | 1);
    return ldexp(bits & 1 ? -mantissa : mantissa, exponent - 52);
}

/* A ray whose vertex about the origin is next to x = 1: p = o + d = (1, -1, e), and the slope is
 * d_x - d_y + e d_z, of equal d_x and d_y. Its low bits are whole where d_z is not too small. */
static sure_ray nearly_at_one(int index, int z_exponent)
{
    double f = 2 * floor(full(2 * index, 51)) * 0x1p-52, z = ldexp(1, z_exponent);
    double e = full(2 * index + 1, z_exponent - 30);
    return (sure_ray){{1 - f, -1 - f, e - z}, {f, f, z}, 1, INFINITY};
}

/* tangent_order is right or does not know, whatever a line's slope is; with few bits it knows. */
TEST(test_tangent_order)
{
    const sure_sphere ball = {{0, 0, 0}, 1};
    int known[2] = {0, 0};
    for (int i = 0; i < STEPS; i++) {
        for (int wide = 0; wide < 2; wide++) {
            sure_ray ray = nearly_at_one(i, wide ? -120 : -50);
            double e = ray.origin.z + ray.direction.z;
            int sign = 0, expected = e > 0 ? -1 : e < 0;
            bool told = tangent_order(&sphere_row, &ray, &ball, 1, &sign);
            ck_assert_msg(!told || sign == expected, "case %d: %d for %d", i, sign, expected);
            known[wide] += told;
        }
    }
    ck_assert_int_eq(known[0], STEPS);
    ck_assert_int_lt(known[1], STEPS / 2);
}

/* At its vertex a line's slope is what doubles round: where it seems to vanish it may be anything
 * that small. */
LOOP_TEST(test_slopes, SURE_SHAPES)
{
    const shape_row *row = shape_rows[_i];
    const surface_row *of = row->surface;
    int deceiving = 0;
    for (uint64_t i = 0; i < STEPS && of->slope_f64; i++) {
        sure_case c = regime_case((sure_shape)_i, REGIME_TYPICAL, SEED, i);
        const void *shape = &c.object.as;
        double slope = of->slope_f64(&c.ray, shape, 0);
        double x = slope / (slope - of->slope_f64(&c.ray, shape, 1));
        ddb_context known = {false};
        ddb half = surface_slope(&known, row, &c.ray, shape, ddb_of(&known, x)).half_slope;
        int sign = 0, expected = -ddb_sign(&known, half);
        bool told = tangent_order(row, &c.ray, shape, x, &sign);
        case_require(&c, known.uncertain || (told && sign == expected), "another order");
        deceiving += !known.uncertain && of->slope_f64(&c.ray, shape, x) == 0;
    }
    ck_assert(deceiving > STEPS / 100 || !of->slope_f64);
}

/* All terms of a body with an axis may vanish. */
LOOP_TEST(test_regimes, SURE_SHAPES)
{
    sure_shape shape = (sure_shape)_i;
    long tangents = 0, vanishing = 0;
    for (int r = 0; r < REGIMES && filter_subjects[_i].body; r++) {
        if (!regime_applies(shape, (regime)r))
            continue;
        watch w = {.of = &filter_subjects[_i]};
        for (uint64_t i = 0; i < CASES; i++) {
            sure_case c = regime_case(shape, (regime)r, SEED, i), asked;
            if (!as_asked(&c, &asked))
                continue;
            watch_case(&w, &asked);
            in_each_environment(&asked, ask, judge, &w);
        }
        if (w.all > 0)
            print(&w, sure_shape_name(shape), regime_name((regime)r));
        ck_assert((regime)r != REGIME_TYPICAL || w.by_dd == w.all);
        ck_assert((regime)r != REGIME_TANGENT || w.by_mod128 > w.all / 2);
        tangents += w.tangents;
        vanishing += w.vanishing;
    }
    ck_assert(tangents > CASES || !filter_subjects[_i].body);
    ck_assert(vanishing > CASES || filter_subjects[_i].powers == 0);
}

static double bits_above_one(int bits, uint64_t stream, uint64_t i)
{
    return 1 + (double)(suite_bits(stream, i) >> (64 - bits)) * power_of_two(-bits);
}

static double small(uint64_t most, uint64_t stream, uint64_t i)
{
    return power_of_two(-(int)(suite_bits(stream, i) % most));
}

/* m or A of more than 53 bits, along d but for its last: d x m or A x d vanishes in double-doubles
 * and not in truth, so that both terms are off by more than they are. */
typedef struct {
    sure_vec3 d, off;
    double last; /* of the bits of `off` */
} nearly_along;

static nearly_along draw_nearly_along(int bits, int more, uint64_t i)
{
    int depth = 54 + (int)(suite_bits(3, i) % 3);
    nearly_along n = {.last = power_of_two(-bits - more - depth)};
    n.d = (sure_vec3){bits_above_one(bits, 4, i), bits_above_one(bits, 5, i),
                      bits_above_one(bits, 6, i)};
    double shift = (double)(suite_bits(7, i) >> (64 - more) | 1) * power_of_two(-more - depth);
    n.off = times(suite_bits(8, i) % 2 ? shift : -shift, n.d);
    return n;
}

static nearly_along draw_long(uint64_t i)
{
    nearly_along n =
        draw_nearly_along((int)(4 + suite_bits(1, i) % 49), (int)(1 + suite_bits(2, i) % 50), i);
    n.off.x = suite_bits(9, i) % 2 ? nextafter(n.off.x, 9) : n.off.x;
    n.off.y = suite_bits(10, i) % 3 ? n.off.y : nextafter(n.off.y, 9);
    return n;
}

static sure_case hostile_sphere(uint64_t i)
{
    nearly_along n = draw_long(i);
    return (sure_case){.ray = {n.d, times(-1, n.d), 0, INFINITY},
                       .object = {SURE_SHAPE_SPHERE, {.sphere = {n.off, small(200, 11, i)}}}};
}

static sure_case hostile_cylinder(uint64_t i)
{
    nearly_along n = draw_long(i);
    sure_vec3 o = suite_bits(12, i) % 2 ? n.off : (sure_vec3){small(60, 13, i), 0, 0};
    o.x += suite_bits(14, i) % 2 ? small(60, 15, i) : 0;
    return (sure_case){
        .ray = {o, n.d, 0, INFINITY},
        .object = {SURE_SHAPE_CYLINDER, {.cylinder = {n.off, n.d, small(60, 11, i)}}}};
}

static sure_case hostile_cone(uint64_t i)
{
    nearly_along n =
        draw_nearly_along((int)(20 + suite_bits(1, i) % 20), (int)(1 + suite_bits(2, i) % 12), i);
    n.off.x += n.last * (double)(suite_bits(9, i) % 3);
    n.off.y += n.last * (double)(suite_bits(10, i) % 3);
    sure_vec3 base = {(double)(suite_bits(16, i) % 5), (double)(suite_bits(17, i) % 7), 1};
    return (sure_case){.ray = {times(0x1p30, n.d), times(-1, n.d), 0, INFINITY},
                       .object = {SURE_SHAPE_CONE,
                                  {.cone = {times(0x1p30, base), times(0x1p30, n.off),
                                            0x1p30 * small(60, 11, i)}}}};
}

static const struct {
    sure_case (*draw)(uint64_t i);
    long deceiving; /* so many at least */
} hostile[SURE_SHAPES] = {
    [SURE_SHAPE_SPHERE] = {hostile_sphere, HOSTILE / 10},
    [SURE_SHAPE_CYLINDER] = {hostile_cylinder, HOSTILE / 10},
    [SURE_SHAPE_CONE] = {hostile_cone, HOSTILE / 400},
};

/* Are the terms as double-doubles have them less than half of what they are, D + 2 outer? */
static bool deceives(const sure_case *c)
{
    two_terms_dd nearly = close_rows[c->object.shape].discriminant(&c->ray, &c->object.as);
    mpfr_mul_2ui(true_outer, true_outer, 1, MPFR_RNDN);
    mpfr_add(true_outer, true_outer, true_d, MPFR_RNDN);
    return mpfr_cmp_d(true_outer, 2 * (nearly.more.head + nearly.less.head)) > 0;
}

LOOP_TEST(test_hostile, SURE_SHAPES)
{
    watch w = {.of = &filter_subjects[_i]};
    long deceiving = 0;
    if (!hostile[_i].draw)
        return;
    for (uint64_t i = 0; i < HOSTILE; i++) {
        sure_case c = hostile[_i].draw(i);
        if (!filter_fits(&c))
            continue;
        watch_case(&w, &c);
        ask(&c, &w);
        judge(&c, &w);
        deceiving += deceives(&c);
    }
    print(&w, sure_shape_name((sure_shape)_i), "hostile");
    printf("%-8s %ld deceive double-doubles\n", sure_shape_name((sure_shape)_i), deceiving);
    ck_assert_int_gt(deceiving, hostile[_i].deceiving);
}

static double dd_share(const sure_case *c, int surroundings, void *context)
{
    watch *w = context;
    (void)surroundings;
    if (!filter_fits(c))
        return 0;
    ask(c, w);
    if (!w->told || w->found.stage != SURE_STAGE_DOUBLE_DOUBLE)
        return 0;
    watch_case(w, c);
    judge(c, w);
    return share_of_pair(true_d, w->found.value, w->found.rest, w->found.error);
}

/* Uphill to the greatest error of what double-doubles tell. */
LOOP_TEST(test_search, SURE_SHAPES)
{
    static const regime from[] = {REGIME_GRAZING, REGIME_TYPICAL, REGIME_FAR, REGIME_NEIGHBOUR};
    const climbing how = {from, 4, CLIMBS, STEPS, NULL};
    watch w = {.of = &filter_subjects[_i]};
    if (!filter_subjects[_i].body)
        return;
    double worst = climb((sure_shape)_i, &how, dd_share, &w);
    printf("%-8s searched      error/bound %.4f\n", sure_shape_name((sure_shape)_i), worst);
    ck_assert(worst > 0x1p-8 && worst < 1);
}

SUITE_IN("discriminant", set_up, tear_down)
