/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "../photons/partial_film.h"

#include <limits.h>
#include <stdio.h>

static const char *output, *share;
static bool quiet;

/* The sum may take the place of one of its shares. */
static int check_outputs(void)
{
    const char *outputs[] = {picture_is_stdout(output) ? NULL : output, share};
    const cli_paths drawn = {outputs, cli_operands, 1, cli_operand_count};
    const cli_paths both = {outputs, NULL, 2, 0};
    int status = picture_path_ok(output, stderr) ? cli_paths_check(&drawn) : EXIT_USAGE;
    return status == 0 ? cli_paths_check(&both) : status;
}

static int write_all(const partial_film *sum)
{
    picture image;
    if (share && !partial_film_write(sum, share, stderr))
        return EXIT_OUTPUT;
    if (!partial_film_picture(sum, output, stderr, &image))
        return EXIT_OUTPUT;
    bool written = picture_write(&image, output, stderr);
    picture_free(&image);
    return written ? 0 : EXIT_OUTPUT;
}

static void print_summary(const partial_film *sum)
{
    FILE *words = picture_is_stdout(output) ? stderr : stdout;
    fprintf(words, "%s%s%s: %dx%d, photons ", output, share ? ", " : "", share ? share : "",
            sum->sums.width, sum->sums.height);
    photons_print_ranges(words, sum);
    fputc('\n', words);
    photons_print(words, sum, PHOTONS_UNTIMED);
}

static int run(void)
{
    partial_film sum;
    int status = output ? check_outputs() : cli_wrong("missing '-o FILE'");
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

static const cli_option options[] = {
    {"o", "FILE", "the picture, or - for a PPM on standard output", cli_text, .to = &output},
    {"share", "FILE", "the sum, a share like the others", cli_text, .to = &share},
    {"quiet", NULL, "says nothing of what became of the photons", cli_flag, .to = &quiet},
    {0},
};

const cli_command command_merge = {
    .name = "surehit merge",
    .summary = "add shares of a picture's photons: render --integrator forward",
    .usage = "A.share B.share ... -o OUT.ppm|OUT.png [--share SUM.share]",
    .about = "Adds shares of one scene's photons, which `surehit render --integrator forward\n"
             "--share` has written. The picture is that of one run over all the photons, byte\n"
             "for byte, in whatever order and groups they are added.",
    .options = options,
    .operands = "A.share",
    .most_operands = INT_MAX,
    .statuses = "0 done; 1 output could not be written; 2 wrong usage, a share that\n"
                "can't be read, that is of another scene or other settings, or that has\n"
                "photons which are in another one.",
    .run = run,
};
