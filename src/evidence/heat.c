#include "heat.h"

#include "key.h"

#include <math.h>
#include <string.h>

static const key_color paper = {24, 24, 28}, ink = {235, 235, 235}, nothing = {84, 88, 92};

/* From dark to light throughout, so that the order can be seen without colours, too. */
static const key_color ramp[] = {
    {24, 20, 88}, {96, 32, 140}, {192, 52, 112}, {240, 128, 56}, {252, 236, 150}};
#define RAMP_STEPS ((int)(sizeof ramp / sizeof *ramp) - 1)

/* What stands out is rare. */
static const key_color stages[SURE_STAGES] = {
    [SURE_STAGE_DOUBLE] = {40, 74, 120},
    [SURE_STAGE_DOUBLE_DOUBLE] = {236, 196, 64},
    [SURE_STAGE_MOD128] = {64, 208, 176},
    [SURE_STAGE_EXACT] = {240, 72, 96},
};

static const struct {
    const char *name, *title;
} kinds[HEATS] = {
    [HEAT_STAGE] = {"stage", ""},
    [HEAT_ERROR] = {"error", "t_error in ulps of t"},
    [HEAT_TIME] = {"time", "microseconds a pixel"},
};

const char *heat_name(heat_kind kind)
{
    return kinds[kind].name;
}

bool heat_from_name(const char *name, heat_kind *kind)
{
    for (int i = 0; i < HEATS; i++) {
        if (strcmp(name, kinds[i].name) == 0) {
            *kind = (heat_kind)i;
            return true;
        }
    }
    return false;
}

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
static key_color ramp_at(double share)
{
    double step = RAMP_STEPS * fmin(fmax(share, 0), 1);
    int from = step < RAMP_STEPS ? (int)step : RAMP_STEPS - 1;
    const key_color *a = &ramp[from], *b = &ramp[from + 1];
    return (key_color){mixed(a->r, b->r, step - from), mixed(a->g, b->g, step - from),
                       mixed(a->b, b->b, step - from)};
}

static key_color color_of(heat_kind kind, const pixel_record *pixel, decades range)
{
    if (kind == HEAT_STAGE)
        return pixel->seen == SURE_HIT ? stages[pixel->stage] : nothing;
    double value = value_of(kind, pixel);
    if (isnan(value))
        return nothing;
    return ramp_at(value > 0 ? (log10(value) - range.low) / (range.high - range.low) : 0);
}

/* A key's measures follow from its scale. */
typedef struct {
    picture *image;
    int top, scale;
} key_place;

static int scale_of(int width)
{
    if (width < 640)
        return 1;
    return width < 1280 ? 2 : width / 640;
}

#define MARGIN 4 /* in units of the scale, as all that follow */
#define LINE (KEY_HEIGHT + MARGIN)
#define SWATCH KEY_HEIGHT
#define TICK 3

/* A swatch and its word; returns the place behind. Where the row is full it goes to the next. */
typedef struct {
    int x, row;
} entry_place;

static entry_place put_entry(const key_place *at, entry_place next, key_color color,
                             const char *word, bool drawn)
{
    const int s = at->scale;
    int width = s * (SWATCH + MARGIN) + key_width(word, s);
    if (next.x > s * MARGIN && next.x + width > at->image->width) {
        next.x = s * MARGIN;
        next.row++;
    }
    int y = at->top + s * (MARGIN + next.row * LINE);
    if (drawn) {
        key_fill(at->image, next.x, y, s * SWATCH, s * SWATCH, color);
        key_text(at->image, next.x + s * (SWATCH + MARGIN), y, s, ink, word);
    }
    next.x += width + s * 2 * MARGIN;
    return next;
}

/* What is to be said of all pixels. */
typedef struct {
    heat_kind kind;
    decades range;                      /* but for HEAT_STAGE */
    size_t stages[SURE_STAGES], missed; /* pixels */
} heat_summary;

static heat_summary summary_of(heat_kind kind, const pixel_record *records, size_t pixels)
{
    heat_summary all = {.kind = kind, .range = range_of(kind, records, pixels)};
    for (size_t i = 0; i < pixels; i++) {
        if (records[i].seen == SURE_HIT)
            all.stages[records[i].stage]++;
        else
            all.missed++;
    }
    return all;
}

