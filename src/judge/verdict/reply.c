#define _POSIX_C_SOURCE 200809L /* strsignal */

#include "reply.h"

#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

static reply reply_of(const case_answer *answer)
{
    return (reply){.status = answer->status,
                   .field = answer->field,
                   .t = answer->t,
                   .part = answer->status == SURE_HIT ? (int)answer->part : REPLY_NO_PART,
                   .has_normal = answer->status == SURE_HIT,
                   .normal = answer->normal};
}

/* A short answer is a whole one with the rest made up: read as such, and cut again. */
static bool read_short(const char *line, int words, const char *rest, reply *given)
{
    char whole[CASE_LINE_MAX];
    case_answer answer;
    size_t length = strcspn(line, "\r\n");
    if (strcmp(line + length, "") != 0 && strcmp(line + length, "\n") != 0 &&
        strcmp(line + length, "\r\n") != 0)
        return false;
    int used = snprintf(whole, sizeof whole, "%.*s%s", (int)length, line, rest);
    if (used >= (int)sizeof whole || !case_answer_read(whole, &answer))
        return false;
    *given = reply_of(&answer);
    given->has_normal = words > 2 && given->status == SURE_HIT;
    if (words < 2)
        given->part = REPLY_NO_PART;
    return true;
}

reply reply_read(const char *line)
{
    static const char *const names[] = {"invalid", "invalid line"};
    reply given;
    if (read_short(line, 5, "", &given) || read_short(line, 2, " 0 0 0", &given) ||
        read_short(line, 1, " surface 0 0 0", &given))
        return given;
    size_t length = strcspn(line, "\r\n");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (length == strlen(names[i]) && memcmp(line, names[i], length) == 0)
            return (reply){.status = SURE_INVALID, .part = REPLY_NO_PART};
    }
    return (reply){.kind = REPLY_GARBAGE, .part = REPLY_NO_PART};
}

static void print_answer(const reply *given, char line[CASE_LINE_MAX])
{
    const char *part = given->part == REPLY_NO_PART ? NULL : sure_part_name((sure_part)given->part);
    case_answer whole = {given->status, given->field, given->t, 0, given->normal};
    if (part)
        whole.part = (sure_part)given->part;
    if (given->status == SURE_HIT && !(part && given->has_normal))
        snprintf(line, CASE_LINE_MAX, "hit %a%s%s", given->t, part ? " " : "", part ? part : "");
    else if (given->status == SURE_INVALID && given->field == SURE_FIELD_NONE)
        snprintf(line, CASE_LINE_MAX, "invalid");
    else
        case_answer_print(&whole, line);
}

static void print_crash(int ended, char line[CASE_LINE_MAX])
{
    if (WIFSIGNALED(ended))
        snprintf(line, CASE_LINE_MAX, "crash: signal %d, %s", WTERMSIG(ended),
                 strsignal(WTERMSIG(ended)));
    else
        snprintf(line, CASE_LINE_MAX, "crash: exit status %d", WEXITSTATUS(ended));
}

void reply_print(const reply *given, char line[CASE_LINE_MAX])
{
    static const char *const words[] = {
        [REPLY_GARBAGE] = "garbage",
        [REPLY_HUNG] = "no answer in time",
        [REPLY_LOST] = "no answer, or more than one",
        [REPLY_UNASKED] = "not asked",
    };
    if (given->kind == REPLY_ANSWERED)
        print_answer(given, line);
    else if (given->kind == REPLY_CRASHED)
        print_crash(given->ended, line);
    else
        snprintf(line, CASE_LINE_MAX, "%s", words[given->kind]);
}

static bool same_bits(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

bool reply_same(const reply *a, const reply *b)
{
    if (a->kind != b->kind || a->status != b->status)
        return false;
    if (a->kind != REPLY_ANSWERED || a->status != SURE_HIT)
        return true;
    return same_bits(&a->t, &b->t, sizeof a->t) && a->part == b->part &&
           a->has_normal == b->has_normal &&
           (!a->has_normal || same_bits(&a->normal, &b->normal, sizeof a->normal));
}

void reply_fill(reply *replies, int first, int count, reply_kind kind, int ended)
{
    for (int i = first; i < first + count; i++)
        replies[i] = (reply){.kind = kind, .part = REPLY_NO_PART, .ended = ended};
}
