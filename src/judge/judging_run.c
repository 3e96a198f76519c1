#include "judging_run.h"

#include "../support/json_file.h"

#include <string.h>

static const char *const options[] = {[SUBJECT_TIER] = "tier",
                                      [SUBJECT_LIBRARY] = "candidate",
                                      [SUBJECT_COMMAND] = "command",
                                      [SUBJECT_ANSWERS] = "answers"};

subject_kind judging_kind_named(const char *option)
{
    subject_kind kind = SUBJECT_TIER;
    while (kind < SUBJECT_ANSWERS && strcmp(option, options[kind]) != 0)
        kind++;
    return kind;
}

/* The parties. */

static bool is_standard_input(const char *name)
{
    return strcmp(name, "-") == 0;
}

static FILE *open_input(const char *name, char *message)
{
    FILE *in = is_standard_input(name) ? stdin : fopen(name, "r");
    if (!in)
        snprintf(message, CANDIDATE_MESSAGE, "%s: cannot be read", name);
    return in;
}

static const char *input_name(const char *name)
{
    return is_standard_input(name) ? "standard input" : name;
}

static void close_input(FILE *in)
{
    if (in && in != stdin)
        fclose(in);
}

static bool open_candidate(const judging_plan *plan, judging_parties *parties, char *message)
{
    const candidate_options *how = &plan->how;
    switch (plan->subject) {
    case SUBJECT_TIER: parties->asked = candidate_of_tier(plan->tier, how, message); break;
    case SUBJECT_LIBRARY: parties->asked = candidate_of_library(plan->name, how, message); break;
    case SUBJECT_COMMAND: parties->asked = candidate_of_command(plan->name, how, message); break;
    default:
        parties->answers = open_input(plan->name, message);
        parties->answers_name = input_name(plan->name);
        parties->in = how->inputs == INPUTS_FLOAT ? PRECISION_FLOAT : PRECISION_DOUBLE;
        return parties->answers != NULL;
    }
    return parties->asked != NULL;
}

static bool open_parties(const judging_plan *plan, judging_parties *parties, char *message)
{
    parties->known = truth_exact();
    return open_candidate(plan, parties, message) &&
           (!plan->by_reference || truth_reference(&plan->how, &parties->known, message));
}

static void close_parties(judging_parties *parties)
{
    candidate_close(parties->asked);
    truth_close(&parties->known);
    close_input(parties->answers);
}

/* How the candidate is named on a command line; NULL where it can't be asked again. */
static const char *option_for(const judging_plan *plan)
{
    static char text[2048];
    static const char *const forms[] = {
        [SUBJECT_TIER] = "--tier %s%s%s",
        [SUBJECT_LIBRARY] = "--candidate '%s'%s%s",
        [SUBJECT_COMMAND] = "--command '%s'%s%s",
    };
    const char *inputs = plan->how.inputs == INPUTS_FLOAT ? " --inputs float" : "";
    const char *by = plan->by_reference ? " --truth reference" : "";
    if (plan->subject == SUBJECT_ANSWERS)
        return NULL;
    snprintf(text, sizeof text, forms[plan->subject], plan->name, inputs, by);
    return text;
}

/* The rows. */

typedef struct {
    judging_row rows[SURE_SHAPES * REGIMES];
    worst_case worst[WORST_KINDS];
    int row_count, worst_count;
} findings;

static bool is_answered(const judging_parties *parties, int shape)
{
    return !parties->asked || parties->asked->answers[shape];
}

/* Every shape that was asked for by name is answered. */
static bool check_shapes(const judging_plan *plan, const judging_parties *parties, char *message)
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (!plan->rows.shapes[shape] || is_answered(parties, shape))
            continue;
        snprintf(message, CANDIDATE_MESSAGE, "%s: no symbol sure_candidate_%s", plan->name,
                 sure_shape_name((sure_shape)shape));
        return false;
    }
    return true;
}

static bool judge_made(const judging_plan *plan, const judging_parties *parties, judging *by,
                       FILE *out, findings *all, char *message)
{
    if (!check_shapes(plan, parties, message))
        return false;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        int shape = i / REGIMES, which = i % REGIMES;
        if (!regime_rows_have(&plan->rows, shape, which) || !is_answered(parties, shape))
            continue;
        judging_row *row = &all->rows[all->row_count];
        if (!judging_regime(by, (sure_shape)shape, (regime)which, plan->seed, plan->count, row,
                            message))
            return false;
        judging_print_row(out, row);
        fflush(out);
        all->row_count++;
    }
    if (all->row_count > 0)
        return true;
    snprintf(message, CANDIDATE_MESSAGE, "the shape has no such regime");
    return false;
}

static bool judge_given(const judging_plan *plan, judging *by, FILE *out, findings *all,
                        char *message)
{
    FILE *cases = open_input(plan->cases, message);
    bool done = cases && judging_given(by, cases, input_name(plan->cases), all->rows,
                                       &all->row_count, message);
    for (int i = 0; done && i < all->row_count; i++)
        judging_print_row(out, &all->rows[i]);
    close_input(cases);
    return done;
}

static bool judge_all(const judging_plan *plan, const judging_parties *parties,
                      const judging_subject *subject, FILE *out, findings *all, char *message)
{
    judging *by = judging_new(parties);
    if (!by) {
        snprintf(message, CANDIDATE_MESSAGE, "no memory");
        return false;
    }
    judging_print_head(out, subject);
    bool done = plan->cases ? judge_given(plan, by, out, all, message)
                            : judge_made(plan, parties, by, out, all, message);
    done = done && judging_answers_end(by, message);
    if (done) {
        judging_print_breaches(out, all->rows, all->row_count);
        fflush(out);
        all->worst_count = worst_find(by, all->rows, all->row_count, all->worst);
        judging_print_worst(out, subject, all->worst, all->worst_count);
    }
    judging_free(by);
    return done;
}

static judging_subject subject_of(const judging_plan *plan, const judging_parties *parties)
{
    bool is_tier = plan->subject == SUBJECT_TIER;
    return (judging_subject){
        .candidate = plan->name,
        .option = option_for(plan),
        .truth = plan->by_reference ? "reference" : "exact",
        .is_tier = is_tier,
        .by_like = is_tier && plan->tier >= SURE_TIER_CERTAIN && !plan->by_reference,
        .counts_text = parties->asked && parties->asked->counts_text,
        .seed = plan->seed,
        .count = plan->cases ? 0 : plan->count,
    };
}

static bool judge(const judging_plan *plan, judging_parties *parties, FILE *out,
                  judging_outcome *outcome, char *message)
{
    static findings all;
    if (!open_parties(plan, parties, message))
        return false;
    const judging_subject subject = subject_of(plan, parties);
    if (!judge_all(plan, parties, &subject, out, &all, message))
        return false;
    int broken = judging_print_promises(out, &plan->required, all.rows, all.row_count);
    *outcome = broken > 0 ? JUDGED_BROKEN : JUDGED;
    if (!json_write_file(judging_json(&subject, all.rows, all.row_count, all.worst, all.worst_count,
                                      &plan->required),
                         plan->json, stderr))
        *outcome = JUDGED_UNWRITTEN;
    return true;
}

judging_outcome judging_run(const judging_plan *plan, FILE *out)
{
    judging_parties parties = {0};
    char message[CANDIDATE_MESSAGE];
    judging_outcome outcome = JUDGED_NOTHING;
    if (!judge(plan, &parties, out, &outcome, message))
        fprintf(stderr, "surehit judge: error: %s\n", message);
    close_parties(&parties);
    return outcome;
}
