#define _POSIX_C_SOURCE 200809L /* fileno */

#include "rt_file.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static void explain(char why[200])
{
    snprintf(why, 200, "%s; expected a scene that can be read", strerror(errno));
}

/* Is it open, and has it an end? */
static bool has_end(FILE *file, size_t *size, char why[200])
{
    struct stat about;
    if (!file || fstat(fileno(file), &about) != 0) {
        explain(why);
        return false;
    }
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) {
        snprintf(why, 200, "%s; expected a scene file",
                 S_ISDIR(about.st_mode) ? "a directory" : "neither a file nor a pipe");
        return false;
    }
    *size = (size_t)about.st_size;
    return true;
}

static char *read_all(FILE *file, size_t *size, char why[200])
{
    size_t capacity = *size + 4096;
    char *text = malloc(capacity), *larger = text;
    for (*size = 0; larger; larger = realloc(text, capacity *= 2)) {
        text = larger;
        *size += fread(text + *size, 1, capacity - *size, file);
        if (*size == capacity)
            continue;
        if (!ferror(file))
            return text;
        explain(why);
        free(text);
        return NULL;
    }
    free(text);
    snprintf(why, 200, "no memory for more; expected a smaller scene");
    return NULL;
}

char *rt_read_file(const char *path, size_t *size, char why[200])
{
    FILE *file = fopen(path, "r");
    char *text = has_end(file, size, why) ? read_all(file, size, why) : NULL;
    if (file)
        fclose(file);
    return text;
}
