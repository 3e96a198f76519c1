/* SPDX-License-Identifier: MIT */
#include "json_file.h"

#include "atomic_file.h"
#include "complain.h"
#include "markup.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

json_t *json_measured(double number)
{
    return isfinite(number) ? json_real(number) : json_null();
}

json_t *json_counts(const uint64_t *counts, int count)
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(array, json_integer((json_int_t)counts[i]));
    return array;
}

json_t *json_bits(uint64_t bits)
{
    char text[17];
    snprintf(text, sizeof text, "%016" PRIx64, bits);
    return json_string(text);
}

bool json_take_bits(const json_t *from, uint64_t *bits)
{
    const char *text = json_string_value(from);
    if (!text || strlen(text) != 16 || strspn(text, "0123456789abcdef") != 16)
        return false;
    *bits = strtoull(text, NULL, 16);
    return true;
}

bool json_take_count(const json_t *from, uint64_t *count)
{
    json_int_t number = json_is_integer(from) ? json_integer_value(from) : -1;
    *count = (uint64_t)number;
    return number >= 0 && number <= (json_int_t)1 << 56;
}

json_t *json_named_counts(json_naming *name, const uint64_t *counts, int count)
{
    json_t *object = json_object();
    for (int i = 0; i < count; i++)
        json_object_set_new(object, name(i), json_integer((json_int_t)counts[i]));
    return object;
}

bool json_take_named_counts(const json_t *object, json_naming *name, uint64_t *counts, int count)
{
    bool taken = json_object_size(object) == (size_t)count;
    for (int i = 0; taken && i < count; i++)
        taken = json_take_count(json_object_get(object, name(i)), &counts[i]);
    return taken;
}

bool json_print_line(json_t *of, FILE *out)
{
    bool whole = of != NULL;
    if (whole) {
        json_dumpf(of, out, JSON_MEASURED);
        fputc('\n', out);
    }
    json_decref(of);
    return whole;
}

bool json_write_file(json_t *of, const char *path, FILE *messages)
{
    atomic_file file;
    bool begun = path && (of || complain(messages, path, "no memory")) &&
                 atomic_file_open(path, messages, &file);
    if (begun) {
        json_dumpf(of, file.stream, JSON_MEASURED | JSON_INDENT(2));
        fputc('\n', file.stream);
    }
    json_decref(of);
    return !path || (begun && atomic_file_finish(&file, messages));
}

json_t *json_text(const char *text)
{
    char *shown = is_utf8(text) ? NULL : strdup(text);
    if (!shown)
        return json_string(text);
    for (char *at = shown; *at != '\0'; at++)
        *at = (unsigned char)*at < 0x80 ? *at : '?';
    json_t *made = json_string(shown);
    free(shown);
    return made;
}
