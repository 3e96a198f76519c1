/* The discriminant by double-doubles and by the low bits (src/stages/discriminant.h), held against
 * integers: is its sign right, is it within its error, does it vanish when it says so? */
#include "../support/every_case.h"
#include "../support/suite.h"

#include "../../src/stages/discriminant.h"
#include "../../src/shapes/cone/cone_filter.h"
#include "../../src/shapes/cylinder/cylinder_filter.h"
#include "../../src/shapes/capped/capped_side.h"
#include "../../src/stages/query.h"
#include "../../src/stages/rows.h"
#include "../../src/shapes/sphere/sphere_filter.h"
#include "../../src/cases/regimes.h"

#define NUMBER dd
#include "../../src/shapes/sphere/sphere_tmpl.h"
#undef NUMBER
#ifdef MOD128_EXISTS
#define NUMBER mod128
#include "../../src/shapes/cone/cone_tmpl.h"
#include "../../src/shapes/cylinder/cylinder_tmpl.h"
#include "../../src/shapes/sphere/sphere_tmpl.h"
#undef NUMBER
#endif

#include <gmp.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    CASES = 300,
    HOSTILE = 60000,
    SEED = 23,
    CLIMBS = 24,
    STEPS = 1500,
    UNIT = -1074,
    WIDE = 24000
};

/* x, y, z in units of 2^-1074, so that everything below is an integer. */
typedef mpz_t triple[3];

static void set_integer(mpz_t integer, double x)
{
    int exponent = 0;
    mpz_set_d(integer, ldexp(frexp(x, &exponent), DBL_MANT_DIG));
    exponent -= DBL_MANT_DIG + UNIT;
    if (exponent >= 0)
        mpz_mul_2exp(integer, integer, (mp_bitcnt_t)exponent);
    else
        mpz_tdiv_q_2exp(integer, integer, (mp_bitcnt_t)-exponent);
}

static void triple_set(triple v, sure_vec3 from, sure_vec3 to)
{
    const double ends[3][2] = {{from.x, to.x}, {from.y, to.y}, {from.z, to.z}};
    mpz_t start;
    mpz_init(start);
    for (int i = 0; i < 3; i++) {
        set_integer(v[i], ends[i][1]);
        set_integer(start, ends[i][0]);
        mpz_sub(v[i], v[i], start);
    }
    mpz_clear(start);
}

static void triple_dot(mpz_t dot, triple v, triple w)
{
    mpz_mul(dot, v[0], w[0]);
    mpz_addmul(dot, v[1], w[1]);
    mpz_addmul(dot, v[2], w[2]);
}

/* The two terms of D, in units of 2^(degree UNIT), from scalar products alone. */
typedef struct {
    mpz_t inner, outer;
    int degree;
} terms;

/* A, d, m, and the products of two of them; x, y: for use between. */
typedef struct {
    triple axis, d, m;
    mpz_t aa, ad, am, dd, dm, mm, rr, x, y;
} products;

static void products_init(products *p)
{
    for (int i = 0; i < 3; i++)
        mpz_inits(p->axis[i], p->d[i], p->m[i], (mpz_ptr)NULL);
    mpz_inits(p->aa, p->ad, p->am, p->dd, p->dm, p->mm, p->rr, p->x, p->y, (mpz_ptr)NULL);
}

static void products_clear(products *p)
{
    for (int i = 0; i < 3; i++)
        mpz_clears(p->axis[i], p->d[i], p->m[i], (mpz_ptr)NULL);
    mpz_clears(p->aa, p->ad, p->am, p->dd, p->dm, p->mm, p->rr, p->x, p->y, (mpz_ptr)NULL);
}

static void products_set(products *p, const sure_case *c, sure_vec3 from, sure_vec3 to, double r)
{
    triple_set(p->axis, from, to);
    triple_set(p->m, from, c->ray.origin);
    triple_set(p->d, (sure_vec3){0, 0, 0}, c->ray.direction);
    triple_dot(p->aa, p->axis, p->axis);
    triple_dot(p->ad, p->axis, p->d);
    triple_dot(p->am, p->axis, p->m);
    triple_dot(p->dd, p->d, p->d);
    triple_dot(p->dm, p->d, p->m);
    triple_dot(p->mm, p->m, p->m);
    set_integer(p->rr, r);
    mpz_mul(p->rr, p->rr, p->rr);
}

