#include "judging.h"

#include "bench/tier_times.h"

#include <stdlib.h>
#include <string.h>

/* The tiers are asked one in so many blocks too, for their times, until these have taken so many
 * nanoseconds. */
#define TIMED_OF 8
#define TIMED_MOST 1e8

/* Nanoseconds, and the rays that took them. */
typedef struct {
    double candidate, textbook, certain;
    uint64_t rays;
} clocks;

/* What belongs to a row while it is made. */
typedef struct {
    tally counted;
    clocks times;
    uint64_t blocks;
    block asked;
} ledger;

struct judging {
    judging_parties parties;
    uint64_t answers_read;
    case_answer right[BLOCK_CASES];
    tier_times *beside;           /* NULL: nobody is timed */
    ledger *ledgers[SURE_SHAPES]; /* made when they are needed */
};

const char *judging_row_name(const judging_row *row)
{
    return row->which == JUDGING_GIVEN ? "given" : regime_name((regime)row->which);
}

judging *judging_new(const judging_parties *parties)
{
    judging *self = calloc(1, sizeof *self);
    if (!self)
        return NULL;
    self->parties = *parties;
    if (!parties->asked || parties->untimed || (self->beside = tier_times_new()))
        return self;
    free(self);
    return NULL;
}

void judging_free(judging *self)
{
    for (int i = 0; self && i < SURE_SHAPES; i++)
        free(self->ledgers[i]);
    if (self)
        tier_times_free(self->beside);
    free(self);
}

precision judging_precision(const judging *self, sure_shape shape)
{
    const candidate *asked = self->parties.asked;
    return asked ? asked->answers_in[shape] : self->parties.in;
}

bool judging_is_quick(const judging *self)
{
    return self->parties.asked && self->parties.asked->is_quick && !self->parties.known.program;
}

static int block_cases(const judging *self)
{
    return self->parties.asked ? self->parties.asked->block_cases : BLOCK_CASES;
}

/* NULL after a message. */
static ledger *open_ledger(judging *self, sure_shape shape, char *message)
{
    ledger **of = &self->ledgers[shape];
    if (!*of)
        *of = calloc(1, sizeof **of);
    if (!*of) {
        snprintf(message, CANDIDATE_MESSAGE, "no memory");
        return NULL;
    }
    tally_clear(&(*of)->counted, judging_precision(self, shape));
    (*of)->times = (clocks){0, 0, 0, 0};
    (*of)->blocks = 0;
    (*of)->asked.shape = shape;
    (*of)->asked.count = 0;
    return *of;
}

/* The next line of the file of answers, as the answer to the last case. */
static bool read_answer(judging *self, reply *given, char *message)
{
    char line[CASE_LINE_MAX + 2];
    if (!fgets(line, sizeof line, self->parties.answers)) {
        snprintf(message, CANDIDATE_MESSAGE, "%s: too few answers: none to case %llu",
                 self->parties.answers_name, (unsigned long long)self->answers_read + 1);
        return false;
    }
    self->answers_read++;
    *given = reply_read(line);
    for (size_t length = strlen(line); length == sizeof line - 1 && line[length - 1] != '\n';
         length = strlen(line)) {
        *given = (reply){.kind = REPLY_GARBAGE, .part = REPLY_NO_PART};
        if (!fgets(line, sizeof line, self->parties.answers))
            break;
    }
    return true;
}

bool judging_answers_end(const judging *self, char *message)
{
    if (!self->parties.answers || fgetc(self->parties.answers) == EOF)
        return true;
    snprintf(message, CANDIDATE_MESSAGE, "%s: answers out of step: more than the %llu cases",
             self->parties.answers_name, (unsigned long long)self->answers_read);
    return false;
}

static double time_of(judging *self, sure_tier tier, const block *asked)
{
    return tier_times_ask(self->beside, tier, asked, asked->with_normals);
}

/* A tier's own time is taken as those beside it. */
static void take_times(judging *self, ledger *of)
{
    const block *asked = &of->asked;
    const candidate *who = self->parties.asked;
    if (!asked->for_time || !self->beside)
        return;
    double own = who->is_tier ? time_of(self, who->tier, asked) : asked->nanoseconds;
    if (own == 0)
        return;
    of->times.candidate += own;
    of->times.textbook += time_of(self, SURE_TIER_TEXTBOOK, asked);
    of->times.certain += time_of(self, SURE_TIER_CERTAIN, asked);
    of->times.rays += (uint64_t)asked->count;
}

static bool is_for_time(const judging *self, const ledger *of)
{
    bool turn = of->blocks % TIMED_OF == 0 || self->parties.asked->counts_text;
    return turn && of->times.textbook + of->times.certain <= TIMED_MOST;
}

/* Asks the cases that have come together, and counts. */
static bool judge_block(judging *self, ledger *of, char *message)
{
    block *asked = &of->asked;
    if (asked->count == 0)
        return true;
    if (self->parties.asked) {
        asked->for_time = is_for_time(self, of);
        candidate_ask(self->parties.asked, asked);
        take_times(self, of);
    }
    if (!truth_ask(&self->parties.known, asked->cases, asked->count, self->right, message))
        return false;
    for (int i = 0; i < asked->count; i++)
        tally_add(&of->counted, &asked->cases[i], &self->right[i], &asked->replies[i]);
    of->blocks++;
    asked->count = 0;
    return true;
}

