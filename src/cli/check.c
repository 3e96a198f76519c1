#define _POSIX_C_SOURCE 200809L /* isatty */

#include "options.h"

#include "../evidence/certificate_check.h"

#include <stdio.h>
#include <unistd.h>

#define EXIT_WRONG 1 /* what the certificate says */
#define EXIT_TROUBLE 2

static int check(const char *path, const char *scene, const check_options *how, bool quiet)
{
    certificate of;
    check_result result;
    if (!certificate_read(path, stderr, &of))
        return EXIT_TROUBLE;
    bool checked = certificate_check(&of, scene, how, stdout, stderr, &result);
    certificate_free(&of);
    if (!checked)
        return EXIT_TROUBLE;
    bool right = check_is_right(&result);
    if (!right || !quiet) {
        printf("%s: ", path);
        check_print_result(stdout, &result);
        putchar('\n');
    }
    return right ? 0 : EXIT_WRONG;
}

int command_check(int count, char **words)
{
    const char **paths;
    check_options how = {.quick = false};
    bool quiet = false;
    const cli_option options[] = {
        {"quick", NULL, "ask the objects by way of the hierarchy: for large scenes", cli_flag,
         .to = &how.quick},
        CLI_THREADS(&how.threads),
        {"quiet", NULL, "no progress bar and no line when all is right", cli_flag, .to = &quiet},
        {0},
    };
    const cli_command command = {
        .name = "surehit check",
        .usage = "CERTIFICATE SCENE.rt [OPTION ...]",
        .about = "Is what `surehit render --certificate` said of a scene's picture true? Every\n"
                 "pixel's ray is asked again, in exact arithmetic and every object of the scene:\n"
                 "the object that it sees, the part, t and its error. The first ones that are\n"
                 "wrong are printed.",
        .options = options,
        .operands = {"CERTIFICATE SCENE.rt", 2, &paths, NULL},
        .statuses = "0 all is right; 1 something is wrong; 2 wrong usage, or something\n"
                    "that can't be read, is no certificate, or is another scene's.",
        .lost = EXIT_TROUBLE,
    };
    int status;
    if (!cli_read(&command, count, words, &status))
        return status;
    how.progress = !quiet && isatty(STDERR_FILENO);
    return cli_finish(&command, check(paths[0], paths[1], &how, quiet));
}
