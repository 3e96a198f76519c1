/* SPDX-License-Identifier: MIT */
/* What is installed beside the program and made of the commands' tables: manual pages, and what
 * completes words in shells. */
#pragma once

#include "../options.h"

/* A page in the language of man(7): the help text, as a manual has it. */
void manual_page(const cli_command *command, FILE *out);

/* A script for each shell. */
void manual_bash(FILE *out);
void manual_zsh(FILE *out);
void manual_fish(FILE *out);
