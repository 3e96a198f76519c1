/* SPDX-License-Identifier: MIT */
/* What bench_measure found, for people (a table) and for programs (JSON). */
#include "bench.h"

#include "instructions.h"

#include "../../support/json_file.h"

#include <math.h>
#include <string.h>

const char *bench_compiler_name(void)
{
#if defined __clang__
    return __VERSION__; /* begins with the name */
#elif defined __GNUC__
    return "GCC " __VERSION__;
#else
    return "unknown";
#endif
}

const char *bench_cpu_name(void)
{
    static char name[256];
    char line[256];
    FILE *in = fopen("/proc/cpuinfo", "r");
    strcpy(name, "unknown");
    while (in && fgets(line, sizeof line, in) && sscanf(line, "model name : %255[^\n]", name) != 1)
        ;
    if (in)
        fclose(in);
    return name;
}

/* The table. */

void bench_print_head(const bench_plan *plan, const char *flags)
{
    char asked[64] = "one ray a call";
    if (plan->block > 0)
        snprintf(asked, sizeof asked, "naive: one ray a call, others: %d%s", plan->block,
                 plan->objects ? " objects" : "");
    printf("Nanoseconds a ray%s: one thread, %s, %d cases a row, all subjects in\n"
           "turns, up to %d repeats. Medians and quartiles of the quiet ones, in which nothing\n"
           "else slowed the processor's core down. Beside naive code, textbook, and the faster\n"
           "of these two. Instructions a ray, of the first %d cases: %s.\n"
           "  %s\n  %s\n  %s\n\n"
           "%-9s %-13s %-8s %-11s %8s %6s %7s %9s %8s %17s %6s\n",
           plan->floats ? " in floats" : "", asked, plan->cases, plan->repeats, INSTRUCTIONS_CASES,
           plan->instructions ? "by valgrind" : "with --instructions", bench_cpu_name(),
           bench_compiler_name(), flags, "shape", "regime", "rays", "tier", "ns", "instr", "/naive",
           bench_shows(plan, BENCH_NAIVE_BLOCK) ? "/block" : "/textbook", "/faster", "", "quiet");
}

void bench_print_row(const bench_plan *plan, const bench_row *row)
{
    for (int subject = 0; subject < BENCH_SUBJECTS && row->cases > 0; subject++) {
        const bench_result *result = &row->results[subject];
        const bench_figure *ratio = &result->over_faster;
        const bool beside_block = bench_shows(plan, BENCH_NAIVE_BLOCK);
        char spread[40], instructions[16] = "-";
        if (!bench_shows(plan, subject))
            continue;
        if (result->instructions >= 0)
            snprintf(instructions, sizeof instructions, "%.0f", result->instructions);
        snprintf(spread, sizeof spread, "%.2f..%.2f", ratio->lower, ratio->upper);
        printf("%-9s %-13s %-8s %-11s %8.1f %6s %7.2f %9.2f %8.2f %17s %4.0f %%\n",
               sure_shape_name(row->shape), regime_name(row->which), bench_rays_names[row->rays],
               bench_subject_name(subject), result->nanoseconds.median, instructions,
               result->over_naive.median,
               beside_block ? result->over_block.median : result->over_textbook.median,
               ratio->median, spread, 100 * row->quiet);
    }
}

/* JSON. */

static json_t *figure_json(const bench_figure *figure)
{
    return json_pack("{s:o, s:o, s:o}", "median", json_measured(figure->median), "lower_quartile",
                     json_measured(figure->lower), "upper_quartile", json_measured(figure->upper));
}

static json_t *result_json(const bench_row *row, int subject)
{
    const bench_result *result = &row->results[subject];
    return json_pack(
        "{s:s, s:s, s:s, s:s, s:i, s:i, s:o, s:I, s:o, s:o, s:o, s:o, s:o, s:o}", "shape",
        sure_shape_name(row->shape), "regime", regime_name(row->which), "rays",
        bench_rays_names[row->rays], "tier", bench_subject_name(subject), "cases", row->cases,
        "repeats", row->repeats, "quiet", json_measured(row->quiet), "hits",
        (json_int_t)result->hits, "nanoseconds", figure_json(&result->nanoseconds), "over_naive",
        figure_json(&result->over_naive), "over_textbook", figure_json(&result->over_textbook),
        "over_faster", figure_json(&result->over_faster), "over_naive_block",
        isnan(result->over_block.median) ? json_null() : figure_json(&result->over_block),
        "instructions",
        result->instructions < 0 ? json_null() : json_measured(result->instructions));
}

json_t *bench_json(const bench_plan *plan, const char *flags, const bench_row *rows, int count)
{
    json_t *results = json_array();
    for (int i = 0; i < count; i++) {
        for (int subject = 0; subject < BENCH_SUBJECTS; subject++) {
            if (bench_shows(plan, subject) && rows[i].cases > 0)
                json_array_append_new(results, result_json(&rows[i], subject));
        }
    }
    return json_pack("{s:s, s:s, s:s, s:i, s:b, s:i, s:b, s:o}", "cpu", bench_cpu_name(),
                     "compiler", bench_compiler_name(), "flags", flags, "threads", 1, "floats",
                     plan->floats, "block", plan->block, "objects", plan->objects, "results",
                     results);
}
