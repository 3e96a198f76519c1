/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../judge/vectors.h"
#include "../support/folder.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static cli_list files;
static vectors_plan plan = {.count = VECTORS_PER_REGIME, .entry = "", .folder = "."};

/* May the shape's file be written there? */
static int check_path(sure_shape shape)
{
    const char *name = sure_shape_name(shape);
    char *path = folder_path(plan.folder, name, strlen(name), ".jsonl");
    const char *const outputs[] = {path};
    const cli_paths all = {outputs, files.texts, 1, files.count};
    int status = cli_paths_check(&all);
    free(path);
    return status;
}

/* What can be read but once is for one shape alone. */
static int check_input(const char *path)
{
    struct stat about;
    int shapes = 0;
    for (int shape = 0; shape < SURE_SHAPES; shape++)
        shapes += plan.rows.shapes[shape] || !plan.rows.some_shapes;
    if (shapes > 1 && stat(path, &about) == 0 && !S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode))
        return cli_wrong("'%s': a pipe is read once, for one '--shape'", path);
    return 0;
}

static int64_t count_cases(void)
{
    int64_t rows = 0;
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++)
        rows += regime_rows_have(&plan.rows, i / REGIMES, i % REGIMES);
    return progress_total(rows, plan.count);
}

static int run(void)
{
    int status = cli_rows_check(&plan.rows);
    plan.files = files.texts;
    plan.file_count = files.count;
    for (int i = 0; status == 0 && i < files.count; i++)
        status = check_input(files.texts[i]);
    for (int shape = 0; status == 0 && shape < SURE_SHAPES; shape++) {
        if (plan.rows.shapes[shape] || !plan.rows.some_shapes)
            status = check_path((sure_shape)shape);
    }
    progress bar = progress_start(stderr, count_cases());
    plan.bar = &bar;
    for (int shape = 0; status == 0 && shape < SURE_SHAPES; shape++) {
        if (plan.rows.shapes[shape] || !plan.rows.some_shapes)
            status = vectors_write(&plan, (sure_shape)shape);
    }
    progress_finish(&bar);
    return status;
}

static const cli_option options[] = {
    {"shape", "SHAPE", "of this shape (default: all); may be repeated", cli_shape,
     .to = &plan.rows},
    {"regime", "REGIME", "the kind of cases (default: all); may be repeated", cli_regime,
     .to = &plan.rows},
    {"count", "N", "of each regime (default " CLI_NUMERAL(VECTORS_PER_REGIME) ")", cli_number,
     .to = &plan.count, .most = UINT64_MAX},
    {"cases", "FILE",
     "then these cases of the shape, one a line; \" -> \" and what follows, empty lines and lines "
     "from # on are passed over; may be repeated",
     cli_texts, .to = &files},
    {"entry", "WORDS", "all made to these conditions (docs/judge.md): unit, local, float, ...",
     cli_entry, .to = &plan.entry},
    {"o", "FOLDER", "where the files go (default: here)", cli_text, .to = &plan.folder},
    {0},
};

const cli_command command_vectors = {
    .name = "surehit vectors",
    .summary = "write hard cases with exact answers for anyone's tests",
    .usage = "[--shape SHAPE ...] [OPTION ...]",
    .about = "Writes hard cases with their exact answers, for tests in any language, to\n"
             "SHAPE.jsonl: one JSON object a line; the first has the format's version and\n"
             "a digest of the others. They are the first of each regime, with seed " CLI_NUMERAL(
                 VECTORS_SEED) ",\n"
                               "the same on every machine.",
    .options = options,
    .print_more = cli_print_regimes,
    .statuses = "0 written; 1 not written; 2 wrong usage, or no such cases.",
    .run = run,
};
