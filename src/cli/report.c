#define _DEFAULT_SOURCE /* scandir, readlink, isatty */

#include "args.h"
#include "choice.h"
#include "commands.h"
#include "report_pictures.h"
#include "report_trade.h"

#include "../judge/bench/bench_report.h"
#include "../judge/report/report.h"
#include "../judge/truth.h"
#include "../support/progress.h"
#include "../support/atomic_file.h"

#include <dirent.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define DEFAULT_COUNT 2000
#define MOST_COUNT 1000000
#define MOST_PROCESSES 256
#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

/* Seen from the program, where both were built. */
#define PEERS_FOLDER "../../reference/peers/"
#define PEER_BEGIN "libpeer-"
#define PEER_END ".so"

enum { HELP, OUTPUT, JSON, TIER, CANDIDATE, SHAPE, REGIME, COUNT, SEED, SCENES, PROCESSES, QUIET };
static const args_option options[] = {
    [HELP] = {"--help", false},    [OUTPUT] = {"-o", true},
    [TIER] = {"--tier", true},     [CANDIDATE] = {"--candidate", true},
    [SHAPE] = {"--shape", true},   [REGIME] = {"--regime", true},
    [COUNT] = {"--count", true},   [SEED] = {"--seed", true},
    [SCENES] = {"--scenes", true}, [PROCESSES] = {"--processes", true},
    [QUIET] = {"--quiet", false},  [JSON] = {"--json", true},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help, quiet;
    const char *output, *json, *scenes;
    choice pairs;
    report_plan plan;
    report_candidate *list; /* room for REPORT_CANDIDATES */
    int count;
    trade trade;
} request;

static void print_help(void)
{
    fputs("Usage: surehit report -o REPORT.html [OPTION ...]\n"
          "\n"
          "Asks several routines for ray-surface intersections the same cases and writes one\n"
          "page: what each gets wrong, where, by how much, and what it costs. The page needs\n"
          "no other file.\n"
          "\n"
          "  -o FILE           the page\n"
          "  --json FILE       what it shows, for programs\n"
          "\n"
          "Who is asked (default: every tier, and the peers that were built with surehit):\n"
          "  --tier TIER       float32, textbook, stable, certain or exact; may be repeated\n"
          "  --candidate FILE  a shared library (surehit/candidate.h says what it defines);\n"
          "                    may be repeated\n"
          "\n"
          "What:\n"
          "  --shape SHAPE     plane, disc, sphere, cylinder or cone (default: all); may be\n"
          "                    repeated\n"
          "  --regime REGIME   the kind of cases (default: all); may be repeated\n"
          "  --count N         cases of each shape and regime (default " TEXT(
              DEFAULT_COUNT) "); "
                             "20 times as many\n"
                             "                    of typical, a quarter of bits and degenerate\n"
                             "  --seed K          others of the same kind (default 0)\n"
                             "  --scenes FOLDER   all scenes there (*.rt) by every tier, too\n"
                             "\n"
                             "  --processes N     that judge at a time (default: one a core)\n"
                             "  --quiet           no progress bar and no line at the end\n",
          stdout);
    choice_print_regimes();
    fputs("\n"
          "Exit status: 0 written, whatever it says; 1 output could not be written, or a\n"
          "candidate could not be asked (the page says why); 2 wrong usage, or a scene\n"
          "that cannot be read.\n",
          stdout);
}

/* Candidates. */

static report_candidate *add(request *asked)
{
    report_candidate *who = &asked->list[asked->count++];
    memset(who, 0, sizeof *who);
    return who;
}

static void add_tier(request *asked, sure_tier tier)
{
    report_candidate *who = add(asked);
    who->name = sure_tier_name(tier);
    who->tier = tier;
}

/* The file's name without what every such name has: libpeer-kahan.so is kahan. It lives as long as
 * the program. */
static const char *short_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    if (strncmp(name, PEER_BEGIN, strlen(PEER_BEGIN)) == 0)
        name += strlen(PEER_BEGIN);
    else if (strncmp(name, "lib", 3) == 0)
        name += 3;
    return strndup(name, strcspn(name, "."));
}

static bool add_library(request *asked, const char *path)
{
    report_candidate *who = add(asked);
    who->name = short_name(path);
    who->library = path;
    return who->name != NULL;
}

static int is_peer(const struct dirent *entry)
{
    size_t length = strlen(entry->d_name), end = strlen(PEER_END);
    return strncmp(entry->d_name, PEER_BEGIN, strlen(PEER_BEGIN)) == 0 && length > end &&
           strcmp(entry->d_name + length - end, PEER_END) == 0;
}

