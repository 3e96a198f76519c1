/* SPDX-License-Identifier: MIT */
#include "truth.h"

#include "../support/folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define REFERENCE_NAME "surehit-reference"

/* Of the program at that path the shell finds it, whatever it holds, in the environment. */
static bool is_at(const char *path)
{
    return access(path, X_OK) == 0 && setenv("SUREHIT_REFERENCE", path, 1) == 0;
}

/* How it is called: beside this one, or where both were built; else the shell looks for it. */
static const char *find_reference(void)
{
    char path[4096];
    bool found = (folder_from_program(REFERENCE_NAME, path, sizeof path) && is_at(path)) ||
                 (folder_from_build("reference/" REFERENCE_NAME, path, sizeof path) && is_at(path));
    return found ? "exec \"$SUREHIT_REFERENCE\"" : REFERENCE_NAME;
}

bool truth_reference(double time_limit, truth *known, char *message)
{
    static const char *const options[TRUTH_KINDS] = {"", " --interval", " --wall"};
    static char commands[TRUTH_KINDS][64]; /* they live as long as who is asked by them */
    const candidate_options how = {INPUTS_DOUBLE, time_limit, .once = true};
    const char *by = find_reference();
    for (int i = 0; i < TRUTH_KINDS; i++) {
        snprintf(commands[i], sizeof commands[i], "%s%s", by, options[i]);
        known->programs[i] = candidate_of_command(commands[i], &how, message);
        if (known->programs[i])
            continue;
        truth_close(known);
        return complain(message,
                        "'" REFERENCE_NAME "' cannot be started: it is built where CGAL is");
    }
    return true;
}

bool truth_has_reference(void)
{
    static truth known;
    bool found = truth_reference(5, &known, NULL);
    truth_close(&known);
    return found;
}
