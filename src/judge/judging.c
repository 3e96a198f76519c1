#include "judging.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* The tiers are asked one in so many blocks too, for their times, until these have taken so many
 * nanoseconds. */
#define TIMED_OF 8
#define TIMED_MOST 1e8
#define TIER_TIME_LIMIT 60 /* seconds for a tier's answer, which always comes */

/* What belongs to a row while it is made. */
typedef struct {
    bool begun;
    int which; /* the regime, or JUDGING_GIVEN */
    tally counted;
    refereed looked_at;
    judging_times times; /* of all rays that were timed: so many */
    uint64_t rays, blocks;
    block asked;
    camera_lengths lengths[BLOCK_CASES]; /* of the cases of pictures */
} ledger;

struct judging {
    const judging_plan *plan;
    candidate *asked;
    candidate absent; /* who it is where the answers come from the lines of this file */
    FILE *answers;
    uint64_t answers_read;
    truth known;
    case_answer right[BLOCK_CASES];
    ledger ledgers[SURE_SHAPES];

    /* The tiers for their times: each runs in a process of its own and is called and timed as a
     * shared library is (plugin.h). */
    candidate *tiers[SURE_TIERS][2]; /* opened when they are needed */
    rng order;
    block room;
};

const char *judging_row_name(int which)
{
    return which == JUDGING_GIVEN ? "given" : regime_name((regime)which);
}

/* Opening and closing. */

static const char *input_name(const char *name)
{
    return strcmp(name, "-") == 0 ? "standard input" : name;
}

static FILE *open_input(const char *name, char *message)
{
    FILE *in = strcmp(name, "-") == 0 ? stdin : fopen(name, "r");
    if (!in)
        complain(message, "%s: cannot be read", name);
    return in;
}

static candidate *open_candidate(judging *self, char *message)
{
    const judging_plan *plan = self->plan;
    switch (plan->subject) {
    case SUBJECT_TIER: return candidate_of_tier(plan->tier, true, &plan->how, message);
    case SUBJECT_LIBRARY: return candidate_of_library(plan->name, &plan->how, message);
    case SUBJECT_COMMAND: return candidate_of_command(plan->name, &plan->how, message);
    default: break;
    }
    self->absent = candidate_by_lines(&plan->how);
    self->answers = open_input(plan->name, message);
    return self->answers ? &self->absent : NULL;
}

judging *judging_open(const judging_plan *plan, char *message)
{
    judging *self = calloc(1, sizeof *self);
    if (!self) {
        complain(message, "no memory");
        return NULL;
    }
    self->plan = plan;
    self->asked = open_candidate(self, message);
    if (self->asked &&
        (!plan->by_reference || truth_reference(plan->how.time_limit, &self->known, message)))
        return self;
    judging_close(self);
    return NULL;
}

void judging_close(judging *self)
{
    if (!self)
        return;
    for (int i = 0; i < SURE_TIERS * 2; i++)
        candidate_close(self->tiers[i / 2][i % 2]);
    candidate_close(self->asked);
    candidate_close(self->known.program);
    if (self->answers)
        fclose(self->answers);
    free(self);
}

const candidate *judging_asked(const judging *self)
{
    return self->asked;
}

bool judging_is_quick(const judging *self)
{
    return self->asked->is_quick && !self->known.program;
}

static ledger *begin(judging *self, sure_shape shape, int which)
{
    ledger *of = &self->ledgers[shape];
    of->begun = true;
    tally_clear(&of->counted, self->asked->answers_in[shape]);
    of->looked_at = (refereed){.allowed = {0}};
    of->times = (judging_times){0, 0, 0};
    of->rays = of->blocks = 0;
    of->which = which;
    of->asked.shape = shape;
    of->asked.count = 0;
    return of;
}

/* The next line of the file of answers, as the answer to the last case. */
static bool read_answer(judging *self, reply *given, char *message)
{
    char *line = NULL;
    size_t room = 0;
    bool read = getline(&line, &room, self->answers) >= 0;
    if (read)
        *given = reply_read(line);
    else
        complain(message, "%s: too few answers: none to case %ju", input_name(self->plan->name),
                 (uintmax_t)self->answers_read + 1);
    self->answers_read++;
    free(line);
    return read;
}

