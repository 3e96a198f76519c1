/* SPDX-License-Identifier: MIT */
/* The second stage of cylinder and cone, and lines in an end plane (axial_plane.c), held against
 * exact numbers. */
#include "../support/every_case.h"
#include "../support/objects.h"
#include "../support/surroundings.h"
#include "filters.h"

#include "../../src/numbers/valid.h"
#include "../../src/shapes/capped/capped_stages.h"
#include "../../src/stages/rows.h"

enum { BITS = 4000, CASES = 400, RIMS = 12000, SEED = 24, PLANES = 10000 };

static const sure_shape shapes[] = {SURE_SHAPE_CYLINDER, SURE_SHAPE_CONE};

typedef struct {
    filter_verdict verdict;
    filter_interval found;
    sure_stage stage;
} refined;

static refined refine(const sure_case *c, bool both_ends)
{
    refined r = {.stage = SURE_STAGE_DOUBLE};
    r.verdict = row_of(&c->object)->refine(&c->ray, &c->object.as, both_ends, &r.found, &r.stage);
    return r;
}

/* Out of the compiler's sight. */
static refined (*volatile refining)(const sure_case *, bool) = refine;

static refined refine_in(bool flushed, const sure_case *c, bool both_ends)
{
    surroundings_set(flushed ? SURROUNDINGS_MODES : 0);
    refined r = refining(c, both_ends);
    surroundings_set(0);
    return r;
}

static true_line line; /* the true one */

static void set_up(void)
{
    true_line_init(&line, BITS);
}

static void tear_down(void)
{
    true_line_clear(&line);
}

typedef struct {
    axial_plane plane; /* that the line is in */
    double worst;
    long asked, told, after; /* after: where doubles are uncertain, which of these are told */
    long doubtful, points[END_ENDLESS], first, starts;
} watch;

/* starts, in: of the planes through `from` and `to`. */
typedef struct {
    axial_plane said, truth;
    bool starts[2], in[2];
    sure_vec3 from, to;
} plane_watch;

static axial_plane plane_of_line(void)
{
    bool level = mpfr_zero_p(line.slope);
    return level && mpfr_zero_p(line.level)                      ? AXIAL_PLANE_FROM
           : level && mpfr_equal_p(line.level, line.height) != 0 ? AXIAL_PLANE_TO
                                                                 : AXIAL_PLANE_UNKNOWN;
}

static void set_true_plane(const sure_case *c, plane_watch *w)
{
    true_line_set(&line, c);
    w->truth = plane_of_line();
    w->in[0] = mpfr_zero_p(line.level) != 0;
    w->in[1] = mpfr_equal_p(line.level, line.height) != 0;
}

/* Of a cap; the plane through a cone's apex is none. */
static axial_plane cap_of_line(void)
{
    axial_plane plane = plane_of_line();
    return line.tapers && plane == AXIAL_PLANE_FROM ? AXIAL_PLANE_UNKNOWN : plane;
}

static double judge_end(watch *w, const sure_case *c, int which, const filter_end *end)
{
    end_kind at = end_kind_of(line.at[which]), said = end->end.at;
    bool apex = line.tapers && at == END_TOP;
    bool tangent = mpfr_equal_p(line.t[0], line.t[1]) || apex;
    double share = share_of_error(line.t[which], end->t, end->error);
    case_require(c, share <= 1, "beyond the error");
    case_require(c, said == (said == END_TANGENT && tangent ? END_TANGENT : at), "another point");
    case_require(c, end->end.part == true_part(&line, line.t[which]), "another part");
    w->points[said]++;
    w->worst = fmax(w->worst, share);
    return share;
}

/* Which end of the true chord is the first in the range? 2: neither, the ray starts within the
 * boundary; -1: the range has none. */
