/* SPDX-License-Identifier: MIT */
/* Commands that a user can paste. */
#pragma once

#include <stdio.h>

/* The word, in quotes where a shell would not read it as it stands. */
void shell_print(FILE *out, const char *word);

/* This program as it was called, which finds it again from the same folder. */
void shell_print_program(FILE *out);
