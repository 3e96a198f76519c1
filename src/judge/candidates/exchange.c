/* SPDX-License-Identifier: MIT */
#include "exchange.h"

#include <surehit/candidate.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

int exchange_place(const exchange *of, int n)
{
    return of->again ? of->count - 1 - n : n;
}

size_t exchange_lines(const exchange *of, char *to)
{
    char *end = to;
    for (int n = 0; n < of->count; n++) {
        case_print(&of->cases[exchange_place(of, n)], end);
        end += strlen(end);
        *end++ = '\n';
    }
    return (size_t)(end - to);
}

size_t exchange_numbers(const exchange *of, char *to)
{
    sure_shape shape = of->cases[0].object.shape;
    const double head[EXCHANGE_HEAD] = {shape, of->count};
    size_t size = (size_t)case_numbers(shape) * sizeof(double);
    memcpy(to, head, sizeof head);
    to += sizeof head;
    for (int n = 0; n < of->count; n++) {
        double numbers[CASE_NUMBERS_MAX];
        case_to_numbers(&of->cases[exchange_place(of, n)], numbers);
        memcpy(to + (size_t)n * size, numbers, size);
    }
    return sizeof head + (size_t)of->count * size;
}

static void keep_reply(const exchange *of, int n, const reply *given, reply *replies)
{
    reply *to = &replies[exchange_place(of, n)];
    if (of->again)
        to->changed = !reply_same(to, given);
    else
        *to = *given;
}

void replies_from_lines(const exchange *of, char **text, reply *replies)
{
    for (int n = 0; n < of->count; n++) {
        const char *line = strsep(text, "\n");
        reply given = of->intervals ? reply_read_interval(line) : reply_read(line);
        keep_reply(of, n, &given, replies);
    }
}

/* status, t, part, normal: what is not a number is not told, but for t. */
static reply reply_from_numbers(const double *said)
{
    double status = said[0], part = said[2];
    reply given = {.part = REPLY_NO_PART};
    if (status == SURE_CANDIDATE_MISS || status == SURE_CANDIDATE_INVALID) {
        given.status = (sure_status)status;
    } else if (status == SURE_CANDIDATE_HIT) {
        given.status = SURE_HIT;
        given.t = said[1];
        given.part = isnan(part) ? REPLY_NO_PART : SURE_PARTS; /* there is none such */
        if (part >= 0 && part < SURE_PARTS && part == (int)part)
            given.part = (int)part;
        given.normal = (sure_vec3){said[3], said[4], said[5]};
        given.has_normal = !(isnan(said[3]) && isnan(said[4]) && isnan(said[5]));
    } else {
        given.kind = REPLY_GARBAGE;
        snprintf(given.said, sizeof given.said, "status %g", status);
    }
    return given;
}

void replies_from_numbers(const exchange *of, const char *text, reply *replies)
{
    for (int n = 0; n < of->count; n++) {
        double said[EXCHANGE_ANSWER];
        memcpy(said, text + (size_t)n * sizeof said, sizeof said);
        reply given = reply_from_numbers(said);
        keep_reply(of, n, &given, replies);
    }
}

int count_lines(const char *text, size_t length)
{
    int count = 0;
    for (size_t i = 0; i < length; i++)
        count += text[i] == '\n';
    return count + (length > 0 && text[length - 1] != '\n');
}
