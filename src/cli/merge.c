#include "args.h"
#include "commands.h"
#include "photons.h"

#include "../photons/partial_film.h"
#include "../support/atomic_file.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { HELP, OUTPUT, SHARE, QUIET };
static const args_option options[] = {
    [HELP] = {"--help", false},
    [OUTPUT] = {"-o", true},
    [SHARE] = {"--share", true},
    [QUIET] = {"--quiet", false},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help, quiet;
    const char **paths; /* room for every word */
    int path_count;
    const char *output, *share;
} request;

static void print_help(void)
{
    fputs("Usage: surehit merge A.share B.share ... -o OUT.ppm|OUT.png [--share SUM.share]\n"
          "\n"
          "Adds shares of one scene's photons, which `surehit render --integrator forward\n"
          "--share` has written. The picture is that of one run over all the photons, byte\n"
          "for byte, in whatever order and groups they are added.\n"
          "\n"
          "  -o FILE       the picture\n"
          "  --share FILE  the sum, a share like the others\n"
          "  --quiet       says nothing of what became of the photons\n"
          "\n"
          "Exit status: 0 done; 1 output could not be written; 2 wrong usage, a share that\n"
          "can't be read, that is of another scene or other settings, or that has photons\n"
          "which are in another one.\n",
          stdout);
}

/* Returns the exit status, 0 to go on. */
static int read_words(args *line, request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case OUTPUT: asked->output = value; break;
        case SHARE: asked->share = value; break;
        case QUIET: asked->quiet = true; break;
        case ARGS_OPERAND: asked->paths[asked->path_count++] = value; break;
        default: status = EXIT_USAGE;
        }
    }
    if (status == 0 && asked->path_count == 0)
        status = args_wrong(line, "missing", "A.share");
    if (status == 0 && !asked->output)
        status = args_wrong(line, "missing", "-o FILE");
    return status;
}

static int check_outputs(const request *asked)
{
    if (!picture_path_ok(asked->output, stderr))
        return EXIT_USAGE;
    return atomic_file_possible(asked->output, stderr) &&
                   (!asked->share || atomic_file_possible(asked->share, stderr))
               ? 0
               : EXIT_OUTPUT;
}

/* Shares without their sums, as many as were added; the sum of all. */
typedef struct {
    const request *asked;
    share *added;
    int count;
    share sum;
} merging;

static bool fits(const merging *m, const share *next)
{
    const char *path = m->asked->paths[m->count];
    for (int i = 0; i < m->count; i++) {
        const char *other = share_difference(&m->added[i], next);
        photon_range both;
        if (other) {
            fprintf(stderr, "%s: error: can't be added to %s: it has another %s\n", path,
                    m->asked->paths[i], other);
            return false;
        }
        if (share_overlap(&m->added[i], next, &both)) {
            fprintf(stderr, "%s: error: photons %" PRIu64 " to %" PRIu64 " are in %s, too\n", path,
                    both.first, both.end - 1, m->asked->paths[i]);
            return false;
        }
    }
    return true;
}

static bool add(merging *m, share *next)
{
    bool added = (m->count > 0 || share_begin(next, &m->sum)) && share_add(&m->sum, next);
    film_free(&next->sums);
    m->added[m->count++] = *next;
    return added;
}

static int read_all(merging *m)
{
    while (m->count < m->asked->path_count) {
        const char *path = m->asked->paths[m->count];
        share next;
        if (!share_read(path, stderr, &next))
            return EXIT_USAGE;
        if (!fits(m, &next)) {
            share_free(&next);
            return EXIT_USAGE;
        }
        if (!add(m, &next)) {
            fprintf(stderr, "%s: error: no memory\n", path);
            return EXIT_USAGE;
        }
    }
    return 0;
}

static int write_all(const merging *m)
{
    const request *asked = m->asked;
    picture image;
    if (asked->share && !share_write(&m->sum, asked->share, stderr))
        return EXIT_OUTPUT;
    if (!picture_new(m->sum.sums.width, m->sum.sums.height, &image)) {
        fprintf(stderr, "%s: error: no memory for this picture\n", asked->output);
        return EXIT_OUTPUT;
    }
    film_picture(&m->sum.sums, m->sum.account.emitted, &image);
    bool written = picture_write(&image, asked->output, stderr);
    picture_free(&image);
    return written ? 0 : EXIT_OUTPUT;
}

static void print_summary(const merging *m)
{
    printf("%s%s%s: %dx%d, photons ", m->asked->output, m->asked->share ? ", " : "",
           m->asked->share ? m->asked->share : "", m->sum.sums.width, m->sum.sums.height);
    photons_print_ranges(stdout, &m->sum);
    putchar('\n');
    photons_print(stdout, &m->sum, PHOTONS_UNTIMED);
}

static int merge(const request *asked)
{
    merging m = {.asked = asked, .added = calloc((size_t)asked->path_count, sizeof *m.added)};
    if (!m.added) {
        fputs("surehit merge: error: no memory\n", stderr);
        return EXIT_OUTPUT;
    }
    int status = read_all(&m);
    if (status == 0)
        status = write_all(&m);
    if (status == 0 && !asked->quiet)
        print_summary(&m);
    for (int i = 0; i < m.count; i++)
        share_free(&m.added[i]);
    free(m.added);
    share_free(&m.sum);
    return status;
}

static int answer(args *line, request *asked)
{
    int status = read_words(line, asked);
    if (status == 0 && asked->help)
        print_help();
    else if (status == 0) {
        status = check_outputs(asked);
        if (status == 0)
            status = merge(asked);
    }
    return status == 0 ? args_flush_output(line, 0) : status;
}

int command_merge(int count, char **words)
{
    args line = {"surehit merge", words, count, 0, false};
    request asked = {.paths = calloc((size_t)count + 1, sizeof *asked.paths)};
    if (!asked.paths) {
        fputs("surehit merge: error: no memory\n", stderr);
        return EXIT_OUTPUT;
    }
    int status = answer(&line, &asked);
    free(asked.paths);
    return status;
}
