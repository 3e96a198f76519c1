/* SPDX-License-Identifier: MIT */
/* The shape SUBJECT: hard cases, exact answers and laws in every regime, and a small world in which
 * all tiers have to be right. With a case line in the environment variable SUREHIT_CASE it says
 * instead what truth and tiers answer to it and which law they break, and fails if they break one:
 * the command that a failure prints. */
#include "bisection_result.h"
#include "case_file.h"
#include "every_case.h"
#include "shape_laws.h"
#include "shrink.h"
#include "world.h"

static const sure_shape subject = SUBJECT;

static case_answer truth_of(const sure_case *question)
{
    bisection_result truth;
    bisection_answer(&question->ray, &question->object, &truth);
    return (case_answer){truth.status, truth.field, truth.t, truth.part, truth.normal, 0};
}

/* What a failure says: the case, what truth and the tier make of it, and how to see it again. */
static void fail_with(const sure_case *question, sure_tier tier, const char *what)
{
    char line[CASE_LINE_MAX], right[CASE_LINE_MAX], given[CASE_LINE_MAX];
    case_answer truth = truth_of(question), answer = case_answer_of(question, tier);
    case_print(question, line);
    case_answer_print(&truth, right);
    case_answer_print(&answer, given);
    ck_abort_msg("%s, tier %s\n  case  %s\n  truth %s\n  tier  %s\n"
                 "  again with: SUREHIT_CASE='%s' test_%s",
                 what, sure_tier_name(tier), line, right, given, line, sure_shape_name(subject));
}

/* Is a tier's answer what its promise makes of the right one? */
static bool answer_holds(const hard_case *hard, sure_tier tier)
{
    case_answer answer = case_answer_of(&hard->question, tier);
    if (tier == SURE_TIER_EXACT || hard->right[tier])
        return case_answers_same(&answer, &hard->answer);
    return tier != SURE_TIER_CERTAIN ||
           (answer.status == hard->answer.status && answer.field == hard->answer.field &&
            answer.part == hard->answer.part);
}

static void hard_case_holds(const hard_case *hard)
{
    char right[CASE_LINE_MAX];
    case_answer truth = truth_of(&hard->question);
    case_answer_print(&truth, right);
    ck_assert_msg(case_answers_same(&truth, &hard->answer), "truth is %s in %s", right, hard->text);
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++) {
        if (!answer_holds(hard, tier))
            fail_with(&hard->question, tier, hard->text);
    }
    const sure_case *question = &hard->question;
    sure_stage stage = sure_object_stage(&question->ray, &question->object, SURE_TIER_CERTAIN);
    ck_assert_msg(stage == hard->stage, "%s decides in %s", sure_stage_name(stage), hard->text);
    unsigned long checked = 0;
    const char *law = shape_law_broken(question, SURE_TIER_CERTAIN, &checked);
    if (law)
        fail_with(question, SURE_TIER_CERTAIN, law);
}

TEST(hard)
{
    ck_assert_int_gt(case_file_each(subject, hard_case_holds), 0);
}

static bool breaks_a_law(const sure_case *question, void *context)
{
    unsigned long checked = 0;
    return shape_law_broken(question, *(sure_tier *)context, &checked) != NULL;
}

/* Is exact's whole answer the oracle's, to the bit? */
static bool exact_is_true(const sure_case *question, const bisection_result *truth)
{
    const sure_ray *ray = &question->ray;
    const sure_object *object = &question->object;
    bisection_result exact = {.field = sure_object_check(ray, object)};
    sure_hit hit;
    exact.status = sure_object_hit(ray, object, SURE_TIER_EXACT, &hit);
    exact.interval_status = sure_object_interval(ray, object, SURE_TIER_EXACT, &exact.interval);
    if (exact.status == SURE_HIT) {
        exact.t = hit.t;
        exact.part = hit.part;
        exact.normal = sure_object_normal(ray, object, SURE_TIER_EXACT, &hit);
    }
    return bisection_same(&exact, truth);
}

