/* SPDX-License-Identifier: MIT */
/* What a campaign checks of a case: held against who lies in one thing, every promise that he
 * contradicts is told. */
#include "suite.h"

#include "campaign_check.h"

static campaign_truth liar;
static char told[1024];
static int tellings;

static void listen(const sure_case *question, const char *what)
{
    (void)question;
    tellings++;
    strcat(strcat(told, what), "\n");
}

/* A third is no double: what is said of this t is off by less than an ulp, for next to the axis's
 * direction only exact numbers are certain. */
static const char *const usual = "cylinder 0.25 0x1p-90 9 0x1p-120 0 -3 0 inf 0 0 0 0 0 1 1";

/* What is told of a case, and how often, where all that there is to be checked is. */
static void expect_told(const char *line, const char *what, int times)
{
    const campaign_more all = {true, true, true, true, true, true, 1};
    sure_case question;
    pair_tally sum = {0};
    tellings = 0;
    told[0] = '\0';
    ck_assert(case_read(line, &question));
    campaign_check(&liar, &question, all, listen, &sum);
    ck_assert_msg(tellings == times && (times == 0 || strstr(told, what)), "%s: %d: %s", what,
                  tellings, told);
    ck_assert_uint_eq(sum.broken, (uint64_t)times);
}

static sure_status later(const sure_ray *ray, const sure_object *object, double *t, sure_part *part,
                         sure_vec3 *normal)
{
    sure_status status = truth_by_exact.hit(ray, object, t, part, normal);
    *t = nextafter(*t, INFINITY);
    return status;
}

static sure_status never_met(const sure_ray *ray, const sure_object *object, double *t,
                             sure_part *part, sure_vec3 *normal)
{
    (void)ray, (void)object, (void)t, (void)part, (void)normal;
    return SURE_MISS;
}

static sure_status endless(const sure_ray *ray, const sure_object *object, double *t,
                           sure_part *part, sure_vec3 *normal)
{
    sure_status status = truth_by_exact.hit(ray, object, t, part, normal);
    *t = INFINITY;
    return status;
}

static bool not_within(const sure_ray *ray, const sure_object *object, double t, double error)
{
    (void)ray, (void)object, (void)t, (void)error;
    return false;
}

TEST(the_hit)
{
    liar = truth_by_exact;
    expect_told(usual, "", 0);
    liar.hit = later;
    liar.hit_within = not_within;
    expect_told(usual, "certain: t_error\nexact: t_error\nexact: t\n", 3);
    liar.hit = endless;
    expect_told(usual, "certain: t_error\nexact: t_error\nexact: t\n", 3);
    liar.hit = never_met;
    expect_told(usual,
                "certain: status or part\nexact: status or part\ncertain: occluded\n"
                "exact: occluded\n",
                4);
}

static sure_status entered(const sure_ray *ray, const sure_object *object, sure_interval *ends)
{
    sure_status status = truth_by_exact.interval(ray, object, ends);
    ends->leave_part = ends->enter_part;
    return status;
}

static sure_status left_late(const sure_ray *ray, const sure_object *object, sure_interval *ends)
{
    sure_status status = truth_by_exact.interval(ray, object, ends);
    ends->t_leave *= 2;
    return status;
}

TEST(the_interval)
{
    liar = truth_by_exact;
    liar.interval = entered;
    expect_told(usual,
                "certain: part of the interval's leave\nexact: part of the interval's leave\n", 2);
    liar.interval = left_late;
    expect_told(usual, "certain: t_leave's cap\nexact: t_leave\n", 2);
}

static int outside(const sure_object *object, sure_vec3 point)
{
    (void)object, (void)point;
    return 1;
}

static int inside(const sure_object *object, sure_vec3 point)
{
    return -outside(object, point);
}

/* It says of either origin that it is on that side: of one that is wrong. */
TEST(the_origins)
{
    liar = truth_by_exact;
    liar.where = outside;
    expect_told(usual, "certain: spawn's side\n", 1);
    liar.where = inside;
    expect_told(usual, "certain: spawn's side\n", 1);
}

static void all_parts(const sure_case *question, uint64_t draw, const char *broken[CAMPAIGN_PARTS])
{
    (void)question, (void)draw;
    for (int i = 0; i < CAMPAIGN_PARTS; i++)
        broken[i] = "a part";
}

static const char *a_law(const sure_case *question)
{
    (void)question;
    return "a law";
}

static sure_field no_radius(const sure_ray *ray, const sure_object *object)
{
    (void)ray, (void)object;
    return SURE_FIELD_RADIUS;
}

TEST(what_the_notes_say)
{
    liar = truth_by_exact;
    liar.parts = all_parts;
    expect_told(usual, "certain: a part\n", CAMPAIGN_PARTS);
    liar = truth_by_exact;
    liar.bracket = a_law;
    expect_told(usual, "exact: a law\n", 1);
    liar = truth_by_exact;
    liar.check = no_radius;
    expect_told(usual, "exact: check's field\n", 1);
}

/* What is checked of a case: each share of them is as it is said, and none goes with another. */
TEST(what_is_checked_is_drawn_apart)
{
    enum { CASES = 1 << 16, KINDS = 6 };
    static const int one_in[KINDS] = {4, 16, 16, 16, 16, 64};
    int both[KINDS][KINDS] = {{0}};
    for (uint64_t index = 0; index < CASES; index++) {
        const campaign_more more = campaign_more_of(index);
        const bool is[KINDS] = {more.normal, more.interval, more.occluded,
                                more.spawn,  more.block,    more.parts != 0};
        for (int i = 0; i < KINDS * KINDS; i++)
            both[i / KINDS][i % KINDS] += is[i / KINDS] && is[i % KINDS];
    }
    for (int i = 0; i < KINDS * KINDS; i++) {
        int a = i / KINDS, b = i % KINDS;
        int expected = CASES / one_in[a] / (a == b ? 1 : one_in[b]);
        ck_assert_msg(both[a][b] > expected / 2 && both[a][b] < 2 * expected, "%d, %d: %d", a, b,
                      both[a][b]);
    }
}

SUITE("check")
