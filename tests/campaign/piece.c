/* SPDX-License-Identifier: MIT */
#include "piece.h"

#include "complain.h"
#include "pieces/allowance.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

/* What gets so many broken promises is not worth its end. */
#define BROKEN_MOST 1000

/* One in so many cases looks at the clock, which takes as long as a case. */
#define CLOCKED 64

bool plan_read(const char *path, FILE *messages, plan *read)
{
    campaign_record own;
    *read = (plan){.seed = 0};
    if (!manifest_read(path, messages, &read->of))
        return false;
    const json_t *asked = manifest_asked(&read->of);
    const char *wrong = asked_take(asked, &read->against, &read->seed);
    const char *other = NULL;
    if (!wrong) {
        record_begin(read->against, read->seed, &own);
        other = asked_difference(own.asked, asked);
        record_free(&own);
    }
    if (!wrong && !other)
        return true;
    manifest_free(&read->of);
    if (wrong)
        return complain(messages, path, "%s", wrong);
    return complain(messages, path, "is for another program than this one: it has another %s",
                    other);
}

bool plan_piece(const plan *by, size_t number, FILE *messages, coverage *cases)
{
    const json_t *line = manifest_piece(&by->of, number, messages);
    const json_t *pairs = json_object_get(line, "cases"), *pair;
    const char *wrong = json_array_size(pairs) > 0 ? NULL : "expected pieces with cases";
    sure_shape shape;
    regime which;
    size_t i;
    *cases = (coverage){0};
    json_array_foreach(pairs, i, pair)
    {
        if (!wrong)
            wrong = pair_take(pair, cases, &shape, &which);
    }
    if (line && !wrong)
        return true;
    coverage_free(cases);
    return line && complain(messages, by->of.path, "piece %zu: %s", number, wrong);
}

/* What was found of a piece. */
typedef enum { NOTHING, OWN, OF_OTHERS } finding;

/* Reads it, if it is there and is of this piece. */
static finding read_found(const plan *by, const coverage *cases, const char *path, FILE *messages,
                          campaign_record *found)
{
    if (access(path, F_OK) != 0 && errno == ENOENT)
        return NOTHING;
    if (!record_read(path, messages, found))
        return NOTHING;
    const char *other = asked_difference(manifest_asked(&by->of), found->asked);
    if (!other && coverage_within(&found->done, cases))
        return OWN;
    record_free(found);
    if (other)
        complain(messages, path, "it has another %s than %s", other, by->of.path);
    else
        complain(messages, path, "it has cases of another piece");
    return OF_OTHERS;
}

/* The part of the piece that is in FOLDER/NUMBER and the ending; less than 0: others' is there. */
static double part_of(const plan *by, size_t number, const coverage *cases, const char *folder,
                      const char *ending, FILE *messages)
{
    campaign_record found;
    char *path = piece_path(folder, number, ending);
    finding what = read_found(by, cases, path, messages, &found);
    double part = what == OF_OTHERS ? -1 : 0;
    if (what == OWN) {
        part = (double)coverage_total(&found.done) / (double)coverage_total(cases);
        record_free(&found);
    }
    free(path);
    return part;
}

double piece_done(const plan *by, size_t number, const coverage *cases, const char *folder,
                  FILE *messages)
{
    double done = part_of(by, number, cases, folder, ".json", messages);
    if (done < 0 || done == 1)
        return done;
    if (done > 0)
        complain(messages, folder, "piece %zu: its file has not all cases of it", number);
    return fmin(part_of(by, number, cases, folder, ".part", messages), nextafter(1, 0));
}

/* What is under way, static so that a signal finds it. */
static struct {
    const plan *by;
    size_t number;
    sure_shape shape;
    regime which;
    uint64_t index;
    campaign_record record;
    char *part;
    allowance left;
    FILE *messages;
} now;

static const int endings[] = {SIGXCPU, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL};
#define ENDINGS (sizeof endings / sizeof *endings)

/* SA_RESETHAND has put the default back, so that the signal raised here ends the program. */
static void die(int signal_number)
{
    char line[256];
    int length = snprintf(line, sizeof line, "piece %zu: %s in case %" PRIu64 " of %s %s\n",
                          now.number, signal_number == SIGXCPU ? "no end" : "a crash", now.index,
                          sure_shape_name(now.shape), regime_name(now.which));
    if (write(STDERR_FILENO, line, (size_t)length) == length)
        raise(signal_number);
    raise(signal_number);
}

static void guard(void)
{
    struct sigaction dying = {.sa_handler = die, .sa_flags = (int)SA_RESETHAND};
    for (size_t i = 0; i < ENDINGS; i++)
        sigaction(endings[i], &dying, NULL);
}

static void report(const sure_case *question, const char *what)
{
    record_broken(&now.record, now.shape, now.which, now.index, question, what);
}

static bool keep_part(void)
{
    allowance_kept(&now.left);
    return record_write(&now.record, now.part, now.messages);
}

static bool ask(index_range range)
{
    index_ranges *done = &now.record.done.of[now.shape][now.which];
    for (now.index = range.first; now.index < range.end; now.index++) {
        sure_case question = regime_case(now.shape, now.which, now.by->seed, now.index);
        campaign_check(now.by->against, &question, campaign_more_of(now.index), report,
                       &now.record.pairs[now.shape][now.which]);
        worst_look(&question, now.which, now.index, now.record.worst[now.shape]);
        bool last = now.index + 1 == range.end;
        allowance_state left =
            now.index % CLOCKED == 0 ? allowance_look(&now.left) : ALLOWANCE_LEFT;
        bool due = left == ALLOWANCE_DUE, over = left == ALLOWANCE_OVER;
        bool hopeless = json_array_size(now.record.broken) > BROKEN_MOST;
        if (!last && !due && !over && !hopeless)
            continue;
        if (!ranges_add(done, (index_range){range.first, now.index + 1}))
            abort();
        range.first = now.index + 1;
        if (((due && !last) || over || hopeless) && !keep_part())
            return false;
        if (over)
            return complain(now.messages, now.part, "no processor time is left");
        if (hopeless)
            return complain(now.messages, now.part, "more than %d broken promises", BROKEN_MOST);
    }
    return true;
}

static bool ask_pair(void *context, sure_shape shape, regime which)
{
    const coverage *cases = context;
    const index_ranges *wanted = &cases->of[shape][which];
    index_range gap;
    now.shape = shape;
    now.which = which;
    for (size_t i = 0; i < wanted->count; i++) {
        while (ranges_gap(&now.record.done.of[shape][which], wanted->of[i], &gap)) {
            if (!ask(gap))
                return false;
        }
    }
    return true;
}

bool piece_work(const plan *by, size_t number, const coverage *cases, const char *folder,
                double keep, unsigned long limit, FILE *messages)
{
    char *path = piece_path(folder, number, ".json");
    now.by = by;
    now.number = number;
    now.part = piece_path(folder, number, ".part");
    now.left = allowance_of(keep, limit);
    now.messages = messages;
    guard();
    if (read_found(by, cases, now.part, messages, &now.record) != OWN)
        record_begin(by->against, by->seed, &now.record);
    bool done = each_pair(ask_pair, (void *)cases) && record_write(&now.record, path, messages);
    if (done)
        unlink(now.part);
    record_free(&now.record);
    free(now.part);
    free(path);
    return done;
}
