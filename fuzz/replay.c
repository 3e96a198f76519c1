/* SPDX-License-Identifier: MIT */
/* The plain engine, of any compiler: runs its target over corpora (*.hex: an input a line, its name
 * and its bytes in hexadecimal) and over files that are one input, such as an engine's finds; with
 * -m N first also over N mutants of each, one made of the other, always the same. Fails on a find,
 * by its abort; on a file that can't be read; and when nothing was compared. */
#include "fuzz.h"

enum { LARGEST = 1 << 20, LARGEST_MUTANT = 1 << 12 };

static unsigned long mutants; /* of each input */

typedef struct {
    unsigned long inputs, compared;
} counts;

/* Of its own size, so that a sanitizer sees a read past its end. */
static bool run(const char *name, const uint8_t *bytes, size_t size, counts *sum)
{
    uint8_t *data = malloc(size > 0 ? size : 1);
    if (!data)
        return false;
    memcpy(data, bytes, size);
    if (getenv("FUZZ_VERBOSE"))
        fprintf(stderr, "%s\n", name);
    sum->inputs++;
    sum->compared += fuzz_target(data, size);
    free(data);
    return true;
}

static bool run_mutants(const char *name, const uint8_t *bytes, size_t size, counts *sum)
{
    static uint8_t room[LARGEST];
    bool done = run(name, bytes, size, sum);
    memcpy(room, bytes, size);
    for (unsigned seed = 0; done && fuzz_mutator && seed < mutants; seed++) {
        size = fuzz_mutator(room, size, LARGEST_MUTANT, seed);
        done = run(name, room, size, sum);
    }
    return done;
}

static bool run_line(char *line, counts *sum)
{
    static uint8_t bytes[LARGEST];
    size_t size = 0;
    unsigned byte;
    char *digits = strchr(line, ' ');
    if (!digits)
        return false;
    *digits++ = '\0';
    for (; size < LARGEST && sscanf(digits, "%2x", &byte) == 1; digits += 2)
        bytes[size++] = (uint8_t)byte;
    return strcmp(digits, "\n") == 0 && run_mutants(line, bytes, size, sum);
}

static bool run_corpus(FILE *file, counts *sum)
{
    static char line[2 * LARGEST];
    bool read = true;
    while (read && fgets(line, sizeof line, file))
        read = run_line(line, sum);
    return read && feof(file);
}

static bool run_file(const char *path, FILE *file, counts *sum)
{
    static uint8_t room[LARGEST];
    const char *ending = strrchr(path, '.');
    if (ending && strcmp(ending, ".hex") == 0)
        return run_corpus(file, sum);
    size_t size = fread(room, 1, sizeof room, file);
    return feof(file) && run_mutants(path, room, size, sum);
}

int main(int argc, char **argv)
{
    counts sum = {0};
    bool read = true;
    int first = argc > 2 && strcmp(argv[1], "-m") == 0 ? 3 : 1;
    mutants = first == 3 ? strtoul(argv[2], NULL, 10) : 0;
    for (int i = first; i < argc; i++) {
        FILE *file = fopen(argv[i], "rb");
        if (!file || !run_file(argv[i], file, &sum)) {
            fprintf(stderr, "%s: can't be read\n", argv[i]);
            read = false;
        }
        if (file)
            fclose(file);
    }
    printf("%s: %lu inputs, %lu compared\n", fuzz_name, sum.inputs, sum.compared);
    return sum.compared > 0 && read ? EXIT_SUCCESS : EXIT_FAILURE;
}
