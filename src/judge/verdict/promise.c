/* SPDX-License-Identifier: MIT */
#include "promise.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name, *unit;
} kinds[] = {
    [PROMISE_DECISIONS] = {"decisions", ""},   [PROMISE_CONTRACT] = {"contract", ""},
    [PROMISE_T_ULPS] = {"t", "ulp"},           [PROMISE_T_RELATIVE] = {"t", ""},
    [PROMISE_NORMAL_ULPS] = {"normal", "ulp"}, [PROMISE_NORMAL] = {"normal", ""},
};
#define PROMISE_KINDS (int)(sizeof kinds / sizeof *kinds)

static bool has_limit(promise_kind kind)
{
    return kind >= PROMISE_T_ULPS;
}

/* "" or "<=X" and the unit. */
static bool read_limit(const char *text, promise_kind kind, double *most)
{
    char *end;
    *most = 0;
    if (*text == '\0')
        return !has_limit(kind);
    if (strncmp(text, "<=", 2) != 0 || kind == PROMISE_CONTRACT || text[2] == ' ')
        return false;
    *most = strtod(text + 2, &end);
    const double greatest = kind == PROMISE_DECISIONS ? 1 : DBL_MAX; /* they are a share */
    return end != text + 2 && *most >= 0 && *most <= greatest && strcmp(end, kinds[kind].unit) == 0;
}

/* `@M` behind decisions. */
static const char *read_margin(const char *text, promise *one)
{
    char *end;
    one->margin = 0;
    if (one->kind != PROMISE_DECISIONS || *text != '@')
        return text;
    one->margin = strtod(text + 1, &end);
    return one->margin > 0 && one->margin <= MARGIN_MOST ? end : text;
}

static bool read_one(const char *text, promise *one)
{
    for (int kind = 0; kind < PROMISE_KINDS; kind++) {
        size_t length = strlen(kinds[kind].name);
        if (strncmp(text, kinds[kind].name, length) != 0)
            continue;
        one->kind = (promise_kind)kind;
        if (read_limit(read_margin(text + length, one), one->kind, &one->most))
            return true;
    }
    return false;
}

static bool is_among(const promises *all, const promise *one)
{
    int i = 0;
    while (i < all->count && (all->list[i].kind != one->kind || all->list[i].most != one->most ||
                              all->list[i].margin != one->margin))
        i++;
    return i < all->count;
}

/* What is promised twice is promised once. */
bool promises_read(const char *text, promises *all)
{
    char one[64];
    for (all->count = 0; all->count < PROMISES_MOST; text++) {
        size_t length = strcspn(text, ",");
        snprintf(one, sizeof one, "%.*s", (int)length, text);
        if (length >= sizeof one || !read_one(one, &all->list[all->count]))
            return false;
        all->count += !is_among(all, &all->list[all->count]);
        text += length;
        if (*text == '\0')
            return true;
    }
    return false;
}

static uint64_t wrong_beyond(double margin, const verdict *by, const refereed *looked_at,
                             const margins *told)
{
    uint64_t undecided = by->wrong;
    if (margin == 0)
        return by->wrong;
    for (int i = 0; i < FAULTS_WITH_MARGIN; i++)
        undecided -= by->faults[i];
    for (int i = 0; i < told->count; i++) {
        if (told->list[i] == margin)
            return undecided + looked_at->beyond[i];
    }
    return by->wrong;
}

const error_summary *promise_errors(const promise *one, const verdict *by)
{
    switch (one->kind) {
    case PROMISE_T_ULPS: return &by->t_ulps;
    case PROMISE_T_RELATIVE: return &by->t_relative;
    case PROMISE_NORMAL_ULPS: return &by->normal_ulps;
    case PROMISE_NORMAL: return &by->normal;
    default: return NULL;
    }
}

static double measured(const promise *one, const verdict *by, const refereed *looked_at,
                       const margins *told)
{
    const error_summary *errors = promise_errors(one, by);
    const bool of_t = one->kind == PROMISE_T_ULPS || one->kind == PROMISE_T_RELATIVE;
    if (errors) {
        uint64_t expected = of_t ? by->with_t : by->with_normal;
        return errors->count == 0 && expected > 0 ? INFINITY : errors->most;
    }
    if (one->kind == PROMISE_CONTRACT)
        return (double)(verdict_breaches(by) + by->unasked);
    uint64_t wrong = wrong_beyond(one->margin, by, looked_at, told);
    return by->unasked > 0 ? 1 : by->valid > 0 ? (double)wrong / (double)by->valid : 0;
}

bool promise_kept(const promise *one, const verdict *by, const refereed *looked_at,
                  const margins *told, double *is)
{
    *is = measured(one, by, looked_at, told);
    return *is <= one->most;
}

/* As few digits as tell it. */
static void print_number(double number, char text[32])
{
    int digits = 0;
    do
        snprintf(text, 32, "%.*g", ++digits, number);
    while (digits < 17 && strtod(text, NULL) != number);
}

void promise_print(const promise *one, char line[CASE_LINE_MAX])
{
    char at[33] = "", limit[64] = "", most[32];
    print_number(one->most, most);
    if (one->margin > 0) {
        at[0] = '@';
        print_number(one->margin, at + 1);
    }
    if (has_limit(one->kind) || one->most > 0)
        snprintf(limit, sizeof limit, "<=%s%s", most, kinds[one->kind].unit);
    snprintf(line, CASE_LINE_MAX, "%s%s%s", kinds[one->kind].name, at, limit);
}
