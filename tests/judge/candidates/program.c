/* A candidate's functions as a program on a pipe: case lines in, answer lines out. SUREHIT_WRONG
 * may also name what only a program can do wrong. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case.h"
#include "reply.h"

#include <surehit/candidate.h>

typedef int routine(const double *ray, const double *object, sure_candidate_hit *hit);
#define ROUTINE(shape, SHAPE) sure_candidate_##shape,
static routine *const routines[] = {SURE_EACH_SHAPE(ROUTINE)};

static int is_wrong(const char *what)
{
    const char *named = getenv("SUREHIT_WRONG");
    return named && strcmp(named, what) == 0;
}

static void print_answer(const sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX];
    sure_candidate_hit hit = {0};
    char text[CASE_LINE_MAX];
    case_to_numbers(question, numbers);
    int status = routines[question->object.shape](numbers, numbers + 8, &hit);
    reply said = {.status = status == SURE_CANDIDATE_HIT    ? SURE_HIT
                            : status == SURE_CANDIDATE_MISS ? SURE_MISS
                                                            : SURE_INVALID,
                  .kind = status > SURE_CANDIDATE_INVALID ? REPLY_GARBAGE : REPLY_ANSWERED,
                  .t = hit.t,
                  .part = hit.part,
                  .has_normal = true,
                  .normal = {hit.normal[0], hit.normal[1], hit.normal[2]}};
    reply_print(&said, text);
    puts(text);
}

int main(void)
{
    char line[CASE_LINE_MAX];
    sure_case question;
    if (is_wrong("greets"))
        puts("hello");
    for (unsigned number = 0; fgets(line, sizeof line, stdin); number++) {
        if (!case_read(line, &question)) {
            puts("invalid line");
            continue;
        }
        if (is_wrong("skips misses") &&
            case_answer_of(&question, SURE_TIER_EXACT).status == SURE_MISS)
            continue;
        if (is_wrong("floods"))
            for (;;)
                puts("miss");
        if (is_wrong("closes early") && number == 0)
            fclose(stdout);
        print_answer(&question);
        if (is_wrong("flushes"))
            fflush(stdout);
    }
    return 0;
}
