#define _POSIX_C_SOURCE 200809L /* getline */

#include "text_fields.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

bool text_wrong(const text_fields *r, const char *format, ...)
{
    va_list arguments;
    fprintf(r->messages, "%s:%zu: error: ", r->path, r->number);
    va_start(arguments, format);
    vfprintf(r->messages, format, arguments);
    va_end(arguments);
    fputc('\n', r->messages);
    return false;
}

bool text_next_line(text_fields *r)
{
    ssize_t length = getline(&r->line, &r->capacity, r->file);
    r->number++;
    if (length < 0 && !feof(r->file))
        return text_wrong(r, "cannot be read: %s", strerror(errno));
    if (length < 0)
        return text_wrong(r, "the %s ends too early", r->kind);
    if (r->line[length - 1] != '\n' || strlen(r->line) != (size_t)length)
        return text_wrong(r, "no whole line of text");
    r->line[length - 1] = '\0';
    r->at = r->line;
    return true;
}

static bool is_end(const char *at)
{
    return *at == '\0' || (*at == ' ' && at[1] != '\0');
}

static void move_to(text_fields *r, const char *end)
{
    r->at = *end == ' ' ? end + 1 : end;
}

bool text_takes(text_fields *r, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(r->at, word, length) != 0 || !is_end(r->at + length))
        return false;
    move_to(r, r->at + length);
    return true;
}

bool text_take_number(text_fields *r, int base, uint64_t most, uint64_t *number)
{
    const char *digits = base == 16 ? "0123456789abcdef" : "0123456789";
    size_t length = strspn(r->at, digits);
    errno = 0;
    uintmax_t value = strtoumax(r->at, NULL, base);
    if (length == 0 || !is_end(r->at + length) || errno != 0 || value > most)
        return false;
    *number = value;
    move_to(r, r->at + length);
    return true;
}

bool text_take_double(text_fields *r, double *number)
{
    char *end;
    if (strncmp(r->at, "0x", 2) != 0)
        return false;
    *number = strtod(r->at, &end);
    if (!is_end(end) || !isfinite(*number))
        return false;
    move_to(r, end);
    return true;
}

bool text_next_field(text_fields *r, const char *name)
{
    if (!text_next_line(r))
        return false;
    return text_takes(r, name) || text_wrong(r, "expected '%s'", name);
}

bool text_at_end(const text_fields *r, const char *expected)
{
    return *r->at == '\0' || text_wrong(r, "expected %s", expected);
}

bool text_read_count(text_fields *r, const char *name, uint64_t *count)
{
    if (!text_next_field(r, name))
        return false;
    if (!text_take_number(r, 10, TEXT_COUNT_MOST, count))
        return text_wrong(r, "expected a number");
    return text_at_end(r, "one number");
}

bool text_read_hash(text_fields *r, uint64_t *hash)
{
    if (!text_next_field(r, "hash"))
        return false;
    return (text_take_number(r, 16, UINT64_MAX, hash) && *r->at == '\0') ||
           text_wrong(r, "expected a hexadecimal number");
}

bool text_read_counts(text_fields *r, const char *field, const char *const *names, int count,
                      uint64_t *counts)
{
    if (!text_next_field(r, field))
        return false;
    for (int i = 0; i < count; i++) {
        if (!text_takes(r, names[i]) || !text_take_number(r, 10, TEXT_COUNT_MOST, &counts[i]))
            return text_wrong(r, "expected '%s' and a number", names[i]);
    }
    return text_at_end(r, "no more");
}
