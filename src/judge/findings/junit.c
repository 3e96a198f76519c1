/* SPDX-License-Identifier: MIT */
/* JUnit's XML, as far as those who read it agree on it: a test case is a row and a promise. */
#include "findings.h"

#include "../../support/atomic_file.h"
#include "../../support/markup.h"

#include <inttypes.h>

/* name="text" */
static void print_attribute(FILE *out, const char *name, const char *text)
{
    fprintf(out, " %s=\"", name);
    markup_print(out, text);
    fputc('"', out);
}

static void print_property(FILE *out, const char *name, const char *value)
{
    if (*value == '\0')
        return;
    fputs("      <property", out);
    print_attribute(out, "name", name);
    print_attribute(out, "value", value);
    fputs("/>\n", out);
}

static void print_properties(FILE *out, const judging_plan *plan, const findings *of)
{
    char seed[24];
    snprintf(seed, sizeof seed, "%" PRIu64, plan->seed);
    fputs("    <properties>\n", out);
    print_property(out, "name", of->who.name);
    print_property(out, "version", of->who.version);
    print_property(out, "build", of->who.build);
    print_property(out, "judge", plan->surehit.version);
    print_property(out, "truth", plan->by_reference ? "reference" : "exact");
    print_property(out, "set", plan->rows.set ? plan->rows.set->name : "");
    print_property(out, plan->cases ? "cases" : "seed", plan->cases ? plan->cases : seed);
    fputs("    </properties>\n", out);
}

/* `classname` is what readers group by, and `promised` a promise in words; NULL: nothing is. */
static void begin_case(FILE *out, const judging_row *row, const char *promised)
{
    char name[CASE_LINE_MAX];
    snprintf(name, sizeof name, "%s%s%.400s", judging_row_name(row->which), promised ? ": " : "",
             promised ? promised : "");
    fputs("    <testcase", out);
    judging_words words;
    print_attribute(out, "classname", judging_topic(row->asks, row->shape, words));
    print_attribute(out, "name", name);
}

static void print_row(FILE *out, const judging_row *row)
{
    begin_case(out, row, NULL);
    fprintf(out, "><system-out>wrong %" PRIu64 " of %" PRIu64 "</system-out></testcase>\n",
            row->sum.wrong, row->sum.valid);
}

static void print_failure(FILE *out, const promised_row *one)
{
    char message[CASE_LINE_MAX];
    snprintf(message, sizeof message, "%.9g", one->is);
    fputs("><failure", out);
    print_attribute(out, "type", one->promised);
    print_attribute(out, "message", message);
    fputc('>', out);
    if (one->shown) {
        const example_lines lines = example_lines_of(one->shown);
        markup_print(out, lines.question);
        fputs("\nanswer  ", out);
        markup_print(out, lines.given);
        fprintf(out, "\nright   %s", lines.right);
    }
    fputs("</failure></testcase>\n", out);
}

static void print_promised(FILE *out, const promised_row *one)
{
    begin_case(out, one->row, one->promised);
    if (!one->kept)
        print_failure(out, one);
    else
        fputs(one->none ? "><skipped/></testcase>\n" : "/>\n", out);
}

bool junit_write(const judging_plan *plan, const findings *of, const char *path, FILE *messages)
{
    atomic_file file;
    promised_row one;
    int tests = 0, failures = 0, skipped = 0;
    if (!path)
        return true;
    if (!atomic_file_open(path, messages, &file))
        return false;
    for (; findings_promised(plan, of, tests, &one); tests++) {
        failures += !one.kept;
        skipped += one.kept && one.none;
    }
    FILE *out = file.stream;
    tests = plan->required.count > 0 ? tests : of->row_count;
    fprintf(out,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites name=\"surehit judge\" tests=\"%d\" failures=\"%d\" errors=\"0\">\n"
            "  <testsuite",
            tests, failures);
    print_attribute(out, "name", plan->name);
    fprintf(out, " tests=\"%d\" failures=\"%d\" errors=\"0\" skipped=\"%d\">\n", tests, failures,
            skipped);
    print_properties(out, plan, of);
    for (int i = 0; plan->required.count == 0 && i < of->row_count; i++)
        print_row(out, &of->rows[i]);
    for (int i = 0; findings_promised(plan, of, i, &one); i++)
        print_promised(out, &one);
    fputs("  </testsuite>\n</testsuites>\n", out);
    return atomic_file_finish(&file, messages);
}
