#include "record.h"

#include "atomic_file.h"

#include <inttypes.h>
#include <string.h>

uint64_t block_begin(int block)
{
    return block == 0 ? 0 : block_end(block - 1);
}

uint64_t block_end(int block)
{
    return UINT64_C(2048) << block;
}

/* Most of these cases take exact numbers: up to 1.8 ms each; the mean of the rest is 20 us. */
int blocks_of(regime which)
{
    return which == REGIME_BITS || which == REGIME_DEGENERATE ? BLOCKS - 2 : BLOCKS;
}

void record_lay_out(record *all)
{
    all->count = 0;
    for (sure_shape shape = 0; shape < SURE_SHAPES; shape++) {
        for (regime which = 0; which < REGIMES; which++) {
            int blocks = regime_applies(shape, which) ? blocks_of(which) : 0;
            for (int block = 0; block < blocks; block++)
                all->rows[all->count++] =
                    (record_row){.shape = shape, .which = which, .block = block};
        }
    }
}

static void print_heading(FILE *out)
{
    fprintf(out, "shape,regime,block,cases");
    for (column c = 0; c < COLUMNS; c++)
        fprintf(out, ",%s", column_name(c));
    fprintf(out, "\n");
}

static void print_row(FILE *out, const record_row *row)
{
    fprintf(out, "%s,%s,%d,%" PRIu64, sure_shape_name(row->shape), regime_name(row->which),
            row->block, block_end(row->block) - block_begin(row->block));
    for (int i = 0; i < COLUMNS; i++)
        fprintf(out, ",%016" PRIx64, row->digests[i]);
    fprintf(out, "\n");
}

static record_row *find(record *all, const char *shape, const char *which, int block)
{
    for (int i = 0; i < all->count; i++) {
        record_row *row = &all->rows[i];
        if (strcmp(shape, sure_shape_name(row->shape)) == 0 &&
            strcmp(which, regime_name(row->which)) == 0 && block == row->block)
            return row;
    }
    return NULL;
}

static bool read_row(record *all, const char *line)
{
    char shape[32], which[32];
    int block, end = 0;
    uint64_t cases;
    if (sscanf(line, "%31[^,],%31[^,],%d,%" SCNu64 "%n", shape, which, &block, &cases, &end) != 4)
        return false;
    record_row *row = find(all, shape, which, block);
    if (!row || row->known || cases != block_end(block) - block_begin(block))
        return false;
    line += end;
    for (int i = 0; i < COLUMNS; i++, line += end) {
        if (sscanf(line, ",%16" SCNx64 "%n", &row->digests[i], &end) != 1)
            return false;
    }
    row->known = true;
    return strcmp(line, "\n") == 0;
}

bool record_read(record *all, const char *path)
{
    char line[512];
    FILE *in = fopen(path, "r");
    if (!in) {
        perror(path);
        return false;
    }
    int number = 1;
    bool good = fgets(line, sizeof line, in) != NULL; /* the heading */
    while (good && fgets(line, sizeof line, in)) {
        number++;
        good = read_row(all, line);
    }
    good = good && !ferror(in);
    if (!good)
        fprintf(stderr, "%s:%d: no row of this record, or twice\n", path, number);
    fclose(in);
    return good;
}

bool record_write(const record *all, const char *path)
{
    atomic_file file;
    if (!atomic_file_open(path, stderr, &file))
        return false;
    print_heading(file.stream);
    for (int i = 0; i < all->count; i++) {
        if (all->rows[i].known)
            print_row(file.stream, &all->rows[i]);
    }
    return atomic_file_finish(&file, stderr);
}
