/* SPDX-License-Identifier: MIT */
/* Does the library still give the answers that are frozen (docs/frozen.md)?
 *
 *     test_frozen [--blocks N] RECORD         holds all blocks, or the first N, against the record
 *     test_frozen --add RECORD                adds the rows that are missing, changes none
 *     test_frozen --cases SHAPE REGIME BLOCK  prints a block's answers, one case a line
 *
 * The last one's output of two builds, compared by diff, shows the first case that differs. */
#include "answers.h"

#include "atomic_file.h"
#include "openmp.h"

#include <inttypes.h>
#include <stdlib.h>
#include <unistd.h>

/* Block 0 has 2048 cases, and each block after it as many as all before. */
enum { BLOCKS = 7, ROWS = SURE_SHAPES * REGIMES * BLOCKS, DIGEST = sizeof ",0123456789abcdef" - 1 };

/* Of a block of cases of a regime of a shape; digests are text, as the record has them, and empty
 * where it has none. */
typedef struct {
    sure_shape shape;
    regime which;
    int block;
    char digests[COLUMNS * DIGEST + 1];
} record_row;

typedef struct {
    int count;
    record_row rows[ROWS];
} record;

static uint64_t block_end(int block)
{
    return UINT64_C(2048) << block;
}

static uint64_t block_begin(int block)
{
    return block == 0 ? 0 : block_end(block - 1);
}

/* Most of these cases take exact numbers: up to 1.8 ms each; the mean of the rest is 20 us. */
static int blocks_of(regime which)
{
    return which == REGIME_BITS || which == REGIME_DEGENERATE ? BLOCKS - 2 : BLOCKS;
}

static void lay_out(record *all)
{
    for (int i = 0; i < ROWS; i++) {
        record_row row = {.shape = (sure_shape)(i / BLOCKS / REGIMES),
                          .which = (regime)(i / BLOCKS % REGIMES),
                          .block = i % BLOCKS};
        if (regime_applies(row.shape, row.which) && row.block < blocks_of(row.which))
            all->rows[all->count++] = row;
    }
}

/* What a row's line begins with; returns its length. */
static size_t begin_line(const record_row *row, char line[100])
{
    return (size_t)snprintf(line, 100, "%s,%s,%d,%" PRIu64, sure_shape_name(row->shape),
                            regime_name(row->which), row->block,
                            block_end(row->block) - block_begin(row->block));
}

/* False, and one line to stderr, for a file that can't be read or has other lines than ours, in our
 * order. */
static bool record_read(record *all, const char *path)
{
    char line[512] = "", begin[100];
    FILE *in = fopen(path, "r");
    bool more = in && fgets(line, sizeof line, in) && fgets(line, sizeof line, in);
    for (record_row *row = all->rows; more && row < all->rows + all->count; row++) {
        size_t length = begin_line(row, begin), digests = sizeof row->digests - 1;
        if (strncmp(line, begin, length) != 0 || strlen(line) != length + digests + 1)
            continue;
        memcpy(row->digests, line + length, digests);
        more = fgets(line, sizeof line, in) != NULL;
    }
    if (!in || more || ferror(in))
        fprintf(stderr, "%s: can't be read, or has no row of this record: %s\n", path, line);
    bool good = in && !more && !ferror(in);
    if (in)
        fclose(in);
    return good;
}

static bool record_write(const record *all, const char *path)
{
    atomic_file file;
    char begin[100];
    if (!atomic_file_open(path, stderr, &file))
        return false;
    fprintf(file.stream, "shape,regime,block,cases");
    for (column c = 0; c < COLUMNS; c++)
        fprintf(file.stream, ",%s", column_name(c));
    fprintf(file.stream, "\n");
    for (const record_row *row = all->rows; row < all->rows + all->count; row++) {
        (void)begin_line(row, begin);
        if (*row->digests)
            fprintf(file.stream, "%s%s\n", begin, row->digests);
    }
    return atomic_file_finish(&file, stderr);
}

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

static void put_digests(const frozen_answers *sum, char *digests)
{
    for (int i = 0; i < COLUMNS; i++)
        snprintf(digests + i * DIGEST, DIGEST + 1, ",%016" PRIx64, sum->digests[i]);
}

/* Compares what a row's cases answer now with its digests. Returns whether all are the same. */
static bool compare(const record_row *row, const frozen_answers *sum)
{
    char now[sizeof row->digests], differing[128] = "";
    put_digests(sum, now);
    for (int i = 0; i < COLUMNS; i++) {
        if (memcmp(row->digests + i * DIGEST, now + i * DIGEST, DIGEST) != 0)
            strcat(strcat(differing, " "), column_name((column)i));
    }
    const char *shape = sure_shape_name(row->shape), *which = regime_name(row->which);
    if (!*row->digests)
        printf("%s %s, block %d: not in the record\n", shape, which, row->block);
    else if (*differing)
        printf("%s %s, block %d: other than recorded:%s\n"
               "  compare the output of this with that of a build that holds the record:\n"
               "  %s --cases %s %s %d\n",
               shape, which, row->block, differing, program, shape, which, row->block);
    return !*differing;
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
        if (*row->digests)
            continue;
        frozen_answers found = ask(row, NULL);
        put_digests(&found, row->digests);
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
    lay_out(&all);
    if (!(adds && access(path, F_OK) != 0) && !record_read(&all, path))
        return EXIT_FAILURE;
    return adds ? add(&all, path) : check(&all, blocks);
}