/* z = k l - m n */
static void minor(mpz_t z, mpz_t k, mpz_t l, mpz_t m, mpz_t n)
{
    mpz_mul(z, k, l);
    mpz_submul(z, m, n);
}

/* (A.(d x m))^2, Gram's determinant of the three. */
static void gram(mpz_t volume, products *p)
{
    minor(p->x, p->dd, p->mm, p->dm, p->dm);
    mpz_mul(volume, p->aa, p->x);
    minor(p->x, p->ad, p->mm, p->am, p->dm);
    mpz_submul(volume, p->ad, p->x);
    minor(p->x, p->ad, p->dm, p->am, p->dd);
    mpz_addmul(volume, p->am, p->x);
}

static void sphere_truth(const sure_case *c, products *p, terms *t)
{
    const sure_sphere *s = &c->object.as.sphere;
    products_set(p, c, s->centre, s->centre, s->radius);
    mpz_mul(t->inner, p->rr, p->dd);
    minor(t->outer, p->dd, p->mm, p->dm, p->dm);
}

static void cylinder_truth(const sure_case *c, products *p, terms *t)
{
    const sure_cylinder *s = &c->object.as.cylinder;
    products_set(p, c, s->base, s->top, s->radius);
    minor(p->y, p->aa, p->dd, p->ad, p->ad);
    mpz_mul(t->inner, p->rr, p->y);
    gram(t->outer, p);
}

static void cone_truth(const sure_case *c, products *p, terms *t)
{
    const sure_cone *s = &c->object.as.cone;
    products_set(p, c, s->apex, s->base, s->radius);
    gram(t->outer, p);
    minor(p->x, p->dd, p->mm, p->dm, p->dm);
    mpz_mul(p->y, p->aa, p->x);
    mpz_sub(p->y, p->y, t->outer);
    mpz_mul(t->inner, p->rr, p->y);
    mpz_mul(t->outer, t->outer, p->aa);
}

/* What the shapes' stages ask with, and whether they ask at all. */
typedef struct {
    double measure;
    bool fits;
} asked_with;

static asked_with sphere_asks(const sure_case *c)
{
    sphere_terms of = sphere_terms_of(&c->ray, &c->object.as.sphere);
    return (asked_with){of.a * of.size, sphere_fits(&c->object.as.sphere, &of)};
}

static asked_with cylinder_asks(const sure_case *c)
{
    cylinder_terms of = cylinder_terms_of(&c->ray, &c->object.as.cylinder);
    return (asked_with){of.measure, cylinder_fits(&c->object.as.cylinder, &of)};
}

static asked_with cone_asks(const sure_case *c)
{
    cone_terms of = cone_terms_of(&c->ray, &c->object.as.cone);
    return (asked_with){of.measure, cone_fits(&c->object.as.cone, &of)};
}

static sure_case hostile_sphere(uint64_t i);
static sure_case hostile_cylinder(uint64_t i);
static sure_case hostile_cone(uint64_t i);

/* The shapes with a discriminant. */
typedef struct {
    sure_shape shape;
    int degree; /* of the terms */
    void (*truth)(const sure_case *, products *, terms *);
    asked_with (*asks)(const sure_case *);
    double bound;
    discriminant_forms forms;
    sure_case (*hostile)(uint64_t i);
    long deceiving;  /* so many of the hostile ones at least */
    bool may_vanish; /* both terms */
} subject;

