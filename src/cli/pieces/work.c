/* SPDX-License-Identifier: MIT */
#include "words.h"

#include "../../support/pieces/cut.h"

static int run(void)
{
    if (!manifest_read(cli_operands[0], stderr, &cut.of) ||
        !piece_number(cli_operands[1], stderr, &cut.number) ||
        !manifest_piece(&cut.of, cut.number, stderr))
        return EXIT_USAGE;
    json_t *words = json_object_get(manifest_asked(&cut.of), "words");
    cut.way = CUT_WORK;
    cut.folder = cli_operands[2];
    cut.asked = words_asked(json_incref(words));
    if (!cut.asked)
        return cli_wrong("'%s' is no manifest of this program's", cut.of.path);
    double done = cut_done(&cut.of, cut.number, cut.folder);
    return done < 0 ? EXIT_USAGE : done == 1 ? 0 : words_run(cut.asked, &(more_words){NULL, NULL});
}

static const cli_option options[] = {
    {"limit", "S", "seconds of the processor, then it ends (0: none)", cli_number, .to = &cut.limit,
     .most = 1000000000},
    {"keep", "S", "seconds of the processor, then what is done is kept (30)", cli_seconds,
     .to = &cut.keep},
    {0},
};

const cli_command command_work = {
    .name = "surehit work",
    .summary = "do a piece of what was planned",
    .usage = "MANIFEST NUMBER FOLDER [OPTION ...]",
    .about = "Does one piece of a manifest, on one core where its words say no --threads.\n"
             "Its result, FOLDER/NUMBER.json, appears when all of it is done. What is done\n"
             "after some seconds, and at the limit, stands in FOLDER/NUMBER.part, from where\n"
             "the same words go on after any end. What is done is not done again.",
    .options = options,
    .operands = "MANIFEST NUMBER FOLDER",
    .most_operands = 3,
    .statuses = "0 done; 1 not yet, or its file could not be written; 2 wrong\n"
                "usage, or a manifest of other sources, options or inputs.",
    .run = run,
};
