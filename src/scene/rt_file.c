/* SPDX-License-Identifier: MIT */
/* A scene's file: its bytes, and what is wrong with the file itself. */
#include "rt_reader.h"

#include "../support/fnv.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* A scene may be as large as this, some four million lines: what never ends is not read on. */
#define BYTES_MOST (256 << 20)
#define TOO_LARGE "more than 256 MiB"

/* All bytes up to the end of the file, pipe or socket, whatever its size was said to be; to be
 * freed, whatever is returned: what is wrong, and what was expected, or NULL. */
static const char *read_all(FILE *file, char **text, size_t *size, const char **expected)
{
    struct stat about;
    *expected = "a scene that can be read";
    if (!file || fstat(fileno(file), &about) != 0)
        return strerror(errno);
    if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode) && !S_ISSOCK(about.st_mode)) {
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

/* Of the file itself, before its first line. */
static bool complain_of_file(const char *path, const char *wrong, const char *expected,
                             FILE *messages)
{
    const rt_options options = rt_default_options();
    rt_scene none;
    rt_reader r;
    if (!rt_begin(&r, path, &options, 0, messages))
        return false;
    rt_fault(&r, r.notes.line_start, "%s; expected %s", wrong, expected);
    return rt_finish(&r, &none);
}

bool rt_load(const char *path, FILE *messages, rt_bytes *bytes)
{
    const char *expected;
    *bytes = (rt_bytes){.path = path};
    FILE *file = is_stdin(path) ? stdin : fopen(path, "r");
    const char *wrong = read_all(file, &bytes->text, &bytes->size, &expected);
    if (file && file != stdin)
        fclose(file);
    if (wrong)
        return complain_of_file(path, wrong, expected, messages);
    bytes->hash = fnv_add(FNV_START, bytes->text, bytes->size);
    return true;
}

bool rt_read_loaded(const rt_bytes *bytes, const rt_options *options, rt_options_set set,
                    FILE *messages, rt_scene *scene)
{
    const char *dot = strrchr(bytes->path, '.');
    rt_reader r;
    if (!rt_begin(&r, bytes->path, options, set, messages))
        return false;
    if (!is_stdin(bytes->path) && (!dot || strcmp(dot, ".rt") != 0))
        rt_complain(&r.notes, RT_WARNING, rt_place_of(&r.notes, r.notes.line_start),
                    "the file's name does not end in .rt");
    rt_read_known(&r, bytes->text, bytes->size);
    r.scene.hash = bytes->hash;
    return rt_finish(&r, scene);
}

bool rt_read(const char *path, const rt_options *options, rt_options_set set, FILE *messages,
             rt_scene *scene)
{
    rt_bytes bytes;
    bool read =
        rt_load(path, messages, &bytes) && rt_read_loaded(&bytes, options, set, messages, scene);
    free(bytes.text);
    return read;
}
