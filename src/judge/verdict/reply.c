#include "reply.h"

#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

/* What a line may leave out, most of it last: made up, it makes an answer of the line. */
static const struct {
    const char *rest;
    bool part, normal; /* are its own */
} forms[] = {{"", true, true}, {" 0 0 0", true, false}, {" surface 0 0 0", false, false}};
#define FORMS (sizeof forms / sizeof *forms)

static reply reply_of(const case_answer *answer, size_t form)
{
    bool hit = answer->status == SURE_HIT;
    return (reply){.status = answer->status,
                   .field = answer->field,
                   .t = answer->t,
                   .part = hit && forms[form].part ? (int)answer->part : REPLY_NO_PART,
                   .has_normal = hit && forms[form].normal,
                   .normal = answer->normal};
}

reply reply_read(const char *line)
{
    const size_t length = strcspn(line, "\r\n");
    const char *end = line + length;
    bool ends = *end == '\0' || strcmp(end, "\n") == 0 || strcmp(end, "\r\n") == 0;
    char whole[CASE_LINE_MAX];
    case_answer answer;
    for (size_t i = 0; ends && i < FORMS; i++) {
        int used = snprintf(whole, sizeof whole, "%.*s%s", (int)length, line, forms[i].rest);
        if (used < (int)sizeof whole && case_answer_read(whole, &answer))
            return reply_of(&answer, i);
    }
    snprintf(whole, sizeof whole, "%.*s", (int)length, line);
    if (strcmp(whole, "invalid") == 0 || strcmp(whole, "invalid line") == 0)
        return (reply){.status = SURE_INVALID, .part = REPLY_NO_PART};
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

void reply_print(const reply *given, char line[CASE_LINE_MAX])
{
    static const char *const words[] = {
        [REPLY_GARBAGE] = "garbage",
        [REPLY_HUNG] = "no answer in time",
        [REPLY_LOST] = "no answer, or more than one",
        [REPLY_UNASKED] = "not asked",
    };
    const int ended = given->ended;
    if (given->kind == REPLY_ANSWERED)
        print_answer(given, line);
    else if (given->kind == REPLY_CRASHED && WIFSIGNALED(ended))
        snprintf(line, CASE_LINE_MAX, "crash: signal %d, %s", WTERMSIG(ended),
                 strsignal(WTERMSIG(ended)));
    else if (given->kind == REPLY_CRASHED)
        snprintf(line, CASE_LINE_MAX, "crash: exit status %d", WEXITSTATUS(ended));
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
           a->has_normal == b->has_normal &&
           (!a->has_normal || memcmp(&a->normal, &b->normal, sizeof a->normal) == 0);
}

void reply_fill(reply *replies, int first, int count, reply_kind kind, int ended)
{
    for (int i = first; i < first + count; i++)
        replies[i] = (reply){.kind = kind, .part = REPLY_NO_PART, .ended = ended};
}