static int first_end(const watch *w, const sure_case *c)
{
    const sure_ray *ray = &c->ray;
    for (int i = 0; i < 2; i++) {
        int after = mpfr_cmp_d(line.t[i], ray->t_min);
        if (i == 1 && after > 0 && w->plane != AXIAL_PLANE_UNKNOWN)
            return 2;
        if (after >= 0)
            return mpfr_cmp_d(line.t[i], ray->t_max) <= 0 ? i : -1;
    }
    return -1;
}

/* The same asked for the first hit alone, which may be told though the other end is not. */
static void judge_first(watch *w, const sure_case *c, bool flushed, bool meets)
{
    refined r = refine_in(flushed, c, false);
    filter_end first;
    const sure_cone *cone = &c->object.as.cone;
    bool at_apex =
        line.tapers && is_zero_bits(c->ray.t_min) && same_point(c->ray.origin, cone->apex);
    case_require(c, !at_apex || r.verdict == FILTER_INTERVAL, "a start at the apex");
    case_require(c, r.verdict != FILTER_MISS || !meets, "no miss");
    if (r.verdict != FILTER_INTERVAL)
        return;
    filter_verdict verdict = filter_first_known(&r.found, &c->ray, &first);
    if (at_apex) {
        case_require(c, verdict == FILTER_INTERVAL && filter_at_start(&first), "not the apex");
        case_require(c, first.end.at == END_TANGENT && first.end.part == SURE_PART_WALL,
                     "its name");
        return;
    }
    case_require(c, meets, "no hit");
    int truth = first_end(w, c);
    case_require(c, verdict != FILTER_MISS || truth < 0, "no miss of the range");
    case_require(c, verdict != FILTER_INTERVAL || truth >= 0, "no hit in the range");
    if (verdict != FILTER_INTERVAL)
        return;
    w->first++;
    w->starts += truth == 2;
    case_require(c, (first.end.at == END_START) == (truth == 2), "a start or not");
    if (truth < 2)
        judge_end(w, c, truth, &first);
    else
        case_require(c, filter_at_start(&first) && first.end.part == line.part[2], "another start");
}

static void judge_stage(const sure_case *c, const watch *w, const refined *r)
{
    bool by_mod128 = w->plane != AXIAL_PLANE_UNKNOWN || r->found.enter.end.at == END_TANGENT ||
                     filter_at_start(&r->found.enter) || filter_at_start(&r->found.leave);
    case_require(
        c, r->stage == SURE_STAGE_MOD128 || (r->stage == SURE_STAGE_DOUBLE_DOUBLE && !by_mod128),
        "stage");
}

/* The greater share of both ends, 0 where there is no chord. */
static double judge(watch *w, const sure_case *c, bool flushed)
{
    if (!case_is_valid(c) || !filter_fits(c))
        return 0;
    refined r = refine_in(flushed, c, true);
    filter_interval unused;
    filter_verdict before = row_of(&c->object)->filter(&c->ray, &c->object.as, &unused);
    bool doubtful = before == FILTER_UNCERTAIN;
    w->asked++;
    w->told += r.verdict != FILTER_UNCERTAIN;
    w->doubtful += doubtful;
    w->after += doubtful && r.verdict != FILTER_UNCERTAIN;
    true_line_set(&line, c);
    bool meets = line.exists;
    w->plane = cap_of_line();
    judge_first(w, c, flushed, meets);
    if (r.verdict == FILTER_UNCERTAIN)
        return 0;
    case_require(c, meets == (r.verdict == FILTER_INTERVAL), meets ? "no miss" : "no interval");
    if (!meets)
        return 0;
    judge_stage(c, w, &r);
    double enter = judge_end(w, c, 0, &r.found.enter);
    return fmax(enter, judge_end(w, c, 1, &r.found.leave));
}

static void finish(watch *w, sure_shape shape, const char *of)
{
    if (w->asked > 0)
        printf("%-8s %-13s error/bound %.3f  told %.1f %%, of what doubles leave %ld of %ld\n",
               sure_shape_name(shape), of, w->worst, 100. * (double)w->told / (double)w->asked,
               w->after, w->doubtful);
}

