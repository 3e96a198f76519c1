#define _POSIX_C_SOURCE 200809L

#include "args.h"
#include "choice.h"
#include "commands.h"

#include "../judge/judging_report.h"
#include "../support/atomic_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_COUNT 2000
#define DEFAULT_TIME_LIMIT 5
#define MOST_TIME_LIMIT 3600
#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

enum {
    HELP, TIER, CANDIDATE, COMMAND, ANSWERS, CASES, SHAPE, REGIME, COUNT, SEED, TRUTH, INPUTS,
    TIME_LIMIT, REQUIRE, JSON
};
static const args_option options[] = {
    [HELP] = {"--help", false},
    [TIER] = {"--tier", true},
    [CANDIDATE] = {"--candidate", true},
    [COMMAND] = {"--command", true},
    [ANSWERS] = {"--answers", true},
    [CASES] = {"--cases", true},
    [SHAPE] = {"--shape", true},
    [REGIME] = {"--regime", true},
    [COUNT] = {"--count", true},
    [SEED] = {"--seed", true},
    [TRUTH] = {"--truth", true},
    [INPUTS] = {"--inputs", true},
    [TIME_LIMIT] = {"--time-limit", true},
    [REQUIRE] = {"--require", true},
    [JSON] = {"--json", true},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help;
    int subject; /* TIER, CANDIDATE, COMMAND or ANSWERS; HELP: none yet */
    const char *name;
    sure_tier tier;
    const char *cases;
    choice pairs;
    uint64_t count, seed;
    bool on_the_fly; /* said so by --shape, --regime, --count or --seed */
    bool by_reference;
    candidate_options how;
    promises required;
    const char *json;
} request;

static void print_help(void)
{
    fputs("Usage: surehit judge CANDIDATE [OPTION ...]\n"
          "\n"
          "Asks a routine for ray-surface intersections many cases and holds its answers\n"
          "against the right ones: wrong decisions, errors of t and normal, breaches of the\n"
          "contract, time, and the worst cases, made simple.\n"
          "\n"
          "The candidate, one of:\n"
          "  --tier TIER        float32, textbook, stable, certain or exact\n"
          "  --candidate FILE   a shared library (surehit/candidate.h says what it defines)\n"
          "  --command COMMAND  a program that reads case lines and writes answer lines\n"
          "  --answers FILE     answer lines that it wrote before; - is standard input\n"
          "\n"
          "The cases:\n"
          "  --cases FILE       case lines; - is standard input. Otherwise they are made:\n"
          "  --shape SHAPE      plane, disc, sphere, cylinder or cone (default: all that the\n"
          "                     candidate answers); may be repeated\n"
          "  --regime REGIME    the kind of cases (default: all); may be repeated\n"
          "  --count N          of each shape and regime (default " TEXT(DEFAULT_COUNT) ")\n"
          "  --seed K           others of the same kind (default 0)\n"
          "\n"
          "  --truth exact      the library's `exact` tier (default)\n"
          "  --truth reference  surehit-reference, by CGAL\n"
          "  --inputs float     the candidate computes in float: its cases are rounded first\n"
          "  --inputs double    (default: as the shared library has its functions)\n"
          "  --time-limit S     seconds for the answer to a case (default "
          TEXT(DEFAULT_TIME_LIMIT) ")\n"
          "  --require LIST     promises, separated by commas: decisions, decisions<=SHARE,\n"
          "                     contract, t<=Nulp, t<=RELATIVE, normal<=Nulp, normal<=X\n"
          "  --json FILE        everything, for programs\n",
          stdout);
    choice_print_regimes();
    fputs("\n"
          "Exit status: 0 judged, and what was required is kept; 1 it is not, or output\n"
          "could not be written; 2 wrong usage, or no candidate, cases, answers or truth.\n",
          stdout);
}

/* The words. */

static int set_subject(const args *line, int option, const char *value, request *asked)
{
    if (asked->subject != HELP)
        return args_wrong(line, "a second candidate", value);
    asked->subject = option;
    asked->name = value;
    if (option == TIER && !sure_tier_from_name(value, &asked->tier))
        return args_wrong_value(line, "--tier", value,
                                "float32, textbook, stable, certain or exact");
    return 0;
}

static int set_number(const args *line, int option, const char *value, uint64_t least,
                      uint64_t *number)
{
    if (args_number(value, least, UINT64_MAX, number))
        return 0;
    return args_wrong_value(line, options[option].name, value,
                            least > 0 ? "a whole number above 0" : "a whole number");
}

static int set_truth(const args *line, const char *value, request *asked)
{
    asked->by_reference = strcmp(value, "reference") == 0;
    if (asked->by_reference || strcmp(value, "exact") == 0)
        return 0;
    return args_wrong_value(line, "--truth", value, "exact or reference");
}

