/* SPDX-License-Identifier: MIT */
/* The oracles against answers reasoned out by hand (by_hand.*), in every
 * floating-point environment, and against the roots of a lattice's formulas. It compares bits:
 * nothing here has a tolerance. */
#include "../support/case_file.h"
#include "../support/suite.h"
#include "../support/surroundings.h"
#include "../support/text_rows.h"
#include "../support/true_hit.h"
#include "../support/world.h"
#include "oracle.h"

enum { ROWS_MAX = 600, BITS = 400 };

/* "?" for an answer or a chord that is left open; of a chord "-" for none. */
typedef struct {
    char text[1024]; /* cut where its parts end */
    const char *answer, *chord, *why;
    sure_case question;
    case_answer said;
    sure_interval ends;
} row;

static sure_part part_named(const char *name)
{
    const char *known;
    for (int part = 0; (known = sure_part_name((sure_part)part)) != NULL; part++) {
        if (strcmp(name, known) == 0)
            return (sure_part)part;
    }
    ck_abort_msg("no part: %s", name);
}

static void read_row(row *r)
{
    char enter[16], leave[16];
    char *answer = row_cut(r->text, " -> "), *chord = row_cut(answer, " ; ");
    r->why = row_cut(chord, " ; ");
    r->answer = answer;
    r->chord = chord;
    ck_assert_msg(case_read(r->text, &r->question), "not a case: %s", r->text);
    if (strcmp(answer, "?") != 0)
        ck_assert_msg(case_answer_read(answer, &r->said), "not an answer: %s", answer);
    if (strcmp(chord, "?") == 0 || strcmp(chord, "-") == 0)
        return;
    ck_assert_int_eq(
        sscanf(chord, "%lf %lf %15s %15s", &r->ends.t_enter, &r->ends.t_leave, enter, leave), 4);
    r->ends.enter_part = part_named(enter);
    r->ends.leave_part = part_named(leave);
}

static int read_lines(const char *name, row rows[ROWS_MAX])
{
    FILE *file = rows_open(name);
    int count = 0;
    while (count < ROWS_MAX && rows_line(file, rows[count].text, sizeof rows[count].text))
        count++;
    ck_assert(feof(file) && count > 0);
    fclose(file);
    return count;
}

static void set_answer(bisection_result *result, const case_answer *said)
{
    result->status = said->status;
    result->field = said->field;
    result->part = said->part;
    result->t = said->t;
    result->normal = said->normal;
}

/* What the oracle said, but for what the row says. */
static bisection_result expected_of(const row *r, const bisection_result *got)
{
    bisection_result expected = *got;
    if (strcmp(r->answer, "?") != 0)
        set_answer(&expected, &r->said);
    if (strcmp(r->chord, "-") == 0)
        expected.interval_status = got->status == SURE_INVALID ? SURE_INVALID : SURE_MISS;
    if (strcmp(r->chord, "?") == 0 || strcmp(r->chord, "-") == 0)
        return expected;
    expected.interval_status = SURE_HIT;
    expected.interval = r->ends;
    return expected;
}

static row rows[ROWS_MAX];

LOOP_TEST(test_answers, ORACLES *SURROUNDINGS)
{
    static bisection_result got[ROWS_MAX];
    const oracle *asked = &oracles[_i / SURROUNDINGS];
    int count = read_lines("oracles/by_hand.cases", rows);
    for (int i = 0; i < count; i++)
        read_row(&rows[i]);
    surroundings_set(_i % SURROUNDINGS);
    for (int i = 0; i < count; i++)
        got[i] = asked->answer(&rows[i].question);
    surroundings_set(0);
    for (int i = 0; i < count; i++) {
        bisection_result expected = expected_of(&rows[i], &got[i]);
        bisection_expect(&rows[i].question, &got[i], &expected, rows[i].why);
    }
}

static const oracle *judged;

static void expect_hard_case(const hard_case *hard)
{
    bisection_result got = judged->answer(&hard->question), expected = got;
    set_answer(&expected, &hard->answer);
    bisection_expect(&hard->question, &got, &expected, hard->text);
}

LOOP_TEST(test_hard_cases, ORACLES *SURE_SHAPES)
{
    judged = &oracles[_i / SURE_SHAPES];
    ck_assert_int_gt(case_file_each((sure_shape)(_i % SURE_SHAPES), expect_hard_case), 0);
}

