/* SPDX-License-Identifier: MIT */
#include "text_rows.h"

#include "suite.h"

/* Its size then. */
static size_t unescape(char *text)
{
    char *out = text;
    for (char *at = text; *at; at++) {
        unsigned byte = (unsigned char)*at;
        if (byte == '\\' && *++at == 'x') {
            ck_assert_int_eq(sscanf(at + 1, "%2x", &byte), 1);
            at += 2;
        } else if (byte == '\\') {
            byte = *at == 'n' ? '\n' : *at == 'r' ? '\r' : *at == 't' ? '\t' : '\\';
        }
        *out++ = (char)byte;
    }
    *out = '\0';
    return (size_t)(out - text);
}

FILE *rows_open(const char *name)
{
    FILE *file = fopen(suite_file("%s", name), "r");
    ck_assert_msg(file != NULL, "%s can't be read", name);
    return file;
}

static bool read_line(FILE *file, char line[ROW_BYTES])
{
    do
        if (!fgets(line, ROW_BYTES, file))
            return false;
    while (strncmp(line, "//", 2) == 0);
    ck_assert_ptr_nonnull(strchr(line, '\n'));
    return true;
}

bool rows_next(FILE *file, text_row *row)
{
    char line[ROW_BYTES];
    long next;
    if (!read_line(file, row->text))
        return false;
    *strchr(row->text, '\n') = '\0';
    row->size = unescape(row->text);
    *row->lines = '\0';
    for (next = ftell(file); read_line(file, line); next = ftell(file)) {
        if (strncmp(line, "    ", 4) != 0)
            break;
        strcat(row->lines, line + 4);
    }
    fseek(file, next, SEEK_SET);
    return true;
}

void rows_drop_known(char *text, const char *known)
{
    char *out = text;
    for (char *line = text, *end; (end = strchr(line, '\n')) != NULL; line = end + 1) {
        size_t length = (size_t)(end - line) + 1;
        char copy[ROW_BYTES];
        ck_assert_uint_lt(length, sizeof copy);
        memcpy(copy, line, length);
        copy[length] = '\0';
        if (!strstr(known, copy)) {
            memmove(out, line, length);
            out += length;
        }
    }
    *out = '\0';
}

bool rows_line(FILE *file, char *line, size_t size)
{
    while (fgets(line, (int)size, file)) {
        ck_assert_msg(strchr(line, '\n') != NULL, "a line without an end: %s", line);
        if (*line != '#' && *line != '\n')
            return true;
    }
    ck_assert(!ferror(file));
    return false;
}

char *row_cut(char *text, const char *mark)
{
    char *at = strstr(text, mark);
    ck_assert_msg(at != NULL, "no \"%s\" in %s", mark, text);
    *at = '\0';
    return at + strlen(mark);
}
