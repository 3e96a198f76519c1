#include "bench_report.h"

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

/* The value of a "model name : ..." line, cut out in place; NULL for any other. */
static char *model_name(char *line)
{
    char *colon = strchr(line, ':');
    if (strncmp(line, "model name", strlen("model name")) != 0 || !colon)
        return NULL;
    colon[strcspn(colon, "\n")] = '\0';
    return colon + 1 + strspn(colon + 1, " \t");
}

const char *bench_cpu_name(void)
{
    static char line[256];
    char *name = NULL;
    FILE *in = fopen("/proc/cpuinfo", "r");
    while (in && !name && fgets(line, sizeof line, in))
        name = model_name(line);
    if (in)
        fclose(in);
    return name && name[0] != '\0' ? name : "unknown";
}

/* The table. */

void bench_print_head(FILE *out, const bench_plan *plan, const bench_machine *machine)
{
    fprintf(out,
            "Nanoseconds a ray: one thread, one ray a call, %d cases a row, all subjects in\n"
            "turns, up to %d repeats. Medians and quartiles of the quiet ones, in which nothing\n"
            "else slowed the processor's core down.\n"
            "  %s\n  %s\n  %s\n\n"
            "%-9s %-13s %-9s %9s %8s %17s %9s %17s %7s\n",
            plan->cases, plan->repeats, machine->cpu, machine->compiler, machine->flags, "shape",
            "regime", "tier", "ns", "/naive", "", "/textbook", "", "quiet");
}

static void print_ratio(FILE *out, int width, const bench_figure *ratio)
{
    char spread[40];
    snprintf(spread, sizeof spread, "%.2f..%.2f", ratio->lower, ratio->upper);
    fprintf(out, " %*.2f %17s", width, ratio->median, spread);
}

static bool is_shown(const bench_plan *plan, const bench_row *row, int subject)
{
    return row->results[subject].asked && (plan->subjects[subject] || subject == BENCH_NAIVE);
}

void bench_print_row(FILE *out, const bench_plan *plan, const bench_row *row)
{
    for (int subject = 0; subject < BENCH_SUBJECTS; subject++) {
        const bench_result *result = &row->results[subject];
        if (!is_shown(plan, row, subject))
            continue;
        fprintf(out, "%-9s %-13s %-9s %9.1f", sure_shape_name(row->shape), regime_name(row->which),
                bench_subject_name(subject), result->nanoseconds.median);
        print_ratio(out, 8, &result->over_naive);
        print_ratio(out, 9, &result->over_textbook);
        fprintf(out, " %5.0f %%\n", 100 * row->quiet);
    }
}

/* JSON. */

static void print_string(FILE *out, const char *text)
{
    fputc('"', out);
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '"' || *c == '\\')
            fputc('\\', out);
        if ((unsigned char)*c < ' ')
            fprintf(out, "\\u%04x", (unsigned)(unsigned char)*c);
        else
            fputc(*c, out);
    }
    fputc('"', out);
}

static void print_member(FILE *out, const char *name, const char *text)
{
    fprintf(out, "  \"%s\": ", name);
    print_string(out, text);
    fputs(",\n", out);
}

static void print_figure(FILE *out, const char *name, const bench_figure *figure)
{
    fprintf(out, ", \"%s\": {\"median\": %.9g, \"lower_quartile\": %.9g, \"upper_quartile\": %.9g}",
            name, figure->median, figure->lower, figure->upper);
}

static void print_result(FILE *out, const bench_row *row, int subject, const char *before)
{
    const bench_result *result = &row->results[subject];
    fprintf(out, "%s    {\"shape\": \"%s\", \"regime\": \"%s\", \"tier\": \"%s\"", before,
            sure_shape_name(row->shape), regime_name(row->which), bench_subject_name(subject));
    fprintf(out, ", \"cases\": %d, \"repeats\": %d, \"quiet\": %.3g, \"hits\": %llu", row->cases,
            row->repeats, row->quiet, (unsigned long long)result->hits);
    print_figure(out, "nanoseconds", &result->nanoseconds);
    print_figure(out, "over_naive", &result->over_naive);
    print_figure(out, "over_textbook", &result->over_textbook);
    fputc('}', out);
}

void bench_print_json(FILE *out, const bench_plan *plan, const bench_machine *machine,
                      const bench_row *rows, int count)
{
    const char *before = "";
    fputs("{\n", out);
    print_member(out, "cpu", machine->cpu);
    print_member(out, "compiler", machine->compiler);
    print_member(out, "flags", machine->flags);
    fputs("  \"threads\": 1,\n  \"results\": [\n", out);
    for (int i = 0; i < count; i++) {
        for (int subject = 0; subject < BENCH_SUBJECTS; subject++) {
            if (!is_shown(plan, &rows[i], subject))
                continue;
            print_result(out, &rows[i], subject, before);
            before = ",\n";
        }
    }
    fputs("\n  ]\n}\n", out);
}
