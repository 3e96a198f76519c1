/* SPDX-License-Identifier: MIT */
#include "../../support/json_file.h"
#include "findings.h"

#include <ctype.h>
#include <inttypes.h>
#include <string.h>

#define SCHEMA "https://json.schemastore.org/sarif-2.1.0.json"

#define TEXT_MOST (4 * CASE_LINE_MAX)

/* A fault's name without blanks; a promise's words are one already. */
static void write_rule(const char *name, char rule[CASE_LINE_MAX])
{
    snprintf(rule, CASE_LINE_MAX, "%s", name);
    for (char *at = rule; *at != '\0'; at++)
        *at = *at == ' ' ? '-' : *at;
}

static json_t *rule_json(const char *name)
{
    char rule[CASE_LINE_MAX];
    write_rule(name, rule);
    return json_pack("{s:s, s:{s:s}}", "id", rule, "shortDescription", "text", name);
}

static json_t *rules_json(const promises *required)
{
    json_t *list = json_array();
    char line[CASE_LINE_MAX];
    for (int i = FAULTS_OF_DECISION; i < FAULTS; i++)
        json_array_append_new(list, rule_json(fault_name(i)));
    for (int i = 0; i < required->count; i++) {
        promise_print(&required->list[i], line);
        json_array_append_new(list, rule_json(line));
    }
    return list;
}

/* A path as a URI: of a relative one the reference to it. */
static json_t *uri_json(const char *path)
{
    char text[TEXT_MOST];
    path += strncmp(path, "./", 2) == 0 ? 2 : 0;
    int used = snprintf(text, sizeof text, "%s", *path == '/' ? "file://" : "");
    for (; *path != '\0' && used + 4 < TEXT_MOST; path++) {
        bool plain = isalnum((unsigned char)*path) || strchr("/._-~", *path);
        used += snprintf(text + used, sizeof text - (size_t)used, plain ? "%c" : "%%%02X",
                         (unsigned char)*path);
    }
    return json_string(text);
}

/* Where the candidate is a file, its first line: those who show results take none without. */
static json_t *location_json(const judging_plan *plan, const char *row)
{
    json_t *logical = json_pack("[{s:s}]", "fullyQualifiedName", row);
    if (plan->subject != SUBJECT_LIBRARY)
        return json_pack("{s:o}", "logicalLocations", logical);
    return json_pack("{s:{s:{s:o}, s:{s:i}}, s:o}", "physicalLocation", "artifactLocation", "uri",
                     uri_json(plan->name), "region", "startLine", 1, "logicalLocations", logical);
}

static json_t *result_json(const judging_plan *plan, const judging_row *row, const char *name,
                           const char *figure, const example *shown)
{
    char place[64], rule[CASE_LINE_MAX], text[TEXT_MOST], key[CASE_LINE_MAX + 80];
    judging_words words;
    snprintf(place, sizeof place, "%s %s", judging_topic(row->asks, row->shape, words),
             judging_row_name(row->which));
    write_rule(name, rule);
    int used = snprintf(text, sizeof text, "%s, %s: %s", name, place, figure);
    if (shown) {
        const example_lines lines = example_lines_of(shown);
        snprintf(text + used, sizeof text - (size_t)used, "\ncase    %s\nanswer  %s\nright   %s",
                 lines.question, lines.given, lines.right);
    }
    snprintf(key, sizeof key, "%s/%s", place, rule);
    return json_pack("{s:s, s:s, s:{s:s}, s:[o], s:{s:s}}", "ruleId", rule, "level", "error",
                     "message", "text", text, "locations", location_json(plan, place),
                     "partialFingerprints", "row/v1", key);
}

static json_t *results_json(const judging_plan *plan, const findings *of)
{
    json_t *list = json_array();
    char figure[64];
    promised_row one;
    for (int i = 0; i < of->row_count * FAULTS; i++) {
        const judging_row *row = &of->rows[i / FAULTS];
        int which = i % FAULTS;
        if (which < FAULTS_OF_DECISION || row->sum.faults[which] == 0)
            continue;
        snprintf(figure, sizeof figure, "%" PRIu64 " of %" PRIu64 " cases", row->sum.faults[which],
                 row->sum.cases);
        json_array_append_new(
            list, result_json(plan, row, fault_name(which), figure, &row->sum.faulty[which]));
    }
    for (int i = 0; findings_promised(plan, of, i, &one); i++) {
        snprintf(figure, sizeof figure, "%.9g", one.is);
        if (!one.kept)
            json_array_append_new(list,
                                  result_json(plan, one.row, one.promised, figure, one.shown));
    }
    return list;
}

json_t *sarif_json(const judging_plan *plan, const findings *of)
{
    json_t *driver = json_pack("{s:s, s:s, s:o}", "name", "surehit judge", "version",
                               plan->surehit.version, "rules", rules_json(&plan->required));
    json_t *about = json_pack("{s:o, s:o, s:o, s:o}", "candidate", json_text(plan->name), "name",
                              json_text(of->who.name), "version", json_text(of->who.version),
                              "build", json_text(of->who.build));
    return json_pack("{s:s, s:s, s:[{s:{s:o}, s:o, s:o}]}", "$schema", SCHEMA, "version", "2.1.0",
                     "runs", "tool", "driver", driver, "results", results_json(plan, of),
                     "properties", about);
}
