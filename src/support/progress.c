/* SPDX-License-Identifier: MIT */
#include "progress.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define FIRST_DRAWN_AFTER 1.0 /* seconds */
#define DRAWN_EVERY 0.1
#define LINE_EVERY 10.0

#define BAR_WIDTH 30

double progress_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec / 1e9;
}

int64_t progress_total(int64_t times, uint64_t much)
{
    const int64_t most = INT64_MAX / (times > 0 ? times : 1);
    return much <= (uint64_t)most ? times * (int64_t)much : 0;
}

progress progress_start(FILE *out, int64_t total)
{
    double now = progress_clock();
    bool is_terminal = out && isatty(fileno(out));
    return (progress){out, is_terminal, .total = total, .started = now, .drawn = now};
}

/* Of a total that is not known. */
static void draw_count(progress *bar)
{
    if (!bar->is_terminal)
        fprintf(bar->out, "%" PRId64 " done\n", bar->done);
    else
        bar->width = fprintf(bar->out, "\r%12" PRId64 " done", bar->done) - 1;
    fflush(bar->out);
}

static void draw(progress *bar)
{
    if (bar->total == 0 || bar->done == 0) {
        draw_count(bar);
        return;
    }
    double share = fmin((double)bar->done / (double)bar->total, 1); /* a file may have grown */
    int64_t left = (int64_t)((bar->drawn - bar->started) * (1 - share) / share);
    if (!bar->is_terminal) {
        fprintf(bar->out, "%d %%, %" PRId64 ":%02d left\n", (int)(100 * share), left / 60,
                (int)(left % 60));
        return;
    }
    char full[BAR_WIDTH + 1] = "";
    memset(full, '#', (size_t)(share * BAR_WIDTH));
    int width = fprintf(bar->out, "\r[%-*s] %3d %%, %3" PRId64 ":%02d left%s%s", BAR_WIDTH, full,
                        (int)(100 * share), left / 60, (int)(left % 60),
                        bar->note[0] != '\0' ? ", " : "", bar->note);
    if (width < bar->width) /* of a longer note */
        fprintf(bar->out, "%*s", bar->width - width, "");
    else
        bar->width = width;
    fflush(bar->out);
}

bool progress_is_due(const progress *bar)
{
    double now = progress_clock();
    return bar->out && now - bar->started >= FIRST_DRAWN_AFTER &&
           now - bar->drawn >= (bar->is_terminal ? DRAWN_EVERY : LINE_EVERY);
}

void progress_step(progress *bar, int64_t steps)
{
    if (!bar)
        return;
    bar->done += steps;
    if (!progress_is_due(bar))
        return;
    bar->drawn = progress_clock();
    draw(bar);
}

void progress_finish(progress *bar)
{
    if (!bar || bar->width == 0)
        return;
    fprintf(bar->out, "\r%*s\r", bar->width, "");
    bar->width = 0;
    fflush(bar->out);
}
