#include "judging_run.h"

#include "../support/json_file.h"

static bool judge_made(const judging_plan *plan, judging *by, FILE *out, judging_findings *all,
                       char *message)
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (!plan->rows.shapes[shape] || judging_has(by, shape))
            continue;
        snprintf(message, CANDIDATE_MESSAGE, "%s: no symbol sure_candidate_%s", plan->name,
                 sure_shape_name((sure_shape)shape));
        return false;
    }
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        int shape = i / REGIMES, which = i % REGIMES;
        if (!regime_rows_have(&plan->rows, shape, which) || !judging_has(by, shape))
            continue;
        judging_row *row = &all->rows[all->row_count];
        if (!judging_regime(by, (sure_shape)shape, (regime)which, plan->count, row, message))
            return false;
        judging_print_row(out, row);
        fflush(out);
        all->row_count++;
    }
    snprintf(message, CANDIDATE_MESSAGE, "the shape has no such regime");
    return all->row_count > 0;
}

static bool judge_all(const judging_plan *plan, FILE *out, judging_findings *all, char *message)
{
    judging *by = judging_open(plan, message);
    if (!by)
        return false;
    judging_print_head(out, plan);
    bool done = plan->cases ? judging_given(by, all->rows, &all->row_count, message)
                            : judge_made(plan, by, out, all, message);
    for (int i = 0; done && plan->cases && i < all->row_count; i++)
        judging_print_row(out, &all->rows[i]);
    done = done && judging_answers_end(by, message);
    if (done) {
        judging_print_breaches(out, all);
        fflush(out);
        all->worst_count = worst_find(by, all->rows, all->row_count, all->worst);
        judging_print_worst(out, plan, all);
    }
    judging_close(by);
    return done;
}

judging_outcome judging_run(const judging_plan *plan, FILE *out)
{
    static judging_findings all;
    char message[CANDIDATE_MESSAGE];
    if (!judge_all(plan, out, &all, message)) {
        fprintf(stderr, "surehit judge: error: %s\n", message);
        return JUDGED_NOTHING;
    }
    int broken = judging_print_promises(out, &plan->required, &all);
    if (!json_write_file(judging_json(plan, &all), plan->json, stderr))
        return JUDGED_UNWRITTEN;
    return broken > 0 ? JUDGED_BROKEN : JUDGED;
}
