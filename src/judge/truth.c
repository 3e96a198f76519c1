#include "truth.h"

#include "../support/folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define REFERENCE_NAME "surehit-reference"

/* A word of the shell's, whatever it holds; false if there is no room. */
static bool quote(const char *text, char *room, size_t size)
{
    size_t used = 0;
    room[used++] = '\'';
    for (; *text != '\0'; text++) {
        if (used + 6 > size)
            return false;
        if (*text == '\'') {
            memcpy(room + used, "'\\''", 4);
            used += 4;
        } else {
            room[used++] = *text;
        }
    }
    room[used++] = '\'';
    room[used] = '\0';
    return true;
}

/* Is the program there, seen from this one's folder? As a command then. */
static bool find_from_here(const char *way, char *command, size_t size)
{
    char path[4096];
    return folder_from_program(way, path, sizeof path) && access(path, X_OK) == 0 &&
           quote(path, command, size);
}

bool truth_reference(double time_limit, truth *known, char *message)
{
    static char command[8192];
    const candidate_options how = {INPUTS_DOUBLE, time_limit, .once = true};
    if (!find_from_here(REFERENCE_NAME, command, sizeof command) &&
        !find_from_here("../../reference/" REFERENCE_NAME, command, sizeof command))
        strcpy(command, REFERENCE_NAME);
    known->room = malloc(sizeof *known->room);
    known->program = candidate_of_command(command, &how, message);
    if (known->room && known->program)
        return true;
    truth_close(known);
    return false;
}

bool truth_has_reference(void)
{
    char message[CANDIDATE_MESSAGE];
    truth known;
    bool found = truth_reference(5, &known, message);
    truth_close(&known);
    return found;
}

void truth_close(truth *known)
{
    candidate_close(known->program);
    free(known->room);
    *known = (truth){NULL, NULL};
}

static bool is_whole(const reply *given)
{
    if (given->kind != REPLY_ANSWERED)
        return false;
    return given->status == SURE_HIT       ? given->part != REPLY_NO_PART && given->has_normal
           : given->status == SURE_INVALID ? given->field != SURE_FIELD_NONE
                                           : true;
}

static bool take(const sure_case *question, const reply *given, case_answer *answer, char *message)
{
    char line[CASE_LINE_MAX], said[CASE_LINE_MAX];
    if (!is_whole(given)) {
        case_print(question, line);
        reply_print(given, said);
        snprintf(message, CANDIDATE_MESSAGE, "the truth has no answer (%.80s) to: %.400s", said,
                 line);
        return false;
    }
    *answer = (case_answer){.status = given->status,
                            .field = given->field,
                            .t = given->t,
                            .part = given->status == SURE_HIT ? (sure_part)given->part : 0,
                            .normal = given->normal};
    return true;
}

bool truth_ask(const truth *known, const sure_case *cases, int count, case_answer *answers,
               char *message)
{
    if (!known->program) {
        for (int i = 0; i < count; i++)
            answers[i] = case_answer_of(&cases[i], SURE_TIER_EXACT);
        return true;
    }
    known->room->shape = cases[0].object.shape;
    known->room->count = count;
    memcpy(known->room->cases, cases, (size_t)count * sizeof *cases);
    candidate_ask(known->program, known->room);
    for (int i = 0; i < count; i++) {
        if (!take(&cases[i], &known->room->replies[i], &answers[i], message))
            return false;
    }
    return true;
}
