/* SPDX-License-Identifier: MIT */
/* A scene's file: its bytes, and what is wrong with the file itself. */
#include "rt_reader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* A scene may be as large as this, some four million lines: what never ends is not read on. */
#define BYTES_MOST (256 << 20)
#define TOO_LARGE "more than 256 MiB"

/* All bytes up to the end of the file or pipe, whatever its size was said to be; to be freed,
 * whatever is returned: what is wrong, and what was expected, or NULL. */
static const char *read_all(FILE *file, char **text, size_t *size, const char **expected)
{
    struct stat about;
    *expected = "a scene that can be read";
    if (!file || fstat(fileno(file), &about) != 0)
        return strerror(errno);
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode)) {
        *expected = "a scene file";
        return S_ISDIR(about.st_mode) ? "a directory" : "neither a file nor a pipe";
    }
    *expected = "a smaller scene";
    if (about.st_size > BYTES_MOST)
        return TOO_LARGE;
    char *larger;
    for (size_t room = (size_t)about.st_size + 4096; (larger = realloc(*text, room)); room *= 2) {
        *text = larger;
        *size += fread(larger + *size, 1, room - *size, file);
        if (*size > BYTES_MOST)
            return TOO_LARGE;
        if (*size < room && !ferror(file))
            return NULL;
        if (*size < room) {
            *expected = "a scene that can be read";
            return strerror(errno);
        }
    }
    return "no memory for more";
}

static bool is_stdin(const char *path)
{
    return strcmp(path, "-") == 0;
}

bool rt_read(const char *path, const rt_options *options, rt_options_set set, FILE *messages,
             rt_scene *scene)
{
    static const char nowhere[] = "";
    const char *expected, *dot = strrchr(path, '.');
    char *text = NULL;
    size_t size = 0;
    rt_reader r;
    if (!rt_begin(&r, path, options, set, messages))
        return false;
    r.notes.line_start = nowhere;
    FILE *file = is_stdin(path) ? stdin : fopen(path, "r");
    const char *wrong = read_all(file, &text, &size, &expected);
    if (wrong)
        rt_fault(&r, nowhere, "%s; expected %s", wrong, expected);
    else if (!is_stdin(path) && (!dot || strcmp(dot, ".rt") != 0))
        rt_complain(&r.notes, RT_WARNING, rt_place_of(&r.notes, nowhere),
                    "the file's name does not end in .rt");
    if (!wrong)
        rt_read_known(&r, text, size);
    if (file && file != stdin)
        fclose(file);
    free(text);
    return rt_finish(&r, scene);
}
