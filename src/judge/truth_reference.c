/* SPDX-License-Identifier: MIT */
#include "truth.h"

#include "../support/folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define REFERENCE_NAME "surehit-reference"

/* Commands for first hits, for intervals and for first hits of walls. */
typedef struct {
    const char *hits, *intervals, *walls;
} commands;

/* Of the program at that path the shell finds it, whatever it holds, in the environment. */
static bool is_at(const char *path)
{
    return access(path, X_OK) == 0 && setenv("SUREHIT_REFERENCE", path, 1) == 0;
}

/* Beside this one, or where both were built; else the shell looks for it. */
static commands find_reference(void)
{
    static const commands found = {"exec \"$SUREHIT_REFERENCE\"",
                                   "exec \"$SUREHIT_REFERENCE\" --interval",
                                   "exec \"$SUREHIT_REFERENCE\" --wall"};
    static const commands named = {REFERENCE_NAME, REFERENCE_NAME " --interval",
                                   REFERENCE_NAME " --wall"};
    char path[4096];
    if (folder_from_program(REFERENCE_NAME, path, sizeof path) && is_at(path))
        return found;
    if (folder_from_build("reference/" REFERENCE_NAME, path, sizeof path) && is_at(path))
        return found;
    return named;
}

bool truth_reference(double time_limit, truth *known, char *message)
{
    const candidate_options how = {INPUTS_DOUBLE, time_limit, .once = true};
    const commands by = find_reference();
    known->program = candidate_of_command(by.hits, &how, message);
    known->intervals = known->program ? candidate_of_command(by.intervals, &how, message) : NULL;
    known->walls = known->intervals ? candidate_of_command(by.walls, &how, message) : NULL;
    if (known->walls)
        return true;
    truth_close(known);
    return complain(message, "'" REFERENCE_NAME "' cannot be started: it is built where CGAL is");
}

bool truth_has_reference(void)
{
    static truth known;
    bool found = truth_reference(5, &known, NULL);
    truth_close(&known);
    return found;
}
