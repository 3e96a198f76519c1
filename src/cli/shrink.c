#define _POSIX_C_SOURCE 200809L /* getline */

#include "args.h"
#include "commands.h"

#include "../judge/shrink.h"

#include <surehit/bounds.h>

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HELP, TIER, AGAINST };
static const args_option options[] = {
    [HELP] = {"--help", false}, [TIER] = {"--tier", true}, [AGAINST] = {"--against", true}};
#define OPTIONS (int)(sizeof options / sizeof *options)

/* What can be wrong with a tier's answer, `exact` being right. */
typedef enum {
    RIGHT,
    WRONG_STATUS,
    WRONG_FIELD,
    WRONG_PART,
    WRONG_T,
    WRONG_NORMAL,
    WRONG_RANGE, /* t outside [t_min, t_max] */
    WRONG_ERROR  /* t farther off than it says */
} wrong;

typedef enum { AGAINST_DECISION, AGAINST_ANSWER, AGAINST_PROMISE, AGAINSTS } against;

static const char *const against_names[AGAINSTS] = {"decision", "answer", "promise"};

/* How a line fails: made simpler, it has to fail in the same way. */
typedef struct {
    sure_tier tier;
    against by;
    wrong what;
    sure_status status, right_status;
} failure;

static void print_help(void)
{
    fputs("Usage: surehit shrink --tier TIER [--against WHAT] [FILE]\n"
          "\n"
          "Reads cases, one a line, from FILE or standard input. Each one that TIER\n"
          "answers wrongly is made simple (zeros, ones, fewer bits, smaller exponents) as\n"
          "long as it is answered wrongly in the same way, and printed.\n"
          "\n"
          "  --tier TIER       float32, textbook, stable or certain\n"
          "  --against WHAT    what is held against the tier exact:\n"
          "                      decision  status, field and part (the default)\n"
          "                      answer    every bit of the answer\n"
          "                      promise   what certain promises: the decision, t in\n"
          "                                range and within t_error, the normal's bound\n"
          "\n"
          "What is answered rightly, and what is no case, is told on standard error.\n"
          "\n"
          "Exit status: 0 every line was a case; 1 output could not be written; 2 wrong\n"
          "usage, or a line that is no case.\n",
          stdout);
}

/* The answers held against each other. */

static bool same_bits(double x, double y)
{
    return memcmp(&x, &y, sizeof x) == 0;
}

