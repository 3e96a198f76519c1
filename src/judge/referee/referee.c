/* SPDX-License-Identifier: MIT */
#include "referee.h"

#include <math.h>
#include <string.h>

margins margins_of(margin_unit unit)
{
    static const double sizes[] = {1e-12, 1e-9, 1e-6, 1e-3, 1e-2, 1};
    static const double ulps[] = {1, 10, 100, 1e3, 1e6, 1e9};
    margins all = {.unit = unit, .count = unit == MARGIN_NONE ? 0 : 6};
    memcpy(all.list, unit == MARGIN_ULPS ? ulps : sizes, sizeof sizes);
    return all;
}

bool margins_add(margins *all, double size)
{
    int at = all->count;
    for (int i = 0; i < all->count; i++) {
        if (all->list[i] == size)
            return true;
    }
    if (at == MARGINS_MOST)
        return false;
    for (; at > 0 && all->list[at - 1] > size; at--)
        all->list[at] = all->list[at - 1];
    all->list[at] = size;
    all->count++;
    return true;
}

unsigned faults_by_entry(const entry *by, const example *one)
{
    unsigned found = faults_of(&one->question, &one->truth, &one->given);
    unsigned decision = found & (FAULT_BIT(FAULTS_WITH_MARGIN) - 1);
    fault which = margin_fault(decision);
    if (!by->declared || decision == 0 || one->truth.status == SURE_INVALID)
        return found;
    event of = event_of(&one->question, &one->truth, which, &one->given);
    return entry_allows(by, of, &one->question, which, &one->given) ? found & ~decision : found;
}

static bool is_beyond(const example *one, fault which, const movement *unit, double times)
{
    const movement way = movement_times(unit, times);
    return margin_beyond(&one->question, which, &one->given, &way);
}

/* How many margins it is beyond: they come first. Mostly it is none, so the first is asked first.
 * The others are halved, since each question takes its time. */
static int count_beyond(const margins *told, const example *one, fault which, const movement *unit)
{
    int low = 1, high = told->count;
    if (high == 0 || !is_beyond(one, which, unit, told->list[0]))
        return 0;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (is_beyond(one, which, unit, told->list[middle]))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static void add_margin(refereed *sum, const margins *told, precision in, const example *one,
                       fault which)
{
    const movement unit = margin_way(&one->question, told->unit, in);
    double *most = &sum->most[which];
    int i = count_beyond(told, one, which, &unit);
    for (int k = 0; k < i; k++)
        sum->beyond[k]++;
    double least = i > 0 ? told->list[i - 1] : 0;
    double below = i < told->count ? told->list[i] : INFINITY;
    if (least == 0 || below <= *most)
        return;
    if (*most > least && !is_beyond(one, which, &unit, *most))
        return;
    double margin = margin_of(&one->question, which, &one->given, least, below, *most, &unit);
    if (margin <= *most)
        return;
    *most = margin;
    sum->widest[which] = *one;
}

void referee_take_t(const entry *by, example *one)
{
    one->given.has_normal &= !one->question.wall;
    bool both = fault_is_hit(&one->truth, &one->given);
    bool at_start = by->zero_inside && one->given.t == one->question.ray.t_min;
    if (both && at_start &&
        event_of(&one->question, &one->truth, FAULTS, &one->given) == EVENT_INSIDE)
        one->given.t = one->truth.t;
}

unsigned referee(refereed *sum, const margins *told, const entry *by, precision in,
                 const example *one)
{
    unsigned all = faults_of(&one->question, &one->truth, &one->given);
    unsigned with_margin = FAULT_BIT(FAULTS_WITH_MARGIN) - 1;
    if ((all & with_margin) == 0 || one->given.kind != REPLY_ANSWERED)
        return faults_by_entry(by, one);
    unsigned left = faults_by_entry(by, one);
    fault which = margin_fault(all);
    if (told->unit == MARGIN_NONE && (left & with_margin) != 0)
        return left;
    event of = event_of(&one->question, &one->truth, which, &one->given);
    if ((left & with_margin) == 0) {
        sum->allowed[of]++;
        return left;
    }
    sum->events[of]++;
    add_margin(sum, told, in, one, which);
    return left;
}

double refereed_most(const refereed *sum)
{
    double most = 0;
    for (int i = 0; i < FAULTS_WITH_MARGIN; i++)
        most = fmax(most, sum->most[i]);
    return most;
}
