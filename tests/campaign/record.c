/* SPDX-License-Identifier: MIT */
#include "record.h"

#include "complain.h"
#include "json_file.h"
#include "made.h"

#include <inttypes.h>
#include <stdlib.h>

bool each_pair(pair_visitor *visit, void *context)
{
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime r = 0; r < REGIMES; r++) {
            if (regime_applies(shape, r) && !visit(context, shape, r))
                return false;
        }
    }
    return true;
}

bool coverage_within(const coverage *a, const coverage *b)
{
    index_range gap;
    for (int p = 0; p < SURE_SHAPES * REGIMES; p++) {
        const index_ranges *ranges = &a->of[p / REGIMES][p % REGIMES];
        for (size_t i = 0; i < ranges->count; i++) {
            if (ranges_gap(&b->of[p / REGIMES][p % REGIMES], ranges->of[i], &gap))
                return false;
        }
    }
    return true;
}

uint64_t coverage_total(const coverage *of)
{
    uint64_t total = 0;
    for (int p = 0; p < SURE_SHAPES * REGIMES; p++)
        total += ranges_total(&of->of[p / REGIMES][p % REGIMES]);
    return total;
}

void coverage_free(coverage *of)
{
    for (int p = 0; p < SURE_SHAPES * REGIMES; p++)
        free(of->of[p / REGIMES][p % REGIMES].of);
    *of = (coverage){0};
}

json_t *pair_json(const coverage *of, sure_shape shape, regime which)
{
    return json_pack("{s:s, s:s, s:o}", "shape", sure_shape_name(shape), "regime",
                     regime_name(which), "ranges", ranges_json(&of->of[shape][which]));
}

/* Which pair a line is of. */
static bool take_names(const json_t *line, sure_shape *shape, regime *which)
{
    const char *shape_name = json_string_value(json_object_get(line, "shape"));
    const char *name = json_string_value(json_object_get(line, "regime"));
    return shape_name && name && sure_shape_from_name(shape_name, shape) &&
           regime_from_name(name, which) && regime_applies(*shape, *which);
}

const char *pair_take(const json_t *line, coverage *to, sure_shape *shape, regime *which)
{
    if (!take_names(line, shape, which))
        return "expected a shape and one of its regimes";
    if (to->of[*shape][*which].count > 0)
        return "a pair of shape and regime is there twice";
    return ranges_take(json_object_get(line, "ranges"), &to->of[*shape][*which]);
}

/* The first line. */

static const campaign_truth *const truths[] = {
#ifdef WITH_REFERENCE
    &truth_by_reference,
#endif
    &truth_by_exact, &truth_of_floats};
enum { TRUTHS = sizeof truths / sizeof *truths };

const campaign_truth *truth_named(const char *name)
{
    for (int i = 0; i < TRUTHS; i++) {
        if (!name || strcmp(truths[i]->name, name) == 0)
            return truths[i];
    }
    return NULL;
}

static json_t *asked_json(const campaign_truth *against, uint64_t seed)
{
    bool by_exact = against->first == SURE_TIER_CERTAIN; /* in floats, too */
    return json_pack("{s:i, s:s, s:o, s:s, s:s, s:s, s:s, s:s}", "surehit campaign", 1, "against",
                     against->name, "seed", json_bits(seed), "sources", MADE_SOURCES, "compiler",
                     MADE_COMPILER, "flags", MADE_FLAGS, "architecture", MADE_ARCHITECTURE,
                     "reference", by_exact ? "none" : MADE_REFERENCE);
}

const char *asked_take(const json_t *line, const campaign_truth **against, uint64_t *seed)
{
    const char *name = json_string_value(json_object_get(line, "against"));
    if (json_integer_value(json_object_get(line, "surehit campaign")) != 1 || !name ||
        !json_take_bits(json_object_get(line, "seed"), seed))
        return "is nothing of a campaign, or of another version";
    *against = truth_named(name);
    return *against ? NULL : "is held against what this program does not have";
}

void record_begin(const campaign_truth *against, uint64_t seed, campaign_record *empty)
{
    *empty = (campaign_record){.against = against,
                               .seed = seed,
                               .asked = asked_json(against, seed),
                               .broken = json_array()};
}

void record_free(campaign_record *of)
{
    coverage_free(&of->done);
    json_decref(of->asked);
    json_decref(of->broken);
    of->asked = of->broken = NULL;
}