static int set_inputs(const args *line, const char *value, request *asked)
{
    asked->how.inputs = strcmp(value, "float") == 0 ? INPUTS_FLOAT : INPUTS_DOUBLE;
    if (asked->how.inputs == INPUTS_FLOAT || strcmp(value, "double") == 0)
        return 0;
    return args_wrong_value(line, "--inputs", value, "float or double");
}

static int set_time_limit(const args *line, const char *value, request *asked)
{
    char *end;
    double seconds = strtod(value, &end);
    if (*end != '\0' || !(seconds >= 0.001 && seconds <= MOST_TIME_LIMIT))
        return args_wrong_value(line, "--time-limit", value,
                                "seconds from 0.001 to " TEXT(MOST_TIME_LIMIT));
    asked->how.time_limit = seconds;
    return 0;
}

static int set_required(const args *line, const char *value, request *asked)
{
    if (promises_read(value, &asked->required))
        return 0;
    return args_wrong_value(line, "--require", value,
                            "a list of decisions, contract, t<=Nulp, ...");
}

static int set_option(const args *line, int option, const char *value, request *asked)
{
    switch (option) {
    case HELP: asked->help = true; return 0;
    case CASES: asked->cases = value; return 0;
    case SHAPE: asked->on_the_fly = true; return choice_add_shape(line, value, &asked->pairs);
    case REGIME: asked->on_the_fly = true; return choice_add_regime(line, value, &asked->pairs);
    case COUNT: asked->on_the_fly = true; return set_number(line, COUNT, value, 1, &asked->count);
    case SEED: asked->on_the_fly = true; return set_number(line, SEED, value, 0, &asked->seed);
    case TRUTH: return set_truth(line, value, asked);
    case INPUTS: return set_inputs(line, value, asked);
    case TIME_LIMIT: return set_time_limit(line, value, asked);
    case REQUIRE: return set_required(line, value, asked);
    case JSON: asked->json = value; return 0;
    case ARGS_OPERAND: return args_wrong(line, "one word too many:", value);
    case ARGS_WRONG: return EXIT_USAGE;
    default: return set_subject(line, option, value, asked);
    }
}

static bool is_standard_input(const char *name)
{
    return name && strcmp(name, "-") == 0;
}

static int read_words(args *line, request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 && !asked->help &&
           (option = args_next(line, options, OPTIONS, &value)) != ARGS_END)
        status = set_option(line, option, value, asked);
    if (status != 0 || asked->help)
        return status;
    if (asked->subject == HELP)
        return args_wrong(line, "missing", "--tier, --candidate, --command or --answers");
    if (asked->cases && asked->on_the_fly)
        return args_wrong(line, "cases are given and to be made:", asked->cases);
    if (is_standard_input(asked->cases) && asked->subject == ANSWERS &&
        is_standard_input(asked->name))
        return args_wrong(line, "cases and answers can't both be", "-");
    return 0;
}

/* The parties. */

static int complain(const char *message)
{
    fprintf(stderr, "surehit judge: error: %s\n", message);
    return EXIT_USAGE;
}

static FILE *open_input(const char *name, char *message)
{
    FILE *in = is_standard_input(name) ? stdin : fopen(name, "r");
    if (!in)
        snprintf(message, CANDIDATE_MESSAGE, "%s: cannot be read", name);
    return in;
}

static bool open_candidate(const request *asked, judging_parties *parties, char *message)
{
    switch (asked->subject) {
    case TIER: parties->asked = candidate_of_tier(asked->tier, &asked->how, message); break;
    case CANDIDATE: parties->asked = candidate_of_library(asked->name, &asked->how, message); break;
    case COMMAND: parties->asked = candidate_of_command(asked->name, &asked->how, message); break;
    default:
        parties->answers = open_input(asked->name, message);
        parties->answers_name = is_standard_input(asked->name) ? "standard input" : asked->name;
        parties->in = asked->how.inputs == INPUTS_FLOAT ? PRECISION_FLOAT : PRECISION_DOUBLE;
        return parties->answers != NULL;
    }
    return parties->asked != NULL;
}

static bool open_parties(const request *asked, judging_parties *parties, char *message)
{
    parties->known = truth_exact();
    return open_candidate(asked, parties, message) &&
           (!asked->by_reference || truth_reference(&asked->how, &parties->known, message));
}

static void close_parties(judging_parties *parties)
{
    candidate_close(parties->asked);
    truth_close(&parties->known);
    if (parties->answers && parties->answers != stdin)
        fclose(parties->answers);
}

/* How the candidate is named on a command line; NULL where it can't be asked again. */
static const char *option_for(const request *asked)
{
    static char text[2048];
    const char *inputs = asked->how.inputs == INPUTS_FLOAT ? " --inputs float" : "";
    const char *by = asked->by_reference ? " --truth reference" : "";
    if (asked->subject == ANSWERS)
        return NULL;
    snprintf(text, sizeof text, asked->subject == TIER ? "%s %s%s%s" : "%s '%s'%s%s",
             options[asked->subject].name, asked->name, inputs, by);
    return text;
}

