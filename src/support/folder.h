/* SPDX-License-Identifier: MIT */
/* Files beside one another. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Names of files, in their order. */
typedef struct {
    char **names;
    int count;
} folder_listing;

/* The files whose names begin and end so, but for hidden ones. To be freed, whatever is returned.
 * False after a line to `messages`, which may be NULL. */
bool folder_list(const char *folder, const char *beginning, const char *ending, FILE *messages,
                 folder_listing *found);
void folder_free(folder_listing *found);

/* Can it be opened without waiting for anybody? Of what was found in a folder: a pipe that a user
 * names is his own. True of a folder, too, and of nothing. False after a line to `messages`, which
 * may be NULL. */
bool folder_entry_ok(const char *path, FILE *messages);

/* Are both there, and the same file? */
bool folder_is_same_file(const char *a, const char *b);

/* Is it a file that can be read again: no pipe, and not "-", standard input? False after a
 * line to `messages`. */
bool file_is_kept(const char *path, FILE *messages);

/* FNV-1a of a file's bytes (fnv.h). False after a line to `messages`: it is none that can be read
 * twice, or can't be read. */
bool file_hash(const char *path, FILE *messages, uint64_t *hash);

/* FOLDER/NAME of the name's first `stem` bytes and the ending, to be freed; NULL: no memory. */
char *folder_path(const char *folder, const char *name, size_t stem, const char *ending);

/* What is beside this program, at `way` from its folder. False: not known, or too long. */
bool folder_from_program(const char *way, char *path, size_t size);

/* Where it was built, and nothing has been installed: what is at `way` from the folder of the
 * build. False: it was installed, or likewise. */
bool folder_from_build(const char *way, char *path, size_t size);
