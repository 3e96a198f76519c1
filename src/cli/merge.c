#include "options.h"

#include "../photons/merge.h"
#include "../photons/photon_counts.h"
#include "../support/atomic_file.h"

#include <limits.h>
#include <stdio.h>

typedef struct {
    const char *output, *share;
    bool quiet;
} request;

static int check_outputs(const request *asked)
{
    if (!picture_path_ok(asked->output, stderr))
        return EXIT_USAGE;
    return atomic_file_possible(asked->output, stderr) &&
                   (!asked->share || atomic_file_possible(asked->share, stderr))
               ? 0
               : EXIT_OUTPUT;
}

static int write_all(const request *asked, const partial_film *sum)
{
    picture image;
    if (asked->share && !partial_film_write(sum, asked->share, stderr))
        return EXIT_OUTPUT;
    if (!film_picture_new(&sum->sums, sum->statistics.emitted, &image)) {
        fprintf(stderr, "%s: error: no memory for this picture\n", asked->output);
        return EXIT_OUTPUT;
    }
    bool written = picture_write(&image, asked->output, stderr);
    picture_free(&image);
    return written ? 0 : EXIT_OUTPUT;
}

static void print_summary(const request *asked, const partial_film *sum)
{
    printf("%s%s%s: %dx%d, photons ", asked->output, asked->share ? ", " : "",
           asked->share ? asked->share : "", sum->sums.width, sum->sums.height);
    photons_print_ranges(stdout, sum);
    putchar('\n');
    photons_print(stdout, sum, PHOTONS_UNTIMED);
}

static int merge(const request *asked, const char **paths, int count)
{
    partial_film sum;
    int status = check_outputs(asked);
    if (status != 0)
        return status;
    if (!merge_partial_films(paths, count, stderr, &sum))
        status = EXIT_USAGE;
    if (status == 0)
        status = write_all(asked, &sum);
    if (status == 0 && !asked->quiet)
        print_summary(asked, &sum);
    partial_film_free(&sum);
    return status;
}

int command_merge(int count, char **words)
{
    const char **paths;
    int path_count, status;
    request asked = {.output = NULL};
    const cli_option options[] = {
        {"o", "FILE", "the picture", cli_text, .to = &asked.output},
        {"share", "FILE", "the sum, a share like the others", cli_text, .to = &asked.share},
        {"quiet", NULL, "says nothing of what became of the photons", cli_flag, .to = &asked.quiet},
        {0},
    };
    const cli_command command = {
        .name = "surehit merge",
        .usage = "A.share B.share ... -o OUT.ppm|OUT.png [--share SUM.share]",
        .about = "Adds shares of one scene's photons, which `surehit render --integrator forward\n"
                 "--share` has written. The picture is that of one run over all the photons, byte\n"
                 "for byte, in whatever order and groups they are added.",
        .options = options,
        .operands = {"A.share", INT_MAX, &paths, &path_count},
        .statuses = "0 done; 1 output could not be written; 2 wrong usage, a share that\n"
                    "can't be read, that is of another scene or other settings, or that has\n"
                    "photons which are in another one.",
    };
    if (!cli_read(&command, count, words, &status))
        return status;
    status =
        asked.output ? merge(&asked, paths, path_count) : cli_wrong(&command, "missing", "-o FILE");
    return cli_finish(&command, status);
}
