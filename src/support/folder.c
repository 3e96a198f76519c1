/* SPDX-License-Identifier: MIT */
#include "folder.h"

#include "complain.h"
#include "fnv.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_wanted(const char *name, const char *beginning, const char *ending)
{
    size_t length = strlen(name), size = strlen(ending);
    return name[0] != '.' && strncmp(name, beginning, strlen(beginning)) == 0 && length > size &&
           strcmp(name + length - size, ending) == 0;
}

/* The same order in every locale. */
static int by_bytes(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

bool folder_list(const char *folder, const char *beginning, const char *ending, FILE *messages,
                 folder_listing *found)
{
    struct dirent **entries = NULL;
    int count = scandir(folder, &entries, NULL, by_bytes);
    *found = (folder_listing){count > 0 ? calloc((size_t)count, sizeof(char *)) : NULL, 0};
    bool done = count >= 0 && (count == 0 || found->names);
    for (int i = 0; i < count; i++) {
        if (done && is_wanted(entries[i]->d_name, beginning, ending))
            done = (found->names[found->count++] = strdup(entries[i]->d_name)) != NULL;
        free(entries[i]);
    }
    free(entries);
    if (!done && messages)
        complain(messages, folder, "cannot be read: %s", strerror(errno));
    return done;
}

void folder_free(folder_listing *found)
{
    for (int i = 0; i < found->count; i++)
        free(found->names[i]);
    free(found->names);
}

bool folder_entry_ok(const char *path, FILE *messages)
{
    struct stat found;
    return stat(path, &found) != 0 || S_ISREG(found.st_mode) || S_ISDIR(found.st_mode) ||
           (messages && complain(messages, path, "is no regular file"));
}

bool folder_is_same_file(const char *a, const char *b)
{
    struct stat of_a, of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
           of_a.st_ino == of_b.st_ino;
}

char *folder_path(const char *folder, const char *name, size_t stem, const char *ending)
{
    char *path;
    size_t length = strlen(folder);
    const char *between = length > 0 && folder[length - 1] == '/' ? "" : "/";
    return asprintf(&path, "%s%s%.*s%s", folder, between, (int)stem, name, ending) < 0 ? NULL
                                                                                       : path;
}

bool folder_from_program(const char *way, char *path, size_t size)
{
    ssize_t length = readlink("/proc/self/exe", path, size - 1);
    if (length <= 0)
        return false;
    path[length] = '\0';
    char *end = strrchr(path, '/') + 1;
    size_t room = size - (size_t)(end - path);
    return (size_t)snprintf(end, room, "%s", way) < room;
}

/* Is the program where the build has it installed? Nothing around it is a build's then. */
static bool is_installed(char *path, size_t size)
{
    static const char folder[] = SUREHIT_BINARIES "/";
    return !folder_from_program("", path, size) || strcmp(path, folder) == 0;
}

/* The program lies two folders below; meson has its notes there. */
bool folder_from_build(const char *way, char *path, size_t size)
{
    char below[256];
    bool fits = (size_t)snprintf(below, sizeof below, "../../%s", way) < sizeof below;
    return fits && !is_installed(path, size) &&
           folder_from_program("../../meson-info", path, size) && access(path, F_OK) == 0 &&
           folder_from_program(below, path, size);
}

bool file_is_kept(const char *path, FILE *messages)
{
    struct stat about;
    bool has_name = strcmp(path, "-") != 0;
    if (has_name && stat(path, &about) != 0)
        return complain(messages, path, "%s", strerror(errno));
    return (has_name && S_ISREG(about.st_mode)) ||
           complain(messages, path, "is no file that can be read again");
}

bool file_hash(const char *path, FILE *messages, uint64_t *hash)
{
    unsigned char bytes[65536];
    size_t count;
    if (!file_is_kept(path, messages))
        return false;
    FILE *file = fopen(path, "rb");
    if (!file)
        return complain(messages, path, "%s", strerror(errno));
    *hash = FNV_START;
    while ((count = fread(bytes, 1, sizeof bytes, file)) > 0)
        *hash = fnv_add(*hash, bytes, count);
    bool whole = !ferror(file);
    fclose(file);
    return whole || complain(messages, path, "cannot be read");
}