LOOP_TEST(test_orders, ORACLES)
{
    int count = read_lines("oracles/by_hand.orders", rows);
    for (int i = 0; i < count; i++) {
        char *second = row_cut(rows[i].text, " & "), *order = row_cut(second, " -> ");
        sure_case one, other;
        int expected, of[2];
        ck_assert_msg(case_read(rows[i].text, &one), "%s", rows[i].text);
        ck_assert_msg(case_read(second, &other), "%s", second);
        ck_assert_int_eq(sscanf(order, "%d", &expected), 1);
        of[0] = oracles[_i].order(&one.ray, &one.object, &other.object);
        of[1] = oracles[_i].order(&one.ray, &other.object, &one.object);
        ck_assert_msg(of[0] == expected && of[1] == -expected, "%s\n%s\n  %d and %d, not %s",
                      rows[i].text, second, of[0], of[1], order);
    }
}

LOOP_TEST(test_comparisons, ORACLES)
{
    int count = read_lines("oracles/by_hand.signs", rows);
    for (int i = 0; i < count; i++) {
        char *number = row_cut(rows[i].text, " & "), *sign = row_cut(number, " -> ");
        sure_case question;
        double x;
        int expected;
        ck_assert_msg(case_read(rows[i].text, &question), "%s", rows[i].text);
        ck_assert_int_eq(sscanf(number, "%lf", &x) + sscanf(sign, "%d", &expected), 2);
        int order = oracles[_i].compare(&question, x);
        ck_assert_msg(order == expected, "%s against %s: %d", rows[i].text, number, order);
    }
}

/* Of the whole ray the signs of t* - x, too. The oracles have one normal. */
static void check_on_lattice(const sure_case *c, true_line *line, mpfr_t t)
{
    bisection_result got[ORACLES];
    for (int o = 0; o < ORACLES; o++)
        got[o] = oracles[o].answer(c);
    bisection_result expected = got[0];
    true_line_set(line, c);
    bool hits = true_first(line, t);
    bool meets = line->exists && mpfr_cmp_d(line->t[1], c->ray.t_min) >= 0 &&
                 mpfr_cmp_d(line->t[0], c->ray.t_max) <= 0;
    expected.status = hits ? SURE_HIT : SURE_MISS;
    expected.interval_status = meets ? SURE_HIT : SURE_MISS;
    if (hits) {
        expected.t = mpfr_get_d(t, MPFR_RNDN) + 0.0;
        expected.part = true_part(line, t);
    }
    if (meets) {
        expected.interval.t_enter = mpfr_get_d(line->t[0], MPFR_RNDN) + 0.0;
        expected.interval.t_leave = mpfr_get_d(line->t[1], MPFR_RNDN) + 0.0;
        expected.interval.enter_part = true_part(line, line->t[0]);
        expected.interval.leave_part = true_part(line, line->t[1]);
    }
    const double xs[] = {expected.t, 1, 2};
    bool whole = c->ray.t_min == 0 && c->ray.t_max == INFINITY;
    for (int o = 0; o < ORACLES; o++) {
        bisection_expect(c, &got[o], &expected, "on the lattice");
        for (int i = 0; i < 3 && hits && whole; i++) {
            int order = mpfr_cmp_d(t, xs[i]);
            ck_assert_int_eq(oracles[o].compare(c, xs[i]), (order > 0) - (order < 0));
        }
    }
}

LOOP_TEST(test_lattice, SURE_SHAPES)
{
    static const double ranges[][2] = {{0, INFINITY}, {1, INFINITY}, {0, 1}, {1, 2}, {2, 2}};
    sure_shape shape = (sure_shape)_i;
    TRUE_LINE(BITS, line);
    TRUE_NUMBERS(BITS, t);
    for (uint64_t index = 0; index < world_count(WORLD_LATTICE, shape); index++) {
        sure_case question = world_case(WORLD_LATTICE, shape, index);
        for (int i = 0; i < 5; i++) {
            question.ray.t_min = ranges[i][0];
            question.ray.t_max = ranges[i][1];
            check_on_lattice(&question, &line, t);
        }
    }
}

SUITE("by hand")
