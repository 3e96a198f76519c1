#include "drawing.h"

#include <stdio.h>
#include <string.h>

#define MOST_THREADS 1024
#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)

static int set_threads(const args *line, const char *value, int *to)
{
    uint64_t threads;
    if (!args_number(value, 1, MOST_THREADS, &threads))
        return args_wrong_value(line, "--threads", value,
                                "a whole number from 1 to " TEXT(MOST_THREADS));
    *to = (int)threads;
    return 0;
}

static int set_tier(const args *line, const char *value, sure_tier *to)
{
    if (!sure_tier_from_name(value, to))
        return args_wrong_value(line, "--tier", value,
                                "float32, textbook, stable, certain or exact");
    return 0;
}

int drawing_set(const args *line, const char *name, const char *value, render_settings *settings)
{
    if (strcmp(name, "--threads") == 0)
        return set_threads(line, value, &settings->how.threads);
    if (strcmp(name, "--tier") == 0)
        return set_tier(line, value, &settings->how.tier);
    const char *expected =
        rt_set_option(&settings->reading, &settings->reading_set, name + 2, value);
    return expected ? args_wrong_value(line, name, value, expected) : 0;
}

void drawing_print_help(void)
{
    sure_tier usual = render_defaults().how.tier;
    fputs("  --size WxH       pixels (default 1280x720, or the scene's R line)\n"
          "  --tier TIER      the functions that decide what is seen:\n"
          "                  ",
          stdout);
    for (int tier = 0; tier < SURE_TIERS; tier++)
        printf(" %s%s", sure_tier_name((sure_tier)tier), tier == (int)usual ? " (default)" : "");
    fputs("\n"
          "  --threads N      1 to " TEXT(MOST_THREADS) " (default: one a core); "
                                                        "the picture stays the same\n",
          stdout);
}
