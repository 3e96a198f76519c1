/* SPDX-License-Identifier: MIT */
#include "instructions.h"

#include "../../support/cpu_time.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* Two open files for the run that counts, by their numbers: one that callgrind fills and one for
 * the figures. */
#define NUMBERS "SUREHIT_INSTRUCTIONS"

static FILE *figures;

bool instructions_counting(void)
{
    return getenv(NUMBERS) != NULL;
}

/* One of them; NULL: it is not open. */
static FILE *open_number(int which, const char *mode)
{
    int numbers[2] = {-1, -1};
    sscanf(getenv(NUMBERS), "%d,%d", &numbers[0], &numbers[1]);
    int number = dup(numbers[which]);
    return number < 0 ? NULL : fdopen(number, mode);
}

/* Callgrind knows it by its name, counts within and writes when it is left. */
void surehit_counted(void (*run)(void *), void *context);
__attribute__((noinline)) void surehit_counted(void (*run)(void *), void *context)
{
    static volatile bool left;
    run(context);
    left = true; /* it returns here */
    (void)left;
}

/* What callgrind has written; the file is empty then. */
static double take_count(void)
{
    char line[256];
    double count = -1;
    FILE *in = open_number(0, "r");
    if (!in)
        return -1;
    rewind(in);
    while (fgets(line, sizeof line, in))
        sscanf(line, "totals: %lf", &count);
    count = ftruncate(fileno(in), 0) == 0 ? count : -1;
    fclose(in);
    return count;
}

static double measured(void (*run)(void *), void *context)
{
    if (instructions_counting()) {
        surehit_counted(run, context);
        return take_count();
    }
    double start = cpu_time();
    run(context);
    return cpu_time() - start;
}

static void do_nothing(void *context)
{
    (void)context;
}

/* What measuring takes: the least of several times; a count repeats. */
static double measuring(void)
{
    double least = measured(do_nothing, NULL);
    for (int i = instructions_counting() ? 1 : 100; i > 1; i--)
        least = fmin(least, measured(do_nothing, NULL));
    return least;
}

double cost_of(void (*run)(void *), void *context)
{
    static double itself = -1;
    if (itself < 0)
        itself = measuring();
    const double all = measured(run, context);
    return all < 0 ? all : fmax(all - itself, 0);
}

double instructions_figure(double counted)
{
    double told = -1;
    if (!figures || !instructions_counting())
        return figures && fscanf(figures, "%lf", &told) == 1 ? told : -1;
    fprintf(figures, "%.17g\n", counted);
    fflush(figures);
    return counted;
}

/* This program's own words, behind its name, are run once more. */
#define COMMAND                                                                                    \
    "exec 2>/dev/null; tail -z -n +2 /proc/%d/cmdline | " NUMBERS                                  \
    "=%d,%d xargs -0 valgrind -q --tool=callgrind "                                                \
    "--combine-dumps=yes --callgrind-out-file=/proc/self/fd/%d --toggle-collect=surehit_counted "  \
    "--dump-after=surehit_counted /proc/%d/exe >/dev/null"

bool instructions_begin(const char *name)
{
    char command[512];
    int first = EOF, own = (int)getpid();
    if (instructions_counting())
        return (figures = open_number(1, "w")) != NULL;
    FILE *counts = tmpfile();
    figures = tmpfile();
    if (counts && figures) {
        int number = fileno(counts);
        snprintf(command, sizeof command, COMMAND, own, number, fileno(figures), number, own);
        int ended = system(command);
        if (ended >= 0 && WIFSIGNALED(ended))
            raise(WTERMSIG(ended)); /* by ^C, which was not for us while it ran */
        if (ended >= 0)
            rewind(figures);
        first = ungetc(fgetc(figures), figures);
    }
    if (counts)
        fclose(counts);
    if (first == EOF)
        fprintf(stderr, "%s: error: valgrind is missing, or counts nothing here\n", name);
    return first != EOF;
}
