/* SPDX-License-Identifier: MIT */
#include "heat.h"

#include <math.h>
#include <string.h>

typedef struct {
    uint8_t r, g, b;
} heat_color;

static const heat_color nothing = {84, 88, 92};

/* From dark to light throughout, so that the order can be seen without colours, too. */
static const heat_color ramp[] = {
    {24, 20, 88}, {96, 32, 140}, {192, 52, 112}, {240, 128, 56}, {252, 236, 150}};
#define RAMP_STEPS ((int)(sizeof ramp / sizeof *ramp) - 1)

/* What stands out is rare. */
static const heat_color stages[SURE_STAGES] = {
    [SURE_STAGE_DOUBLE] = {40, 74, 120},
    [SURE_STAGE_DOUBLE_DOUBLE] = {236, 196, 64},
    [SURE_STAGE_MOD128] = {64, 208, 176},
    [SURE_STAGE_EXACT] = {240, 72, 96},
};

const char *const heat_names[HEATS + 1] = {
    [HEAT_STAGE] = "stage", [HEAT_ERROR] = "error", [HEAT_TIME] = "time"};

/* Powers of ten between which the values lie. */
typedef struct {
    int low, high;
} decades;

/* NaN where there is none. */
static double value_of(heat_kind kind, const pixel_record *pixel)
{
    if (kind == HEAT_TIME)
        return pixel->microseconds;
    if (pixel->seen != SURE_HIT)
        return NAN;
    return pixel->t_error / (nextafter(pixel->t, INFINITY) - pixel->t);
}

#define DECADE_LEAST (-6)
#define DECADE_MOST 16
#define DECADES (DECADE_MOST - DECADE_LEAST + 1)

static int decade_of(double value)
{
    double decade = value > 0 ? floor(log10(value)) : DECADE_LEAST;
    return (int)fmin(fmax(decade, DECADE_LEAST), DECADE_MOST);
}

/* All but the thousandth part at either end, which is shown as the end is: a pixel during which
 * something else was run would darken all others. */
static decades range_of(heat_kind kind, const pixel_record *records, size_t pixels)
{
    size_t counts[DECADES] = {0}, all = 0;
    for (size_t i = 0; i < pixels; i++) {
        double value = value_of(kind, &records[i]);
        if (isnan(value))
            continue;
        all++;
        counts[decade_of(value) - DECADE_LEAST]++;
    }
    int low = 0, high = DECADES - 1;
    size_t left_out = all / 1000;
    for (size_t sum = counts[low]; low < high && sum <= left_out; sum += counts[low])
        low++;
    for (size_t sum = counts[high]; high > low && sum <= left_out; sum += counts[high])
        high--;
    return (decades){low + DECADE_LEAST, high + DECADE_LEAST + 1};
}

static uint8_t mixed(uint8_t from, uint8_t to, double share)
{
    return (uint8_t)lround(from + share * (to - from));
}

/* 0 is the ramp's dark end, 1 its light one. */
static heat_color ramp_at(double share)
{
    double step = RAMP_STEPS * fmin(fmax(share, 0), 1);
    int from = step < RAMP_STEPS ? (int)step : RAMP_STEPS - 1;
    const heat_color *a = &ramp[from], *b = &ramp[from + 1];
    return (heat_color){mixed(a->r, b->r, step - from), mixed(a->g, b->g, step - from),
                        mixed(a->b, b->b, step - from)};
}

static heat_color color_of(heat_kind kind, const pixel_record *pixel, decades range)
{
    if (kind == HEAT_STAGE)
        return pixel->seen == SURE_HIT ? stages[pixel->stage] : nothing;
    double value = value_of(kind, pixel);
    if (isnan(value))
        return nothing;
    return ramp_at(value > 0 ? (log10(value) - range.low) / (range.high - range.low) : 0);
}

bool heat_draw(heat_kind kind, const pixel_record *records, int width, int height, picture *shown)
{
    const size_t pixels = (size_t)width * (size_t)height;
    const decades range = range_of(kind, records, pixels);
    if (!picture_new(width, height, shown))
        return false;
    for (size_t i = 0; i < pixels; i++) {
        heat_color color = color_of(kind, &records[i], range);
        memcpy(shown->rgb + 3 * i, &color, 3);
    }
    return true;
}

static void print_entry(FILE *out, heat_color color, const char *name, size_t pixels)
{
    fprintf(out, "  #%02x%02x%02x %-14s %12zu\n", color.r, color.g, color.b, name, pixels);
}

void heat_print_key(FILE *out, heat_kind kind, const pixel_record *records, size_t pixels)
{
    size_t counts[SURE_STAGES] = {0}, hits = 0;
    for (size_t i = 0; i < pixels; i++) {
        counts[records[i].stage] += records[i].seen == SURE_HIT;
        hits += records[i].seen == SURE_HIT;
    }
    fprintf(out, "heat %s", heat_names[kind]);
    if (kind == HEAT_STAGE) {
        fputs(", pixels\n", out);
        for (int stage = 0; stage < SURE_STAGES; stage++)
            print_entry(out, stages[stage], sure_stage_name((sure_stage)stage), counts[stage]);
    } else if (kind == HEAT_ERROR && hits == 0) {
        fputs(": no ray met anything\n", out);
    } else {
        const decades range = range_of(kind, records, pixels);
        fprintf(out, ": %s, from 1e%d (dark) to 1e%d (light)\n",
                kind == HEAT_TIME ? "microseconds a pixel" : "t_error in ulps of t", range.low,
                range.high);
    }
    if (kind != HEAT_TIME)
        print_entry(out, nothing, "miss", pixels - hits);
}