bool judging_answers_end(const judging *self, char *message)
{
    return !self->answers || fgetc(self->answers) == EOF ||
           complain(message, "%s: answers out of step: more than the %ju cases",
                    input_name(self->plan->name), (uintmax_t)self->answers_read);
}

/* Times. */

/* Nanoseconds for the hits of all these cases, and for their normals where the candidate gives
 * them: the faster of two passes, in an order that nobody has been asked in. 0: not known. */
static double time_of(judging *self, sure_tier tier, const block *asked)
{
    const candidate_options how = {.inputs = INPUTS_DOUBLE, .time_limit = TIER_TIME_LIMIT};
    candidate **of = &self->tiers[tier][asked->with_normals];
    block *room = &self->room;
    if (!*of && !(*of = candidate_of_tier(tier, asked->with_normals, &how, NULL)))
        return 0;
    room->shape = asked->shape;
    room->for_time = true;
    room->count = asked->count;
    memcpy(room->cases, asked->cases, (size_t)room->count * sizeof *room->cases);
    shuffle_cases(room->cases, room->count, &self->order);
    candidate_ask(*of, room);
    return room->nanoseconds;
}

/* A tier's own time is taken as those beside it. */
static void take_times(judging *self, ledger *of)
{
    const block *asked = &of->asked;
    if (!asked->for_time || self->plan->untimed)
        return;
    double own = self->asked->is_tier ? time_of(self, self->plan->tier, asked) : asked->nanoseconds;
    if (own == 0)
        return;
    of->times.candidate += own;
    of->times.textbook += time_of(self, SURE_TIER_TEXTBOOK, asked);
    of->times.certain += time_of(self, SURE_TIER_CERTAIN, asked);
    of->rays += (uint64_t)asked->count;
}

static bool is_for_time(const judging *self, const ledger *of)
{
    bool turn = of->blocks % TIMED_OF == 0 || self->asked->counts_text;
    return turn && of->times.textbook + of->times.certain <= TIMED_MOST;
}

/* Cases. */

/* Asks the cases that have come together, and counts. */
static bool judge_block(judging *self, ledger *of, char *message)
{
    block *asked = &of->asked;
    if (asked->count == 0)
        return true;
    if (!self->answers) {
        asked->for_time = is_for_time(self, of);
        candidate_ask(self->asked, asked);
        take_times(self, of);
    }
    if (!truth_ask(&self->known, asked->cases, asked->count, self->right, message))
        return false;
    for (int i = 0; i < asked->count; i++) {
        example one = {true, asked->cases[i], asked->replies[i], self->right[i]};
        referee_take_t(&self->asked->entry, &one);
        unsigned faults = referee(&of->looked_at, &self->plan->told, &self->asked->entry,
                                  of->counted.answers_in, &one);
        tally_add(&of->counted, &one, faults, of->which == REGIME_CAMERA ? &of->lengths[i] : NULL);
    }
    of->blocks++;
    asked->count = 0;
    return true;
}

/* One more case; a block that is full is judged. */
static bool add_case(judging *self, ledger *of, const sure_case *question, char *message)
{
    block *asked = &of->asked;
    sure_case *place = &asked->cases[asked->count];
    bool possible = entry_case(&self->asked->entry, question, of->counted.answers_in, place);
    if (self->answers && !read_answer(self, &asked->replies[asked->count], message))
        return false;
    if (!possible) {
        of->counted.sum.skipped++;
        return true;
    }
    asked->count++;
    return asked->count < self->asked->block_cases || judge_block(self, of, message);
}

static judging_row row_of(const ledger *of)
{
    const judging_times *sum = &of->times;
    double rays = of->rays > 0 ? (double)of->rays : 1;
    return (judging_row){
        .shape = of->asked.shape,
        .which = of->which,
        .sum = tally_verdict(&of->counted),
        .looked_at = of->looked_at,
        .times = {sum->candidate / rays, sum->textbook / rays, sum->certain / rays}};
}