/* Are the exact answers those of an oracle that shares nothing with them? */
TEST(truth)
{
    enum { CASES = 100 };
    unsigned long cases = 0;
    for (case_walk w = walk_regimes(subject, 2, CASES); walk_next(&w); cases++) {
        bisection_result truth = bisection_of(&w.asked);
        if (!exact_is_true(&w.asked, &truth))
            fail_with(&w.asked, SURE_TIER_EXACT, "not the oracle's answer");
    }
    printf("%s: %lu cases against bisection\n", sure_shape_name(subject), cases);
    ck_assert_uint_gt(cases, 0);
}

/* Cases that only whole numbers decide take milliseconds: some of them are enough. */
static bool too_slow(const sure_case *question, sure_tier tier, uint64_t index)
{
    return tier >= SURE_TIER_CERTAIN && index % 64 != 0 &&
           sure_object_stage(&question->ray, &question->object, tier) == SURE_STAGE_EXACT;
}

TEST(laws)
{
    enum { CASES = 2000 };
    unsigned long checked = 0, cases = 0;
    uint64_t step = suite_setting("SUREHIT_SHARE", 1);
    for (case_walk w = walk_regimes(subject, 1, CASES); walk_next(&w);) {
        for (sure_tier tier = 0; tier < SURE_TIERS && w.index % step == 0; tier++) {
            if (too_slow(&w.asked, tier, w.index))
                continue;
            cases++;
            if (!shape_law_broken(&w.asked, tier, &checked))
                continue;
            sure_case simple = shrink_case(&w.asked, false, breaks_a_law, &tier);
            fail_with(&simple, tier, shape_law_broken(&simple, tier, &checked));
        }
    }
    printf("%s: %lu laws checked on %lu cases\n", sure_shape_name(subject), checked, cases);
    ck_assert_uint_gt(checked, 8 * cases);
}

/* t moved by `ulps` units in the last place of `scale` in the tier's precision. */
static double moved(double t, double scale, int ulps, sure_tier tier)
{
    int bits = tier == SURE_TIER_FLOAT32 ? 24 : 53, exponent;
    (void)frexp(scale, &exponent);
    return t + ldexp(ulps, exponent - bits);
}

/* The largest |t| among the roots that the answer may come from: the chord's ends, and those of the
 * quadratic that an end plane cut off. */
static double largest_root(const sure_case *question, const sure_interval *chord)
{
    static true_line line;
    if (line.bits == 0)
        true_line_init(&line, 400);
    true_line_set(&line, question);
    return fmax(fmax(fabs(chord->t_enter), fabs(chord->t_leave)),
                line.capped ? true_largest_root(&line) : 0);
}

/* Is t* within SURE_ROOT_ULPS of the tier's t, counted at the largest root? */
static bool root_close(const sure_case *question, double t, sure_tier tier,
                       const sure_interval *chord)
{
    double scale = largest_root(question, chord);
    if (!isfinite(scale))
        return bisection_compare(&question->ray, &question->object, t) == 0;
    double low = moved(t, scale, -SURE_ROOT_ULPS, tier);
    double high = moved(t, scale, SURE_ROOT_ULPS, tier);
    return bisection_compare(&question->ray, &question->object, low) >= 0 &&
           bisection_compare(&question->ray, &question->object, high) <= 0;
}

/* Do both chords have the same parts, and ends within SURE_ROOT_ULPS counted at the largest root?
 * */
static bool chord_close(const sure_case *question, const sure_interval *given, sure_tier tier,
                        const sure_interval *chord)
{
    double scale = largest_root(question, chord);
    if (!isfinite(scale))
        return given->t_enter == chord->t_enter && given->t_leave == chord->t_leave;
    double off = moved(0, scale, SURE_ROOT_ULPS, tier);
    return given->enter_part == chord->enter_part && given->leave_part == chord->leave_part &&
           fabs(given->t_enter - chord->t_enter) <= off &&
           fabs(given->t_leave - chord->t_leave) <= off;
}

