/* SPDX-License-Identifier: MIT */
/* libFuzzer (clang -fsanitize=fuzzer). */
#include "counts.h"
#include "fuzz.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max, unsigned seed);
size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max);

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    if (fuzz_counts_open())
        return 0;
    fprintf(stderr, "FUZZ_COUNTS: can't be mapped\n");
    return 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_count_execution();
    fuzz_count_compared(fuzz_target(data, size));
    return 0;
}

/* The target's mutator knows its numbers, the engine's what has been found to matter. */
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max, unsigned seed)
{
    if (!fuzz_mutator || seed % 2 == 0)
        return LLVMFuzzerMutate(data, size, max);
    size_t made = fuzz_mutator(data, size, max, seed / 2);
    return seed / 2 % 4 == 0 ? LLVMFuzzerMutate(data, made, max) : made;
}
