#include "truth.h"

#include "../support/folder.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define REFERENCE_NAME "surehit-reference"

/* A command for the program at that path; the shell finds it, whatever it holds, in the
 * environment. */
static const char *command_of(const char *path)
{
    bool found = access(path, X_OK) == 0 && setenv("SUREHIT_REFERENCE", path, 1) == 0;
    return found ? "exec \"$SUREHIT_REFERENCE\"" : NULL;
}

/* Beside this one, or where both were built; else the shell looks for it. */
static const char *find_reference(void)
{
    char path[4096];
    const char *found = NULL;
    if (folder_from_program(REFERENCE_NAME, path, sizeof path))
        found = command_of(path);
    if (!found && folder_from_build("reference/" REFERENCE_NAME, path, sizeof path))
        found = command_of(path);
    return found ? found : REFERENCE_NAME;
}

bool truth_reference(double time_limit, truth *known, char *message)
{
    const candidate_options how = {INPUTS_DOUBLE, time_limit, .once = true};
    known->program = candidate_of_command(find_reference(), &how, message);
    return known->program ||
           complain(message, "'" REFERENCE_NAME "' cannot be started: it is built where CGAL is");
}

bool truth_has_reference(void)
{
    static truth known;
    bool found = truth_reference(5, &known, NULL);
    candidate_close(known.program);
    return found;
}
