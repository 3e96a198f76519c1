/* SPDX-License-Identifier: MIT */
#include "words.h"

#include "../../support/pieces/cut.h"

#include <limits.h>

static const char *output;

static int run(void)
{
    const cli_paths all = {&output, NULL, 1, 0};
    if (!output || cut.pieces == 0)
        return cli_wrong(output ? "missing '--pieces N'" : "missing '-o MANIFEST'");
    int status = cli_paths_check(&all);
    if (status != 0)
        return status;
    json_t *words = json_array();
    for (int i = 0; i < cli_operand_count; i++) {
        if (json_array_append_new(words, json_string(cli_operands[i])) != 0)
            return cli_wrong("'%s' is no UTF-8, as the words of a manifest are", cli_operands[i]);
    }
    cut.way = CUT_PLAN;
    cut.manifest = output;
    cut.asked = words_asked(words);
    return words_run(cut.asked, &(more_words){NULL, NULL});
}

static const cli_option options[] = {
    {"o", "MANIFEST", "what is to be done", cli_text, .to = &output},
    {"pieces", "N", "so many", cli_number, .to = &cut.pieces, .least = 1, .most = 1000000000},
    {0},
};

const cli_command command_plan = {
    .name = "surehit plan",
    .summary = "cut the work of render or judge into pieces for many machines",
    .usage = "--pieces N -o MANIFEST render|judge WORD ...",
    .about = "Cuts a picture, its photons or a judgement into pieces. `surehit work` does one,\n"
             "`surehit merge` adds them, byte for byte to what the command makes alone.",
    .options = options,
    .operands = "COMMAND",
    .most_operands = INT_MAX,
    .words_follow = true,
    .statuses = "0 planned; 1 the manifest could not be written; 2 wrong usage.",
    .run = run,
};
