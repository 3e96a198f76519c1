/* SPDX-License-Identifier: MIT */
/* Asked by the build (meson.build), so that it stands in no list of commands. */
#include "manual.h"

#include <string.h>

static const struct {
    const char *name;
    void (*write)(FILE *out);
} shells[] = {{"bash", manual_bash}, {"zsh", manual_zsh}, {"fish", manual_fish}};

static int write_page(const char *name)
{
    const cli_command *command = name ? cli_command_of(name) : &cli_program;
    if (!command)
        return cli_wrong("no page of '%s'", name);
    manual_page(command, stdout);
    return 0;
}

static int run(void)
{
    const char *kind = cli_operands[0];
    if (strcmp(kind, "man") == 0)
        return write_page(cli_operand_count > 1 ? cli_operands[1] : NULL);
    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++) {
        if (strcmp(kind, shells[i].name) == 0 && cli_operand_count == 1) {
            shells[i].write(stdout);
            return 0;
        }
    }
    return cli_wrong("expected 'man', 'man COMMAND', 'bash', 'zsh' or 'fish'");
}

static const cli_option options[] = {{0}};

const cli_command command_describe = {
    .name = "surehit describe",
    .usage = "man [COMMAND] | bash | zsh | fish",
    .about = "Writes a manual page, of surehit or of a command, or what completes words in\n"
             "a shell.",
    .options = options,
    .operands = "KIND",
    .most_operands = 2,
    .statuses = "0 written; 1 output could not be written; 2 wrong usage.",
    .run = run,
};
