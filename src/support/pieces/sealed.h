/* SPDX-License-Identifier: MIT */
/* A file of lines of JSON, the last of which has a checksum of those before: it appears whole or
 * not at all, and is refused where it was cut, damaged or edited. */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

/* A line for each item of an array, which is taken over; NULL: there was no memory for it. On false
 * one line was written to `messages`. */
bool sealed_write(json_t *lines, const char *path, FILE *messages);

/* The array; NULL after a line to `messages`. */
json_t *sealed_read(const char *path, FILE *messages);