static const subject subjects[] = {
    {SURE_SHAPE_SPHERE, 4, sphere_truth, sphere_asks, SURE_CYLINDER_DISCRIMINANT_BOUND,
     DISCRIMINANT_FORMS(sphere_discriminant_of), hostile_sphere, HOSTILE / 10, false},
    {SURE_SHAPE_CYLINDER, 6, cylinder_truth, cylinder_asks, SURE_CYLINDER_DISCRIMINANT_BOUND,
     DISCRIMINANT_FORMS(cylinder_discriminant_of), hostile_cylinder, HOSTILE / 10, true},
    {SURE_SHAPE_CONE, 8, cone_truth, cone_asks, SURE_CONE_DISCRIMINANT_BOUND,
     DISCRIMINANT_FORMS(cone_discriminant_of), hostile_cone, HOSTILE / 400, true},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

static void true_terms(const subject *of, const sure_case *c, terms *t)
{
    products p;
    products_init(&p);
    of->truth(c, &p, t);
    t->degree = of->degree;
    products_clear(&p);
}

/* One query, its truth, what was answered, and a tally. */
typedef struct {
    const subject *of;
    const sure_case *asked;
    terms truth;
    mpfr_t d, sum; /* inner - outer, inner + outer */
    known_discriminant found;
    bool told;
    double worst;
    long all, by_dd, by_mod128, tangents, vanishing;
} watch;

static void watch_init(watch *w, const subject *of)
{
    w->of = of;
    mpz_inits(w->truth.inner, w->truth.outer, (mpz_ptr)NULL);
    mpfr_inits2(WIDE, w->d, w->sum, (mpfr_ptr)NULL);
    w->worst = 0;
    w->all = w->by_dd = w->by_mod128 = w->tangents = w->vanishing = 0;
}

static void watch_clear(watch *w)
{
    mpz_clears(w->truth.inner, w->truth.outer, (mpz_ptr)NULL);
    mpfr_clears(w->d, w->sum, (mpfr_ptr)NULL);
}

static void watch_case(watch *w, const sure_case *c)
{
    mpz_t difference;
    w->asked = c;
    true_terms(w->of, c, &w->truth);
    mpz_init(difference);
    mpz_sub(difference, w->truth.inner, w->truth.outer);
    int inexact = mpfr_set_z_2exp(w->d, difference, w->truth.degree * UNIT, MPFR_RNDN);
    if (inexact != 0)
        ck_abort_msg("WIDE is not wide enough");
    mpz_clear(difference);
}

static void ask(const sure_case *c, void *context)
{
    watch *w = context;
    w->told = discriminant_of(&c->ray, &c->object.as, &w->of->forms, w->of->asks(c).measure,
                              w->of->bound, &w->found);
}

static void require(const watch *w, bool holds, const char *what)
{
    if (holds)
        return;
    char line[CASE_LINE_MAX];
    case_print(w->asked, line);
    ck_abort_msg("%s: %a + %a +- %a by stage %d: %s", what, w->found.value, w->found.rest,
                 w->found.error, w->found.stage, line);
}

/* |value + rest - D| over the error; 0 for 0 over 0. */
static double share_of(const watch *w)
{
    mpfr_t off;
    mpfr_init2(off, WIDE);
    mpfr_sub_d(off, w->d, w->found.value, MPFR_RNDN);
    mpfr_sub_d(off, off, w->found.rest, MPFR_RNDN);
    bool none = mpfr_zero_p(off) != 0;
    mpfr_div_d(off, off, w->found.error, MPFR_RNDA);
    double share = none ? 0 : fabs(mpfr_get_d(off, MPFR_RNDA));
    mpfr_clear(off);
    return share;
}

static void judge(const sure_case *c, void *context)
{
    watch *w = context;
    const known_discriminant *found = &w->found;
    (void)c;
    w->all++;
    if (!w->told)
        return;
    int truth = mpfr_sgn(w->d);
    bool nothing = mpz_sgn(w->truth.inner) == 0 && mpz_sgn(w->truth.outer) == 0;
    double share = share_of(w);
    require(w, (found->value > 0) - (found->value < 0) == (truth > 0) - (truth < 0), "sign");
    require(w, share <= 1, "beyond the error");
    require(w, found->error <= fabs(found->value), "an error above the value");
    require(w, fabs(found->rest) <= 0x1p-53 * fabs(found->value), "a long rest");
    require(w, truth != 0 || (found->value == 0 && found->error == 0), "a tangent of some size");
    require(w, !found->coplanar, "coplanar");
    if (found->stage == SURE_STAGE_DOUBLE_DOUBLE) {
        w->by_dd++;
        w->worst = fmax(w->worst, share);
        require(w, !found->vanishes && truth != 0, "a zero by double-doubles");
    } else {
        w->by_mod128++;
        w->tangents += truth == 0;
        w->vanishing += nothing;
        require(w, found->stage == SURE_STAGE_MOD128, "stage");
        require(w, found->vanishes == nothing, "both terms");
    }
}

static void judge_case(watch *w, const sure_case *c)
{
    watch_case(w, c);
    in_each_environment(c, ask, judge, w);
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
static bool as_asked(const subject *of, const sure_case *c, sure_case *asked)
{
    query q;
    *asked = *c;
    if (sure_object_check(&c->ray, &c->object) != SURE_FIELD_NONE)
        return false;
    if (of->asks(c).fits)
        return true;
    if (!query_of(&c->ray, row_of(&c->object), &c->object.as, &q))
        return false;
    *asked = (sure_case){.ray = *q.ray, .object.shape = c->object.shape};
    memcpy(&asked->object.as, q.scaled_shape, sizeof q.scaled_shape);
    return of->asks(asked).fits;
}

START_TEST(test_regimes)
{
    const subject *of = &subjects[_i];
    sure_shape shape = of->shape;
    long tangents = 0, vanishing = 0;
    for (int r = 0; r < REGIMES; r++) {
        if (!regime_applies(shape, (regime)r))
            continue;
        watch w;
        watch_init(&w, &subjects[_i]);
        for (uint64_t i = 0; i < CASES; i++) {
            sure_case c = regime_case(shape, (regime)r, SEED, i), asked;
            if (as_asked(of, &c, &asked))
                judge_case(&w, &asked);
        }
        if (w.all > 0)
            print(&w, sure_shape_name(shape), regime_name((regime)r));
        ck_assert((regime)r != REGIME_TYPICAL || w.by_dd == w.all);
        ck_assert((regime)r != REGIME_TANGENT || w.by_mod128 > w.all / 2);
        tangents += w.tangents;
        vanishing += w.vanishing;
        watch_clear(&w);
    }
    ck_assert_int_gt(tangents, CASES);
    ck_assert(!of->may_vanish || vanishing > CASES);
}
END_TEST

static double bits_above_one(int bits, uint64_t stream, uint64_t i)
{
    return 1 + (double)(suite_bits(stream, i) >> (64 - bits)) * power_of_two(-bits);
}

static double small(uint64_t most, uint64_t stream, uint64_t i)
{
    return power_of_two(-(int)(suite_bits(stream, i) % most));
}

static sure_vec3 scaled(double k, sure_vec3 v)
{
    return (sure_vec3){k * v.x, k * v.y, k * v.z};
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
    n.off = scaled(suite_bits(8, i) % 2 ? shift : -shift, n.d);
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
    return (sure_case){{n.d, scaled(-1, n.d), 0, INFINITY},
                       {SURE_SHAPE_SPHERE, {.sphere = {n.off, small(200, 11, i)}}}};
}

static sure_case hostile_cylinder(uint64_t i)
{
    nearly_along n = draw_long(i);
    sure_vec3 o = suite_bits(12, i) % 2 ? n.off : (sure_vec3){small(60, 13, i), 0, 0};
    o.x += suite_bits(14, i) % 2 ? small(60, 15, i) : 0;
    return (sure_case){{o, n.d, 0, INFINITY},
                       {SURE_SHAPE_CYLINDER, {.cylinder = {n.off, n.d, small(60, 11, i)}}}};
}

static sure_case hostile_cone(uint64_t i)
{
    nearly_along n =
        draw_nearly_along((int)(20 + suite_bits(1, i) % 20), (int)(1 + suite_bits(2, i) % 12), i);
    n.off.x += n.last * (double)(suite_bits(9, i) % 3);
    n.off.y += n.last * (double)(suite_bits(10, i) % 3);
    sure_vec3 base = {(double)(suite_bits(16, i) % 5), (double)(suite_bits(17, i) % 7), 1};
    return (sure_case){
        {scaled(0x1p30, n.d), scaled(-1, n.d), 0, INFINITY},
        {SURE_SHAPE_CONE,
         {.cone = {scaled(0x1p30, base), scaled(0x1p30, n.off), 0x1p30 * small(60, 11, i)}}}};
}

/* Are the terms as double-doubles have them less than half of what they are? */
static bool deceives(watch *w)
{
    const sure_case *c = w->asked;
    two_terms_dd nearly = w->of->forms.by_dd(&c->ray, &c->object.as);
    mpz_t sum;
    mpz_init(sum);
    mpz_add(sum, w->truth.inner, w->truth.outer);
    mpfr_set_z_2exp(w->sum, sum, w->truth.degree * UNIT, MPFR_RNDN);
    mpz_clear(sum);
    return mpfr_cmp_d(w->sum, 2 * (nearly.more.head + nearly.less.head)) > 0;
}

START_TEST(test_hostile)
{
    watch w;
    long deceiving = 0;
    watch_init(&w, &subjects[_i]);
    for (uint64_t i = 0; i < HOSTILE; i++) {
        sure_case c = subjects[_i].hostile(i);
        if (!subjects[_i].asks(&c).fits)
            continue;
        watch_case(&w, &c);
        ask(&c, &w);
        judge(&c, &w);
        deceiving += deceives(&w);
    }
    print(&w, sure_shape_name(subjects[_i].shape), "hostile");
    printf("%-8s %ld deceive double-doubles\n", sure_shape_name(subjects[_i].shape), deceiving);
    ck_assert_int_gt(deceiving, subjects[_i].deceiving);
    watch_clear(&w);
}
END_TEST

static double dd_share(watch *w, const sure_case *c)
{
    ask(c, w);
    if (!w->told || w->found.stage != SURE_STAGE_DOUBLE_DOUBLE)
        return 0;
    watch_case(w, c);
    judge(c, w);
    return share_of(w);
}

/* Uphill to the greatest error of what double-doubles tell. */
START_TEST(test_search)
{
    static const regime from[] = {REGIME_GRAZING, REGIME_TYPICAL, REGIME_FAR, REGIME_NEIGHBOUR};
    sure_shape shape = subjects[_i].shape;
    watch w;
    watch_init(&w, &subjects[_i]);
    for (uint64_t climb = 0; climb < CLIMBS; climb++) {
        sure_case best = regime_case(shape, from[climb % 4], SEED, climb);
        double most = dd_share(&w, &best);
        for (uint64_t k = 0; k < STEPS; k++) {
            sure_case next = case_changed(&best, suite_bits(43, climb * STEPS + k), 52);
            double share = subjects[_i].asks(&next).fits ? dd_share(&w, &next) : 0;
            if (share >= most) {
                most = share;
                best = next;
            }
        }
    }
    printf("%-8s searched      error/bound %.4f\n", sure_shape_name(shape), w.worst);
    ck_assert(w.worst > 0x1p-8 && w.worst < 1);
    watch_clear(&w);
}
END_TEST

/* Mantissas of 53 bits. */
static double full(int index, int exponent)
{
    uint64_t bits = suite_bits(9, (uint64_t)index);
    double mantissa = (double)(bits >> 11 | UINT64_C(1) << 52 | 1);
    return ldexp(bits & 1 ? -mantissa : mantissa, exponent - 52);
}

/* A ray whose vertex about the origin is next to x = 1: p = o + d = (0, 0, e), the slope is e d_z.
 * Its low bits are whole where d_y is as large as d_z, not where it is much less. */
static sure_ray nearly_at_one(int index, int e_exponent, int y_exponent)
{
    sure_vec3 d = {full(3 * index, 0), full(3 * index + 1, y_exponent), ldexp(1, -50)};
    double e = full(3 * index + 2, e_exponent);
    return (sure_ray){{-d.x, -d.y, -d.z + e}, d, 1, INFINITY};
}

/* tangent_order is right or does not know, whatever a line's slope is; with few bits it knows. */
START_TEST(test_tangent_order)
{
    const sure_sphere ball = {{0, 0, 0}, 1};
    int known[2] = {0, 0};
    for (int i = 0; i < STEPS; i++) {
        for (int wide = 0; wide < 2; wide++) {
            sure_ray ray = nearly_at_one(i, -80, wide ? -120 : -50);
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
END_TEST

int main(void)
{
    Suite *suite = suite_create("discriminant");
    TCase *tests = tcase_create("discriminant");
    tcase_set_timeout(tests, 120);
    tcase_add_loop_test(tests, test_regimes, 0, SUBJECTS);
    tcase_add_loop_test(tests, test_hostile, 0, SUBJECTS);
    tcase_add_loop_test(tests, test_search, 0, SUBJECTS);
    tcase_add_test(tests, test_tangent_order);
    suite_add_tcase(suite, tests);
    return suite_run(suite);
}
