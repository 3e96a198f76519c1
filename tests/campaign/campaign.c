/* SPDX-License-Identifier: MIT */
/* The campaign: the tiers certain and exact against who knows the truth, case by case, over every
 * regime of every shape, in pieces that any machine works off (docs/cluster.md). */
#include "atomic_file.h"
#include "complain.h"
#include "piece.h"

#include <inttypes.h>
#include <limits.h>
#include <popt.h>
#include <stdlib.h>

enum { BROKEN = 1, WRONG_USAGE = 2 };

/* Options of all commands. */
static double cases, seconds = 600, keep = 30;
static long long seed = 1, pieces, limit;
static const char *output, *against, *after, *shape_name, *chosen_regime;
static sure_shape shape;
static regime which;

/* Operands. */
static const char **operands;
static int operand_count;

static int fails(bool good)
{
    return good ? EXIT_SUCCESS : WRONG_USAGE;
}

static int make_plan(void)
{
    plan_wish wish = {.against = truth_named(against),
                      .seed = (uint64_t)seed,
                      .cases = cases,
                      .seconds = seconds,
                      .pieces = (uint64_t)pieces,
                      .shape = shape_name ? (int)shape : -1,
                      .regime = chosen_regime ? (int)which : -1};
    static campaign_record before, own;
    if (!wish.against)
        return fails(complain(stderr, "campaign", "%s: nobody of that name is known", against));
    if (after) {
        if (!record_read(after, stderr, &before))
            return WRONG_USAGE;
        wish.after = &before;
        record_begin(wish.against, wish.seed, &own);
        const char *other = asked_difference(own.asked, before.asked);
        if (other)
            return fails(
                complain(stderr, after, "can't be gone on from: it has another %s", other));
    }
    return (int)plan_write(&wish, output, stderr);
}

static int work(void)
{
    plan by;
    coverage wanted;
    size_t number;
    if (!piece_number(operands[1], stderr, &number) || !plan_read(operands[0], stderr, &by))
        return WRONG_USAGE;
    if (!plan_piece(&by, number, stderr, &wanted))
        return WRONG_USAGE;
    double done = piece_done(&by, number, &wanted, operands[2], stderr);
    int ends = done < 0 ? WRONG_USAGE : EXIT_SUCCESS;
    if (done >= 0 && done < 1 &&
        !piece_work(&by, number, &wanted, operands[2], keep, (unsigned long)limit, stderr))
        ends = BROKEN;
    coverage_free(&wanted);
    manifest_free(&by.of);
    return ends;
}

typedef struct {
    plan by;
    bool readable;
} asking;

static double part_done(void *context, size_t number)
{
    asking *of = context;
    coverage wanted;
    if (!of->readable || !plan_piece(&of->by, number, stderr, &wanted))
        return of->readable = false;
    double done = piece_done(&of->by, number, &wanted, operands[1], stderr);
    coverage_free(&wanted);
    return done;
}

static int status(void)
{
    asking of = {.readable = true};
    if (!plan_read(operands[0], stderr, &of.by))
        return WRONG_USAGE;
    pieces_state is = pieces_status(&of.by.of, part_done, &of, stderr);
    manifest_free(&of.by.of);
    return of.readable ? (int)is : WRONG_USAGE;
}

/* Adding. */

/* Who of the files before has these cases, too? Read once more to say so. */
static bool complain_of_overlap(const campaign_record *next, char *const *paths, int at)
{
    static campaign_record other;
    char words[128] = "";
    bool found = false;
    int i = 0;
    for (; i < at && !found; i++) {
        found = record_read(paths[i], stderr, &other) && record_overlap(&other, next, words);
        record_free(&other);
    }
    return complain(stderr, paths[at], "%s are in %s, too", words,
                    found ? paths[i - 1] : "another");
}

static bool add_files(char *const *paths, int count, campaign_record *sum)
{
    static campaign_record next;
    char words[128];
    for (int i = 0; i < count; i++) {
        if (!record_read(paths[i], stderr, i == 0 ? sum : &next))
            return false;
        const char *other = i > 0 ? asked_difference(sum->asked, next.asked) : NULL;
        if (other)
            return complain(stderr, paths[i], "can't be added to %s: it has another %s", paths[0],
                            other);
        if (i > 0 && record_overlap(sum, &next, words))
            return complain_of_overlap(&next, paths, i);
        if (i > 0)
            record_add(sum, &next);
    }
    return true;
}

static void print_sum(const pair_tally *sum)
{
    printf("%" PRIu64 " cases: %" PRIu64 " hit, %" PRIu64 " miss, %" PRIu64 " invalid; %" PRIu64
           " normals, %" PRIu64 " intervals, %" PRIu64 " spawns; %" PRIu64
           " times half an ulp above the cap; %" PRIu64 " broken promises\n",
           sum->cases, sum->hits, sum->misses, sum->invalid, sum->normals, sum->intervals,
           sum->spawns, sum->out_of_cap, sum->broken);
}