/* The judgement. */

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
static bool check_shapes(const request *asked, const judging_parties *parties, char *message)
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (!asked->pairs.shapes[shape] || is_answered(parties, shape))
            continue;
        snprintf(message, CANDIDATE_MESSAGE, "%s: no symbol sure_candidate_%s", asked->name,
                 sure_shape_name((sure_shape)shape));
        return false;
    }
    return true;
}

static bool judge_made(const request *asked, const judging_parties *parties, judging *by,
                       findings *all, char *message)
{
    if (!check_shapes(asked, parties, message))
        return false;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int which = 0; which < REGIMES; which++) {
            if (!choice_has(&asked->pairs, shape, which) || !is_answered(parties, shape))
                continue;
            judging_row *row = &all->rows[all->row_count];
            if (!judging_regime(by, (sure_shape)shape, (regime)which, asked->seed, asked->count,
                                row, message))
                return false;
            judging_print_row(stdout, row);
            fflush(stdout);
            all->row_count++;
        }
    }
    if (all->row_count > 0)
        return true;
    snprintf(message, CANDIDATE_MESSAGE, "the shape has no such regime");
    return false;
}

static bool judge_given(const request *asked, judging *by, findings *all, char *message)
{
    const char *name = is_standard_input(asked->cases) ? "standard input" : asked->cases;
    FILE *cases = open_input(asked->cases, message);
    bool done = cases && judging_given(by, cases, name, all->rows, &all->row_count, message);
    for (int i = 0; done && i < all->row_count; i++)
        judging_print_row(stdout, &all->rows[i]);
    if (cases && cases != stdin)
        fclose(cases);
    return done;
}

static bool judge_all(const request *asked, const judging_parties *parties,
                      const judging_subject *subject, findings *all, char *message)
{
    judging *by = judging_new(parties);
    if (!by) {
        snprintf(message, CANDIDATE_MESSAGE, "no memory");
        return false;
    }
    judging_print_head(stdout, subject);
    bool done = asked->cases ? judge_given(asked, by, all, message)
                             : judge_made(asked, parties, by, all, message);
    done = done && judging_answers_end(by, message);
    if (done) {
        judging_print_breaches(stdout, all->rows, all->row_count);
        fflush(stdout);
        all->worst_count = worst_find(by, all->rows, all->row_count, all->worst);
        judging_print_worst(stdout, subject, all->worst, all->worst_count);
    }
    judging_free(by);
    return done;
}

static int write_json(const request *asked, const judging_subject *subject, const findings *all)
{
    atomic_file file;
    if (!atomic_file_open(asked->json, stderr, &file))
        return EXIT_OUTPUT;
    judging_print_json(file.stream, subject, all->rows, all->row_count, all->worst,
                       all->worst_count, &asked->required);
    return atomic_file_finish(&file, stderr) ? 0 : EXIT_OUTPUT;
}

static int judge(const request *asked, const judging_parties *parties)
{
    static findings all;
    char message[CANDIDATE_MESSAGE];
    bool promising = asked->subject == TIER && asked->tier >= SURE_TIER_CERTAIN;
    const judging_subject subject = {
        .candidate = asked->name,
        .option = option_for(asked),
        .truth = asked->by_reference ? "reference" : "exact",
        .is_tier = asked->subject == TIER,
        .by_like = promising && !asked->by_reference,
        .counts_text = parties->asked && parties->asked->counts_text,
        .seed = asked->seed,
        .count = asked->cases ? 0 : asked->count,
    };
    if (!judge_all(asked, parties, &subject, &all, message))
        return complain(message);
    int broken = judging_print_promises(stdout, &asked->required, all.rows, all.row_count);
    int status = asked->json ? write_json(asked, &subject, &all) : 0;
    return status == 0 && broken > 0 ? EXIT_OUTPUT : status;
}

int command_judge(int count, char **words)
{
    args line = {"surehit judge", words, count, 0, false};
    request asked = {.count = DEFAULT_COUNT, .how = {.time_limit = DEFAULT_TIME_LIMIT}};
    judging_parties parties = {0};
    char message[CANDIDATE_MESSAGE];
    int status = read_words(&line, &asked);
    if (status == 0 && asked.help) {
        print_help();
        return args_flush_output(&line, 0);
    }
    if (status == 0 && asked.json && !atomic_file_possible(asked.json, stderr))
        status = EXIT_OUTPUT;
    if (status == 0)
        status = open_parties(&asked, &parties, message) ? judge(&asked, &parties)
                                                         : complain(message);
    close_parties(&parties);
    return status == EXIT_USAGE ? status : args_flush_output(&line, status);
}
