/* SPDX-License-Identifier: MIT */
#include "facts.h"

#include "export.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

#define FACTS_MOST 192

static struct {
    char name[48], words[640];
    int has_words;
    double is;
} facts[FACTS_MOST];
static int count;

void facts_clear(void)
{
    count = 0;
}

void facts_number(const char *name, double is)
{
    assert(count < FACTS_MOST && strlen(name) < sizeof facts->name);
    strcpy(facts[count].name, name);
    facts[count].is = is;
    facts[count].has_words = 0;
    count++;
}

void facts_words(const char *name, const char *words)
{
    facts_number(name, 0);
    facts[count - 1].has_words = 1;
    snprintf(facts[count - 1].words, sizeof facts->words, "%s", words);
}

void facts_member(const char *of, const char *member, double is)
{
    char name[sizeof facts->name];
    snprintf(name, sizeof name, "%s/%s", of, member);
    facts_number(name, is);
}

int WASM_EXPORT(facts_count)(void)
{
    return count;
}

const char *WASM_EXPORT(fact_name)(int i)
{
    return facts[i].name;
}

double WASM_EXPORT(fact_number)(int i)
{
    return facts[i].is;
}

/* NULL: it is a number. */
const char *WASM_EXPORT(fact_words)(int i)
{
    return facts[i].has_words ? facts[i].words : NULL;
}