static void print_broken(const campaign_record *of)
{
    size_t i;
    const json_t *line;
    json_array_foreach(of->broken, i, line) printf(
        "%s\n  %s\n  certain %s\n  exact   %s\n", json_string_value(json_object_get(line, "case")),
        json_string_value(json_object_get(line, "promise")),
        json_string_value(json_object_get(line, "certain")),
        json_string_value(json_object_get(line, "exact")));
}

/* Of enough cases of each pair some are hits and some are misses; not of floats, in which needles,
 * for one, lie elsewhere. */
static bool is_two_sided(void *context, sure_shape of_shape, regime of_regime)
{
    enum { ENOUGH = 1000 };
    const campaign_record *of = context;
    const pair_tally *pair = &of->pairs[of_shape][of_regime];
    if (of->against->floats || pair->cases < ENOUGH || (pair->hits > 0 && pair->misses > 0))
        return true;
    printf("%s %s: hits or misses alone\n", sure_shape_name(of_shape), regime_name(of_regime));
    return false;
}

static bool may_be_written(const folder_listing *inputs)
{
    int i = 0;
    while (i < inputs->count && !folder_is_same_file(output, inputs->names[i]))
        i++;
    return i == inputs->count ||
           complain(stderr, output, "may not take the place of a file that is read");
}

static int merge(void)
{
    static campaign_record sum;
    folder_listing all = {0};
    bool added = pieces_list(operands, operand_count, stderr, &all) && may_be_written(&all) &&
                 add_files(all.names, all.count, &sum);
    folder_free(&all);
    if (!added)
        return WRONG_USAGE;
    pair_tally total = record_sum(&sum);
    bool written = record_write(&sum, output, stderr);
    print_broken(&sum);
    print_sum(&total);
    bool good = written && total.broken == 0 && each_pair(is_two_sided, &sum);
    record_free(&sum);
    return good ? EXIT_SUCCESS : BROKEN;
}

/* A row for each regime of a shape: what docs/accuracy.md is made of. */
typedef struct {
    FILE *to;
    const campaign_record *of;
} table_rows;

static bool put_row(void *context, sure_shape of_shape, regime of_regime)
{
    const table_rows *rows = context;
    const uint64_t *counts = (const uint64_t *)&rows->of->pairs[of_shape][of_regime];
    fprintf(rows->to, "%s,%s", sure_shape_name(of_shape), regime_name(of_regime));
    for (int i = 0; i < TALLY_COUNTS; i++)
        fprintf(rows->to, ",%" PRIu64, counts[i]);
    fputc('\n', rows->to);
    return true;
}

static int table(void)
{
    static campaign_record of;
    atomic_file file;
    if (!record_read(operands[0], stderr, &of))
        return WRONG_USAGE;
    if (!atomic_file_open(output, stderr, &file))
        return BROKEN;
    fprintf(file.stream, "seed,%" PRIu64 "\nshape,regime", of.seed);
    for (int i = 0; i < TALLY_COUNTS; i++)
        fprintf(file.stream, ",%s", tally_count_name(i));
    fputc('\n', file.stream);
    each_pair(put_row, &(table_rows){file.stream, &of});
    record_free(&of);
    return atomic_file_finish(&file, stderr) ? EXIT_SUCCESS : BROKEN;
}

/* Lines of CSV: what docs/worst_cases.md is made of. Bits are counted once more. */
static bool put_worst(FILE *to, const campaign_record *of, sure_shape one, worst_question question)
{
    const worst_calls *calls = &of->worst[one][question];
    char line[CASE_LINE_MAX];
    for (int i = 0; i < calls->count; i++) {
        const worst_call *call = &calls->list[i];
        sure_case asked = regime_case(one, call->which, of->seed, call->index);
        if (worst_bits(&asked, question) != call->bits)
            return complain(stderr, operands[0], "%s %s %" PRIu64 " does not need %d bits",
                            sure_shape_name(one), regime_name(call->which), call->index,
                            call->bits);
        case_print(&asked, line);
        fprintf(to, "%s,%s,%d,%d,%s,%" PRIu64 ",%s\n", sure_shape_name(one), worst_names[question],
                call->bits, worst_bound(one, question), regime_name(call->which), call->index,
                line);
    }
    return true;
}

static int worst(void)
{
    static campaign_record of;
    atomic_file file;
    bool told = true;
    if (!record_read(operands[0], stderr, &of))
        return WRONG_USAGE;
    if (!atomic_file_open(output, stderr, &file))
        return BROKEN;
    fprintf(file.stream, "shape,question,bits,bound,regime,index,case\n");
    for (int i = 0; i < SURE_SHAPES * WORST_QUESTIONS && told; i++)
        told = put_worst(file.stream, &of, (sure_shape)(i / WORST_QUESTIONS),
                         (worst_question)(i % WORST_QUESTIONS));
    record_free(&of);
    if (told)
        return atomic_file_finish(&file, stderr) ? EXIT_SUCCESS : BROKEN;
    atomic_file_discard(&file);
    return WRONG_USAGE;
}