/* A plain tier's answer in the small world; NULL when it is right. */
static const char *plain_fault(const sure_case *question, sure_tier tier,
                               const bisection_result *truth)
{
    sure_hit hit = {0};
    sure_interval chord;
    sure_status status = sure_object_hit(&question->ray, &question->object, tier, &hit);
    sure_status meets = sure_object_interval(&question->ray, &question->object, tier, &chord);
    if (meets != truth->interval_status)
        return "wrong decision on the interval";
    if (meets == SURE_HIT && !chord_close(question, &chord, tier, &truth->interval))
        return "wrong interval";
    if (status != truth->status)
        return "wrong decision";
    if (status == SURE_HIT && hit.part != truth->part)
        return "wrong part";
    if (status == SURE_HIT && !root_close(question, hit.t, tier, &truth->interval))
        return "t beyond SURE_ROOT_ULPS";
    return NULL;
}

/* Of certain and exact: by law 8 certain is right when exact is. */
static const char *sure_fault(const sure_case *question, const bisection_result *truth)
{
    unsigned long checked = 0;
    if (!exact_is_true(question, truth))
        return "exact is wrong";
    return shape_law_broken(question, SURE_TIER_CERTAIN, &checked);
}

TEST(world)
{
    static const double ranges[][2] = {{0, INFINITY}, {1, 2}, {0, 1}};
    uint64_t count = 3 * world_count(WORLD_EXACT, subject), seen[3] = {0},
             step = suite_setting("SUREHIT_SHARE", 1);
    for (uint64_t i = 0; i < count; i += step) {
        sure_case question = world_case(WORLD_EXACT, subject, i / 3);
        question.ray.t_min = ranges[i % 3][0];
        question.ray.t_max = ranges[i % 3][1];
        bisection_result truth;
        bisection_answer(&question.ray, &question.object, &truth);
        seen[truth.status]++;
        for (sure_tier tier = 0; tier < SURE_TIERS; tier++) {
            const char *fault = tier < SURE_TIER_CERTAIN  ? plain_fault(&question, tier, &truth)
                                : tier == SURE_TIER_EXACT ? sure_fault(&question, &truth)
                                                          : NULL;
            if (fault)
                fail_with(&question, tier, fault);
        }
    }
    printf("%s: world of %llu, %llu hits, %llu misses\n", sure_shape_name(subject),
           (unsigned long long)count, (unsigned long long)seen[SURE_HIT],
           (unsigned long long)seen[SURE_MISS]);
    ck_assert_uint_gt(seen[SURE_HIT], count / step / 20);
    ck_assert_uint_gt(seen[SURE_MISS], count / step / 20);
}

static int answer_one(const char *text)
{
    sure_case question;
    char line[CASE_LINE_MAX];
    int broken = 0;
    if (!case_read(text, &question) || question.object.shape != subject) {
        fprintf(stderr, "SUREHIT_CASE: not a case of %s: %s\n", sure_shape_name(subject), text);
        return 2;
    }
    case_answer truth = truth_of(&question);
    case_answer_print(&truth, line);
    printf("%-10s %s\n", "truth", line);
    for (sure_tier tier = 0; tier < SURE_TIERS; tier++) {
        unsigned long checked = 0;
        case_answer answer = case_answer_of(&question, tier);
        const char *law = shape_law_broken(&question, tier, &checked);
        case_answer_print(&answer, line);
        sure_stage stage = sure_object_stage(&question.ray, &question.object, tier);
        printf("%-10s %s; by %s%s%s\n", sure_tier_name(tier), line, sure_stage_name(stage),
               law ? "; breaks " : "", law ? law : "");
        broken += law != NULL;
    }
    return broken ? 1 : 0;
}

int main(void)
{
    const char *text = getenv("SUREHIT_CASE");
    return text ? answer_one(text) : suite_main(sure_shape_name(subject), NULL, NULL);
}