/* Was there anything to judge, and is nearly all of it told? */
static void require_told(const watch *w, long least)
{
    ck_assert_int_ge(w->asked, least);
    ck_assert_int_gt(w->doubtful, 0);
    ck_assert(10 * w->told > 9 * w->asked && 4 * w->after > 3 * w->doubtful);
}

LOOP_TEST(test_regimes, 2)
{
    sure_shape shape = shapes[_i];
    for (int r = 0; r < REGIMES; r++) {
        if (!regime_applies(shape, (regime)r))
            continue;
        watch w = {.worst = 0};
        for (uint64_t i = 0; i < 2 * CASES; i++) {
            sure_case c = regime_case(shape, (regime)r, SEED, i / 2);
            judge(&w, &c, i % 2 != 0);
        }
        finish(&w, shape, regime_name((regime)r));
        ck_assert((regime)r != REGIME_TYPICAL || w.told == w.asked);
    }
}

/* Through a rim, or past it by some ulps: a wall's end and a plane's next to each other. */
LOOP_TEST(test_rims, 2)
{
    watch w = {.worst = 0};
    for (uint64_t i = 0; i < RIMS; i++) {
        sure_case c = regime_case(shapes[_i], i % 2 ? REGIME_RIM : REGIME_NEIGHBOUR, SEED, i / 6);
        c = case_changed(&c, suite_bits(40, i), 6);
        judge(&w, &c, i % 4 == 0);
    }
    finish(&w, shapes[_i], "rims, by ulps");
    ck_assert(w.doubtful > RIMS / 8 && 4 * w.after > 3 * w.doubtful);
    for (int at = END_LESS; at <= END_BASE; at++)
        ck_assert_int_gt(w.points[at], 0);
}

/* The ray from next to where it enters: t is so small that its rounding hides no other error. */
static sure_case from_there(const sure_case *c)
{
    sure_case next = *c;
    for (int i = 0; i < 2 && filter_fits(&next); i++) {
        refined r = refine(&next, true);
        double t = r.verdict == FILTER_INTERVAL ? r.found.enter.t : 0;
        next.ray.origin = vector_sum(1, next.ray.origin, t, next.ray.direction);
    }
    return next;
}

LOOP_TEST(test_from_there, 2)
{
    static const regime from[] = {REGIME_GRAZING, REGIME_NEIGHBOUR, REGIME_FAR, REGIME_COIN};
    watch w = {.worst = 0};
    for (uint64_t i = 0; i < RIMS; i++) {
        sure_case c = regime_case(shapes[_i], from[i % 4], SEED, i / 4);
        c = from_there(&c);
        c = i % 3 == 0 ? case_changed(&c, suite_bits(44, i), 30) : c;
        judge(&w, &c, false);
    }
    finish(&w, shapes[_i], "from there");
    require_told(&w, RIMS / 4);
}

static sure_case start(const sure_case *from, int climb)
{
    return climb % 2 ? from_there(from) : *from;
}

static double share_of_ends(const sure_case *c, int surroundings, void *context)
{
    (void)surroundings;
    return judge(context, c, false);
}

/* Uphill to the greatest error. */
LOOP_TEST(test_search, 2)
{
    static const regime from[] = {REGIME_GRAZING, REGIME_RIM, REGIME_FAR, REGIME_COIN};
    const climbing how = {from, 4, 40, 1000, start};
    watch w = {.worst = 0};
    climb(shapes[_i], &how, share_of_ends, &w);
    finish(&w, shapes[_i], "searched");
    require_told(&w, 20000);
}

/* Is an end of that kind near the start told to be there? Whether it enters or leaves is drawn. */
static bool starts_at(const sure_case *c, const plane_watch *w, const axial_terms *of, end_kind at)
{
    const filter_end near = {0x1p-60, 0x1p-50, {at, SURE_PART_BASE}};
    const filter_end far = {0x1p-20, 0x1p-50, {END_MORE, SURE_PART_WALL}};
    filter_interval found = {near, far};
    filter_end *end = &found.enter;
    if (c->ray.origin.x < c->ray.origin.y) {
        found = (filter_interval){far, near};
        end = &found.leave;
    }
    bool said = axial_starts(&c->ray, w->from, w->to, of, END_BASE, END_TOP, &found);
    case_require(c, filter_at_start(end) == said, "the end's t");
    return said;
}

