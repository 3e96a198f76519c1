/* SPDX-License-Identifier: MIT */
/* The judge's parts, each by itself; the whole is in test_judge.py. */
#include "candidate_callback.h"
#include "exchange.h"
#include "pipe.h"
#include "judging.h"
#include "promise.h"
#include "reply.h"
#include "suite.h"
#include "tally.h"
#include "vectors.h"

#include <signal.h>
#include <string.h>
#include <sys/wait.h>

static const double nan_value = NAN;

/* Confidence. */

/* Wilson's interval by its definition: at its ends the counted share is just 1.96 deviations off.
 * Computed in long double, whose own rounding is far below a double's. */
static void expect_deviation(long double share, uint64_t counted, uint64_t sample)
{
    const long double deviations = 1.959963984540054L;
    long double n = (long double)sample, off = fabsl((long double)counted / n - share);
    long double wide = deviations * sqrtl(share * (1 - share) / n);
    ck_assert_msg(fabsl(off - wide) <= 0x1p-45L, "%llu of %llu: %Lg, %Lg",
                  (unsigned long long)counted, (unsigned long long)sample, off, wide);
}

TEST(test_confidence)
{
    static const uint64_t pairs[][2] = {{1, 2}, {10, 100}, {1, 1000000}, {999, 1000}, {5, 17}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        confidence c = confidence_of(pairs[i][0], pairs[i][1]);
        ck_assert_double_lt(c.lower, (double)pairs[i][0] / (double)pairs[i][1]);
        ck_assert_double_gt(c.upper, (double)pairs[i][0] / (double)pairs[i][1]);
        expect_deviation(c.lower, pairs[i][0], pairs[i][1]);
        expect_deviation(c.upper, pairs[i][0], pairs[i][1]);
    }
    confidence none = confidence_of(0, 100), all = confidence_of(100, 100);
    ck_assert(none.lower == 0 && none.upper > 0.0369 && none.upper < 0.0371);
    ck_assert(all.upper == 1 && all.lower > 0.9629 && all.lower < 0.9631);
    confidence nothing = confidence_of(0, 0);
    ck_assert(nothing.lower == 0 && nothing.upper == 1);
}

/* Histogram. */

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

TEST(test_histogram)
{
    enum { COUNT = 1000 };
    static histogram all, none;
    static double sizes[COUNT];
    static const double shares[] = {0.001, 0.25, 0.5, 0.99, 0.9999, 1};
    for (int i = 0; i < COUNT; i++) {
        sizes[i] = i % 5 == 0 ? 0 : fabs(suite_double(1, (uint64_t)i, 40));
        histogram_add(&all, sizes[i]);
    }
    qsort(sizes, COUNT, sizeof *sizes, by_value);
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        double least = sizes[(int)ceil(shares[i] * COUNT) - 1];
        double told = histogram_quantile(&all, shares[i]);
        ck_assert_msg(told >= least && told <= least * (1 + 1 / 32.0), "%g: %a, not %a", shares[i],
                      told, least);
    }
    ck_double_same(histogram_quantile(&all, 0.2), 0);
    ck_double_same(histogram_quantile(&all, 1), sizes[COUNT - 1]);
    histogram_add(&all, nan_value);
    ck_double_same(histogram_quantile(&all, 1), INFINITY);
    ck_double_same(histogram_quantile(&none, 0.5), 0);
}

/* Sizes of errors. */

TEST(test_ulps)
{
    const double one_down = nextafter(1, 0), half_float = 1 + 0x1p-24;
    ck_double_same(error_ulps(1, 1, PRECISION_DOUBLE), 0);
    ck_double_same(error_ulps(one_down, 1, PRECISION_DOUBLE), 1);
    ck_double_same(error_ulps(-0.0, 0, PRECISION_DOUBLE), 0);
    ck_double_same(error_ulps(-0x1p-1074, 0x1p-1074, PRECISION_DOUBLE), 2);
    ck_double_same(error_ulps(INFINITY, DBL_MAX, PRECISION_DOUBLE), 1);
    ck_double_same(error_ulps(nan_value, 1, PRECISION_DOUBLE), INFINITY);
    ck_double_same(error_ulps(-1, 1, PRECISION_DOUBLE), 2.0 * 0x3ff0000000000000);
    ck_double_same(error_ulps(1 + 0x1p-23, 1, PRECISION_FLOAT), 1);
    ck_double_same(error_ulps(1, one_down, PRECISION_FLOAT), 0);
    /* Halfway: both neighbours are right, as far as is known; a double farther only one. */
    ck_double_same(error_ulps(1, half_float, PRECISION_FLOAT), 0);
    ck_double_same(error_ulps(1 + 0x1p-23, half_float, PRECISION_FLOAT), 0);
    ck_double_same(error_ulps(1, nextafter(half_float, 2), PRECISION_FLOAT), 1);
    ck_double_same(error_ulps(1 + 0x1p-22, half_float, PRECISION_FLOAT), 1);
    ck_double_same(error_ulps(INFINITY, 1e300, PRECISION_FLOAT), 0);
    ck_double_same(error_relative(3, 2), 0.5);
    ck_double_same(error_relative(1, 0), INFINITY);
    ck_double_same(error_relative(0, 0), 0);
    ck_double_same(error_relative(INFINITY, INFINITY), 0);
}

