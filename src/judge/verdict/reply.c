/* SPDX-License-Identifier: MIT */
#include "reply.h"

#include "../../numbers/digits/hex_float.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

const char *const query_names[] = {"hit", "occluded", "interval", "inside", NULL};

/* What a line may leave out, most of it last: made up, it makes an answer of the line. */
static const struct {
    const char *rest;
    bool part, normal; /* are its own */
} forms[] = {{"", true, true}, {" 0 0 0", true, false}, {" surface 0 0 0", false, false}};
#define FORMS (sizeof forms / sizeof *forms)

reply reply_of(const case_answer *answer, query to)
{
    return (reply){.to = to,
                   .status = answer->status,
                   .field = answer->field,
                   .t = answer->t,
                   .t_leave = answer->t_leave,
                   .part = (int)answer->part,
                   .has_normal = true,
                   .normal = answer->normal};
}

static reply reply_with(const case_answer *answer, bool part, bool normal)
{
    bool hit = answer->status == SURE_HIT;
    reply given = reply_of(answer, QUERY_HIT);
    given.part = hit && part ? given.part : REPLY_NO_PART;
    given.has_normal = hit && normal;
    return given;
}

/* Blanks and tabs at the ends are nothing, between words they are one blank. Too long: false. */
static bool tidy(const char *line, char words[CASE_LINE_MAX])
{
    const char *const blanks = " \t\r\n";
    size_t used = 0;
    words[0] = '\0';
    for (line += strspn(line, blanks); *line != '\0'; line += strspn(line, blanks)) {
        size_t length = strcspn(line, blanks);
        if (used + length + 2 > CASE_LINE_MAX)
            return false;
        used += (size_t)sprintf(words + used, "%s%.*s", used > 0 ? " " : "", (int)length, line);
        line += length;
    }
    return true;
}

static reply garbage_of(const char *line)
{
    reply given = {.kind = REPLY_GARBAGE, .part = REPLY_NO_PART};
    snprintf(given.said, sizeof given.said, "%.*s", (int)strcspn(line, "\r\n"), line);
    for (char *at = given.said; *at != '\0'; at++)
        *at = isprint((unsigned char)*at) ? *at : '?';
    return given;
}

reply reply_read(const char *line)
{
    char words[CASE_LINE_MAX], whole[2 * CASE_LINE_MAX];
    case_answer answer;
    if (!tidy(line, words))
        return garbage_of(line);
    const char *unnamed = strstr(words, " - "); /* a part before a normal */
    if (unnamed) {
        snprintf(whole, sizeof whole, "%.*s surface %s", (int)(unnamed - words), words,
                 unnamed + 3);
        return case_answer_read(whole, &answer) ? reply_with(&answer, false, true)
                                                : garbage_of(line);
    }
    for (size_t i = 0; i < FORMS; i++) {
        snprintf(whole, sizeof whole, "%s%s", words, forms[i].rest);
        if (case_answer_read(whole, &answer))
            return reply_with(&answer, forms[i].part, forms[i].normal);
    }
    if (strcmp(words, "invalid") == 0 || strcmp(words, "invalid line") == 0)
        return (reply){.status = SURE_INVALID, .part = REPLY_NO_PART};
    return garbage_of(line);
}

reply reply_read_interval(const char *line)
{
    reply chord = {.status = SURE_HIT, .part = REPLY_NO_PART};
    int end = 0;
    if (sscanf(line, " interval %lf %lf %n", &chord.t, &chord.t_leave, &end) == 2 && end > 0 &&
        line[end] == '\0')
        return chord;
    reply other = reply_read(line);
    return other.kind == REPLY_ANSWERED && other.status == SURE_HIT ? garbage_of(line) : other;
}

/* To what is not asked for a hit. */
static void print_other(const reply *given, char line[CASE_LINE_MAX])
{
    bool yes = given->status == SURE_HIT, inside = given->to == QUERY_INSIDE;
    if (yes && given->to == QUERY_INTERVAL)
        snprintf(line, CASE_LINE_MAX, "interval %s %s", HEX(given->t), HEX(given->t_leave));
    else
        snprintf(line, CASE_LINE_MAX, "%s",
                 inside ? (yes ? "inside" : "outside") : (yes ? "hit" : "miss"));
}

/* A part that there is none of, by its number. */
static void print_hit(const reply *given, char line[CASE_LINE_MAX])
{
    const char *part = given->part == REPLY_NO_PART ? "-" : sure_part_name((sure_part)given->part);
    int used = snprintf(line, CASE_LINE_MAX, "hit %s", HEX(given->t));
    if (!part)
        used += sprintf(line + used, " part %d", given->part);
    else if (given->part != REPLY_NO_PART || given->has_normal)
        used += sprintf(line + used, " %s", part);
    if (given->has_normal)
        sprintf(line + used, " %s %s %s", HEX(given->normal.x), HEX(given->normal.y),
                HEX(given->normal.z));
}

static void print_answer(const reply *given, char line[CASE_LINE_MAX])
{
    const case_answer whole = {.status = given->status, .field = given->field};
    if (given->status != SURE_INVALID && given->to != QUERY_HIT)
        print_other(given, line);
    else if (given->status == SURE_HIT)
        print_hit(given, line);
    else if (given->status == SURE_INVALID && given->field == SURE_FIELD_NONE)
        snprintf(line, CASE_LINE_MAX, "invalid");
    else
        case_answer_print(&whole, line);
}

void reply_print(const reply *given, char line[CASE_LINE_MAX])
{
    static const char *const words[] = {
        [REPLY_HUNG] = "no answer in time",
        [REPLY_LOST] = "no answer, or more than one",
        [REPLY_UNASKED] = "not asked",
    };
    if (given->kind == REPLY_ANSWERED)
        print_answer(given, line);
    else if (given->kind == REPLY_GARBAGE)
        snprintf(line, CASE_LINE_MAX, "garbage: '%s'", given->said);
    else if (given->kind == REPLY_CRASHED)
        reply_print_end(given->ended, line);
    else
        snprintf(line, CASE_LINE_MAX, "%s", words[given->kind]);
}

bool reply_same(const reply *a, const reply *b)
{
    if (a->kind != b->kind || a->status != b->status)
        return false;
    if (a->kind != REPLY_ANSWERED || a->status != SURE_HIT)
        return true;
    return memcmp(&a->t, &b->t, sizeof a->t) == 0 && a->part == b->part &&
           memcmp(&a->t_leave, &b->t_leave, sizeof a->t_leave) == 0 &&
           a->has_normal == b->has_normal &&
           (!a->has_normal || memcmp(&a->normal, &b->normal, sizeof a->normal) == 0);
}

void reply_fill(reply *replies, int first, int count, reply_kind kind, int ended)
{
    for (int i = first; i < first + count; i++)
        replies[i] = (reply){.kind = kind, .part = REPLY_NO_PART, .ended = ended};
}
