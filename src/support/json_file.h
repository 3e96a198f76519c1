/* SPDX-License-Identifier: MIT */
/* JSON by jansson: what numbers are, and a file that appears whole or not at all. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* Of what is no UTF-8 with '?' for what is beyond ASCII. */
json_t *json_text(const char *text);

/* JSON knows no infinity and no NaN: null. */
json_t *json_measured(double number);

/* JSON has no numbers of 64 bits: 16 hexadecimal digits. False where that is not what is read. */
json_t *json_bits(uint64_t bits);
bool json_take_bits(const json_t *from, uint64_t *bits);

/* A count, up to 2^56: more is not counted in a lifetime, and sums of counts don't overflow. */
bool json_take_count(const json_t *from, uint64_t *count);

/* An array of counts. */
json_t *json_counts(const uint64_t *counts, int count);

/* Counts by the names of what is counted. False where others are read, or no counts. */
typedef const char *json_naming(int i);
json_t *json_named_counts(json_naming *name, const uint64_t *counts, int count);
bool json_take_named_counts(const json_t *object, json_naming *name, uint64_t *counts, int count);

/* A flag for json_dump: what is measured has nine digits. */
#define JSON_MEASURED JSON_REAL_PRECISION(9)

/* These take over `of`, which may be NULL where there was no memory for it, and print by
 * JSON_MEASURED. */

/* One line to `out`. False when there is no memory; whether `out` took it all is not asked. */
bool json_print_line(json_t *of, FILE *out);

/* Where `path` is NULL nothing is written. On false one line was written to `messages`. */
bool json_write_file(json_t *of, const char *path, FILE *messages);
