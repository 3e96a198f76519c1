/* SPDX-License-Identifier: MIT */
#include "../options.h"

#include "../../support/pieces/cut.h"

static double done(void *context, size_t number)
{
    return cut_done(context, number, cli_operands[1]);
}

static int run(void)
{
    manifest of;
    if (!manifest_read(cli_operands[0], stderr, &of))
        return EXIT_USAGE;
    pieces_state is = pieces_status(&of, done, &of, stderr);
    manifest_free(&of);
    return (int)is;
}

static const cli_option options[] = {{0}};

const cli_command command_status = {
    .name = "surehit status",
    .summary = "which pieces of what was planned are missing",
    .usage = "MANIFEST FOLDER",
    .about = "Prints the numbers of the pieces that the folder lacks, as `sbatch --array`\n"
             "takes them: 1,4-6.",
    .options = options,
    .operands = "MANIFEST FOLDER",
    .most_operands = 2,
    .statuses = "0 all are done; 2 wrong usage, or what is there is another\n"
                "plan's; 3 some are missing.",
    .run = run,
};