TEST(test_normal_errors)
{
    const sure_vec3 up = {0, 0, 1}, off = {0x1p-30, -0x1p-31, 1}, lost = {0, nan_value, 1};
    ck_double_same(error_normal(up, up), 0);
    ck_double_same(error_normal(off, up), 0x1p-30);
    ck_double_same(error_normal(lost, up), INFINITY);
    ck_double_same(error_normal_ulps(0x1p-52, PRECISION_DOUBLE), 1);
    ck_double_same(error_normal_ulps(0x1p-23, PRECISION_FLOAT), 1);
    ck_assert(error_normal_none(up, up, PRECISION_DOUBLE));
    ck_assert(!error_normal_none(off, up, PRECISION_DOUBLE));
    const sure_vec3 fine = {0.1, 0.2, 0.3}, coarse = {0.1f, 0.2f, 0.3f};
    ck_assert(!error_normal_none(coarse, fine, PRECISION_DOUBLE));
    ck_assert(error_normal_none(coarse, fine, PRECISION_FLOAT));
}

/* Replies. */

TEST(test_replies_read)
{
    static const struct {
        const char *line;
        sure_status status;
        int part;
        bool normal;
        sure_field field;
    } lines[] = {
        {"miss", SURE_MISS, REPLY_NO_PART, false, SURE_FIELD_NONE},
        {"miss\n", SURE_MISS, REPLY_NO_PART, false, SURE_FIELD_NONE},
        {"hit 0x1p+1", SURE_HIT, REPLY_NO_PART, false, SURE_FIELD_NONE},
        {"hit 2\r\n", SURE_HIT, REPLY_NO_PART, false, SURE_FIELD_NONE},
        {"hit 2 wall", SURE_HIT, SURE_PART_WALL, false, SURE_FIELD_NONE},
        {"hit 2 top 0 0 1", SURE_HIT, SURE_PART_TOP, true, SURE_FIELD_NONE},
        {"hit 2  - 0 0 1", SURE_HIT, REPLY_NO_PART, true, SURE_FIELD_NONE},
        {"invalid", SURE_INVALID, REPLY_NO_PART, false, SURE_FIELD_NONE},
        {"invalid line", SURE_INVALID, REPLY_NO_PART, false, SURE_FIELD_NONE},
        {" \tmiss  \r\n", SURE_MISS, REPLY_NO_PART, false, SURE_FIELD_NONE},
        {"hit\t2  wall\r", SURE_HIT, SURE_PART_WALL, false, SURE_FIELD_NONE},
        {"invalid t_max\n", SURE_INVALID, REPLY_NO_PART, false, SURE_FIELD_T_MAX},
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        reply given = reply_read(lines[i].line);
        ck_assert_msg(given.kind == REPLY_ANSWERED && given.status == lines[i].status &&
                          given.part == lines[i].part && given.has_normal == lines[i].normal &&
                          given.field == lines[i].field && !given.touched && !given.changed,
                      "%s", lines[i].line);
        if (given.status == SURE_HIT)
            ck_double_same(given.t, 2);
    }
}

TEST(test_intervals_read)
{
    static const char *const whole[] = {"interval 0x1p+0 inf", " interval\t1  inf \r\n"};
    static const char *const garbage[] = {"",
                                          "interval",
                                          "interval 1",
                                          "hit 1",
                                          "hit 1 wall 0 0 1",
                                          "interval 1 2 wall",
                                          "interval 1 2 3"};
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++) {
        reply given = reply_read_interval(whole[i]);
        ck_assert_msg(given.kind == REPLY_ANSWERED && given.status == SURE_HIT &&
                          given.part == REPLY_NO_PART && !given.has_normal && given.t == 1 &&
                          given.t_leave == INFINITY,
                      "%s", whole[i]);
        ck_assert_int_eq(reply_read(whole[i]).kind, REPLY_GARBAGE); /* of who is asked hits */
    }
    for (size_t i = 0; i < sizeof garbage / sizeof *garbage; i++)
        ck_assert_msg(reply_read_interval(garbage[i]).kind == REPLY_GARBAGE, "'%s'", garbage[i]);
    ck_assert_int_eq(reply_read_interval("miss").status, SURE_MISS);
    ck_assert_int_eq(reply_read_interval("invalid apex\n").field, SURE_FIELD_APEX);
}

