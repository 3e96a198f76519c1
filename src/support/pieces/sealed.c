/* SPDX-License-Identifier: MIT */
#include "sealed.h"

#include "../atomic_file.h"
#include "../complain.h"
#include "../fnv.h"
#include "../json_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static bool put_line(const json_t *line, FILE *to, uint64_t *hash)
{
    char *text = json_dumps(line, JSON_COMPACT | JSON_MEASURED);
    if (!text)
        return false;
    *hash = fnv_add(*hash, text, strlen(text));
    fprintf(to, "%s\n", text);
    free(text);
    return true;
}

static bool put_lines(const json_t *lines, FILE *to)
{
    uint64_t hash = FNV_START;
    size_t i;
    const json_t *line;
    bool put = lines != NULL;
    json_array_foreach(lines, i, line) put = put && put_line(line, to, &hash);
    json_t *seal = put ? json_pack("{s:o}", "checksum", json_bits(hash)) : NULL;
    put = seal && put_line(seal, to, &hash);
    json_decref(seal);
    return put;
}

bool sealed_write(json_t *lines, const char *path, FILE *messages)
{
    atomic_file file;
    bool opened = atomic_file_open(path, messages, &file);
    bool put = opened && put_lines(lines, file.stream);
    json_decref(lines);
    if (put)
        return atomic_file_finish(&file, messages);
    if (opened) {
        complain(messages, path, "no memory");
        atomic_file_discard(&file);
    }
    return false;
}

/* Is it the seal of what came before? */
static bool is_seal(const json_t *line, uint64_t hash)
{
    uint64_t sum;
    return json_object_size(line) == 1 && json_take_bits(json_object_get(line, "checksum"), &sum) &&
           sum == hash;
}

/* The lines, or NULL and what is wrong. */
static json_t *get_lines(FILE *from, const char **wrong)
{
    json_t *lines = json_array(), *line = NULL;
    char *text = NULL;
    size_t room = 0;
    uint64_t hash = FNV_START, before = hash;
    json_error_t error = {0};
    for (ssize_t size; (size = getline(&text, &room, from)) > 0;) {
        line = text[size - 1] == '\n'
                   ? json_loadb(text, (size_t)size, JSON_REJECT_DUPLICATES, &error)
                   : NULL;
        before = hash;
        hash = fnv_add(hash, text, (size_t)size - 1);
        if (!line)
            break;
        json_array_append_new(lines, line);
    }
    free(text);
    if (ferror(from))
        *wrong = strerror(errno);
    else if (!line && json_error_code(&error) == json_error_duplicate_key)
        *wrong = "a name stands twice in one of its lines";
    else if (!line || !is_seal(line, before) || json_array_size(lines) < 2)
        *wrong = "is damaged: its last line is not the checksum of those before";
    else if (json_array_remove(lines, json_array_size(lines) - 1) == 0)
        return lines;
    json_decref(lines);
    return NULL;
}

json_t *sealed_read(const char *path, FILE *messages)
{
    const char *wrong = "no memory";
    FILE *from = fopen(path, "r");
    json_t *lines = from ? get_lines(from, &wrong) : NULL;
    if (!lines)
        complain(messages, path, "%s", from ? wrong : strerror(errno));
    if (from)
        fclose(from);
    return lines;
}