/* The folder, with its slash; false: there is none. */
static bool find_peers(char *folder, size_t size)
{
    ssize_t length = readlink("/proc/self/exe", folder, size - sizeof PEERS_FOLDER);
    if (length <= 0)
        return false;
    folder[length] = '\0';
    char *slash = strrchr(folder, '/');
    strcpy(slash ? slash + 1 : folder, PEERS_FOLDER);
    char *real = realpath(folder, NULL);
    bool found = real && strlen(real) + 2 <= size;
    if (found)
        sprintf(folder, "%s/", real);
    free(real);
    return found;
}

static bool add_peers(request *asked)
{
    char folder[4096];
    struct dirent **entries;
    int found =
        find_peers(folder, sizeof folder) ? scandir(folder, &entries, is_peer, alphasort) : 0;
    bool done = true;
    for (int i = 0; i < found; i++) {
        size_t size = strlen(folder) + strlen(entries[i]->d_name) + 1;
        char *path = asked->count < REPORT_CANDIDATES ? malloc(size) : NULL;
        if (path) {
            snprintf(path, size, "%s%s", folder, entries[i]->d_name);
            done = add_library(asked, path) && done;
        }
        free(entries[i]);
    }
    if (found > 0)
        free(entries);
    return done;
}

/* The words. */

static int set_candidate(const args *line, int option, const char *value, request *asked)
{
    sure_tier tier;
    if (asked->count == REPORT_CANDIDATES)
        return args_wrong(line, "too many candidates:", value);
    if (option == CANDIDATE) {
        if (!add_library(asked, value))
            return args_wrong(line, "no memory for", value);
        return 0;
    }
    if (!sure_tier_from_name(value, &tier))
        return args_wrong_value(line, "--tier", value,
                                "float32, textbook, stable, certain or exact");
    add_tier(asked, tier);
    return 0;
}

static int set_number(const args *line, int option, const char *value, uint64_t most,
                      uint64_t *number)
{
    char expected[64];
    uint64_t least = option == SEED ? 0 : 1;
    if (args_number(value, least, most, number))
        return 0;
    snprintf(expected, sizeof expected, "a whole number from %" PRIu64 " to %" PRIu64, least, most);
    return args_wrong_value(line, options[option].name, value, expected);
}

static int set_processes(const args *line, const char *value, request *asked)
{
    uint64_t processes = 0;
    int status = set_number(line, PROCESSES, value, MOST_PROCESSES, &processes);
    asked->plan.processes = (int)processes;
    return status;
}

static int set_option(const args *line, int option, const char *value, request *asked)
{
    switch (option) {
    case HELP: asked->help = true; return 0;
    case OUTPUT: asked->output = value; return 0;
    case JSON: asked->json = value; return 0;
    case SCENES: asked->scenes = value; return 0;
    case QUIET: asked->quiet = true; return 0;
    case SHAPE: return choice_add_shape(line, value, &asked->pairs);
    case REGIME: return choice_add_regime(line, value, &asked->pairs);
    case COUNT: return set_number(line, COUNT, value, MOST_COUNT, &asked->plan.count);
    case SEED: return set_number(line, SEED, value, UINT64_MAX, &asked->plan.seed);
    case PROCESSES: return set_processes(line, value, asked);
    case TIER:
    case CANDIDATE: return set_candidate(line, option, value, asked);
    case ARGS_OPERAND: return args_wrong(line, "unexpected", value);
    default: return EXIT_USAGE;
    }
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
    if (!asked->output)
        return args_wrong(line, "missing", "-o FILE");
    bool some = false;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        bool wanted = choice_has(&asked->pairs, i / REGIMES, i % REGIMES);
        asked->plan.wanted[i / REGIMES][i % REGIMES] = wanted;
        some |= wanted;
    }
    return some ? 0 : args_wrong(line, "nothing to ask:", "the shape has no such regime");
}

static bool choose_candidates(request *asked)
{
    if (asked->count > 0)
        return true;
    for (int tier = 0; tier < SURE_TIERS; tier++)
        add_tier(asked, (sure_tier)tier);
    return add_peers(asked);
}

/* The page. */

static int fail(const char *message)
{
    fprintf(stderr, "surehit report: error: %s\n", message);
    return EXIT_OUTPUT;
}

static void step(void *context, int done, int of)
{
    progress *bar = context;
    (void)of;
    progress_step(bar, done - bar->done);
}

/* The command as it was given; a word with anything unusual in it stands in quotes. */
static char *command_of(int count, char **words)
{
    size_t size = sizeof "surehit report";
    for (int i = 0; i < count; i++)
        size += strlen(words[i]) + 3;
    char *text = malloc(size), *at = text;
    if (!text)
        return NULL;
    at += sprintf(at, "surehit report");
    for (int i = 0; i < count; i++)
        at += sprintf(at, strpbrk(words[i], " '\"$&;<>()|*?") ? " '%s'" : " %s", words[i]);
    return text;
}