/* A stage's name and its pixels: a single one of these would hardly be found. */
static entry_place put_counted(const key_place *at, entry_place next, key_color color,
                               const char *name, size_t pixels, bool drawn)
{
    char text[64];
    snprintf(text, sizeof text, "%s %zu", name, pixels);
    return put_entry(at, next, color, text, drawn);
}

/* Returns how many rows they take. */
static int put_stage_entries(const key_place *at, const heat_summary *all, bool drawn)
{
    entry_place next = {at->scale * MARGIN, 0};
    for (int stage = 0; stage < SURE_STAGES; stage++)
        next = put_counted(at, next, stages[stage], sure_stage_name((sure_stage)stage),
                           all->stages[stage], drawn);
    return put_counted(at, next, nothing, "miss", all->missed, drawn).row + 1;
}

static void print_decade(char *text, size_t size, int decade)
{
    if (decade >= -2 && decade <= 4)
        snprintf(text, size, "%.*f", decade < 0 ? -decade : 0, pow(10, decade));
    else
        snprintf(text, size, "1e%d", decade);
}

/* Ticks at the powers of ten, with a number where the last one leaves room for it. */
static void put_ticks(const key_place *at, decades range, int left, int width, int y)
{
    const int s = at->scale;
    int free_from = 0;
    for (int decade = range.low; decade <= range.high; decade++) {
        char text[16];
        print_decade(text, sizeof text, decade);
        int x = left + width * (decade - range.low) / (range.high - range.low);
        int from = x - key_width(text, s) / 2;
        from = from > at->image->width - key_width(text, s) ? at->image->width - key_width(text, s)
               : from > 0                                   ? from
                                                            : 0;
        key_fill(at->image, x, y, s, s * TICK, ink);
        if (from < free_from)
            continue;
        key_text(at->image, from, y + s * (TICK + 1), s, ink, text);
        free_from = from + key_width(text, s) + s * MARGIN;
    }
}

static void put_ramp(const key_place *at, const heat_summary *all)
{
    const int s = at->scale, left = s * 3 * MARGIN, width = at->image->width - 2 * left - s;
    const int title = at->top + s * MARGIN, bar = title + s * LINE;
    const char *text = kinds[all->kind].title;
    key_text(at->image, s * MARGIN, title, s, ink, text);
    if (all->kind == HEAT_ERROR) {
        int behind = key_width(text, s) + s * 3 * MARGIN;
        (void)put_entry(at, (entry_place){behind, 0}, nothing, "miss", true);
    }
    for (int x = 0; x < width; x++)
        key_fill(at->image, left + x, bar, 1, s * SWATCH, ramp_at((double)x / width));
    put_ticks(at, all->range, left, width, bar + s * SWATCH);
}

static int key_lines(const key_place *at, const heat_summary *all)
{
    return all->kind == HEAT_STAGE ? put_stage_entries(at, all, false) : 3;
}

static void put_key(const key_place *at, const heat_summary *all)
{
    key_fill(at->image, 0, 0, at->image->width, at->image->height, paper);
    if (all->kind == HEAT_STAGE)
        (void)put_stage_entries(at, all, true);
    else
        put_ramp(at, all);
}

bool heat_draw(heat_kind kind, const pixel_record *records, int width, int height, picture *shown)
{
    const heat_summary all = summary_of(kind, records, (size_t)width * (size_t)height);
    picture sheet = {.width = width > HEAT_WIDTH ? width : HEAT_WIDTH};
    key_place at = {&sheet, height, scale_of(sheet.width)};
    int below = at.scale * (MARGIN + key_lines(&at, &all) * LINE);
    if (!picture_new(sheet.width, height + below, shown))
        return false;
    at.image = shown;
    put_key(&at, &all);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const pixel_record *pixel = &records[(size_t)y * (size_t)width + (size_t)x];
            key_fill(shown, x, y, 1, 1, color_of(kind, pixel, all.range));
        }
    }
    return true;
}