static bool same_normal(sure_vec3 a, sure_vec3 b)
{
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

static wrong wrong_decision(const case_answer *given, const case_answer *right)
{
    if (given->status != right->status)
        return WRONG_STATUS;
    if (given->field != right->field)
        return WRONG_FIELD;
    return given->part != right->part ? WRONG_PART : RIGHT;
}

static wrong wrong_answer(const case_answer *given, const case_answer *right)
{
    if (!same_bits(given->t, right->t))
        return WRONG_T;
    return same_normal(given->normal, right->normal) ? RIGHT : WRONG_NORMAL;
}

/* Surely farther off: exact's t is rounded, and the real one between its neighbours. */
static bool is_off(double given, double right, double error)
{
    double low = nextafter(right, -INFINITY), high = nextafter(right, INFINITY);
    return !(given >= low - error && given <= high + error);
}

static bool is_off_normal(sure_vec3 given, sure_vec3 right)
{
    const double error = SURE_NORMAL_ERROR;
    return is_off(given.x, right.x, error) || is_off(given.y, right.y, error) ||
           is_off(given.z, right.z, error);
}

static wrong broken_promise(const sure_case *question, sure_tier tier, const case_answer *given,
                            const case_answer *right)
{
    sure_hit hit = {0};
    (void)sure_object_hit(&question->ray, &question->object, tier, &hit);
    if (!(given->t >= question->ray.t_min && given->t <= question->ray.t_max))
        return WRONG_RANGE;
    if (is_off(given->t, right->t, hit.t_error))
        return WRONG_ERROR;
    return is_off_normal(given->normal, right->normal) ? WRONG_NORMAL : RIGHT;
}

static failure failure_of(const sure_case *question, sure_tier tier, against by)
{
    case_answer given = case_answer_of(question, tier);
    case_answer right = case_answer_of(question, SURE_TIER_EXACT);
    wrong what = wrong_decision(&given, &right);
    if (what == RIGHT && given.status == SURE_HIT && by == AGAINST_ANSWER)
        what = wrong_answer(&given, &right);
    if (what == RIGHT && given.status == SURE_HIT && by == AGAINST_PROMISE)
        what = broken_promise(question, tier, &given, &right);
    return (failure){tier, by, what, given.status, right.status};
}

static bool fails_alike(const sure_case *question, void *context)
{
    const failure *first = context;
    failure now = failure_of(question, first->tier, first->by);
    return now.what == first->what && now.status == first->status &&
           now.right_status == first->right_status;
}

/* The lines. */

static void shrink_line(const args *line, uint64_t number, const sure_case *question,
                        const failure *how)
{
    char text[CASE_LINE_MAX];
    failure found = failure_of(question, how->tier, how->by);
    if (found.what == RIGHT) {
        fprintf(stderr, "%s: line %ju: does not fail\n", line->command, (uintmax_t)number);
        return;
    }
    sure_case simple = shrink_case(question, fails_alike, &found);
    case_print(&simple, text);
    puts(text);
}

/* The exit status. A NUL byte would hide what stands behind it. */
static int shrink_lines(const args *line, FILE *in, const failure *how)
{
    char *text = NULL;
    size_t room = 0;
    int status = 0;
    uint64_t number = 0;
    for (ssize_t length; !ferror(stdout) && (length = getline(&text, &room, in)) >= 0;) {
        sure_case question;
        number++;
        if (strlen(text) == (size_t)length && case_read(text, &question)) {
            shrink_line(line, number, &question, how);
            continue;
        }
        fprintf(stderr, "%s: error: line %ju: no case\n", line->command, (uintmax_t)number);
        status = EXIT_USAGE;
    }
    free(text);
    if (ferror(in)) {
        fprintf(stderr, "%s: error: the cases cannot be read\n", line->command);
        status = EXIT_USAGE;
    }
    return status;
}

static int shrink_file(const args *line, const char *path, const failure *how)
{
    bool is_input = !path || strcmp(path, "-") == 0;
    FILE *in = is_input ? stdin : fopen(path, "r");
    if (!in) {
        fprintf(stderr, "%s: error: %s: %s\n", line->command, path, strerror(errno));
        return EXIT_USAGE;
    }
    int status = shrink_lines(line, in, how);
    if (!is_input)
        fclose(in);
    return args_flush_output(line, status);
}

/* The words. */

typedef struct {
    bool help, has_tier;
    failure how;
    const char *path;
} request;

static int set_tier(const args *line, const char *value, request *asked)
{
    if (!sure_tier_from_name(value, &asked->how.tier) || asked->how.tier == SURE_TIER_EXACT)
        return args_wrong_value(line, "--tier", value, "float32, textbook, stable or certain");
    asked->has_tier = true;
    return 0;
}

static int set_against(const args *line, const char *value, request *asked)
{
    for (int i = 0; i < AGAINSTS; i++) {
        if (strcmp(value, against_names[i]) == 0) {
            asked->how.by = (against)i;
            return 0;
        }
    }
    return args_wrong_value(line, "--against", value, "decision, answer or promise");
}

/* Returns the exit status, 0 to go on. */
static int read_words(args *line, request *asked)
{
    const char *value;
    int status = 0, option;
    while (status == 0 && (option = args_next(line, options, OPTIONS, &value)) != ARGS_END) {
        switch (option) {
        case HELP: asked->help = true; return 0;
        case TIER: status = set_tier(line, value, asked); break;
        case AGAINST: status = set_against(line, value, asked); break;
        case ARGS_OPERAND:
            if (asked->path)
                return args_wrong(line, "one word too many:", value);
            asked->path = value;
            break;
        default: return EXIT_USAGE;
        }
    }
    if (status == 0 && !asked->has_tier)
        return args_wrong(line, "missing", "--tier");
    if (status == 0 && asked->how.by == AGAINST_PROMISE && asked->how.tier != SURE_TIER_CERTAIN)
        return args_wrong_value(line, "--against", "promise", "the tier certain");
    return status;
}

int command_shrink(int count, char **words)
{
    args line = {"surehit shrink", words, count, 0, false};
    request asked = {0};
    int status = read_words(&line, &asked);
    if (status != 0)
        return status;
    if (asked.help) {
        print_help();
        return args_flush_output(&line, 0);
    }
    return shrink_file(&line, asked.path, &asked.how);
}