static bool is_all_asked(const request *asked)
{
    bool all = true;
    for (int i = 0; i < asked->count; i++) {
        const char *trouble = report_trouble(&asked->list[i]);
        if (!trouble)
            continue;
        fprintf(stderr, "surehit report: error: %s\n", trouble);
        all = false;
    }
    return all;
}

static bool write_json(const char *path, const json_t *found)
{
    atomic_file file;
    if (!atomic_file_open(path, stderr, &file))
        return false;
    (void)json_dumpf(found, file.stream, JSON_INDENT(1));
    fputc('\n', file.stream);
    return atomic_file_finish(&file, stderr);
}

static bool write_page(const char *path, const json_t *found)
{
    atomic_file file;
    if (!atomic_file_open(path, stderr, &file))
        return false;
    if (report_print_page(file.stream, found))
        return atomic_file_finish(&file, stderr);
    atomic_file_discard(&file);
    return fail("no memory") == 0;
}

static bool is_shown(const request *asked)
{
    return !asked->quiet && isatty(STDERR_FILENO);
}

static bool gather(request *asked)
{
    char message[REPORT_MESSAGE];
    bool shown = is_shown(asked);
    progress bar = progress_start(stderr, REPORT_STEPS(asked->count));
    asked->plan.reference = truth_has_reference();
    bool done =
        report_gather(&asked->plan, asked->list, asked->count, shown ? step : NULL, &bar, message);
    if (shown)
        progress_finish(&bar);
    if (!done)
        fail(message);
    return done;
}

/* What was found, and how. NULL after a line to standard error. */
static json_t *document(const request *asked, const char *command, double seconds, json_t *scenes,
                        json_t *pictures)
{
    char date[32];
    time_t now = time(NULL);
    strftime(date, sizeof date, "%Y-%m-%d", gmtime(&now));
    json_t *found = report_json(&asked->plan, asked->list, asked->count);
    json_t *made = json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:f, s:o?, s:o}", "version",
                             SUREHIT_VERSION, "cpu", bench_cpu_name(), "compiler",
                             bench_compiler_name(), "flags", SUREHIT_FLAGS, "date", date, "command",
                             command, "seconds", seconds, "scenes", scenes, "pictures", pictures);
    if (!found || !made || json_object_update_new(found, made) != 0) {
        fail("no memory, or a name that is no text");
        json_decref(found);
        return NULL;
    }
    return found;
}

/* After the judging: what draws keeps threads, and a process that forks should have none. For the
 * same reason what is timed is drawn first. */
static json_t *draw(request *asked, const char *command, double seconds)
{
    json_t *scenes = NULL;
    if (asked->scenes && !(scenes = report_trade_draw(&asked->trade, is_shown(asked))))
        return NULL;
    json_t *pictures = report_pictures_draw();
    return pictures ? document(asked, command, seconds, scenes, pictures) : NULL;
}

static int make(request *asked, const char *command)
{
    double started = progress_clock();
    if (!gather(asked))
        return EXIT_OUTPUT;
    double seconds = progress_clock() - started;
    json_t *found = draw(asked, command, seconds);
    bool written = found && (!asked->json || write_json(asked->json, found)) &&
                   write_page(asked->output, found);
    json_decref(found);
    if (!written)
        return EXIT_OUTPUT;
    if (!asked->quiet)
        printf("%s: %d %s, %.0f s\n", asked->output, asked->count,
               asked->count == 1 ? "routine" : "routines", seconds);
    return is_all_asked(asked) ? 0 : EXIT_OUTPUT;
}

static int answer(args *line, request *asked)
{
    int status = read_words(line, asked);
    if (status == 0 && asked->help) {
        print_help();
        return args_flush_output(line, 0);
    }
    if (status == 0 && (!atomic_file_possible(asked->output, stderr) ||
                        (asked->json && !atomic_file_possible(asked->json, stderr))))
        status = EXIT_OUTPUT;
    /* Before the judging, which is long. */
    if (status == 0 && asked->scenes && !report_trade_read(asked->scenes, &asked->trade))
        status = EXIT_USAGE;
    if (status != 0)
        return status;
    char *command = choose_candidates(asked) ? command_of(line->count, line->words) : NULL;
    status = command ? make(asked, command) : fail("no memory");
    free(command);
    return args_flush_output(line, status);
}

int command_report(int count, char **words)
{
    static report_candidate list[REPORT_CANDIDATES];
    args line = {"surehit report", words, count, 0, false};
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    request asked = {.plan = {.count = DEFAULT_COUNT, .processes = cores > 0 ? (int)cores : 1},
                     .list = list};
    int status = answer(&line, &asked);
    report_trade_free(&asked.trade);
    return status;
}
