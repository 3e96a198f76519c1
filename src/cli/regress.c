/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../regress/regress.h"

#include <stdio.h>

static regress_plan plan = {.settings = RENDER_DEFAULTS};

static int run(void)
{
    if (cli_paths_check(&(cli_paths){&plan.page, NULL, 1, 0}) != 0)
        return EXIT_TROUBLE;
    plan.folder = cli_operands[0];
    plan.settings.how.progress = !plan.quiet;
    return regress_folder(&plan);
}

static const cli_option options[] = {
    {"golden", "DIR2", "where the golden pictures are (default: DIR/golden)", cli_text,
     .to = &plan.golden},
    {"o", "FILE", "a page that shows what differs; it needs no other file", cli_text,
     .to = &plan.page},
    {"accept", NULL,
     "what is drawn now becomes golden, where it differs or is new; golden pictures without a "
     "scene are removed",
     cli_flag, .to = &plan.accept},
    CLI_SIZE(&plan.settings),
    CLI_DRAWN_TIER(&plan.settings.how.tier),
    CLI_THREADS(&plan.settings.how.threads),
    {"quiet", NULL, "no word of what is the same", cli_flag, .to = &plan.quiet},
    CLI_MEANINGS(&plan.settings),
    {0},
};

const cli_command command_regress = {
    .name = "surehit regress",
    .summary = "hold a folder of scenes against their golden pictures",
    .usage = "DIR [-o PAGE.html] [--accept] [OPTION ...]",
    .about = "Draws every scene (*.rt) of a folder and holds it against its golden picture,\n"
             "the one that was looked at and found right. Says what differs, what has no\n"
             "golden picture yet, and which golden picture (*.png) has no scene any more.\n"
             "\n"
             "A scene's picture is the same, bit for bit, on every machine, whatever its\n"
             "compiler, C library and number of threads: nothing but + - * / and square roots\n"
             "goes into it. So the comparison is exact, and what differs is a change of scene,\n"
             "settings or surehit.",
    .options = options,
    .operands = "DIR",
    .most_operands = 1,
    .statuses = "0 all the same, or accepted; 1 something differs, is new or stale;\n"
                "2 wrong usage, or something could not be read or written.",
    .lost = EXIT_TROUBLE,
    .run = run,
};
