/* SPDX-License-Identifier: MIT */
#include "referee_report.h"

#include "../../support/json_file.h"

#include <inttypes.h>
#include <stdio.h>

const char *referee_unit_words(margin_unit unit)
{
    static const char *const words[] = {[MARGIN_NONE] = "",
                                        [MARGIN_SIZE] = "of its size",
                                        [MARGIN_DISTANCE] = "of the distance",
                                        [MARGIN_LENGTH] = "in the scene's unit",
                                        [MARGIN_ULPS] = "ulps of the largest coordinate",
                                        [MARGIN_GROWTH] = "of the way from its middle"};
    return words[unit];
}

void referee_print_head(int width, const margins *told, const entry *by)
{
    if (told->count > 0)
        printf("\nWrong decisions by what happens in the case; in %% of the valid cases those that "
               "stay wrong\nwherever the object's faces go by so much %s; the largest such way.\n",
               referee_unit_words(told->unit));
    if (by->declared)
        fputs("By the entry conditions: not asked; allowed.\n", stdout);
    printf("\n%-*s %-13s", width, "shape", "regime");
    if (by->declared)
        printf(" %8s %8s", "no entry", "allowed");
    for (int i = 0; i < EVENTS && told->count > 0; i++)
        printf(" %7s", event_name(i));
    fputs(told->count > 0 ? " |" : "", stdout);
    for (int i = 0; i < told->count; i++)
        printf(" %7g", told->list[i]);
    puts(told->count > 0 ? " |   most" : "");
}

static uint64_t sum_of(const uint64_t counts[EVENTS])
{
    uint64_t sum = 0;
    for (int i = 0; i < EVENTS; i++)
        sum += counts[i];
    return sum;
}

/* "-" where no case was asked. */
static void print_beyond(const verdict *sum, const refereed *of, const margins *told)
{
    const double valid = (double)sum->valid;
    for (int i = 0; i < told->count; i++) {
        if (valid > 0)
            printf(" %7.3g", 100 * (double)of->beyond[i] / valid);
        else
            printf(" %7s", "-");
    }
    if (valid > 0)
        printf(" | %6.2g", refereed_most(of));
    else
        printf(" | %6s", "-");
}

bool referee_tells(const verdict *sum, const refereed *of, const entry *by)
{
    return sum_of(of->events) + sum_of(of->allowed) + (by->declared ? sum->skipped : 0) > 0;
}

void referee_print(const verdict *sum, const refereed *of, const margins *told, const entry *by)
{
    if (by->declared)
        printf(" %8" PRIu64 " %8" PRIu64, sum->skipped, sum_of(of->allowed));
    for (int i = 0; i < EVENTS && told->count > 0; i++)
        printf(" %7" PRIu64, of->events[i]);
    fputs(told->count > 0 ? " |" : "", stdout);
    if (told->count > 0)
        print_beyond(sum, of, told);
    putchar('\n');
}

json_t *referee_margins(const margins *told, const refereed *of)
{
    json_t *wrong = json_array();
    for (int i = 0; i < told->count; i++)
        json_array_append_new(wrong, json_pack("{s:f, s:I}", "beyond", told->list[i], "wrong",
                                               (json_int_t)of->beyond[i]));
    if (told->count > 0)
        return json_pack("{s:s, s:o, s:f}", "unit", margin_unit_names[told->unit], "wrong", wrong,
                         "most", refereed_most(of));
    json_decref(wrong);
    return NULL;
}

json_t *referee_events(const refereed *of)
{
    return json_pack("{s:o, s:o}", "wrong", json_named_counts(event_name, of->events, EVENTS),
                     "allowed", json_named_counts(event_name, of->allowed, EVENTS));
}