pair_tally record_sum(const campaign_record *of)
{
    pair_tally sum = {0};
    for (int p = 0; p < SURE_SHAPES * REGIMES; p++)
        pair_tally_add(&sum, &of->pairs[p / REGIMES][p % REGIMES]);
    return sum;
}

/* Reading. */

/* Every case is counted once. */
static const char *take_pair(const json_t *line, campaign_record *to)
{
    sure_shape shape;
    regime which;
    const char *wrong = pair_take(line, &to->done, &shape, &which);
    if (wrong)
        return wrong;
    pair_tally *sum = &to->pairs[shape][which];
    if (!json_take_named_counts(json_object_get(line, "counts"), tally_count_name, (uint64_t *)sum,
                                TALLY_COUNTS))
        return "expected counts by their names";
    return sum->cases == ranges_total(&to->done.of[shape][which]) &&
                   sum->cases == sum->hits + sum->misses + sum->invalid
               ? NULL
               : "the counts are of other cases";
}

/* Of a line with a broken promise, which is of a case that was asked. */
static const char *take_broken(json_t *line, campaign_record *to)
{
    sure_shape shape;
    regime which;
    uint64_t index;
    index_range gap;
    if (!take_names(line, &shape, &which) ||
        !json_take_count(json_object_get(line, "index"), &index) ||
        !json_is_string(json_object_get(line, "promise")))
        return "expected a pair of shape and regime, or a broken promise";
    json_array_append(to->broken, line);
    return ranges_gap(&to->done.of[shape][which], (index_range){index, index + 1}, &gap)
               ? "a broken promise is of a case that was not asked"
               : NULL;
}

/* Of cases that were asked. */
static const char *take_worst(const json_t *line, campaign_record *to)
{
    const char *shape_name = json_string_value(json_object_get(line, "shape"));
    const char *question = json_string_value(json_object_get(line, "question"));
    sure_shape shape;
    int of = 0;
    index_range gap;
    while (of < WORST_QUESTIONS && question && strcmp(question, worst_names[of]) != 0)
        of++;
    if (!shape_name || !question || !sure_shape_from_name(shape_name, &shape) ||
        of == WORST_QUESTIONS || to->worst[shape][of].count > 0)
        return "expected one line of worst cases of a shape and a question";
    worst_calls *read = &to->worst[shape][of];
    const char *wrong = worst_calls_take(json_object_get(line, "worst"), read);
    for (int i = 0; i < read->count && !wrong; i++) {
        uint64_t index = read->list[i].index;
        if (ranges_gap(&to->done.of[shape][read->list[i].which], (index_range){index, index + 1},
                       &gap))
            wrong = "a worst case was not asked";
    }
    return wrong;
}

static const char *take_line(json_t *line, campaign_record *to)
{
    if (json_object_get(line, "worst"))
        return take_worst(line, to);
    return json_object_get(line, "ranges") ? take_pair(line, to) : take_broken(line, to);
}

static const char *take_lines(const json_t *lines, campaign_record *read)
{
    size_t i;
    json_t *line;
    const char *wrong = asked_take(json_array_get(lines, 0), &read->against, &read->seed);
    read->asked = json_incref(json_array_get(lines, 0));
    read->broken = json_array();
    json_array_foreach(lines, i, line)
    {
        if (i > 0 && !wrong)
            wrong = take_line(line, read);
    }
    if (!wrong && record_sum(read).broken != json_array_size(read->broken))
        wrong = "broken promises are missing";
    return wrong;
}

bool record_read(const char *path, FILE *messages, campaign_record *read)
{
    json_t *lines = sealed_read(path, messages);
    *read = (campaign_record){0};
    const char *wrong = lines ? take_lines(lines, read) : NULL;
    json_decref(lines);
    if (lines && !wrong)
        return true;
    record_free(read);
    if (wrong)
        complain(messages, path, "%s", wrong);
    return false;
}

/* Writing. */

typedef struct {
    const campaign_record *of;
    json_t *lines;
} writing;

static bool append_pair(void *context, sure_shape shape, regime which)
{
    const writing *w = context;
    if (w->of->done.of[shape][which].count == 0)
        return true;
    json_t *line = pair_json(&w->of->done, shape, which);
    json_object_set_new(line, "counts",
                        json_named_counts(tally_count_name,
                                          (const uint64_t *)&w->of->pairs[shape][which],
                                          TALLY_COUNTS));
    return json_array_append_new(w->lines, line) == 0;
}

