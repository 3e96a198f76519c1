#include "args.h"
#include "commands.h"

#include "../cases/extremes/extremes_table.h"

#include <stdio.h>

#define DEFAULT_COUNT 1000
#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

enum { HELP, COUNT };
static const args_option options[] = {[HELP] = {"--help", false}, [COUNT] = {"--count", true}};
#define OPTIONS (int)(sizeof options / sizeof *options)

static void print_help(void)
{
    fputs("Usage: surehit extremes [--count N]\n"
          "\n"
          "Asks every tier extreme cases whose right answers are known from the way they\n"
          "are made (tangents, rims, apexes, parallels, ...) and prints a table of its\n"
          "wrong answers.\n"
          "\n"
          "  --count N  cases of each family (default " TEXT(DEFAULT_COUNT) ")\n"
          "\n"
          "Exit status: 0 table printed; 1 it could not be printed; 2 wrong usage.\n", stdout);
}

int command_extremes(int count, char **words)
{
    args line = {"surehit extremes", words, count, 0, false};
    uint64_t cases = DEFAULT_COUNT;
    const char *value;
    for (int option; (option = args_next(&line, options, OPTIONS, &value)) != ARGS_END;) {
        switch (option) {
        case HELP:
            print_help();
            return args_flush_output(&line, 0);
        case COUNT:
            if (!args_number(value, 1, UINT64_MAX, &cases))
                return args_wrong_value(&line, "--count", value, "a whole number above 0");
            break;
        case ARGS_OPERAND:
            return args_wrong(&line, "one word too many:", value);
        default:
            return EXIT_USAGE;
        }
    }
    bool printed = extremes_table(stdout, cases) == 0;
    int status = args_flush_output(&line, 0);
    if (status != 0 || printed)
        return status;
    fputs("surehit extremes: error: the table could not be printed\n", stderr);
    return EXIT_OUTPUT;
}
