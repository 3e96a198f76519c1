/* SPDX-License-Identifier: MIT */
/* A manifest: what is to be done, in pieces. Of sealed lines the first says what is asked and by
 * whom, as that of each result does; each other one is a piece, in their order from 1 on. */
#pragma once

#include "../folder.h"
#include "sealed.h"

#include <stddef.h>
#include <stdint.h>

typedef struct {
    const char *path;
    json_t *lines;
    size_t pieces;
} manifest;

/* On false one line was written to `messages`, and nothing is left allocated. */
bool manifest_read(const char *path, FILE *messages, manifest *read);
void manifest_free(manifest *of);

/* The first line. */
const json_t *manifest_asked(const manifest *of);

/* A piece's line, or NULL after a line to `messages`. */
const json_t *manifest_piece(const manifest *of, size_t number, FILE *messages);

/* The first key by which two first lines differ, "sources" for one; NULL: none. */
const char *asked_difference(const json_t *a, const json_t *b);

/* A number from 1 on; false after a line to `messages`. */
bool piece_number(const char *text, FILE *messages, size_t *number);

/* FOLDER/NUMBER and the ending, to be freed. */
char *piece_path(const char *folder, size_t number, const char *ending);

/* Prints the numbers of pieces that are not done as `sbatch --array` takes them, and to `messages`
 * how many are, and which part of all. */
typedef enum { PIECES_DONE = 0, PIECES_OF_OTHERS = 2, PIECES_MISSING = 3 } pieces_state;
typedef double piece_question(void *context, size_t number); /* its part that is done, 1: all,
                                                              * less than 0: others' is there */
pieces_state pieces_status(const manifest *of, piece_question *done, void *context, FILE *messages);

/* The files that are named, and the results in folders that are. False after a line to `messages`,
 * also where there is none; to be freed by folder_free, whatever is returned. */
bool pieces_list(const char *const *paths, int count, FILE *messages, folder_listing *all);
