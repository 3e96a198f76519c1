/* SPDX-License-Identifier: MIT */
/* A candidate's functions as a program on a pipe: case lines in, answer lines out. With an argument
 * it can be kept: `lines`, or `binary`. SUREHIT_WRONG may also name what only a program can do
 * wrong. */
#include <stdbool.h>
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

static int answer(sure_shape shape, const double *numbers, sure_candidate_hit *hit)
{
    return routines[shape](numbers, numbers + 8, hit);
}

static void print_answer(const sure_case *question)
{
    double numbers[CASE_NUMBERS_MAX];
    sure_candidate_hit hit = {0};
    char text[CASE_LINE_MAX];
    case_to_numbers(question, numbers);
    int status = answer(question->object.shape, numbers, &hit);
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

static void read_lines(bool kept)
{
    char line[CASE_LINE_MAX];
    sure_case question;
    for (unsigned number = 0; fgets(line, sizeof line, stdin); number++) {
        if (kept && strcmp(line, "\n") == 0) {
            puts("");
            fflush(stdout);
            continue;
        }
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
}

static void read_blocks(void)
{
    double head[2], numbers[CASE_NUMBERS_MAX];
    while (fread(head, sizeof head, 1, stdin) == 1) {
        sure_shape shape = (sure_shape)head[0];
        size_t count = (size_t)case_numbers(shape);
        for (int i = 0; i < head[1] && fread(numbers, sizeof *numbers, count, stdin) == count;
             i++) {
            sure_candidate_hit hit = {0};
            double status = answer(shape, numbers, &hit);
            const double said[] = {status,        hit.t,         hit.part,
                                   hit.normal[0], hit.normal[1], hit.normal[2]};
            fwrite(said, sizeof said, 1, stdout);
        }
        fflush(stdout);
    }
}

int main(int count, char **words)
{
    bool kept = count > 1, binary = kept && strcmp(words[1], "binary") == 0;
    if (is_wrong("greets"))
        puts("hello");
    if (kept)
        puts(binary ? "ready binary\n" : "ready\n");
    fflush(stdout);
    if (binary)
        read_blocks();
    else
        read_lines(kept);
    return 0;
}