/* Commands. */

#define OUTPUT                                                                                     \
    {                                                                                              \
        NULL, 'o', POPT_ARG_STRING, &output, 0, "the file that is written", "FILE"                 \
    }
static const struct poptOption of_plan[] = {
    OUTPUT,
    {"cases", 0, POPT_ARG_DOUBLE, &cases, 0, "of all pairs of shape and regime together", "N"},
    {"seconds", 0, POPT_ARG_DOUBLE, &seconds, 0, "of the processor that a piece takes (600)", "S"},
    {"pieces", 0, POPT_ARG_LONGLONG, &pieces, 0, "so many, however long they take", "N"},
    {"seed", 0, POPT_ARG_LONGLONG, &seed, 0, "(1)", "S"},
    {"against", 0, POPT_ARG_STRING, &against, 0,
     "reference, or exact or floats, which need no CGAL", "WHO"},
    {"after", 0, POPT_ARG_STRING, &after, 0, "begin where its cases end", "RECORD"},
    {"shape", 0, POPT_ARG_STRING, &shape_name, 0, "no other", "NAME"},
    {"regime", 0, POPT_ARG_STRING, &chosen_regime, 0, "no other", "NAME"},
    POPT_AUTOHELP POPT_TABLEEND};
static const struct poptOption of_work[] = {
    {"limit", 0, POPT_ARG_LONGLONG, &limit, 0, "of the processor, then it ends (0: none)", "S"},
    {"keep", 0, POPT_ARG_DOUBLE, &keep, 0, "of the processor, then what is done is kept (30)", "S"},
    POPT_AUTOHELP POPT_TABLEEND};
static const struct poptOption of_status[] = {POPT_AUTOHELP POPT_TABLEEND};
static const struct poptOption of_merge[] = {OUTPUT, POPT_AUTOHELP POPT_TABLEEND};

static const struct {
    const char *name, *usage;
    const struct poptOption *options;
    int least, most; /* operands */
    int (*run)(void);
} commands[] = {
    {"plan", "--cases N -o MANIFEST [OPTION...]", of_plan, 0, 0, make_plan},
    {"work", "MANIFEST NUMBER FOLDER [OPTION...]", of_work, 3, 3, work},
    {"status", "MANIFEST FOLDER", of_status, 2, 2, status},
    {"merge", "FOLDER|RECORD... -o RECORD", of_merge, 1, INT_MAX, merge},
    {"table", "RECORD -o FILE.csv", of_merge, 1, 1, table},
    {"worst", "RECORD -o FILE.csv", of_merge, 1, 1, worst},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static int usage(void)
{
    for (int i = 0; i < COMMANDS; i++)
        fprintf(stderr, "%s campaign %s %s\n", i == 0 ? "usage:" : "      ", commands[i].name,
                commands[i].usage);
    return WRONG_USAGE;
}

static const char *bad_option(int c)
{
    if (commands[c].options == of_plan && !(cases >= 1 && cases <= (double)RANGES_MOST))
        return "--cases: expected how many";
    if (!(seconds > 0) || pieces < 0 || limit < 0 || !(keep > 0))
        return "expected numbers above 0";
    if (shape_name && !sure_shape_from_name(shape_name, &shape))
        return "--shape: unknown";
    if (chosen_regime && !regime_from_name(chosen_regime, &which))
        return "--regime: unknown";
    return NULL;
}

static int run(int c, int argc, const char **argv)
{
    poptContext context = poptGetContext("campaign", argc, argv, commands[c].options, 0);
    poptSetOtherOptionHelp(context, commands[c].usage);
    int read = poptGetNextOpt(context);
    operands = poptGetArgs(context);
    while (operands && operands[operand_count])
        operand_count++;
    bool unwritten = commands[c].options[0].arg == &output && !output;
    const char *wrong = read < -1 ? poptStrerror(read) : unwritten ? "-o FILE is missing" : NULL;
    if (!wrong)
        wrong = bad_option(c);
    if (!wrong && (operand_count < commands[c].least || operand_count > commands[c].most))
        wrong = commands[c].usage;
    int result = wrong ? fails(complain(stderr, commands[c].name, "%s", wrong)) : commands[c].run();
    poptFreeContext(context);
    return result;
}

int main(int argc, const char **argv)
{
    for (int i = 0; argc > 1 && i < COMMANDS; i++) {
        if (strcmp(argv[1], commands[i].name) == 0)
            return run(i, argc - 1, argv + 1);
    }
    return usage();
}
