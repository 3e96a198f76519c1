/* SPDX-License-Identifier: MIT */
#include "ranges.h"

#include <stdlib.h>

bool ranges_add(index_ranges *all, index_range more)
{
    size_t kept = 0, at = all->count;
    index_range *of = realloc(all->of, (all->count + 1) * sizeof *of);
    if (!of)
        return false;
    for (; at > 0 && of[at - 1].first > more.first; at--)
        of[at] = of[at - 1];
    of[at] = more;
    for (size_t i = 0; i <= all->count; i++) {
        if (kept > 0 && of[kept - 1].end == of[i].first)
            of[kept - 1].end = of[i].end;
        else
            of[kept++] = of[i];
    }
    *all = (index_ranges){of, kept};
    return true;
}

bool ranges_overlap(const index_ranges *a, const index_ranges *b, index_range *both)
{
    for (size_t i = 0; i < a->count; i++) {
        for (size_t j = 0; j < b->count; j++) {
            const index_range *of_a = &a->of[i], *of_b = &b->of[j];
            both->first = of_a->first > of_b->first ? of_a->first : of_b->first;
            both->end = of_a->end < of_b->end ? of_a->end : of_b->end;
            if (both->first < both->end)
                return true;
        }
    }
    return false;
}

bool ranges_gap(const index_ranges *all, index_range wanted, index_range *gap)
{
    *gap = wanted;
    for (size_t i = 0; i < all->count; i++) {
        const index_range *there = &all->of[i];
        if (there->first <= gap->first && gap->first < there->end)
            gap->first = there->end;
        if (gap->first < there->first && there->first < gap->end)
            gap->end = there->first;
    }
    return gap->first < gap->end;
}

uint64_t ranges_total(const index_ranges *all)
{
    uint64_t total = 0;
    for (size_t i = 0; i < all->count; i++)
        total += all->of[i].end - all->of[i].first;
    return total;
}

json_t *ranges_json(const index_ranges *all)
{
    json_t *list = json_array();
    for (size_t i = 0; i < all->count; i++) {
        const index_range *range = &all->of[i];
        json_array_append_new(list, json_pack("[I, I]", (json_int_t)range->first,
                                              (json_int_t)(range->end - range->first)));
    }
    return list;
}

const char *ranges_take(const json_t *list, index_ranges *all)
{
    size_t i;
    json_t *item;
    json_array_foreach(list, i, item)
    {
        json_int_t first, number;
        if (json_unpack(item, "[I, I!]", &first, &number) != 0 || first < 0 || number < 1 ||
            first > (json_int_t)RANGES_MOST || number > (json_int_t)RANGES_MOST - first)
            return "expected ranges, of each the first number and how many";
        if (i > 0 && (uint64_t)first <= all->of[all->count - 1].end)
            return "ranges that don't lie behind those before";
        if (!ranges_add(all, (index_range){(uint64_t)first, (uint64_t)(first + number)}))
            return "no memory";
    }
    return all->count > 0 ? NULL : "no ranges at all";
}
