/* SPDX-License-Identifier: MIT */
#include "manifest.h"

#include "../complain.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

bool manifest_read(const char *path, FILE *messages, manifest *read)
{
    *read = (manifest){path, sealed_read(path, messages), 0};
    read->pieces = read->lines ? json_array_size(read->lines) - 1 : 0;
    return read->lines != NULL;
}

void manifest_free(manifest *of)
{
    json_decref(of->lines);
    of->lines = NULL;
}

const json_t *manifest_asked(const manifest *of)
{
    return json_array_get(of->lines, 0);
}

const json_t *manifest_piece(const manifest *of, size_t number, FILE *messages)
{
    if (number >= 1 && number <= of->pieces)
        return json_array_get(of->lines, number);
    complain(messages, of->path, "piece %zu: has no such piece", number);
    return NULL;
}

const char *asked_difference(const json_t *a, const json_t *b)
{
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)a, key, value)
    {
        if (!json_equal(value, json_object_get(b, key)))
            return key;
    }
    return json_object_size(a) == json_object_size(b) ? NULL : "first line";
}

bool piece_number(const char *text, FILE *messages, size_t *number)
{
    char *end;
    errno = 0;
    unsigned long long given = strtoull(text, &end, 10);
    *number = (size_t)given;
    return (given > 0 && errno == 0 && *end == '\0' && *text >= '0' && *text <= '9') ||
           complain(messages, text, "expected the number of a piece");
}

char *piece_path(const char *folder, size_t number, const char *ending)
{
    char name[32];
    int length = snprintf(name, sizeof name, "%zu", number);
    char *path = folder_path(folder, name, (size_t)length, ending);
    if (!path)
        abort();
    return path;
}

/* first-last, as `sbatch --array` takes them. */
static void print_run(size_t first, size_t end, bool *some)
{
    if (first < end)
        printf(first + 1 < end ? "%s%zu-%zu" : "%s%zu", *some ? "," : "", first, end - 1);
    *some = *some || first < end;
}

pieces_state pieces_status(const manifest *of, piece_question *done, void *context, FILE *messages)
{
    size_t first = 1, missing = 0;
    double all = 0;
    bool some = false, of_others = false;
    for (size_t i = 1; i <= of->pieces; i++) {
        double part = done(context, i);
        all += part > 0 ? part : 0;
        of_others = of_others || part < 0;
        if (part == 1) {
            print_run(first, i, &some);
            first = i + 1;
        } else {
            missing++;
        }
    }
    print_run(first, of->pieces + 1, &some);
    if (some)
        printf("\n");
    fprintf(messages, "%zu of %zu pieces are done, %.2f %% of all\n", of->pieces - missing,
            of->pieces, 100 * all / (double)of->pieces);
    return of_others ? PIECES_OF_OTHERS : missing > 0 ? PIECES_MISSING : PIECES_DONE;
}

static void append(folder_listing *all, char *path)
{
    char **names = realloc(all->names, (size_t)(all->count + 1) * sizeof *names);
    if (!names || !path)
        abort();
    all->names = names;
    names[all->count++] = path;
}

/* Those of a folder. */
static bool append_all(folder_listing *all, const char *folder, FILE *messages)
{
    folder_listing inside;
    bool listed = folder_list(folder, "", ".json", messages, &inside);
    for (int i = 0; listed && i < inside.count; i++) {
        append(all, folder_path(folder, inside.names[i], strlen(inside.names[i]), ""));
        listed = folder_entry_ok(all->names[all->count - 1], messages);
    }
    folder_free(&inside);
    return listed;
}

bool pieces_list(const char *const *paths, int count, FILE *messages, folder_listing *all)
{
    bool listed = true;
    *all = (folder_listing){NULL, 0};
    for (int i = 0; listed && i < count; i++) {
        struct stat is;
        if (stat(paths[i], &is) == 0 && S_ISDIR(is.st_mode))
            listed = append_all(all, paths[i], messages);
        else
            append(all, strdup(paths[i]));
    }
    return listed && (all->count > 0 || complain(messages, paths[0], "there are no results"));
}
