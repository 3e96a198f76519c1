/* SPDX-License-Identifier: MIT */
/* A file that appears whole or not at all: it is written beside its place under a temporary name
 * and takes its place by a rename. What stood there before stays untouched until then. */
#pragma once

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    FILE *stream;     /* write here; nobody sees it before atomic_file_finish */
    const char *path; /* as the caller named it, for messages */
    char *target;     /* the same, or what it links to; NULL: a pipe, written as it comes */
} atomic_file;

/* Could a file take its place at `path`? One line to `messages` if not: the folder is missing or
 * not writable, or there is something that is neither a writable regular file nor a pipe. Touches
 * nothing. NULL is no file, and possible. */
bool atomic_file_possible(const char *path, FILE *messages);

/* Begins one; at most one at a time. A new file gets the usual permissions, a replaced one keeps
 * its own; a symbolic link is followed. On false one line was written to `messages`. Every opened
 * file must be finished or discarded; should SIGHUP, SIGINT, SIGQUIT or SIGTERM end the program
 * before that, the temporary file is removed first, and a file size limit is an error like any
 * other. */
bool atomic_file_open(const char *path, FILE *messages, atomic_file *file);

/* Puts it in its place. On false one line was written to `messages` and it is discarded. */
bool atomic_file_finish(atomic_file *file, FILE *messages);

/* Removes it. */
void atomic_file_discard(atomic_file *file);

/* Why a stream with an error, whose file nobody wants any more, cannot be written: it is tried once
 * more. */
const char *stream_reason(FILE *stream);
