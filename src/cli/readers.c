/* SPDX-License-Identifier: MIT */
/* What an option's value may be. */
#include "options.h"

#include "../judge/referee/entry.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *cli_flag(const cli_option *row, const char *value)
{
    (void)value;
    *(bool *)row->to = true;
    return NULL;
}

const char *cli_text(const cli_option *row, const char *value)
{
    *(const char **)row->to = value;
    return NULL;
}

const char *cli_texts(const cli_option *row, const char *value)
{
    cli_list *list = row->to;
    if (list->count == CLI_LIST_MOST)
        return "no more than " CLI_NUMERAL(CLI_LIST_MOST) " of them";
    list->texts[list->count++] = value;
    return NULL;
}

/* Digits and nothing else. */
static bool read_number(const char *text, uint64_t least, uint64_t most, uint64_t *number)
{
    if (text[strspn(text, "0123456789")] != '\0')
        return false;
    errno = 0;
    uintmax_t read = strtoumax(text, NULL, 10);
    if (errno != 0 || read < least || read > most)
        return false;
    *number = read;
    return true;
}

const char *cli_number(const cli_option *row, const char *value)
{
    static char expected[80];
    if (read_number(value, row->least, row->most, row->to))
        return NULL;
    snprintf(expected, sizeof expected, "a whole number from %" PRIu64 " to %" PRIu64, row->least,
             row->most);
    return expected;
}

const char *cli_int(const cli_option *row, const char *value)
{
    uint64_t number = 0;
    cli_option wide = *row;
    wide.to = &number;
    const char *expected = cli_number(&wide, value);
    if (!expected)
        *(int *)row->to = (int)number;
    return expected;
}

/* Names. */

const char *cli_word(const cli_option *row, const char *value)
{
    static char expected[512];
    size_t length = 0;
    for (int i = 0; row->words[i]; i++) {
        const char *between = i == 0 ? "" : row->words[i + 1] ? ", " : " or ";
        if (strcmp(value, row->words[i]) == 0) {
            *(int *)row->to = i;
            return NULL;
        }
        if (length < sizeof expected)
            length += (size_t)snprintf(expected + length, sizeof expected - length, "%s%s", between,
                                       row->words[i]);
    }
    return expected;
}

const char *cli_mark(const cli_option *row, const char *value)
{
    int which;
    const cli_option named = {.to = &which, .words = row->words};
    const char *expected = cli_word(&named, value);
    if (!expected)
        ((bool *)row->to)[which] = true;
    return expected;
}

void cli_print_regimes(FILE *out)
{
    int column = 80;
    fputs("\nRegimes:", out);
    for (int i = 0; i < REGIMES; i++) {
        const char *name = regime_name((regime)i);
        int length = (int)strlen(name) + 1;
        if (column + length > 78) {
            fputs("\n    ", out);
            column = 4;
        }
        fprintf(out, " %s", name);
        column += length;
    }
    fputc('\n', out);
}

#define SECONDS_MOST 3600

const char *cli_seconds(const cli_option *row, const char *value)
{
    char *end;
    double seconds = strtod(value, &end);
    if (*end != '\0' || !(seconds >= 0.001 && seconds <= SECONDS_MOST))
        return "seconds from 0.001 to " CLI_NUMERAL(SECONDS_MOST);
    *(double *)row->to = seconds;
    return NULL;
}

/* One of so many tiers. */
static const char *first_tier(const cli_option *row, const char *value, int count)
{
    const char *names[SURE_TIERS + 1] = {NULL};
    for (int i = 0; i < count; i++)
        names[i] = sure_tier_name((sure_tier)i);
    const cli_option named = {.to = row->to, .words = names};
    return cli_word(&named, value);
}

const char *cli_tier(const cli_option *row, const char *value)
{
    return first_tier(row, value, SURE_TIERS);
}

const char *cli_fallible_tier(const cli_option *row, const char *value)
{
    return first_tier(row, value, SURE_TIER_EXACT);
}

/* Shapes and regimes. */

const char *cli_shape(const cli_option *row, const char *value)
{
    regime_rows *asked = row->to;
    const char *names[SURE_SHAPES + 1] = {NULL};
    int shape;
    for (int i = 0; i < SURE_SHAPES; i++)
        names[i] = sure_shape_name((sure_shape)i);
    const cli_option named = {.to = &shape, .words = names};
    const char *expected = cli_word(&named, value);
    if (!expected)
        asked->shapes[shape] = asked->some_shapes = true;
    return expected;
}

const char *cli_regime(const cli_option *row, const char *value)
{
    regime_rows *asked = row->to;
    const char *names[REGIMES + 1] = {NULL};
    int which;
    for (int i = 0; i < REGIMES; i++)
        names[i] = regime_name((regime)i);
    const cli_option named = {.to = &which, .words = names};
    const char *expected = cli_word(&named, value);
    if (!expected)
        asked->regimes[which] = asked->some_regimes = true;
    return expected;
}

const char *cli_set(const cli_option *row, const char *value)
{
    const char *names[CLI_LIST_MOST] = {NULL};
    int set;
    for (int i = 0; case_sets[i].name; i++)
        names[i] = case_sets[i].name;
    const cli_option named = {.to = &set, .words = names};
    const char *expected = cli_word(&named, value);
    if (!expected)
        ((regime_rows *)row->to)->set = &case_sets[set];
    return expected;
}

void cli_print_sets(FILE *out)
{
    cli_print_regimes(out);
    fputs("\nSets, with the SHA-256 of their lines:\n", out);
    for (const case_set *set = case_sets; set->name; set++)
        fprintf(out, "     %s  %s\n", set->name, set->sha256);
}

const char *cli_entry(const cli_option *row, const char *value)
{
    entry all;
    const char *expected = entry_read(value, &all);
    if (!expected && all.declared)
        *(const char **)row->to = value;
    return expected || all.declared ? expected : "a word";
}

int cli_rows_check(const regime_rows *asked)
{
    const char *missing = "";
    for (int i = 0; i < SURE_SHAPES * REGIMES; i++) {
        if (regime_rows_have(asked, i / REGIMES, i % REGIMES))
            return 0;
        if (asked->regimes[i % REGIMES])
            missing = regime_name((regime)(i % REGIMES));
    }
    return cli_wrong("--regime '%s': expected a regime that the shape%s has", missing,
                     asked->set ? ", and the set," : "");
}

int cli_rows_numbers(const regime_rows *asked, const char *numbered, uint64_t *count,
                     uint64_t *seed)
{
    if (!asked->set)
        return 0;
    if (numbered)
        return cli_wrong("--set says how many cases there are, and their seed: '--%s'", numbered);
    *count = asked->set->count;
    *seed = asked->set->seed;
    return 0;
}
