/* SPDX-License-Identifier: MIT */
/* What is to be asked, and what was found: cases by shape, regime and number, which add up.
 *
 * Both kinds of files are sealed lines. Their first line says what was asked and by whom:
 *
 *     {"surehit campaign":1,"against":"reference","seed":"0000000000000001",
 *      "sources":"0123456789abcdef","compiler":"gcc 12.2.0","flags":"...",
 *      "architecture":"x86_64","reference":"CGAL 5.5.1, GMP 6.2.1, MPFR 4.2.0"}
 *
 * Pairs of shape and regime follow in their order, each with ranges of cases (the first one, and
 * how many) and counts, then of each shape and question the closest calls, and broken promises by
 * pair and case:
 *
 *     {"shape":"cone","regime":"bits","ranges":[[0,8333]],"counts":{"cases":8333, ...}}
 *     {"shape":"cone","question":"rounding","worst":[[117,"bits",4711], ...]}
 *     {"shape":"cone","regime":"bits","index":17,"case":"cone 0x1p+0 ...","promise":"exact: t",
 *      "certain":"hit ...","exact":"hit ..."}
 *
 * Of one set of cases there is one file. */
#pragma once

#include "campaign_check.h"
#include "worst.h"
#include "pieces/manifest.h"
#include "pieces/ranges.h"

#include <stdio.h>

/* Cases of each pair. */
typedef struct {
    index_ranges of[SURE_SHAPES][REGIMES];
} coverage;

typedef struct {
    const campaign_truth *against;
    uint64_t seed;
    json_t *asked; /* the first line */
    coverage done;
    pair_tally pairs[SURE_SHAPES][REGIMES];
    worst_calls worst[SURE_SHAPES][WORST_QUESTIONS];
    json_t *broken; /* lines, in their order */
} campaign_record;

/* Calls `visit` for each pair that there can be, in their order, until it returns false. */
typedef bool pair_visitor(void *context, sure_shape shape, regime which);
bool each_pair(pair_visitor *visit, void *context);

/* Are all cases of `a` in `b`? */
bool coverage_within(const coverage *a, const coverage *b);
uint64_t coverage_total(const coverage *of);
void coverage_free(coverage *of);

/* {"shape":..., "regime":..., "ranges":...}; reading returns what is wrong, or NULL. */
json_t *pair_json(const coverage *of, sure_shape shape, regime which);
const char *pair_take(const json_t *line, coverage *to, sure_shape *shape, regime *which);

/* Who is asked for by that name, NULL: the first that there is; NULL where there is none. */
const campaign_truth *truth_named(const char *name);

/* Without cases, as this program asks and answers. */
void record_begin(const campaign_truth *against, uint64_t seed, campaign_record *empty);
void record_free(campaign_record *of);

/* Reads the first line: who is to know, and the seed. Returns what is wrong, or NULL. */
const char *asked_take(const json_t *line, const campaign_truth **against, uint64_t *seed);

/* On false one line was written to `messages`, and nothing is left allocated. */
bool record_read(const char *path, FILE *messages, campaign_record *read);
bool record_write(const campaign_record *of, const char *path, FILE *messages);

/* A promise that pair's count has. */
void record_broken(campaign_record *to, sure_shape shape, regime which, uint64_t index,
                   const sure_case *question, const char *promise);

/* Adds what has no case in common with it, and frees it. */
void record_add(campaign_record *to, campaign_record *from);

/* A pair and its cases that are in both, as words. */
bool record_overlap(const campaign_record *a, const campaign_record *b, char words[128]);

pair_tally record_sum(const campaign_record *of);
