/* SPDX-License-Identifier: MIT */
/* Cases, and answers, that are lines of a file. */
#include "../cases/lines.h"
#include "judging_state.h"

#include <errno.h>
#include <string.h>

static const char *input_name(const char *name)
{
    return strcmp(name, "-") == 0 ? "standard input" : name;
}

FILE *judging_input(const char *name, char *message)
{
    FILE *in = strcmp(name, "-") == 0 ? stdin : fopen(name, "r");
    if (!in)
        complain(message, "%s: cannot be read: %s", name, strerror(errno));
    return in;
}

bool judging_read_answer(judging *self, reply *given, char *message)
{
    case_lines lines = {.in = self->answers};
    bool read = case_lines_next(&lines);
    const char *wrong = read ? NULL : case_lines_fault(&lines);
    if (read)
        *given = reply_read(lines.whole ? lines.text : "no whole line");
    given->to = candidate_tells(self->asked, QUERY_HIT);
    self->answers_read++;
    if (wrong)
        complain(message, "%s: answer %ju: %s", input_name(self->plan->name),
                 (uintmax_t)self->answers_read, wrong);
    else if (!read)
        complain(message, "%s: too few answers: none to case %ju", input_name(self->plan->name),
                 (uintmax_t)self->answers_read);
    return read;
}

bool judging_answers_end(const judging *self, char *message)
{
    return !self->answers || fgetc(self->answers) == EOF ||
           complain(message, "%s: answers out of step: more than the %ju cases",
                    input_name(self->plan->name), (uintmax_t)self->answers_read);
}

/* The regime that the line names, if the shape has it. */
static int which_of(const char *line, sure_shape shape)
{
    regime which;
    return regime_remarked(line, &which) && regime_applies(shape, which) ? (int)which
                                                                         : JUDGING_GIVEN;
}

static bool is_wanted(const judging *self, sure_shape shape, int which)
{
    const regime_rows *rows = &self->plan->rows;
    bool asked = false;
    for (int i = 0; i < QUERIES; i++)
        asked |= judging_asks(self, (query)i, shape);
    return asked && (rows->shapes[shape] || !rows->some_shapes) &&
           (!rows->some_regimes || (which != JUDGING_GIVEN && rows->regimes[which]));
}

/* What is left out has an answer, too, where they were written before. */
static bool take_line(judging *self, const char *line, const sure_case *question,
                      uint64_t *left_out, char *message)
{
    sure_shape shape = question->object.shape;
    int which = which_of(line, shape);
    reply unread;
    if (!is_wanted(self, shape, which)) {
        ++*left_out;
        return !self->answers || judging_read_answer(self, &unread, message);
    }
    for (int i = 0; i < QUERIES; i++) {
        if (!judging_asks(self, (query)i, shape))
            continue;
        ledger *of = ledger_of(self, (query)i, shape, which, message);
        if (!of || !ledger_add(self, of, question, message))
            return false;
    }
    return true;
}

/* True at the end of the file. */
static bool judge_all(judging *self, FILE *cases, uint64_t *left_out, char *message)
{
    const char *name = input_name(self->plan->cases);
    case_lines lines = {.in = cases};
    bool done = true;
    while (done && case_lines_next(&lines)) {
        sure_case question;
        progress_step(self->bar, (int64_t)lines.length + 1);
        done = lines.whole && case_read(lines.text, &question)
                   ? take_line(self, lines.text, &question, left_out, message)
                   : complain(message, "%s: line %ju is no case", name, lines.number);
    }
    if (done && case_lines_fault(&lines))
        return complain(message, "%s: cannot be read after line %ju: %s", name, lines.number,
                        case_lines_fault(&lines));
    const char *none = lines.number > 0
                           ? "%s: no case of a shape that the candidate answers, or none that "
                             "is asked for"
                           : "%s: there is no case";
    return done && (lines.number > *left_out || complain(message, none, name));
}

bool judging_given(judging *self, judging_row *rows, int *count, uint64_t *left_out, char *message)
{
    FILE *cases = judging_input(self->plan->cases, message);
    *left_out = 0;
    bool done = cases && judge_all(self, cases, left_out, message);
    *count = 0;
    for (int i = 0; i < JUDGING_ALL_ROWS && done; i++) {
        ledger *of = (&self->ledgers[0][0][0])[i];
        if (of)
            done = ledger_finish(self, of, &rows[(*count)++], message);
    }
    if (cases)
        fclose(cases);
    return done;
}
