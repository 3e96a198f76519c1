/* The first two stages of plane and disc, held against numbers wide enough to be exact: the first
 * hit itself, not the chord alone. */
#include "../../src/stages/rows.h"
#include "../support/objects.h"
#include "planar_suite.h"

/* What was answered. */
typedef struct {
    true_line truth;
    mpfr_t t;
    filter_verdict filter, close[2]; /* by t_wanted */
    filter_end first;
    sure_hit hits[2];
    long all, close_asked, close_answers;
    double worst;
} answers;

static void ask(const sure_case *c, void *context)
{
    answers *of = context;
    const shape_row *row = row_of(&c->object);
    filter_interval found;
    of->filter = row->filter(&c->ray, &c->object.as, &found);
    if (of->filter == FILTER_INTERVAL)
        of->filter = filter_first(&found, &c->ray, &of->first);
    of->close[0] = of->close[1] = FILTER_UNCERTAIN;
    for (int wanted = 0; wanted < 2 && environment_is_nearest(); wanted++)
        of->close[wanted] =
            row->refine_hit(&c->ray, &c->object.as, (t_wanted)wanted, &of->hits[wanted]);
}

static void judge_certain(answers *of, const sure_case *c)
{
    const sure_hit *hit = &of->hits[T_CERTAIN];
    double share = share_of_error(of->t, hit->t, hit->t_error);
    of->worst = fmax(of->worst, share);
    case_require(c, share <= 1, "beyond the bound");
    case_require(c, hit->t >= c->ray.t_min && hit->t <= c->ray.t_max, "beyond the range");
}

static void judge_exact(answers *of, const sure_case *c)
{
    const sure_hit *hit = &of->hits[T_EXACT];
    double rounded = mpfr_get_d(of->t, MPFR_RNDN);
    case_require(c, hit->t == rounded && signbit(hit->t) == 0, "wrongly rounded");
    case_require(c, hit->t_error == 0 || hit->t_error == half_ulp(hit->t), "half ulp");
}

static void judge(const sure_case *c, void *context)
{
    answers *of = context;
    true_line_set(&of->truth, c);
    bool hits = true_first(&of->truth, of->t);
    of->all++;
    case_require(c, of->filter != FILTER_MISS || !hits, "the filter: no miss");
    case_require(c, of->filter != FILTER_INTERVAL || hits, "the filter: no hit");
    for (int wanted = 0; wanted < 2; wanted++) {
        case_require(c, of->close[wanted] != FILTER_MISS || !hits, "closely: no miss");
        case_require(c, of->close[wanted] != FILTER_INTERVAL || hits, "closely: no hit");
    }
    of->close_asked += of->filter == FILTER_UNCERTAIN;
    of->close_answers += of->filter == FILTER_UNCERTAIN && of->close[0] != FILTER_UNCERTAIN;
    if (of->close[T_CERTAIN] == FILTER_INTERVAL)
        judge_certain(of, c);
    if (of->close[T_EXACT] == FILTER_INTERVAL)
        judge_exact(of, c);
}

typedef void each_case(sure_shape shape, case_compute *what, case_compute *judge, void *context);

/* Of what the filter leaves at least one in `share` of all cases is answered. */
static void run(sure_shape shape, each_case *each, const char *what, long share)
{
    answers of = {.all = 0};
    if (!shape_rows[shape]->refine_hit)
        return;
    true_line_init(&of.truth, PLANAR_BITS);
    mpfr_init2(of.t, PLANAR_BITS);
    each(shape, ask, judge, &of);
    true_line_clear(&of.truth);
    mpfr_clear(of.t);
    printf("%-8s %-13s error/bound %.3f  of %ld left by the filter %ld answered\n",
           sure_shape_name(shape), what, of.worst, of.close_asked, of.close_answers);
    fflush(stdout);
    ck_assert_int_gt(of.close_answers, of.all / share);
}

LOOP_TEST(test_regimes, SURE_SHAPES)
{
    run((sure_shape)_i, in_each_regime, "closely", 10);
}

/* Crossings at about t_min and about the rim, to within roundings. */
LOOP_TEST(test_near, SURE_SHAPES)
{
    run((sure_shape)_i, planar_each_near, "near", 20);
}

static double whole(uint64_t stream, uint64_t i, int bits)
{
    return floor(suite_double(stream, i, 0) * power_of_two(bits));
}

/* v.(v x u) = 0, in whole numbers of up to 52 and 104 digits; with one component off by one it is
 * not. */
TEST(test_vanishing)
{
    enum { DRAWN = 20000 };
    int vanish = 0;
    for (uint64_t i = 0; i < DRAWN; i++) {
        sure_vec3 v = {whole(1, i, 26), whole(2, i, 26), whole(3, i, 26)};
        sure_vec3 u = {whole(4, i, 24), whole(5, i, 24), whole(6, i, 24)};
        sure_vec3 w = cross(v, u);
        double far = power_of_two((int)(suite_bits(7, i) % 26));
        v = times(far, v);
        vector_dd across = vector_of_dd(NULL, w);
        vanish += dot_vanishes(&v, &across);
        across.x.head += v.x != 0;
        across.y.head += v.x == 0;
        ck_assert(!dot_vanishes(&v, &across) || (v.x == 0 && v.y == 0));
        across = vector_of_dd(NULL, w);
        across.z.tail = 0x1p-40;
        ck_assert(!dot_vanishes(&v, &across));
    }
    ck_assert_int_eq(vanish, DRAWN);
}

/* Heads that cancel and tails that do not, and the other way round. */
TEST(test_left_out)
{
    const struct {
        double heads[4], tails[4];
        bool zero;
    } sums[] = {{{0x1p60, 1, -0x1p60, 0}, {0, 0, 0, 0}, false},
                {{0x1p60, 1, -0x1p60, -1}, {0, 0, 0, 0}, true},
                {{0, 0, 0, 0}, {0x1p60, 0x1p-60, -0x1p60, 0}, false},
                {{0, 0, 0, 0}, {0x1p60, -0x1p60, 0x1p60, 0x1p-60}, false},
                {{-0x1p60, 0, 0, 0}, {0x1p60, 0, 0x1p-60, 0}, false},
                {{0x1p60, 1, -0x1p60, -1}, {0, 0x1p-9, 0, 0}, false},
                {{1, 0x1p-60, -1, 0}, {-0x1p-60, 0, 0, 0}, true}};
    for (int i = 0; i < 7; i++)
        ck_assert_int_eq(sum_vanishes(sums[i].heads, sums[i].tails), sums[i].zero);
}

SUITE("planar")
