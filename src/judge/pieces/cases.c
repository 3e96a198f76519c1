/* SPDX-License-Identifier: MIT */
#include "cases.h"

#include "ledger_json.h"

#include "../../support/folder.h"
#include "../../support/pieces/cut.h"

typedef struct {
    judging *by;
    const bool *rows;
    char *message;
} judged_rows;

static ledger *row(const judged_rows *of, int i)
{
    return ledger_of(of->by, (query)(i / REGIMES / SURE_SHAPES),
                     (sure_shape)(i / REGIMES % SURE_SHAPES), i % REGIMES, of->message);
}

static bool judge(const judged_rows *of, uint64_t first, uint64_t end)
{
    for (int i = 0; i < PIECE_ROWS; i++) {
        ledger *one = of->rows[i] ? row(of, i) : NULL;
        if (of->rows[i] && (!one || !ledger_judge(of->by, one, first, end, of->message)))
            return false;
    }
    return true;
}

/* All rows side by side, a block each. */
static bool work(void *sum, index_range some)
{
    const judged_rows *of = sum;
    for (uint64_t first = some.first, end; first < some.end; first = end) {
        end = some.end - first > BLOCK_CASES ? first + BLOCK_CASES : some.end;
        if (!judge(of, first, end)) {
            fprintf(stderr, "surehit judge: error: %s\n", of->message);
            return false;
        }
        if (!cut_goes_on(end))
            return false;
    }
    return true;
}

/* A row each, in their order. */
static json_t *tell(const void *sum, const index_ranges *done)
{
    const judged_rows *of = sum;
    json_t *rows = json_array();
    (void)done; /* all that is in the ledgers */
    for (int i = 0; i < PIECE_ROWS; i++) {
        if (of->rows[i])
            json_array_append_new(rows, ledger_json(row(of, i)));
    }
    return json_pack("{s:o}", "rows", rows);
}

static const char *add(void *sum, const index_ranges *done, const json_t *told)
{
    const judged_rows *of = sum;
    const json_t *rows = json_object_get(told, "rows");
    const char *wrong = NULL;
    size_t next = 0;
    (void)done;
    for (int i = 0; i < PIECE_ROWS && !wrong; i++) {
        ledger *one = of->rows[i] ? row(of, i) : NULL;
        if (of->rows[i])
            wrong = one ? ledger_add_json(one, json_array_get(rows, next++)) : of->message;
    }
    return wrong || next == json_array_size(rows) ? wrong : "it has other rows";
}

int cases_do(judging *by, const bool rows[PIECE_ROWS], char *message)
{
    const judging_plan *plan = by->plan;
    judged_rows of = {by, rows, message};
    cut_input library = {plan->subject == SUBJECT_LIBRARY ? plan->name : NULL, 0};
    if (cut.way != CUT_NOT && library.path && !file_hash(library.path, stderr, &library.hash))
        return 2;
    return cut_do(&(cut_work){.unit = "cases",
                              .total = plan->count,
                              .input = library,
                              .sum = &of,
                              .work = work,
                              .tell = tell,
                              .add = add});
}