static void ask_plane(const sure_case *c, void *context)
{
    plane_watch *w = context;
    axial_terms of = {.axis = vector_between_f64(NULL, w->from, w->to),
                      .m = vector_between_f64(NULL, w->from, c->ray.origin),
                      .d = vector_of_f64(NULL, c->ray.direction)};
    of.height = vector_dot_f64(NULL, of.axis, of.axis);
    of.d_d = vector_dot_f64(NULL, of.d, of.d);
    of.size = vector_dot_f64(NULL, of.m, of.m) + of.height + 1;
    w->said = axial_plane_of(&c->ray, w->from, w->to, &of);
    w->starts[0] = starts_at(c, w, &of, END_BASE);
    w->starts[1] = starts_at(c, w, &of, END_TOP);
    case_require(c, !starts_at(c, w, &of, END_LESS), "no plane");
}

static void judge_plane(const sure_case *c, void *context)
{
    const plane_watch *w = context;
    case_require(c, w->said == w->truth, "another plane");
    case_require(c, w->starts[0] == w->in[0] && w->starts[1] == w->in[1], "another start");
}

static void judge_unknown(const sure_case *c, void *context)
{
    const plane_watch *w = context;
    case_require(c, w->said == AXIAL_PLANE_UNKNOWN || w->said == w->truth, "a plane");
    case_require(c, w->starts[0] <= w->in[0] && w->starts[1] <= w->in[1], "a start");
}

/* In an end plane by integers of some size, and then one number an ulp off. */
TEST(test_planes)
{
    long planes[3] = {0, 0, 0}, off = 0;
    for (uint64_t i = 0; i < PLANES; i++) {
        int most = 1 << (1 + i % 16);
        sure_vec3 axis = suite_integers(50, i, most), other = suite_integers(53, i, most);
        plane_watch w = {.from = suite_integers(56, i, most)};
        sure_case c = {.ray = {.direction = cross(axis, other), .t_max = INFINITY},
                       .object = {.shape = SURE_SHAPE_CYLINDER}};
        w.to = vector_sum(1, w.from, 1, axis);
        c.ray.origin =
            vector_sum(1, i % 2 ? w.from : w.to, suite_integer(59, i, 9), c.ray.direction);
        c.ray.origin =
            vector_sum(1, c.ray.origin, suite_integer(60, i, 1), cross(axis, c.ray.direction));
        c.object.as.cylinder = (sure_cylinder){w.from, w.to, 1};
        if (!case_is_valid(&c))
            continue;
        set_true_plane(&c, &w);
        ck_assert(w.truth != AXIAL_PLANE_UNKNOWN);
        in_each_environment(&c, ask_plane, judge_plane, &w);
        planes[w.truth]++;
        sure_case next = case_changed(&c, suite_bits(61, i), 2);
        w.from = next.object.as.cylinder.base;
        w.to = next.object.as.cylinder.top;
        if (!case_is_valid(&next))
            continue;
        set_true_plane(&next, &w);
        in_each_environment(&next, ask_plane, judge_unknown, &w);
        off += w.truth == AXIAL_PLANE_UNKNOWN;
    }
    printf("in planes: %ld of the first end, %ld of the other, %ld beside\n",
           planes[AXIAL_PLANE_FROM], planes[AXIAL_PLANE_TO], off);
    ck_assert_int_gt(planes[AXIAL_PLANE_FROM], PLANES / 4);
    ck_assert_int_gt(planes[AXIAL_PLANE_TO], PLANES / 4);
    ck_assert_int_gt(off, PLANES / 4);
}

SUITE_IN("refine", set_up, tear_down)
