#include "instructions.h"

#include "../../support/cpu_time.h"
#include "../../support/shell.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NUMBER "SUREHIT_INSTRUCTIONS" /* in the run that counts: of the file that callgrind fills */
#define MOST 4096

static FILE *to; /* in the run that counts */
static double kept[MOST];
static int kept_count;

bool instructions_counting(void)
{
    return getenv(NUMBER) != NULL;
}

/* Callgrind knows it by its name, counts within and writes when it is left. */
__attribute__((noinline)) void surehit_counted(void (*run)(void *), void *context);
void surehit_counted(void (*run)(void *), void *context)
{
    static volatile int left;
    run(context);
    left = 1; /* it returns here */
    (void)left;
}

/* What it has written; the file is empty then. */
static double take_count(void)
{
    char line[256];
    double count = -1;
    int number = dup(atoi(getenv(NUMBER)));
    FILE *in = number < 0 ? NULL : fdopen(number, "r");
    if (!in)
        return -1;
    rewind(in);
    while (fgets(line, sizeof line, in))
        sscanf(line, "totals: %lf", &count);
    count = ftruncate(number, 0) == 0 ? count : -1;
    fclose(in);
    return count;
}

double cost_of(void (*run)(void *), void *context)
{
    if (instructions_counting()) {
        surehit_counted(run, context);
        return take_count();
    }
    double start = cpu_time();
    run(context);
    return cpu_time() - start;
}

double instructions_figure(double counted)
{
    static int taken;
    if (!to)
        return taken < kept_count ? kept[taken++] : -1;
    fprintf(to, "%.17g\n", counted);
    fflush(to);
    return counted;
}

static void print_command(FILE *out, int number, const char *command, char *const *words)
{
    fprintf(out,
            NUMBER "=%d exec valgrind -q --tool=callgrind --combine-dumps=yes "
                   "--callgrind-out-file=/proc/self/fd/%d --toggle-collect=surehit_counted "
                   "--dump-after=surehit_counted /proc/%d/exe %s",
            number, number, (int)getpid(), command);
    for (; *words; words++) {
        fputc(' ', out);
        shell_print(out, *words);
    }
    fputs(" 2>/dev/null", out);
}

bool instructions_begin(const char *name, char *const *words)
{
    if (instructions_counting()) {
        to = fdopen(dup(STDOUT_FILENO), "w");
        return to && freopen("/dev/null", "w", stdout);
    }
    char *text = NULL;
    size_t size;
    FILE *file = tmpfile(), *out = open_memstream(&text, &size), *said = NULL;
    if (out) {
        print_command(out, file ? fileno(file) : -1, strchr(name, ' ') + 1, words);
        said = fclose(out) == 0 && file ? popen(text, "r") : NULL;
    }
    while (said && kept_count < MOST && fscanf(said, "%lf", &kept[kept_count]) == 1)
        kept_count++;
    if (said)
        pclose(said);
    if (file)
        fclose(file);
    free(text);
    if (kept_count == 0)
        fprintf(stderr, "%s: error: valgrind is missing, or counts nothing here\n", name);
    return kept_count > 0;
}