/* The next one of the block. */
static sure_case make_case(const judging *self, ledger *of, uint64_t index)
{
    sure_shape shape = of->asked.shape;
    if (of->which != REGIME_CAMERA)
        return regime_case(shape, (regime)of->which, self->plan->seed, index);
    rng g = regime_rng(shape, REGIME_CAMERA, self->plan->seed, index);
    camera_case made = camera_case_of(shape, &g);
    of->lengths[of->asked.count] = camera_lengths_of(&made);
    return made.question;
}

bool judging_regime(judging *self, sure_shape shape, regime which, uint64_t count, judging_row *row,
                    char *message)
{
    ledger *of = begin(self, shape, (int)which);
    candidate_forgive(self->asked);
    for (uint64_t i = 0; i < count; i++) {
        sure_case question = make_case(self, of, i);
        if (!add_case(self, of, &question, message))
            return false;
    }
    if (!judge_block(self, of, message))
        return false;
    *row = row_of(of);
    return true;
}

/* True at the end of the file. */
static bool judge_all(judging *self, FILE *cases, uint64_t *left_out, char *message)
{
    const char *name = input_name(self->plan->cases);
    char line[CASE_LINE_MAX + 2];
    sure_case question;
    uintmax_t number = 1;
    for (; fgets(line, sizeof line, cases); number++) {
        if (!case_read(line, &question))
            return complain(message, "%s: line %ju is no case", name, number);
        sure_shape shape = question.object.shape;
        ledger *of = &self->ledgers[shape];
        if (!self->asked->answers[shape]) {
            ++*left_out;
            continue;
        }
        if (!add_case(self, of->begun ? of : begin(self, shape, JUDGING_GIVEN), &question, message))
            return false;
    }
    if (ferror(cases))
        return complain(message, "%s: cannot be read after line %ju: %s", name, number - 1,
                        strerror(errno));
    return number - 1 > *left_out ||
           complain(message,
                    number > 1 ? "%s: no case of a shape that the candidate answers"
                               : "%s: there is no case",
                    name);
}

bool judging_given(judging *self, judging_row rows[SURE_SHAPES], int *count, uint64_t *left_out,
                   char *message)
{
    FILE *cases = open_input(self->plan->cases, message);
    *left_out = 0;
    bool done = cases && judge_all(self, cases, left_out, message);
    *count = 0;
    for (int shape = 0; shape < SURE_SHAPES && done; shape++) {
        ledger *of = &self->ledgers[shape];
        done = !of->begun || judge_block(self, of, message);
        if (done && of->begun)
            rows[(*count)++] = row_of(of);
    }
    if (cases)
        fclose(cases);
    return done;
}

/* Can the candidate be asked just this? */
static bool is_possible(const judging *self, const sure_case *question)
{
    return entry_holds(&self->asked->entry, question,
                       self->asked->answers_in[question->object.shape]);
}

margin_unit judging_unit(const judging *self)
{
    return self->plan->told.unit;
}

unsigned judging_faults(const judging *self, const example *one)
{
    return faults_by_entry(&self->asked->entry, one);
}

bool judging_several(judging *self, const sure_case *questions, int count, example *answered)
{
    block *asked = &self->ledgers[questions[0].object.shape].asked;
    if (self->answers)
        return false;
    asked->count = 0;
    asked->for_time = false;
    for (int i = 0; i < count; i++) {
        answered[i] =
            (example){.found = is_possible(self, &questions[i]), .question = questions[i]};
        if (answered[i].found)
            asked->cases[asked->count++] = questions[i];
    }
    if (asked->count == 0)
        return true;
    candidate_forgive(self->asked);
    candidate_ask(self->asked, asked);
    if (!truth_ask(&self->known, asked->cases, asked->count, self->right, NULL))
        return false;
    for (int i = 0, n = 0; i < count; i++) {
        if (!answered[i].found)
            continue;
        answered[i].given = asked->replies[n];
        answered[i].truth = self->right[n++];
    }
    return true;
}
