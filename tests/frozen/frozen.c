/* Does the library still give the answers that are frozen (docs/frozen.md)?
 *
 *     frozen [--blocks N] RECORD         holds all blocks, or the first N, against the record
 *     frozen --add RECORD                adds the rows that are missing, changes none
 *     frozen --cases SHAPE REGIME BLOCK  prints a block's answers, one case a line
 *
 * The last one's output of two builds, compared by diff, shows the first case that differs. */
#include "openmp.h"
#include "record.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *program;

static int usage(void)
{
    fprintf(stderr, "usage: %s [--blocks N] RECORD | --add RECORD | --cases SHAPE REGIME BLOCK\n",
            program);
    return 2;
}

static frozen_answers ask(const record_row *row, FILE *text)
{
    frozen_answers sum = answers_none(text);
    for (uint64_t i = block_begin(row->block); i < block_end(row->block); i++)
        answers_add(&sum, row->shape, row->which, i);
    return sum;
}

static int print_cases(char **names)
{
    record_row row = {0};
    char *end;
    long block = strtol(names[2], &end, 10);
    if (!sure_shape_from_name(names[0], &row.shape) || !regime_from_name(names[1], &row.which) ||
        !regime_applies(row.shape, row.which) || *end != '\0' || block < 0 || block >= BLOCKS)
        return usage();
    row.block = (int)block;
    (void)ask(&row, stdout);
    return fflush(stdout) == 0 && !ferror(stdout) ? EXIT_SUCCESS : EXIT_FAILURE;
}

/* Compares what a row's cases answer now with its digests. Returns whether all are the same. */
static bool compare(const record_row *row, const frozen_answers *sum)
{
    char differing[128] = "";
    for (int i = 0; i < COLUMNS; i++) {
        if (sum->digests[i] != row->digests[i]) {
            strcat(differing, " ");
            strcat(differing, column_name((column)i));
        }
    }
    const char *shape = sure_shape_name(row->shape), *which = regime_name(row->which);
    if (!row->known)
        printf("%s %s, block %d: not in the record\n", shape, which, row->block);
    else if (differing[0] != '\0')
        printf("%s %s, block %d: other than recorded:%s\n"
               "  compare the output of this with that of a build that holds the record:\n"
               "  %s --cases %s %s %d\n",
               shape, which, row->block, differing, program, shape, which, row->block);
    return row->known && differing[0] == '\0';
}

typedef struct {
    uint64_t cases, rows, failed;
    uint64_t counts[COLUMNS];
} totals;

static void count(totals *sum, const record_row *row, const frozen_answers *found, bool same)
{
    sum->cases += block_end(row->block) - block_begin(row->block);
    sum->rows++;
    sum->failed += !same;
    for (int i = 0; i < COLUMNS; i++)
        sum->counts[i] += found->counts[i];
}

/* A column in which nothing was answered fails, too. */
static int judge(const totals *sum)
{
    bool empty = false;
    printf("%" PRIu64 " cases in %" PRIu64 " blocks;", sum->cases, sum->rows);
    for (int i = 0; i < COLUMNS; i++) {
        printf(" %" PRIu64 " %s", sum->counts[i], column_name((column)i));
        empty = empty || sum->counts[i] == 0;
    }
    printf("\n%" PRIu64 " passed, %" PRIu64 " failed%s\n", sum->rows - sum->failed, sum->failed,
           empty ? "; a column was given nothing to check" : "");
    return sum->failed == 0 && !empty ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int check(const record *all, int blocks)
{
    totals sum = {0};
    OPENMP(omp parallel for schedule(dynamic))
    for (int i = 0; i < all->count; i++) {
        const record_row *row = &all->rows[all->count - 1 - i]; /* the longest first */
        if (row->block >= blocks)
            continue;
        frozen_answers found = ask(row, NULL);
        OPENMP(omp critical)
        count(&sum, row, &found, compare(row, &found));
    }
    return judge(&sum);
}

static int add(record *all, const char *path)
{
    int added = 0;
    OPENMP(omp parallel for schedule(dynamic) reduction(+ : added))
    for (int i = 0; i < all->count; i++) {
        record_row *row = &all->rows[i];
        if (row->known)
            continue;
        frozen_answers found = ask(row, NULL);
        memcpy(row->digests, found.digests, sizeof row->digests);
        row->known = true;
        added++;
    }
    printf("%d rows added\n", added);
    return record_write(all, path) ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    static record all;
    program = argv[0];
    if (argc == 5 && strcmp(argv[1], "--cases") == 0)
        return print_cases(argv + 2);
    bool adds = argc == 3 && strcmp(argv[1], "--add") == 0;
    bool limited = argc == 4 && strcmp(argv[1], "--blocks") == 0;
    int blocks = limited ? atoi(argv[2]) : BLOCKS;
    if ((argc != 2 && !adds && !limited) || blocks < 1)
        return usage();
    const char *path = argv[argc - 1];
    record_lay_out(&all);
    if (!(adds && access(path, F_OK) != 0) && !record_read(&all, path))
        return EXIT_FAILURE;
    return adds ? add(&all, path) : check(&all, blocks);
}
