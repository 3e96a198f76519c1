/* What bench_measure found, for people (a table) and for programs (JSON). */
#include "bench.h"

#include "../../support/json_file.h"

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
    printf("Nanoseconds a ray: one thread, one ray a call, %d cases a row, all subjects in\n"
           "turns, up to %d repeats. Medians and quartiles of the quiet ones, in which nothing\n"
           "else slowed the processor's core down.\n"
           "  %s\n  %s\n  %s\n\n"
           "%-9s %-13s %-9s %9s %8s %17s %9s %17s %7s\n",
           plan->cases, plan->repeats, bench_cpu_name(), bench_compiler_name(), flags, "shape",
           "regime", "tier", "ns", "/naive", "", "/textbook", "", "quiet");
}

static void print_ratio(int width, const bench_figure *ratio)
{
    char spread[40];
    snprintf(spread, sizeof spread, "%.2f..%.2f", ratio->lower, ratio->upper);
    printf(" %*.2f %17s", width, ratio->median, spread);
}

void bench_print_row(const bench_plan *plan, const bench_row *row)
{
    for (int subject = 0; subject < BENCH_SUBJECTS; subject++) {
        const bench_result *result = &row->results[subject];
        if (!bench_shows(plan, subject))
            continue;
        printf("%-9s %-13s %-9s %9.1f", sure_shape_name(row->shape), regime_name(row->which),
               bench_subject_name(subject), result->nanoseconds.median);
        print_ratio(8, &result->over_naive);
        print_ratio(9, &result->over_textbook);
        printf(" %5.0f %%\n", 100 * row->quiet);
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
        "{s:s, s:s, s:s, s:i, s:i, s:o, s:I, s:o, s:o, s:o}", "shape", sure_shape_name(row->shape),
        "regime", regime_name(row->which), "tier", bench_subject_name(subject), "cases", row->cases,
        "repeats", row->repeats, "quiet", json_measured(row->quiet), "hits",
        (json_int_t)result->hits, "nanoseconds", figure_json(&result->nanoseconds), "over_naive",
        figure_json(&result->over_naive), "over_textbook", figure_json(&result->over_textbook));
}

json_t *bench_json(const bench_plan *plan, const char *flags, const bench_row *rows, int count)
{
    json_t *results = json_array();
    for (int i = 0; i < count; i++) {
        for (int subject = 0; subject < BENCH_SUBJECTS; subject++) {
            if (bench_shows(plan, subject))
                json_array_append_new(results, result_json(&rows[i], subject));
        }
    }
    return json_pack("{s:s, s:s, s:s, s:i, s:o}", "cpu", bench_cpu_name(), "compiler",
                     bench_compiler_name(), "flags", flags, "threads", 1, "results", results);
}
