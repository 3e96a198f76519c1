/* SPDX-License-Identifier: MIT */
#include "findings/findings.h"

#include "judging_state.h"

#include "bench/instructions.h"
#include "pieces/cases.h"

#include "../support/json_file.h"
#include "../support/pieces/cut.h"

#include <stdio.h>
#include <sys/stat.h>

static void finish_row(judging_row *row, int width)
{
    row->instructions.candidate = instructions_figure(row->times.candidate);
    row->instructions.textbook = instructions_figure(row->times.textbook);
    row->instructions.certain = instructions_figure(row->times.certain);
    row->instructions.building = instructions_figure(row->times.building);
    findings_print_row(row, width);
}

static bool is_asked(const judging *by, sure_shape shape)
{
    bool asked = false;
    for (int i = 0; i < QUERIES; i++)
        asked |= judging_asks(by, (query)i, shape);
    return asked;
}

static bool is_row(const judging_plan *plan, const judging *by, int i)
{
    query asks = (query)(i / REGIMES / SURE_SHAPES);
    int shape = i / REGIMES % SURE_SHAPES;
    return regime_rows_have(&plan->rows, shape, i % REGIMES) &&
           judging_asks(by, asks, (sure_shape)shape);
}

/* How many cases are made; or bytes of a file of them, 0 where that is not known. */
static int64_t total_of(const judging_plan *plan, const judging *by)
{
    struct stat about;
    int64_t rows = 0;
    if (plan->cases)
        return stat(plan->cases, &about) == 0 && S_ISREG(about.st_mode) ? about.st_size : 0;
    for (int i = 0; i < QUERIES * SURE_SHAPES * REGIMES; i++)
        rows += is_row(plan, by, i);
    return progress_total(rows, plan->count);
}

/* The rows that there are; false where one is asked for that the candidate does not answer. */
static bool list_rows(const judging_plan *plan, const judging *by, bool rows[PIECE_ROWS],
                      char *message)
{
    bool any = false;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (!plan->rows.shapes[shape] || is_asked(by, (sure_shape)shape))
            continue;
        return complain(message,
                        plan->subject == SUBJECT_LIBRARY ? "%s: no symbol sure_candidate_%s"
                                                         : "%s: that is not asked of a %s",
                        plan->name, sure_shape_name((sure_shape)shape));
    }
    for (int i = 0; i < PIECE_ROWS; i++)
        any |= rows[i] = is_row(plan, by, i);
    return any || complain(message, "that is not answered, or the shape has no such regime");
}

/* What is there already was added from pieces. */
static bool judge_made(const judging_plan *plan, judging *by, const bool rows[PIECE_ROWS],
                       findings *all, char *message)
{
    for (int i = 0; i < PIECE_ROWS; i++) {
        query asks = (query)(i / REGIMES / SURE_SHAPES);
        sure_shape shape = (sure_shape)(i / REGIMES % SURE_SHAPES);
        if (!rows[i])
            continue;
        judging_row *row = &all->rows[all->row_count++];
        if (!judging_regime(by, asks, shape, (regime)(i % REGIMES),
                            cut.way == CUT_NOT ? plan->count : 0, row, message))
            return false;
        progress_finish(by->bar);
        finish_row(row, all->width);
    }
    return true;
}

/* Room for "cylinder interval" where others than hits are asked for. */
static int width_of(const judging *by)
{
    int width = 9;
    for (int i = 0; i < QUERIES * SURE_SHAPES; i++) {
        if (i >= SURE_SHAPES &&
            judging_asks(by, (query)(i / SURE_SHAPES), (sure_shape)(i % SURE_SHAPES)))
            width = 18;
    }
    return width;
}

/* Of each shape that was judged. False: nothing can be asked. */
static bool ask_conventions(judging *by, findings *all)
{
    bool any = false;
    for (int i = 0; i < all->row_count; i++) {
        sure_shape shape = all->rows[i].shape;
        if (!all->has_said[shape])
            all->has_said[shape] = conventions_ask(by, shape, &all->said[shape]);
        any |= all->has_said[shape];
    }
    return any;
}

static bool is_any_asked(const findings *all)
{
    bool any = false;
    for (int i = 0; i < all->row_count; i++)
        any |= all->rows[i].sum.cases > 0;
    return any;
}

static bool judge_rows(const judging_plan *plan, judging *by, const bool rows[PIECE_ROWS],
                       findings *all, char *message)
{
    all->who = judging_who(by);
    all->width = width_of(by);
    findings_print_head(plan, all);
    progress bar = progress_start(instructions_counting() ? NULL : stderr, total_of(plan, by));
    by->bar = &bar;
    bool done = plan->cases ? judging_given(by, all->rows, &all->row_count, &all->left_out, message)
                            : judge_made(plan, by, rows, all, message);
    progress_finish(&bar);
    by->bar = NULL;
    for (int i = 0; done && plan->cases && i < all->row_count; i++)
        finish_row(&all->rows[i], all->width);
    return done && judging_answers_end(by, message);
}

static void look_closer(const judging_plan *plan, judging *by, findings *all)
{
    findings_print_lengths(all);
    findings_print_margins(plan, judging_asked(by), all);
    if (ask_conventions(by, all))
        findings_print_conventions(all);
    findings_print_breaches(all);
    findings_print_skipped(all);
    fflush(stdout);
    all->worst_count = worst_find(by, all->rows, all->row_count, all->worst);
    findings_print_worst(plan, all);
}

/* CUT_GOES_ON: all is found; else an exit status, which is 2 after a message. */
static int judge_all(const judging_plan *plan, findings *all, char *message)
{
    bool rows[PIECE_ROWS] = {false};
    judging *by = judging_open(plan, message);
    if (!by)
        return 2;
    *message = '\0';
    bool listed = plan->cases || list_rows(plan, by, rows, message);
    int status = listed ? cases_do(by, rows, message) : 2;
    if (status == CUT_GOES_ON && !judge_rows(plan, by, rows, all, message))
        status = 2;
    if (status == CUT_GOES_ON && !instructions_counting())
        look_closer(plan, by, all);
    judging_close(by);
    if (status == CUT_GOES_ON && !is_any_asked(all) &&
        !complain(message, "no case has the entry: none was asked"))
        status = 2;
    return status;
}

int judging_run(const judging_plan *plan)
{
    static findings all;
    char message[CANDIDATE_MESSAGE] = "";
    int status = judge_all(plan, &all, message);
    if (status == 2 && *message)
        fprintf(stderr, "surehit judge: error: %s\n", message);
    if (status != CUT_GOES_ON)
        return status;
    int broken = findings_print_promises(plan, &all);
    bool written = json_write_file(findings_json(plan, &all), plan->json, stderr) &&
                   junit_write(plan, &all, plan->junit, stderr) &&
                   json_write_file(sarif_json(plan, &all), plan->sarif, stderr);
    return broken > 0 || !written;
}
