/* What bench_measure found, for people (a table) and for programs (JSON). */
#ifndef JUDGE_BENCH_REPORT_H
#define JUDGE_BENCH_REPORT_H

#include "bench.h"

#include <jansson.h>
#include <stdio.h>

/* How the routines were compiled and what they run on; any text. */
typedef struct {
    const char *compiler, *flags, *cpu;
} bench_machine;

/* The processor's own name, or "unknown"; valid until the next call. */
const char *bench_cpu_name(void);

/* The compiler of this file, as it names itself. */
const char *bench_compiler_name(void);

/* The table's head, and a row's lines: the plan's subjects and the naive peer. */
void bench_print_head(FILE *out, const bench_plan *plan, const bench_machine *machine);
void bench_print_row(FILE *out, const bench_plan *plan, const bench_row *row);

/* One object with every figure of every row; NULL when there is no memory. */
json_t *bench_json(const bench_plan *plan, const bench_machine *machine, const bench_row *rows,
                   int count);

#endif
