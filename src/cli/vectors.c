#include "options.h"

#include "../judge/vectors.h"

static regime_rows rows;
static cli_list files;
static const char *folder = ".";

static int run(void)
{
    int status = 0;
    for (int shape = 0; status == 0 && shape < SURE_SHAPES; shape++) {
        if (rows.shapes[shape] || !rows.some_shapes)
            status = vectors_write((sure_shape)shape, files.texts, files.count, folder);
    }
    return status;
}

static const cli_option options[] = {
    {"shape", "SHAPE", "of this shape (default: all); may be repeated", cli_shape, .to = &rows},
    {"cases", "FILE",
     "then these cases of the shape, one a line; \" -> \" and what follows, empty lines and lines "
     "from # on are passed over; may be repeated",
     cli_texts, .to = &files},
    {"o", "FOLDER", "where the files go (default: here)", cli_text, .to = &folder},
    {0},
};

const cli_command command_vectors = {
    .name = "surehit vectors",
    .summary = "write hard cases with exact answers for anyone's tests",
    .usage = "[--shape SHAPE ...] [--cases FILE ...] [-o FOLDER]",
    .about =
        "Writes hard cases with their exact answers, for tests in any language, to\n"
        "SHAPE.jsonl: one JSON object a line, the format's version in the first.\n"
        "They are the first " CLI_NUMERAL(
            VECTORS_PER_REGIME) " of each regime with "
                                "seed " CLI_NUMERAL(VECTORS_VERSION) ", the same on every machine.",
    .options = options,
    .statuses = "0 written; 1 not written; 2 wrong usage, or no such cases.",
    .run = run,
};
