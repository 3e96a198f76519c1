#include "args.h"
#include "choice.h"
#include "commands.h"

#include "../cases/case.h"

#include <stdio.h>

#define DEFAULT_COUNT 1000
#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

enum { HELP, SHAPE, REGIME, COUNT, SEED };
static const args_option options[] = {
    [HELP] = {"--help", false},  [SHAPE] = {"--shape", true}, [REGIME] = {"--regime", true},
    [COUNT] = {"--count", true}, [SEED] = {"--seed", true},
};
#define OPTIONS (int)(sizeof options / sizeof *options)

typedef struct {
    bool help;
    choice pairs;
    uint64_t count, seed;
} request;

static void print_help(void)
{
    fputs("Usage: surehit cases [--shape SHAPE ...] [--regime REGIME ...] [OPTION ...]\n"
          "\n"
          "Writes cases, one a line: SHAPE ox oy oz dx dy dz t_min t_max, and the object's\n"
          "numbers. Without --shape those of all shapes, without --regime those of all regimes.\n"
          "\n"
          "  --shape SHAPE    plane, disc, sphere, cylinder or cone\n"
          "  --regime REGIME  the kind of cases\n"
          "  --count N        of each shape and regime (default " TEXT(
              DEFAULT_COUNT) ")\n"
                             "  --seed K         others of the same kind (default 0)\n",
          stdout);
    choice_print_regimes();
    fputs("\nExit status: 0 written; 1 output could not be written; 2 wrong usage.\n", stdout);
}

static int set_number(const args *line, int option, const char *value, uint64_t *number)
{
    if (args_number(value, 0, UINT64_MAX, number))
        return 0;
    return args_wrong_value(line, options[option].name, value, "a whole number");
}

static int read_words(args *line, request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case SHAPE: status = choice_add_shape(line, value, &asked->pairs); break;
        case REGIME: status = choice_add_regime(line, value, &asked->pairs); break;
        case COUNT: status = set_number(line, COUNT, value, &asked->count); break;
        case SEED: status = set_number(line, SEED, value, &asked->seed); break;
        case ARGS_OPERAND: status = args_wrong(line, "one word too many:", value); break;
        default: status = EXIT_USAGE;
        }
    }
    return status;
}

static void write_cases(const request *asked, sure_shape shape, regime which)
{
    char text[CASE_LINE_MAX];
    for (uint64_t i = 0; i < asked->count && !ferror(stdout); i++) {
        sure_case question = regime_case(shape, which, asked->seed, i);
        case_print(&question, text);
        puts(text);
    }
}

int command_cases(int count, char **words)
{
    args line = {"surehit cases", words, count, 0, false};
    request asked = {.count = DEFAULT_COUNT};
    int status = read_words(&line, &asked), pairs = 0;
    if (status != 0)
        return status;
    if (asked.help) {
        print_help();
        return args_flush_output(&line, 0);
    }
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int which = 0; which < REGIMES; which++) {
            if (!choice_has(&asked.pairs, shape, which))
                continue;
            write_cases(&asked, (sure_shape)shape, (regime)which);
            pairs++;
        }
    }
    if (pairs == 0)
        return args_wrong(&line, "no such cases: the shape has no", "--regime");
    return args_flush_output(&line, 0);
}