TEST(test_garbage)
{
    static const char *const lines[] = {
        "",
        "\n",
        "hit",
        "hit ",
        "hit x",
        "hit 2 rim",
        "hit 2 top 0 0",
        "hit 2 0 0 1",
        "hit 2 top 0 0 1 0",
        "Miss",
        "miss 1",
        "miss\nmiss",
        "invalid none",
        "invalid hit",
        "hit 2 surface 0 0 0 0 0 0",
        "hit 2 -",
        "hit 2 - 0 0",
        "hit 2 - 0 0 1 0",
        "hit - 0 0 1",
        "hit 2 part 77",
        "miss - 0 0 1",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        ck_assert_msg(reply_read(lines[i]).kind == REPLY_GARBAGE, "'%s'", lines[i]);
    char longest[2 * CASE_LINE_MAX], said[CASE_LINE_MAX];
    memset(longest, '\033', sizeof longest);
    memcpy(longest, "hit", 3);
    longest[sizeof longest - 1] = '\0';
    reply given = reply_read(longest);
    reply_print(&given, said);
    ck_assert_int_eq(given.kind, REPLY_GARBAGE);
    ck_assert_int_eq(strncmp(said, "garbage: 'hit????", 17), 0);
}

TEST(test_replies_printed)
{
    static const char *const lines[] = {"miss",
                                        "hit 0x1p+1",
                                        "hit 0x1p+1 wall",
                                        "invalid",
                                        "hit 0x1p+1 base 0x0p+0 -0x0p+0 0x1p+0",
                                        "hit 0x1p+1 - 0x0p+0 -0x0p+0 0x1p+0",
                                        "invalid apex"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char text[CASE_LINE_MAX];
        reply given = reply_read(lines[i]);
        reply_print(&given, text);
        ck_assert_str_eq(text, lines[i]);
    }
}

/* To other questions than hits, and of processes that ended. */
TEST(test_other_replies_printed)
{
    static const struct {
        reply given;
        const char *text;
    } rows[] = {
        {{.to = QUERY_OCCLUDED, .status = SURE_HIT}, "hit"},
        {{.to = QUERY_OCCLUDED, .status = SURE_MISS}, "miss"},
        {{.to = QUERY_INSIDE, .status = SURE_HIT}, "inside"},
        {{.to = QUERY_INSIDE, .status = SURE_MISS}, "outside"},
        {{.to = QUERY_INTERVAL, .status = SURE_MISS}, "miss"},
        {{.to = QUERY_INTERVAL, .status = SURE_HIT, .t = 1, .t_leave = 2},
         "interval 0x1p+0 0x1p+1"},
        {{.to = QUERY_INSIDE, .status = SURE_INVALID, .field = SURE_FIELD_D}, "invalid d"},
        {{.kind = REPLY_CRASHED, .ended = 3 << 8}, "crash: exit status 3"},
        {{.kind = REPLY_CRASHED, .ended = SIGKILL}, "crash: signal 9, Killed"},
        {{.kind = REPLY_HUNG}, "no answer in time"},
        {{.kind = REPLY_LOST}, "no answer, or more than one"},
        {{.kind = REPLY_UNASKED}, "not asked"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[CASE_LINE_MAX];
        reply_print(&rows[i].given, text);
        ck_assert_str_eq(text, rows[i].text);
    }
}

TEST(test_parts_that_there_are_none_of)
{
    reply given = reply_read("hit 2 top 0 0 1");
    char text[CASE_LINE_MAX];
    given.part = 77;
    reply_print(&given, text);
    ck_assert_str_eq(text, "hit 0x1p+1 part 77 0x0p+0 0x0p+0 0x1p+0");
    ck_assert_int_eq(reply_read(text).kind, REPLY_GARBAGE);
}

TEST(test_same_replies)
{
    reply hit = reply_read("hit 2 top 0 0 1"), other = hit;
    ck_assert(reply_same(&hit, &other));
    other.t = nextafter(2, 3);
    ck_assert(!reply_same(&hit, &other));
    other = hit;
    other.normal.x = -0.0;
    ck_assert(!reply_same(&hit, &other));
    other = reply_read("hit 2 top");
    ck_assert(!reply_same(&hit, &other));
    other = reply_read("miss");
    ck_assert(!reply_same(&hit, &other));
    reply miss = other;
    miss.t = 1; /* nothing of a miss */
    ck_assert(reply_same(&miss, &other));
    hit = reply_read_interval("interval 1 2"), other = reply_read_interval("interval 1 3");
    ck_assert(!reply_same(&hit, &other));
}

/* Faults. */

static unsigned faults_of_lines(const char *question, const char *truly, const char *given)
{
    sure_case asked;
    case_answer right;
    ck_assert(case_read(question, &asked) && case_answer_read(truly, &right));
    reply said = reply_read(given);
    return faults_of(&asked, &right, &said);
}

TEST(test_faults)
{
    static const char *const line = "cylinder 0 0 9 0 0 -1 1 10 0 0 0 0 0 1 1";
    static const struct {
        const char *truth, *given;
        unsigned faults;
    } answers[] = {
        {"hit 8 top 0 0 1", "hit 8 top 0 0 1", 0},
        {"hit 8 top 0 0 1", "hit 8", 0},
        {"hit 8 top 0 0 1", "hit 7 top 1 0 0", 0},
        {"hit 8 top 0 0 1", "hit 1", 0},
        {"hit 8 top 0 0 1", "hit 10", 0},
        {"miss", "miss", 0},
        {"invalid d", "invalid", 0},
        {"invalid d", "invalid d", 0},
        {"invalid d", "invalid line", 0},
        {"miss", "hit 8", FAULT_BIT(FAULT_FALSE_HIT)},
        {"hit 8 top 0 0 1", "miss", FAULT_BIT(FAULT_FALSE_MISS)},
        {"hit 8 top 0 0 1", "hit 8 wall", FAULT_BIT(FAULT_WRONG_PART)},
        {"hit 8 top 0 0 1", "invalid d", FAULT_BIT(FAULT_REFUSED)},
        {"miss", "invalid", FAULT_BIT(FAULT_REFUSED)},
        {"hit 8 top 0 0 1", "hit nan", FAULT_BIT(FAULT_NOT_A_NUMBER)},
        {"hit 8 top 0 0 1", "hit 8 top nan 0 0", FAULT_BIT(FAULT_NOT_A_NUMBER)},
        {"hit 8 top 0 0 1", "hit 8 top 0 nan 0", FAULT_BIT(FAULT_NOT_A_NUMBER)},
        {"hit 8 top 0 0 1", "hit 8 top 0 0 nan", FAULT_BIT(FAULT_NOT_A_NUMBER)},
        {"hit 8 top 0 0 1", "hit 0x1.fffffffffffffp-1", FAULT_BIT(FAULT_OUT_OF_RANGE)},
        {"hit 8 top 0 0 1", "hit 0x1.4000000000001p+3", FAULT_BIT(FAULT_OUT_OF_RANGE)},
        {"miss", "hit 11", FAULT_BIT(FAULT_FALSE_HIT) | FAULT_BIT(FAULT_OUT_OF_RANGE)},
        {"invalid d", "miss", FAULT_BIT(FAULT_INVALID_ACCEPTED)},
        {"invalid d", "hit 8", FAULT_BIT(FAULT_INVALID_ACCEPTED)},
        {"invalid d", "invalid o", FAULT_BIT(FAULT_WRONG_FIELD)},
        {"miss", "Miss", FAULT_BIT(FAULT_GARBAGE)},
    };
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++)
        ck_assert_msg(faults_of_lines(line, answers[i].truth, answers[i].given) ==
                          answers[i].faults,
                      "%s for %s", answers[i].given, answers[i].truth);
}

TEST(test_faults_beside_the_answer)
{
    sure_case asked;
    ck_assert(case_read("sphere 0 0 9 0 0 -1 0 inf 0 0 0 1", &asked));
    const case_answer right = {.status = SURE_MISS};
    static const struct {
        reply given;
        unsigned faults;
    } rows[] = {{{.kind = REPLY_ANSWERED, .status = SURE_MISS}, 0},
                {{.status = SURE_MISS, .touched = true}, FAULT_BIT(FAULT_TOUCHED)},
                {{.status = SURE_MISS, .changed = true}, FAULT_BIT(FAULT_CHANGED)},
                {{.status = SURE_MISS, .leaked = true}, FAULT_BIT(FAULT_LEAKED)},
                {{.kind = REPLY_CRASHED}, FAULT_BIT(FAULT_CRASHED)},
                {{.kind = REPLY_HUNG}, FAULT_BIT(FAULT_HUNG)},
                {{.kind = REPLY_LOST}, FAULT_BIT(FAULT_LOST)},
                {{.kind = REPLY_UNASKED}, 0}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        ck_assert_uint_eq(faults_of(&asked, &right, &rows[i].given), rows[i].faults);
}

/* The tally. */

static void count(tally *all, const sure_case *question, const case_answer *right,
                  const reply *given, const camera_lengths *by)
{
    const example one = {true, *question, *given, *right, 0};
    tally_add(all, &one, faults_of(question, right, given), by);
}

TEST(test_tally)
{
    static tally all;
    sure_case asked;
    ck_assert(case_read("sphere 0 0 9 0 0 -1 0 inf 0 0 0 1", &asked));
    case_answer hit = {.status = SURE_HIT, .t = 8, .normal = {0, 0, 1}};
    case_answer miss = {.status = SURE_MISS}, invalid = {.status = SURE_INVALID};
    static const char *const hits[] = {"hit 8", "hit 8 surface 0 0 1", "hit 0x1.0000000000003p+3",
                                       "miss",  "hit 8 wall 1 0 0",    "gone"};
    memset(&all, 0, sizeof all);
    for (size_t i = 0; i < sizeof hits / sizeof *hits; i++) {
        reply given = reply_read(hits[i]);
        count(&all, &asked, &hit, &given, NULL);
    }
    reply missed = reply_read("miss"), unasked = {.kind = REPLY_UNASKED};
    count(&all, &asked, &miss, &missed, NULL);
    count(&all, &asked, &invalid, &missed, NULL);
    count(&all, &asked, &miss, &unasked, NULL);
    verdict sum = tally_verdict(&all);
    ck_assert_uint_eq(sum.cases, 8);
    ck_assert_uint_eq(sum.valid, 7);
    ck_assert_uint_eq(sum.hits, 6);
    ck_assert_uint_eq(sum.unasked, 1);
    ck_assert_uint_eq(sum.wrong, 3); /* a miss, a part, no answer */
    ck_assert_uint_eq(sum.t_ulps.count, 4);
    ck_assert_uint_eq(sum.t_ulps.right, 3);
    ck_double_same(sum.t_ulps.median, 0);
    ck_double_same(sum.t_ulps.q99, 3);
    ck_double_same(sum.t_ulps.most, 3);
    ck_assert_uint_eq(sum.t_classes[0], 3);
    ck_assert_uint_eq(sum.t_classes[3], 1); /* above 2, up to 4 */
    ck_assert_uint_eq(sum.normal.count, 1); /* not of a wrong part */
    ck_assert_uint_eq(sum.normal.right, 1);
    ck_assert(sum.worst_t.found && sum.worst_t.given.t > 8);
    ck_assert(sum.faulty[FAULT_GARBAGE].found && !sum.faulty[FAULT_FALSE_HIT].found);
    ck_assert_uint_eq(verdict_breaches(&sum), 2); /* invalid accepted, garbage */
    ck_assert_double_lt(sum.wrong_share.lower, 3 / 7.0);
    memset(&all, 0, sizeof all);
    sum = tally_verdict(&all);
    ck_assert_uint_eq(sum.cases + sum.wrong + sum.t_ulps.count + sum.t_ulps.right, 0);
    ck_double_same(sum.t_ulps.median, 0);
}

/* None, and up to 1, 2, 4, ... ulps. */
TEST(test_classes_of_errors)
{
    static tally all;
    static const int classes[] = {0, 1, 2, 3, 3, 4, 4, 4, 4, 5};
    const sure_case asked = {.ray.t_max = INFINITY};
    const case_answer hit = {.status = SURE_HIT, .t = 8};
    for (int ulps = 0; ulps < 10; ulps++) {
        reply given = reply_read("hit 8");
        given.t += ulps * 0x1p-49;
        memset(&all, 0, sizeof all);
        count(&all, &asked, &hit, &given, NULL);
        ck_assert_uint_eq(tally_verdict(&all).t_classes[classes[ulps]], 1);
    }
}

/* 2 is the double of the bits 2^62: so many ulps lie from 0 to it, and 2^63 from -2. */
TEST(test_classes_of_large_errors)
{
    static tally all;
    static const struct {
        double truth, given;
        int class;
    } rows[] = {{0, 1, 63}, {0, 2, 63}, {0, 4, 64}, {-2, 2, 64}, {-2, 4, 65}, {1, NAN, 65}};
    const sure_case asked = {.ray = {.t_min = -INFINITY, .t_max = INFINITY}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const case_answer hit = {.status = SURE_HIT, .t = rows[i].truth};
        reply given = reply_read("hit 8");
        given.t = rows[i].given;
        memset(&all, 0, sizeof all);
        count(&all, &asked, &hit, &given, NULL);
        ck_assert_uint_eq(tally_verdict(&all).t_classes[rows[i].class], 1);
    }
}

/* An error of 1 at t = 8, at speed 2, is a length of 2, and 19 from the eye a pixel covers 9.5. */
TEST(test_lengths)
{
    static tally all;
    const camera_lengths by = {.extent = 4, .pixel = 0.5, .way = 3, .speed = 2};
    const case_answer hit = {.status = SURE_HIT, .t = 8}, miss = {.status = SURE_MISS};
    const sure_case asked = {.ray.t_max = INFINITY};
    reply given = reply_read("hit 7"), missed = reply_read("miss");
    memset(&all, 0, sizeof all);
    count(&all, &asked, &hit, &given, &by);
    count(&all, &asked, &hit, &missed, &by);
    count(&all, &asked, &miss, &given, &by);
    count(&all, &asked, &hit, &given, NULL);
    verdict sum = tally_verdict(&all);
    ck_assert(sum.t_extents.count == 1 && sum.t_pixels.count == 1);
    ck_double_same(sum.t_extents.most, 0.5);
    ck_double_same(sum.t_pixels.most, 2 / 9.5);
}

/* Each case of a picture is measured by its own lengths, and no other case is. */
TEST(test_lengths_of_a_regime)
{
    enum { CASES = 6000 }; /* more than a block */
    const judging_plan plan = {.subject = SUBJECT_TIER,
                               .tier = SURE_TIER_FLOAT32,
                               .name = "float32",
                               .how = {INPUTS_DOUBLE, 60, .once = true},
                               .untimed = true,
                               .seed = 5};
    static tally expected;
    judging_row row;
    judging *by = judging_open(&plan, NULL);
    ck_assert(by &&
              judging_regime(by, QUERY_HIT, SURE_SHAPE_PLANE, REGIME_CAMERA, CASES, &row, NULL));
    for (uint64_t i = 0; i < CASES; i++) {
        rng g = regime_rng(SURE_SHAPE_PLANE, REGIME_CAMERA, plan.seed, i);
        camera_case made = camera_case_of(SURE_SHAPE_PLANE, &g);
        camera_lengths lengths = camera_lengths_of(&made);
        case_answer right = case_answer_of(&made.question, SURE_TIER_EXACT);
        case_answer is = case_answer_of(&made.question, SURE_TIER_FLOAT32);
        reply given = {.status = is.status, .t = is.t};
        count(&expected, &made.question, &right, &given, &lengths);
    }
    verdict sum = tally_verdict(&expected);
    ck_assert_uint_eq(row.sum.t_pixels.count, sum.t_pixels.count);
    ck_double_same(row.sum.t_pixels.median, sum.t_pixels.median);
    ck_double_same(row.sum.t_pixels.most, sum.t_pixels.most);
    ck_double_same(row.sum.t_extents.q99, sum.t_extents.q99);
    ck_assert(judging_regime(by, QUERY_HIT, SURE_SHAPE_PLANE, REGIME_TYPICAL, 10, &row, NULL));
    ck_assert_uint_eq(row.sum.t_extents.count + row.sum.t_pixels.count, 0);
    judging_close(by);
}

/* What is told of a case is its whole answer, though its normal was not needed to judge it. */
static int expect_whole(const example *one)
{
    if (!one->found)
        return 0;
    case_answer right = case_answer_of(&one->question, SURE_TIER_EXACT);
    ck_assert_int_eq(one->truth.status, right.status);
    ck_double_same(one->truth.t, right.t);
    ck_double_same(one->truth.normal.x, right.normal.x);
    ck_double_same(one->truth.normal.y, right.normal.y);
    ck_double_same(one->truth.normal.z, right.normal.z);
    return right.status == SURE_HIT;
}

/* In floats, and without a part or a normal. */
static int answer_t_alone(void *context, const double *questions, double *answers)
{
    sure_shape shape = (sure_shape)questions[0];
    const double *numbers = questions + EXCHANGE_HEAD;
    (void)context;
    for (int i = 0; i < (int)questions[1]; i++) {
        sure_case question = case_from_numbers(shape, numbers + i * case_numbers(shape));
        case_answer said = case_answer_of(&question, SURE_TIER_FLOAT32);
        const double given[EXCHANGE_ANSWER] = {said.status == SURE_HIT, said.t, NAN, NAN, NAN, NAN};
        memcpy(answers + i * EXCHANGE_ANSWER, given, sizeof given);
    }
    return (int)questions[1];
}

TEST(test_told_answers_are_whole)
{
    const judging_plan plan = {.subject = SUBJECT_CALLBACK,
                               .name = "t alone",
                               .how = {INPUTS_DOUBLE, 60},
                               .untimed = true,
                               .told = margins_of(MARGIN_SIZE)};
    judging_row row;
    judging *by =
        judging_of(&plan, candidate_of_callback(answer_t_alone, NULL, &plan.how, NULL), NULL);
    ck_assert(by &&
              judging_regime(by, QUERY_HIT, SURE_SHAPE_CYLINDER, REGIME_GRAZING, 2000, &row, NULL));
    int faulty = 0, widest = 0;
    for (int i = 0; i < FAULTS; i++)
        faulty += expect_whole(&row.sum.faulty[i]);
    for (int i = 0; i < FAULTS_WITH_MARGIN; i++)
        widest += expect_whole(&row.looked_at.widest[i]);
    ck_assert_int_eq(expect_whole(&row.sum.worst_t), 1);
    ck_assert(faulty > 0 && widest > 0);
    judging_close(by);
}

/* Promises. */

TEST(test_promises_printed)
{
    static const char *const lines[] = {"decisions<=0.06", "decisions@1.23456789e-09<=0.3333",
                                        "t<=4ulp",         "t<=1e-09",
                                        "contract",        "normal<=0.1"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char text[CASE_LINE_MAX];
        promises all;
        ck_assert(promises_read(lines[i], &all));
        promise_print(&all.list[0], text);
        ck_assert_str_eq(text, lines[i]);
    }
}

TEST(test_promises_read)
{
    static const struct {
        const char *text;
        int count;
        promise first;
    } right[] = {
        {"decisions", 1, {PROMISE_DECISIONS, 0, 0}},
        {"decisions<=1e-6", 1, {PROMISE_DECISIONS, 1e-6, 0}},
        {"contract", 1, {PROMISE_CONTRACT, 0, 0}},
        {"t<=4ulp", 1, {PROMISE_T_ULPS, 4, 0}},
        {"t<=0x1p-40,decisions", 2, {PROMISE_T_RELATIVE, 0x1p-40, 0}},
        {"normal<=2ulp", 1, {PROMISE_NORMAL_ULPS, 2, 0}},
        {"normal<=1e-9", 1, {PROMISE_NORMAL, 1e-9, 0}},
        {"decisions@1e-9", 1, {PROMISE_DECISIONS, 0, 1e-9}},
        {"decisions@0.01<=0.5", 1, {PROMISE_DECISIONS, 0.5, 0.01}},
        {"t<=1ulp,t<=2ulp,t<=1.0ulp,t<=1", 3, {PROMISE_T_ULPS, 1, 0}},
        {"decisions@1e-9,decisions,decisions", 2, {PROMISE_DECISIONS, 0, 1e-9}},
    };
    static const char *const wrong[] = {
        "",          ",",          "decisions,",    "t",          "t<=",         "t<4",
        "t<=-1",     "t<=4ul",     "t<=4 ulp",      "t<= 4",      "contract<=3", "decision",
        "t<=nan",    "decisionsx", "normal<=2ulps", "decisions@", "decisions@0", "decisions@1e9",
        "t@1<=1ulp", "contract@1"};
    promises all;
    for (size_t i = 0; i < sizeof right / sizeof *right; i++) {
        ck_assert_msg(promises_read(right[i].text, &all), "%s", right[i].text);
        ck_assert_int_eq(all.count, right[i].count);
        ck_assert_int_eq(all.list[0].kind, right[i].first.kind);
        ck_double_same(all.list[0].most, right[i].first.most);
        ck_double_same(all.list[0].margin, right[i].first.margin);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert_msg(!promises_read(wrong[i], &all), "'%s'", wrong[i]);
    char most[16 * PROMISES_MOST] = "";
    for (int i = 0; i < PROMISES_MOST; i++)
        sprintf(most + strlen(most), "%st<=%d", i == 0 ? "" : ",", i);
    ck_assert(promises_read(most, &all) && all.count == PROMISES_MOST);
    ck_assert(!promises_read(strcat(most, ",contract"), &all));
}

static bool is_kept(const char *text, const verdict *by)
{
    promises all;
    double is;
    ck_assert(promises_read(text, &all));
    /* One decision is wrong by more than 1e-9. */
    const margins told = margins_of(MARGIN_SIZE);
    const refereed looked_at = {.beyond = {1, 1}};
    return promise_kept(&all.list[0], by, &looked_at, &told, &is);
}

TEST(test_promises_kept)
{
    verdict by = {.valid = 1000,
                  .wrong = 1,
                  .t_ulps.most = 4,
                  .t_relative.most = 1e-16,
                  .normal_ulps.most = 2,
                  .normal.most = 1e-9};
    ck_assert(!is_kept("decisions", &by) && is_kept("decisions<=0.001", &by));
    ck_assert(!is_kept("decisions<=0.00099", &by));
    by.faults[FAULT_FALSE_HIT] = 1;
    ck_assert(!is_kept("decisions@1e-9", &by) && is_kept("decisions@1e-6", &by));
    by.wrong = 2; /* another one is no answer at all */
    ck_assert(!is_kept("decisions@1e-6", &by) && is_kept("decisions@1e-6<=0.001", &by));
    by.wrong = 1;
    ck_assert(is_kept("t<=4ulp", &by) && !is_kept("t<=3ulp", &by));
    ck_assert(is_kept("t<=1e-16", &by) && !is_kept("t<=0.9e-16", &by));
    ck_assert(is_kept("normal<=2ulp", &by) && !is_kept("normal<=1.9ulp", &by));
    ck_assert(is_kept("normal<=1e-9", &by) && !is_kept("normal<=0", &by));
    ck_assert(is_kept("contract", &by));
    by.faults[FAULT_LEAKED] = 1;
    ck_assert(!is_kept("contract", &by));
    by.faults[FAULT_LEAKED] = 0;
    by.wrong = 0;
    ck_assert(is_kept("decisions", &by));
    by.unasked = 1;
    ck_assert(!is_kept("decisions", &by) && !is_kept("contract", &by));
    by = (verdict){.t_ulps.most = INFINITY};
    ck_assert(!is_kept("t<=1e300ulp", &by));
    by = (verdict){.hits = 9};
    ck_assert(is_kept("t<=1ulp", &by) && is_kept("normal<=1ulp", &by));
    by.with_t = 9; /* and none was told */
    ck_assert(!is_kept("t<=1ulp", &by) && is_kept("normal<=1ulp", &by));
    by.with_normal = 9;
    ck_assert(!is_kept("normal<=1ulp", &by));
    by.t_ulps.count = 1;
    ck_assert(is_kept("t<=1ulp", &by) && !is_kept("t<=1e-9", &by));
}

/* Cases in float. */

TEST(test_float_cases)
{
    sure_case asked, rounded;
    ck_assert(case_read("sphere 0.1 0 9 0 0 -1 0 1e300 0 0 0 1", &asked));
    ck_assert(float_case(&asked, &rounded));
    ck_double_same(rounded.ray.origin.x, (double)0.1f);
    ck_double_same(rounded.ray.t_max, INFINITY);
    ck_assert(case_read("sphere 1e300 0 9 0 0 -1 0 inf 0 0 0 1", &asked));
    ck_assert(!float_case(&asked, &rounded)); /* o is infinite now */
    ck_assert(case_read("sphere 0 0 9 0 0 -1e-60 0 inf 0 0 0 1", &asked));
    ck_assert(!float_case(&asked, &rounded)); /* d is 0 now */
    ck_assert(case_read("sphere 0 0 9 0 0 0 0 inf 0 0 0 1", &asked));
    ck_assert(float_case(&asked, &rounded)); /* it never was valid */
}

/* Programs on a pipe. */

/* One that does not end by itself prints nothing of interest. */
TEST(test_pipe)
{
    static const struct {
        const char *command, *text;
        reply_kind kind;
        int status, signal;
    } runs[] = {{"cat", "one\n", REPLY_ANSWERED, 0, 0},
                {"cat >/dev/null; echo one; exit 3", "one\n", REPLY_ANSWERED, 3, 0},
                {"kill -ABRT $$", NULL, REPLY_ANSWERED, 0, SIGABRT},
                {"/nowhere/nothing", NULL, REPLY_ANSWERED, 127, 0},
                {"sleep 100", NULL, REPLY_HUNG, 0, 0},
                {"exec >&-; sleep 100", NULL, REPLY_HUNG, 0, 0}, /* its output is closed */
                {"yes", NULL, REPLY_LOST, 0, 0}};
    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++) {
        double limit = runs[i].kind == REPLY_HUNG ? 0.1 : 10;
        pipe_result result = pipe_run(runs[i].command, "one\n", 4, 100, limit);
        ck_assert_int_eq(result.kind, runs[i].kind);
        ck_assert(!runs[i].text || strcmp(result.text, runs[i].text) == 0);
        if (result.kind == REPLY_ANSWERED && runs[i].signal != 0)
            ck_assert(WIFSIGNALED(result.ended) && WTERMSIG(result.ended) == runs[i].signal);
        else if (result.kind == REPLY_ANSWERED)
            ck_assert(WIFEXITED(result.ended) && WEXITSTATUS(result.ended) == runs[i].status);
        free(result.text);
    }
}

/* More than any pipe holds, both ways at once. */
TEST(test_pipe_of_much)
{
    enum { LENGTH = 3000000 };
    char *text = malloc(LENGTH + 1);
    memset(text, 'x', LENGTH);
    text[LENGTH] = '\0';
    pipe_result result = pipe_run("cat", text, LENGTH, LENGTH, 10);
    ck_assert_int_eq(result.kind, REPLY_ANSWERED);
    ck_assert_uint_eq(result.length, LENGTH);
    ck_assert(memcmp(result.text, text, LENGTH) == 0);
    free(result.text);
    free(text);
}

/* Frozen vectors (docs/vectors.md). */

/* Every number is printed as it is: each exponent, whole and odd fractions, both signs. */
TEST(test_numbers_of_vectors)
{
    for (int power = 0; power < 2048; power++) {
        for (int i = 0; i < 4; i++) {
            uint64_t fraction = suite_bits(1, (uint64_t)(4 * power + i)) >> 12 >> (17 * i % 52);
            uint64_t bits = (uint64_t)i % 2 << 63 | (uint64_t)power << 52 | fraction;
            double numbers[CASE_NUMBERS_MAX] = {0};
            memcpy(&numbers[i], &bits, sizeof bits);
            sure_case question = case_from_numbers(SURE_SHAPE_SPHERE, numbers);
            frozen_case frozen = vectors_case_of("test", 7, &question);
            json_t *object = vectors_json(&frozen);
            FREED_BY(free_text) char *line = json_dumps(object, JSON_COMPACT);
            char number[64], digits[64];
            snprintf(number, sizeof number, isnan(numbers[i]) ? "\"nan\"" : "\"%a\"", numbers[i]);
            snprintf(digits, sizeof digits, "\"%016" PRIx64 "\"", bits);
            ck_assert_msg(strstr(line, number) && strstr(line, digits), "%s or %s not in %s",
                          number, digits, line);
            json_decref(object);
        }
    }
}

SUITE("judge")
