/* SPDX-License-Identifier: MIT */
#include "pieces/words.h"

#include "../photons/partial_film.h"
#include "../support/pieces/cut.h"
#include "../support/printable.h"

#include <limits.h>
#include <stdio.h>
#include <sys/stat.h>

static const char *output, *share;
static cli_list given;
static bool quiet;

static const char *file_of(const char *path)
{
    return path && picture_is_stdout(path) ? NULL : path;
}

/* The sum may take the place of one of its shares. */
static int check_outputs(void)
{
    const char *outputs[] = {file_of(output), share};
    const cli_paths drawn = {outputs, cli_operands, 1, cli_operand_count};
    const cli_paths both = {outputs, NULL, 2, 0};
    if (!output && !share)
        return cli_wrong("missing '-o FILE'");
    bool named =
        (!output || picture_path_ok(output, stderr)) && picture_is_other(share, "share", stderr);
    int status = named ? cli_paths_check(&drawn) : EXIT_USAGE;
    return status == 0 ? cli_paths_check(&both) : status;
}

static int write_all(const partial_film *sum)
{
    picture image;
    if (share && !partial_film_write(sum, share, stderr))
        return EXIT_OUTPUT;
    if (!output)
        return 0;
    if (!partial_film_picture(sum, output, stderr, &image))
        return EXIT_OUTPUT;
    bool written = picture_write(&image, output, stderr);
    picture_free(&image);
    return written ? 0 : EXIT_OUTPUT;
}

static void print_summary(const partial_film *sum)
{
    FILE *words = output && picture_is_stdout(output) ? stderr : stdout;
    printable_printf(words, "%s%s%s: %dx%d, photons ", output ? output : "",
                     output && share ? ", " : "", share ? share : "", sum->sums.width,
                     sum->sums.height);
    photons_print_ranges(words, sum);
    fputc('\n', words);
    photons_print(words, sum, PHOTONS_UNTIMED);
}

/* Results of `surehit work`: the command that was planned goes on from their sum. */

static int merge_results(const folder_listing *results)
{
    const char *outputs[] = {file_of(output), share};
    const cli_paths all = {outputs, (const char *const *)results->names, 2, results->count};
    json_t *lines = sealed_read(results->names[0], stderr);
    const json_t *asked = json_array_get(lines, 0);
    const cli_command *command = lines ? words_command(asked) : NULL;
    int status = command ? cli_paths_check(&all) : EXIT_USAGE;
    if (status != 0)
        return status;
    cut.way = CUT_MERGE;
    cut.results = results;
    cut.asked = words_asked(json_incref(json_object_get(asked, "words")));
    return words_run(cut.asked,
                     (more_words[]){{command->cut_output, output},
                                    {"--share", share},
                                    {"--quiet", quiet && command == &command_render ? "" : NULL},
                                    {NULL, NULL}});
}

/* Shares of photons. */

static int merge_shares(void)
{
    partial_film sum;
    int status = check_outputs();
    if (status != 0)
        return status;
    if (!merge_partial_films(cli_operands, cli_operand_count, stderr, &sum))
        status = EXIT_USAGE;
    if (status == 0)
        status = write_all(&sum);
    if (status == 0 && !quiet)
        print_summary(&sum);
    partial_film_free(&sum);
    return status;
}

/* They are compressed as by gzip; what can't be read will be complained of. A pipe is read once:
 * results of pieces come in files. */
static bool is_share(const char *path)
{
    struct stat about;
    bool once = stat(path, &about) == 0 && !S_ISREG(about.st_mode);
    FILE *file = once ? NULL : fopen(path, "rb");
    bool is = !file || (fgetc(file) == 0x1f && fgetc(file) == 0x8b);
    if (file)
        fclose(file);
    return is;
}

static int run(void)
{
    folder_listing results;
    if (given.count > 1)
        return cli_wrong("'-o' is given %d times", given.count);
    output = given.count == 1 ? given.texts[0] : NULL;
    bool listed = pieces_list(cli_operands, cli_operand_count, stderr, &results);
    int status = !listed                      ? EXIT_USAGE
                 : is_share(results.names[0]) ? merge_shares()
                                              : merge_results(&results);
    folder_free(&results);
    return status;
}

static const cli_option options[] = {
    {"o", "FILE", "the picture, or - for a PPM on standard output; of a judgement its JSON",
     cli_texts, .to = &given},
    {"share", "FILE", "the sum, a share like the others", cli_text, .to = &share},
    {"quiet", NULL, "says nothing of what became of the photons", cli_flag, .to = &quiet},
    {0},
};

const cli_command command_merge = {
    .name = "surehit merge",
    .summary = "add pieces of what was planned, or shares of a picture's photons",
    .usage = "FOLDER|A.json ...|A.share ... [-o OUT] [--share SUM.share]",
    .about = "Adds results of `surehit work`, in any order: the command that was planned goes\n"
             "on from there, and writes and prints what it makes alone. Or adds shares of one\n"
             "scene's photons, which `surehit render --integrator forward --share` has\n"
             "written: the picture is that of one run over all the photons, byte for byte, in\n"
             "whatever order and groups they are added.",
    .options = options,
    .operands = "A.share",
    .most_operands = INT_MAX,
    .statuses = "as of the command that was planned; of shares 0 done; 1 output\n"
                "could not be written. 2 wrong usage, or what can't be read, is of another\n"
                "scene, other settings or sources, is in another one, too, or is missing.",
    .run = run,
};
