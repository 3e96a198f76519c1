#include "options.h"

#include "../cases/case.h"

#include <stdio.h>

#define DEFAULT_COUNT 1000

typedef struct {
    cli_rows rows;
    uint64_t count, seed;
} request;

static void write_cases(const request *asked, sure_shape shape, regime which)
{
    char text[CASE_LINE_MAX];
    for (uint64_t i = 0; i < asked->count && !ferror(stdout); i++) {
        sure_case question = regime_case(shape, which, asked->seed, i);
        case_print(&question, text);
        puts(text);
    }
}

int command_cases(int count, char **words)
{
    request asked = {.count = DEFAULT_COUNT};
    const cli_option options[] = {
        {"shape", "SHAPE", cli_shape_names(), cli_shape, .to = &asked.rows},
        {"regime", "REGIME", "the kind of cases", cli_regime, .to = &asked.rows},
        {"count", "N", "of each shape and regime (default " CLI_NUMERAL(DEFAULT_COUNT) ")",
         cli_number, .to = &asked.count, .most = UINT64_MAX},
        {"seed", "K", "others of the same kind (default 0)", cli_number, .to = &asked.seed,
         .most = UINT64_MAX},
        {0},
    };
    const cli_command command = {
        .name = "surehit cases",
        .usage = "[--shape SHAPE ...] [--regime REGIME ...] [OPTION ...]",
        .about = "Writes cases, one a line: SHAPE ox oy oz dx dy dz t_min t_max, and the object's\n"
                 "numbers. Without --shape those of all shapes, without --regime those of all\n"
                 "regimes.",
        .options = options,
        .print_more = cli_print_regimes,
        .statuses = "0 written; 1 output could not be written; 2 wrong usage.",
    };
    int status;
    if (!cli_read(&command, count, words, &status))
        return status;
    status = cli_rows_check(&command, &asked.rows);
    for (int i = 0; status == 0 && i < SURE_SHAPES * REGIMES; i++) {
        if (cli_rows_have(&asked.rows, i / REGIMES, i % REGIMES))
            write_cases(&asked, (sure_shape)(i / REGIMES), (regime)(i % REGIMES));
    }
    return cli_finish(&command, status);
}