static bool append_worst(const campaign_record *of, json_t *lines)
{
    bool appended = true;
    for (int i = 0; i < SURE_SHAPES * WORST_QUESTIONS; i++) {
        sure_shape shape = (sure_shape)(i / WORST_QUESTIONS);
        const worst_calls *worst = &of->worst[shape][i % WORST_QUESTIONS];
        if (worst->count > 0)
            appended &= json_array_append_new(
                            lines, json_pack("{s:s, s:s, s:o}", "shape", sure_shape_name(shape),
                                             "question", worst_names[i % WORST_QUESTIONS], "worst",
                                             worst_calls_json(worst))) == 0;
    }
    return appended;
}

bool record_write(const campaign_record *of, const char *path, FILE *messages)
{
    writing w = {of, json_array()};
    bool whole = json_array_append(w.lines, of->asked) == 0 && each_pair(append_pair, &w) &&
                 append_worst(of, w.lines) && json_array_extend(w.lines, of->broken) == 0;
    if (!whole) {
        json_decref(w.lines);
        w.lines = NULL;
    }
    return sealed_write(w.lines, path, messages);
}

/* Adding. */

/* Is the line of an earlier case? */
static bool is_before(const json_t *a, const json_t *b)
{
    sure_shape shapes[2];
    regime regimes[2];
    if (!take_names(a, &shapes[0], &regimes[0]) || !take_names(b, &shapes[1], &regimes[1]))
        return false;
    if (shapes[0] != shapes[1] || regimes[0] != regimes[1])
        return shapes[0] != shapes[1] ? shapes[0] < shapes[1] : regimes[0] < regimes[1];
    return json_integer_value(json_object_get(a, "index")) <
           json_integer_value(json_object_get(b, "index"));
}

/* Behind those of the same case. */
static void insert_broken(json_t *lines, json_t *line)
{
    size_t at = json_array_size(lines);
    while (at > 0 && is_before(line, json_array_get(lines, at - 1)))
        at--;
    json_array_insert(lines, at, line);
}

static void print_answer(const sure_case *question, sure_tier tier, char line[CASE_LINE_MAX])
{
    case_answer answer = case_answer_of(question, tier);
    case_answer_print(&answer, line);
}

void record_broken(campaign_record *to, sure_shape shape, regime which, uint64_t index,
                   const sure_case *question, const char *promise)
{
    char line[CASE_LINE_MAX], certain[CASE_LINE_MAX], exact[CASE_LINE_MAX];
    case_print(question, line);
    print_answer(question, SURE_TIER_CERTAIN, certain);
    print_answer(question, SURE_TIER_EXACT, exact);
    json_t *broken =
        json_pack("{s:s, s:s, s:I, s:s, s:s, s:s, s:s}", "shape", sure_shape_name(shape), "regime",
                  regime_name(which), "index", (json_int_t)index, "case", line, "promise", promise,
                  "certain", certain, "exact", exact);
    insert_broken(to->broken, broken);
    json_decref(broken);
}

bool record_overlap(const campaign_record *a, const campaign_record *b, char words[128])
{
    index_range both;
    for (int p = 0; p < SURE_SHAPES * REGIMES; p++) {
        sure_shape shape = (sure_shape)(p / REGIMES);
        regime which = (regime)(p % REGIMES);
        if (!ranges_overlap(&a->done.of[shape][which], &b->done.of[shape][which], &both))
            continue;
        snprintf(words, 128, "cases %" PRIu64 " to %" PRIu64 " of %s %s", both.first, both.end - 1,
                 sure_shape_name(shape), regime_name(which));
        return true;
    }
    return false;
}

void record_add(campaign_record *to, campaign_record *from)
{
    size_t i;
    json_t *line;
    for (int p = 0; p < SURE_SHAPES * REGIMES; p++) {
        const index_ranges *more = &from->done.of[p / REGIMES][p % REGIMES];
        for (size_t j = 0; j < more->count; j++) {
            if (!ranges_add(&to->done.of[p / REGIMES][p % REGIMES], more->of[j]))
                abort();
        }
        pair_tally_add(&to->pairs[p / REGIMES][p % REGIMES],
                       &from->pairs[p / REGIMES][p % REGIMES]);
    }
    for (int s = 0; s < SURE_SHAPES * WORST_QUESTIONS; s++) {
        const worst_calls *more = &from->worst[s / WORST_QUESTIONS][s % WORST_QUESTIONS];
        for (int j = 0; j < more->count; j++)
            worst_add(&to->worst[s / WORST_QUESTIONS][s % WORST_QUESTIONS], more->list[j]);
    }
    json_array_foreach(from->broken, i, line) insert_broken(to->broken, line);
    record_free(from);
}
