/* The report as JSON: one object; a number that is infinite or unknown is null. */
#include "judging_report.h"

#include <inttypes.h>
#include <math.h>

static void print_string(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text != '\0'; text++) {
        unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            fputc('\\', out);
        if (c < ' ')
            fprintf(out, "\\u%04x", (unsigned)c);
        else
            fputc(c, out);
    }
    fputc('"', out);
}

static void print_name(FILE *out, const char *before, const char *name)
{
    fputs(before, out);
    print_string(out, name);
    fputs(": ", out);
}

static void print_text(FILE *out, const char *before, const char *name, const char *text)
{
    print_name(out, before, name);
    print_string(out, text);
}

static void print_count(FILE *out, const char *before, const char *name, uint64_t count)
{
    print_name(out, before, name);
    fprintf(out, "%" PRIu64, count);
}

static void print_number(FILE *out, const char *before, const char *name, double number)
{
    print_name(out, before, name);
    if (isfinite(number))
        fprintf(out, "%.9g", number);
    else
        fputs("null", out);
}

static void print_errors(FILE *out, const char *name, const error_summary *of)
{
    print_name(out, ", ", name);
    print_count(out, "{", "hits", of->count);
    print_count(out, ", ", "correctly_rounded", of->right);
    print_number(out, ", ", "median", of->median);
    print_number(out, ", ", "99", of->q99);
    print_number(out, ", ", "99.99", of->q9999);
    print_number(out, ", ", "most", of->most);
    fputc('}', out);
}

/* Element n > 0: ulps above 2^(n - 2), up to 2^(n - 1); element 0: none. */
static void print_classes(FILE *out, const uint64_t classes[SIZE_CLASSES])
{
    print_name(out, ", ", "t_ulps_by_powers_of_two");
    for (int i = 0; i < SIZE_CLASSES; i++)
        fprintf(out, "%s%" PRIu64, i > 0 ? ", " : "[", classes[i]);
    fputc(']', out);
}

static void print_faults(FILE *out, const verdict *sum)
{
    const char *before = "{";
    print_name(out, ", ", "faults");
    for (int i = 0; i < FAULTS; i++) {
        print_count(out, before, fault_name((fault)i), sum->faults[i]);
        before = ", ";
    }
    fputc('}', out);
}

static void print_time(FILE *out, const char *before, const char *name, double nanoseconds)
{
    print_number(out, before, name, nanoseconds > 0 ? nanoseconds : INFINITY);
}

static void print_row(FILE *out, const char *before, const judging_row *row)
{
    const verdict *sum = &row->sum;
    fputs(before, out);
    print_text(out, "    {", "shape", sure_shape_name(row->shape));
    print_text(out, ", ", "regime", judging_row_name(row));
    print_count(out, ", ", "cases", sum->cases);
    print_count(out, ", ", "valid", sum->valid);
    print_count(out, ", ", "hits", sum->hits);
    print_count(out, ", ", "skipped", sum->skipped);
    print_count(out, ", ", "unasked", sum->unasked);
    print_count(out, ", ", "wrong", sum->wrong);
    print_number(out, ", ", "wrong_from", sum->wrong_share.lower);
    print_number(out, ", ", "wrong_to", sum->wrong_share.upper);
    print_faults(out, sum);
    print_errors(out, "t_ulps", &sum->t_ulps);
    print_errors(out, "t_relative", &sum->t_relative);
    print_errors(out, "normal_ulps", &sum->normal_ulps);
    print_errors(out, "normal", &sum->normal);
    print_classes(out, sum->t_classes);
    print_name(out, ", ", "nanoseconds");
    print_time(out, "{", "candidate", row->times.candidate);
    print_time(out, ", ", "textbook", row->times.textbook);
    print_time(out, ", ", "certain", row->times.certain);
    fputs("}}", out);
}

static void print_worst(FILE *out, const char *before, const worst_case *one)
{
    char line[CASE_LINE_MAX];
    judging_row met = {.which = one->which};
    fputs(before, out);
    print_text(out, "    {", "kind", worst_name(one->kind));
    print_text(out, ", ", "shape", sure_shape_name(one->shape));
    print_text(out, ", ", "regime", judging_row_name(&met));
    case_print(&one->found.question, line);
    print_text(out, ", ", "case", line);
    reply_print(&one->found.given, line);
    print_text(out, ", ", "answer", line);
    case_answer_print(&one->found.truth, line);
    print_text(out, ", ", "right", line);
    if (one->kind >= FAULTS)
        print_number(out, ", ", "ulps", worst_size(one->kind, &one->found, one->in));
    fputc('}', out);
}

static void print_promise(FILE *out, const char *before, const promise *one,
                          const judging_row *rows, int count)
{
    char line[CASE_LINE_MAX];
    double is;
    int broken = 0;
    for (int i = 0; i < count; i++)
        broken += !promise_kept(one, &rows[i].sum, &is);
    promise_print(one, line);
    fputs(before, out);
    print_text(out, "    {", "promise", line);
    print_name(out, ", ", "kept");
    fprintf(out, "%s}", broken > 0 ? "false" : "true");
}

static const char *separator(int i)
{
    return i > 0 ? ",\n" : "\n";
}

void judging_print_json(FILE *out, const judging_subject *subject, const judging_row *rows,
                        int row_count, const worst_case *list, int list_count, const promises *all)
{
    print_text(out, "{\n  ", "candidate", subject->candidate);
    print_text(out, ",\n  ", "truth", subject->truth);
    print_count(out, ",\n  ", "seed", subject->seed);
    print_count(out, ",\n  ", "count", subject->count);
    print_name(out, ",\n  ", "time_includes_text");
    fputs(subject->counts_text ? "true" : "false", out);
    print_name(out, ",\n  ", "rows");
    fputc('[', out);
    for (int i = 0; i < row_count; i++)
        print_row(out, separator(i), &rows[i]);
    print_name(out, "],\n  ", "worst");
    fputc('[', out);
    for (int i = 0; i < list_count; i++)
        print_worst(out, separator(i), &list[i]);
    print_name(out, "],\n  ", "required");
    fputc('[', out);
    for (int i = 0; i < all->count; i++)
        print_promise(out, separator(i), &all->list[i], rows, row_count);
    fputs("]\n}\n", out);
}
