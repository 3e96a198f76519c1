/* SPDX-License-Identifier: MIT */
/* A mutator for targets that read lines of words: works on whole words, numbers and lines, of which
 * an engine that changes bytes seldom makes new ones that are still read. */
#pragma once

#include "fuzz.h"

typedef struct {
    const char *words;        /* with a blank between them */
    const char *const *lines; /* with their ends */
    size_t line_count;
    size_t longest_run; /* of one byte, inserted */
} text_words;

typedef struct {
    uint8_t *data;
    size_t head, size, max; /* the text begins behind `head` bytes */
    uint64_t random;
    const text_words *words;
} text_mutation;

typedef struct {
    size_t start, length;
} text_piece;

/* A random number below `limit`, which is not 0. */
static inline size_t text_below(text_mutation *m, size_t limit)
{
    return (size_t)(fuzz_random(&m->random) % limit);
}

static inline bool text_separates(uint8_t byte, bool lines)
{
    return byte == '\n' || byte == '\r' || (!lines && memchr(" \t,:", byte, 4) != NULL);
}

/* The word, or line, at a random place; empty between two separators. */
static inline text_piece text_any(text_mutation *m, bool lines)
{
    size_t at = m->head + text_below(m, m->size - m->head + 1), end = at;
    while (at > m->head && !text_separates(m->data[at - 1], lines))
        at--;
    while (end < m->size && !text_separates(m->data[end], lines))
        end++;
    return (text_piece){at, end - at};
}

/* `length` bytes instead of the piece; nothing happens where there is no room. */
static inline void text_replace(text_mutation *m, text_piece old, const void *bytes, size_t length)
{
    uint8_t copy[256];
    if (m->size - old.length + length > m->max || length > sizeof copy)
        return;
    memcpy(copy, bytes, length); /* it may be a part of what is moved */
    memmove(m->data + old.start + length, m->data + old.start + old.length,
            m->size - old.start - old.length);
    memcpy(m->data + old.start, copy, length);
    m->size += length - old.length;
}

static inline void text_insert_run(text_mutation *m, size_t at, uint8_t byte, size_t length)
{
    if (length > m->max - m->size)
        length = m->max - m->size;
    memmove(m->data + at + length, m->data + at, m->size - at);
    memset(m->data + at, byte, length);
    m->size += length;
}

/* A line of the target's own before another. */
static inline void text_insert_line(text_mutation *m, size_t start)
{
    const char *line = m->words->lines[text_below(m, m->words->line_count)];
    text_replace(m, (text_piece){start, 0}, line, strlen(line));
}

/* Another one of the separators, or none at all, behind a word. */
static inline void text_change_separator(text_mutation *m)
{
    static const char *const separators[] = {" ",    "\t", ",",  ", ", "\n",
                                             "\r\n", "\r", "  ", "",   ":"};
    text_piece word = text_any(m, false);
    const char *by = separators[text_below(m, sizeof separators / sizeof *separators)];
    text_piece behind = {word.start + word.length, 0};
    behind.length = behind.start < m->size;
    text_replace(m, behind, by, strlen(by));
}

static inline bool text_is_number(const void *word, size_t length)
{
    return length > 0 && memchr("0123456789+-.", *(const char *)word, 13) != NULL;
}

typedef struct {
    const char *start;
    size_t length;
} text_word;

/* A word of the target's own, the longer ones more often. */
static inline text_word text_own_word(text_mutation *m)
{
    const char *words = m->words->words, *at = words + text_below(m, strlen(words));
    while (at > words && at[-1] != ' ')
        at--;
    return (text_word){at, strcspn(at, " ")};
}

/* One of them; a number for a number, if it is easily found. */
static inline text_word text_word_for(text_mutation *m, text_piece old)
{
    text_word word = {"", 0};
    bool is_number = text_is_number(m->data + old.start, old.length);
    for (int tries = 0; tries < 8; tries++) {
        word = text_own_word(m);
        if (text_is_number(word.start, word.length) == is_number)
            break;
    }
    return word;
}

static inline void text_change(text_mutation *m)
{
    static const char odd[] = "\0\t\r\n #/,:.-+e0x19nai\x01\x7f\x80\xff";
    const text_words *w = m->words;
    text_piece piece = text_any(m, false), line = text_any(m, true), other;
    text_word word = text_word_for(m, piece);
    switch (text_below(m, 14)) {
    case 0:
    case 1:
    case 2: text_replace(m, piece, word.start, word.length); break;
    case 3: text_replace(m, (text_piece){piece.start, 0}, word.start, word.length); break;
    case 4: text_replace(m, piece, "", 0); break;
    case 5:
        other = text_any(m, false);
        text_replace(m, piece, m->data + other.start, other.length);
        break;
    case 6:
        other = text_any(m, true);
        text_replace(m, line, m->data + other.start, other.length);
        break;
    case 7: /* the line again, behind itself */
        text_replace(m, (text_piece){line.start, 0}, "\n", 1);
        text_replace(m, (text_piece){line.start, 0}, m->data + line.start + 1, line.length);
        break;
    case 8: text_replace(m, line, "", 0); break;
    case 9: text_change_separator(m); break;
    case 10:
        text_replace(m, (text_piece){piece.start, 0}, &odd[text_below(m, sizeof odd - 1)], 1);
        break;
    case 11:
    case 12: text_insert_line(m, line.start); break;
    default:
        text_insert_run(m, piece.start, (uint8_t)odd[text_below(m, sizeof odd - 1)],
                        text_below(m, text_below(m, 64) == 0 ? w->longest_run : 40) + 1);
    }
}

static inline size_t text_mutate(uint8_t *data, size_t head, size_t size, size_t max, unsigned seed,
                                 const text_words *words)
{
    text_mutation m = {data, head, size, max, seed, words};
    if (size < head || max < size)
        return size;
    for (size_t times = 1 + text_below(&m, 4); times > 0; times--)
        text_change(&m);
    return m.size;
}
