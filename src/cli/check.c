#define _POSIX_C_SOURCE 200809L /* isatty */

#include "args.h"
#include "commands.h"

#include "../evidence/certificate_check.h"

#include <stdio.h>
#include <unistd.h>

#define EXIT_WRONG 1 /* what the certificate says */
#define EXIT_TROUBLE 2
#define MOST_THREADS 1024

enum { HELP, QUIET, QUICK, THREADS };
static const args_option options[] = {
    [HELP] = {"--help", false},
    [QUIET] = {"--quiet", false},
    [QUICK] = {"--quick", false},
    [THREADS] = {"--threads", true},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help, quiet;
    const char *certificate, *scene;
    check_options how;
} request;

static void print_help(void)
{
    fputs("Usage: surehit check CERTIFICATE SCENE.rt [OPTION ...]\n"
          "\n"
          "Is what `surehit render --certificate` said of a scene's picture true? Every\n"
          "pixel's ray is asked again, in exact arithmetic and every object of the scene:\n"
          "the object that it sees, the part, t and its error. The first ones that are\n"
          "wrong are printed.\n"
          "\n"
          "  --quick        ask the objects by way of the hierarchy: for large scenes\n"
          "  --threads N    1 to 1024 (default: one a core)\n"
          "  --quiet        no progress bar and no line when all is right\n"
          "\n"
          "Exit status: 0 all is right; 1 something is wrong; 2 wrong usage, or something\n"
          "that can't be read, is no certificate, or is another scene's.\n",
          stdout);
}

static int set_operand(const args *line, const char *word, request *asked)
{
    if (!asked->certificate)
        asked->certificate = word;
    else if (!asked->scene)
        asked->scene = word;
    else
        return args_wrong(line, "one word too many:", word);
    return 0;
}

static int set_threads(const args *line, const char *value, int *to)
{
    uint64_t threads;
    if (!args_number(value, 1, MOST_THREADS, &threads))
        return args_wrong_value(line, "--threads", value, "a whole number from 1 to 1024");
    *to = (int)threads;
    return 0;
}

/* Returns the exit status, 0 to go on. */
static int read_words(args *line, request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case QUIET: asked->quiet = true; break;
        case QUICK: asked->how.quick = true; break;
        case THREADS: status = set_threads(line, value, &asked->how.threads); break;
        case ARGS_OPERAND: status = set_operand(line, value, asked); break;
        default: status = EXIT_USAGE;
        }
    }
    if (status == 0 && !asked->scene)
        status = args_wrong(line, "missing", asked->certificate ? "SCENE.rt" : "CERTIFICATE");
    return status;
}

static int check(const request *asked)
{
    certificate of;
    check_result result;
    if (!certificate_read(asked->certificate, stderr, &of))
        return EXIT_TROUBLE;
    bool checked = certificate_check(&of, asked->scene, &asked->how, stdout, stderr, &result);
    certificate_free(&of);
    if (!checked)
        return EXIT_TROUBLE;
    bool right = check_is_right(&result);
    if (!right || !asked->quiet) {
        printf("%s: ", asked->certificate);
        check_print_result(stdout, &result);
        putchar('\n');
    }
    return right ? 0 : EXIT_WRONG;
}

int command_check(int count, char **words)
{
    args line = {"surehit check", words, count, 0, false};
    request asked = {.help = false};
    int status = read_words(&line, &asked);
    if (status == 0 && asked.help) {
        print_help();
    } else if (status == 0) {
        asked.how.progress = !asked.quiet && isatty(STDERR_FILENO);
        status = check(&asked);
    }
    return args_flush_output(&line, 0) == 0 ? status : EXIT_TROUBLE;
}
