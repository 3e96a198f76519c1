/* SPDX-License-Identifier: MIT */
/* Files in tests, a folder that is empty, and what is said of a file. For each test of its own:
 * SUITE_IN(title, enter_folder, leave_folder). Wants _XOPEN_SOURCE 700. */
#pragma once

#include "suite.h"

#include <dirent.h>
#include <unistd.h>

static char own_folder[] = "test.XXXXXX";

static inline void enter_folder(void)
{
    strcpy(own_folder + sizeof own_folder - 7, "XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(own_folder));
    ck_assert_int_eq(chdir(own_folder), 0);
}

/* Calls `visit` for everything in the folder, also what begins with a dot, and counts it. */
static inline int each_entry(int (*visit)(const char *name))
{
    DIR *here = opendir(".");
    ck_assert_ptr_nonnull(here);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(here));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        count++;
        if (visit)
            ck_assert_int_eq(visit(entry->d_name), 0);
    }
    closedir(here);
    return count;
}

static inline void leave_folder(void)
{
    each_entry(remove);
    ck_assert_int_eq(chdir(".."), 0);
    ck_assert_int_eq(rmdir(own_folder), 0);
}

static inline void put(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert_uint_eq(fwrite(bytes, 1, size, file), size);
    ck_assert_int_eq(fclose(file), 0);
}

/* The whole file, to be freed. */
static inline uint8_t *get(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(fseek(file, 0, SEEK_END), 0);
    *size = (size_t)ftell(file);
    rewind(file);
    uint8_t *bytes = malloc(*size + 1);
    ck_assert_ptr_nonnull(bytes);
    ck_assert_uint_eq(fread(bytes, 1, *size, file), *size);
    fclose(file);
    return bytes;
}

static inline void assert_holds(const char *path, const void *bytes, size_t size)
{
    size_t found_size;
    uint8_t *found = get(path, &found_size);
    ck_assert_uint_eq(found_size, size);
    ck_assert_mem_eq(found, bytes, size);
    free(found);
}

/* What was said to `messages` in a call; one at a time. */
static char *heard;
static size_t heard_size;

static inline FILE *listen(void)
{
    free(heard);
    heard = NULL;
    return open_memstream(&heard, &heard_size);
}

/* One line, "PATH: error: ...", that holds `word`. */
static inline void assert_said(FILE *messages, const char *path, const char *word)
{
    fclose(messages);
    size_t length = strlen(path);
    ck_assert_msg(strncmp(heard, path, length) == 0 && strncmp(heard + length, ": error: ", 9) == 0,
                  "said: %s", heard);
    ck_assert_msg(strchr(heard, '\n') == heard + heard_size - 1, "said: %s", heard);
    ck_assert_msg(strstr(heard + length, word) != NULL, "'%s' is not in: %s", word, heard);
}
