/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../evidence/certificate.h"

#include <stdio.h>

static check_options how;

static int run(void)
{
    how.progress = !how.quiet;
    return certificate_check(cli_operands[0], cli_operands[1], &how);
}

static const cli_option options[] = {
    {"quick", NULL, "ask the objects by way of the hierarchy: for large scenes", cli_flag,
     .to = &how.quick},
    CLI_THREADS(&how.threads),
    {"quiet", NULL, "no progress bar and no line when all is right", cli_flag, .to = &how.quiet},
    {0},
};

const cli_command command_check = {
    .name = "surehit check",
    .summary = "verify the certificate of a picture, pixel by pixel",
    .usage = "CERTIFICATE SCENE.rt [OPTION ...]",
    .about = "Is what `surehit render --certificate` said of a scene's picture true? Every\n"
             "pixel's ray is asked again, in exact arithmetic and every object of the scene:\n"
             "the object that it sees, the part, t and its error. The first ones that are\n"
             "wrong are printed.",
    .options = options,
    .operands = "CERTIFICATE SCENE.rt",
    .most_operands = 2,
    .statuses = "0 all is right; 1 something is wrong; 2 wrong usage, or something\n"
                "that can't be read, is no certificate, or is another scene's.",
    .lost = EXIT_TROUBLE,
    .run = run,
};