/* One more case; a block that is full is judged. */
static bool add_case(judging *self, ledger *of, const sure_case *question, char *message)
{
    block *asked = &of->asked;
    sure_case *place = &asked->cases[asked->count];
    *place = *question;
    bool possible = of->counted.answers_in == PRECISION_DOUBLE || float_case(question, place);
    if (self->parties.answers && !read_answer(self, &asked->replies[asked->count], message))
        return false;
    if (!possible) {
        of->counted.sum.skipped++;
        return true;
    }
    asked->count++;
    return asked->count < block_cases(self) || judge_block(self, of, message);
}

static double per_ray(double nanoseconds, uint64_t rays)
{
    return rays > 0 ? nanoseconds / (double)rays : 0;
}

static judging_row row_of(const ledger *of, int which)
{
    const clocks *t = &of->times;
    return (judging_row){.shape = of->asked.shape,
                         .which = which,
                         .sum = tally_verdict(&of->counted),
                         .times = {per_ray(t->candidate, t->rays), per_ray(t->textbook, t->rays),
                                   per_ray(t->certain, t->rays)}};
}

static void forgive(judging *self)
{
    if (self->parties.asked)
        candidate_forgive(self->parties.asked);
}

bool judging_regime(judging *self, sure_shape shape, regime which, uint64_t seed, uint64_t count,
                    judging_row *row, char *message)
{
    ledger *of = open_ledger(self, shape, message);
    forgive(self);
    if (!of)
        return false;
    for (uint64_t i = 0; i < count; i++) {
        sure_case question = regime_case(shape, which, seed, i);
        if (!add_case(self, of, &question, message))
            return false;
    }
    if (!judge_block(self, of, message))
        return false;
    *row = row_of(of, (int)which);
    return true;
}

/* The next case line, as *question. False at the end, or after a message. */
static bool read_case(FILE *cases, const char *name, uint64_t number, sure_case *question,
                      char *message)
{
    char line[CASE_LINE_MAX + 2];
    message[0] = '\0';
    if (!fgets(line, sizeof line, cases))
        return false;
    if (case_read(line, question))
        return true;
    snprintf(message, CANDIDATE_MESSAGE, "%s: line %llu is no case", name,
             (unsigned long long)number);
    return false;
}

static bool judge_all(judging *self, ledger *of[SURE_SHAPES], FILE *cases, const char *name,
                      char *message)
{
    sure_case question;
    for (uint64_t number = 1; read_case(cases, name, number, &question, message); number++) {
        sure_shape shape = question.object.shape;
        if (self->parties.asked && !self->parties.asked->answers[shape]) {
            snprintf(message, CANDIDATE_MESSAGE, "%s: line %llu: the candidate answers no %s", name,
                     (unsigned long long)number, sure_shape_name(shape));
            return false;
        }
        if (!of[shape] && !(of[shape] = open_ledger(self, shape, message)))
            return false;
        if (!add_case(self, of[shape], &question, message))
            return false;
    }
    return message[0] == '\0';
}

bool judging_given(judging *self, FILE *cases, const char *name, judging_row rows[SURE_SHAPES],
                   int *count, char *message)
{
    ledger *of[SURE_SHAPES] = {NULL};
    forgive(self);
    *count = 0;
    if (!judge_all(self, of, cases, name, message))
        return false;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (!of[shape])
            continue;
        if (!judge_block(self, of[shape], message))
            return false;
        rows[(*count)++] = row_of(of[shape], JUDGING_GIVEN);
    }
    return true;
}

static bool is_same(const sure_case *a, const sure_case *b)
{
    double x[CASE_NUMBERS_MAX], y[CASE_NUMBERS_MAX];
    case_to_numbers(a, x);
    case_to_numbers(b, y);
    for (int i = 0; i < case_numbers(a->object.shape); i++) {
        if (x[i] != y[i] && (x[i] == x[i] || y[i] == y[i]))
            return false;
    }
    return true;
}

/* Can the candidate be asked just this? */
static bool is_possible(const judging *self, const sure_case *question)
{
    sure_case rounded;
    return judging_precision(self, question->object.shape) == PRECISION_DOUBLE ||
           (float_case(question, &rounded) && is_same(question, &rounded));
}

/* As many as suit the candidate. */
static bool ask_some(judging *self, block *asked, const sure_case *questions, int count,
                     example *answered)
{
    char message[CANDIDATE_MESSAGE];
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
    candidate_forgive(self->parties.asked);
    candidate_ask(self->parties.asked, asked);
    if (!truth_ask(&self->parties.known, asked->cases, asked->count, self->right, message))
        return false;
    for (int i = 0, n = 0; i < count; i++) {
        if (!answered[i].found)
            continue;
        answered[i].given = asked->replies[n];
        answered[i].truth = self->right[n++];
    }
    return true;
}

bool judging_several(judging *self, const sure_case *questions, int count, example *answered)
{
    ledger *of = self->ledgers[questions[0].object.shape];
    if (!of || !self->parties.asked)
        return false;
    for (int first = 0, most = block_cases(self); first < count; first += most) {
        int left = count - first;
        if (!ask_some(self, &of->asked, questions + first, left < most ? left : most,
                      answered + first))
            return false;
    }
    return true;
}
