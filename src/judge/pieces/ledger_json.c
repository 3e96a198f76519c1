/* SPDX-License-Identifier: MIT */
#include "ledger_json.h"

#include "../../support/json_file.h"

#include "../../numbers/bits.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Counts, which stand side by side. */

#define VERDICT_COUNTS (int)(offsetof(verdict, wrong_share) / sizeof(uint64_t))
#define REFEREED_COUNTS (int)(offsetof(refereed, most) / sizeof(uint64_t))

static bool add_counts(uint64_t *to, int count, const json_t *from)
{
    uint64_t more;
    for (int i = 0; i < count; i++) {
        if (!json_take_count(json_array_get(from, (size_t)i), &more))
            return false;
        to[i] += more;
    }
    return json_array_size(from) == (size_t)count;
}

/* Doubles, infinite ones too. */

static json_t *double_json(double x)
{
    return json_bits(bits_of(x));
}

static bool take_double(const json_t *from, double *x)
{
    uint64_t bits;
    bool taken = json_take_bits(from, &bits);
    *x = taken ? double_of(bits) : 0;
    return taken;
}

/* Examples. */

/* Members of an example beside its case: doubles, and others by their size. */
#define IS_DOUBLE 0
#define WHOLE(name)                                                                                \
    {                                                                                              \
        offsetof(example, name), sizeof(((example *)0)->name)                                      \
    }
#define DOUBLE(name)                                                                               \
    {                                                                                              \
        offsetof(example, name), IS_DOUBLE                                                         \
    }
static const struct {
    size_t at, size;
} members[] = {
    WHOLE(given.kind),      WHOLE(given.to),        WHOLE(given.status),    WHOLE(given.field),
    DOUBLE(given.t),        DOUBLE(given.t_leave),  WHOLE(given.part),      WHOLE(given.has_normal),
    DOUBLE(given.normal.x), DOUBLE(given.normal.y), DOUBLE(given.normal.z), WHOLE(given.touched),
    WHOLE(given.changed),   WHOLE(given.leaked),    WHOLE(given.ended),     WHOLE(truth.status),
    WHOLE(truth.field),     DOUBLE(truth.t),        WHOLE(truth.part),      DOUBLE(truth.normal.x),
    DOUBLE(truth.normal.y), DOUBLE(truth.normal.z), DOUBLE(truth.t_leave),  WHOLE(question.wall),
};
#define MEMBERS (sizeof members / sizeof *members)

static json_t *member_json(const example *of, size_t i)
{
    const char *at = (const char *)of + members[i].at;
    double real;
    int whole;
    if (members[i].size == IS_DOUBLE)
        return double_json(*(double *)memcpy(&real, at, sizeof real));
    if (members[i].size == sizeof(bool))
        return json_boolean(*at != 0);
    return json_integer(*(int *)memcpy(&whole, at, sizeof whole));
}

static bool take_int(const json_t *from, int *to)
{
    json_int_t number = json_integer_value(from);
    bool fits = json_is_integer(from) && number >= INT_MIN && number <= INT_MAX;
    *to = fits ? (int)number : 0;
    return fits;
}

static bool take_member(const json_t *from, example *of, size_t i)
{
    char *at = (char *)of + members[i].at;
    double real;
    int whole;
    if (members[i].size == IS_DOUBLE)
        return take_double(from, &real) && memcpy(at, &real, sizeof real);
    if (members[i].size == sizeof(bool))
        return json_is_boolean(from) && memcpy(at, &(bool){json_is_true(from)}, sizeof(bool));
    return take_int(from, &whole) && memcpy(at, &whole, sizeof whole);
}

static json_t *example_json(const example *of)
{
    char line[CASE_LINE_MAX];
    json_t *told = json_array();
    if (!of->found)
        return told;
    case_print(&of->question, line);
    json_array_append_new(told, json_integer((json_int_t)of->number));
    json_array_append_new(told, json_string(line));
    json_array_append_new(told, json_string(of->given.said));
    for (size_t i = 0; i < MEMBERS; i++)
        json_array_append_new(told, member_json(of, i));
    return told;
}

static bool take_example(const json_t *from, example *of)
{
    const char *line = json_string_value(json_array_get(from, 1));
    const char *said = json_string_value(json_array_get(from, 2));
    *of = (example){.found = json_array_size(from) > 0};
    if (!of->found)
        return json_is_array(from);
    bool taken = line && said && json_take_count(json_array_get(from, 0), &of->number) &&
                 case_read(line, &of->question) && json_array_size(from) == MEMBERS + 3;
    for (size_t i = 0; taken && i < MEMBERS; i++)
        taken = take_member(json_array_get(from, i + 3), of, i);
    if (taken)
        snprintf(of->given.said, sizeof of->given.said, "%s", said);
    return taken;
}

/* The larger one stays, of equals the first. */
static bool add_example(example *to, double to_size, const json_t *from, double from_size)
{
    example more;
    if (!take_example(from, &more))
        return false;
    bool larger = from_size > to_size || (from_size == to_size && more.number < to->number);
    if (more.found && (!to->found || larger))
        *to = more;
    return true;
}

/* Histograms: bins that are not empty. */

static json_t *histogram_json(const histogram *of)
{
    json_t *bins = json_array();
    for (int i = 0; i < HISTOGRAM_BINS; i++) {
        if (of->bins[i] > 0)
            json_array_append_new(bins, json_pack("[i, I]", i, (json_int_t)of->bins[i]));
    }
    return json_pack("[I, o, o]", (json_int_t)of->zeros, double_json(of->most), bins);
}

static bool add_histogram(histogram *to, const json_t *from)
{
    uint64_t zeros;
    double most;
    size_t i;
    const json_t *bin;
    if (!json_take_count(json_array_get(from, 0), &zeros) ||
        !take_double(json_array_get(from, 1), &most))
        return false;
    to->zeros += zeros;
    to->most = most > to->most ? most : to->most;
    json_array_foreach(json_array_get(from, 2), i, bin)
    {
        json_int_t which, count;
        if (json_unpack((json_t *)bin, "[I, I!]", &which, &count) != 0 || which < 0 ||
            which >= HISTOGRAM_BINS || count < 1)
            return false;
        histogram_add_bin(to, (int)which, (uint64_t)count);
    }
    return true;
}

/* A ledger. */

#define HISTOGRAMS 5

static histogram *histogram_of(tally *of, int i)
{
    histogram *const all[HISTOGRAMS] = {&of->t_ulps, &of->t_relative, &of->normal, &of->t_extents,
                                        &of->t_pixels};
    return all[i];
}

static json_t *examples_json(const example *of, int count)
{
    json_t *all = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(all, example_json(&of[i]));
    return all;
}

json_t *ledger_json(const ledger *of)
{
    const tally *counted = &of->counted;
    const verdict *sum = &counted->sum;
    const refereed *by = &of->looked_at;
    json_t *histograms = json_array(), *most = json_array();
    for (int i = 0; i < HISTOGRAMS; i++)
        json_array_append_new(histograms, histogram_json(histogram_of((tally *)counted, i)));
    for (int i = 0; i < FAULTS_WITH_MARGIN; i++)
        json_array_append_new(most, double_json(by->most[i]));
    return json_pack("{s:o, s:o, s:o, s:I, s:o, s:o, s:o, s:o, s:o, s:o}", "counts",
                     json_counts(&sum->cases, VERDICT_COUNTS), "t_classes",
                     json_counts(sum->t_classes, SIZE_CLASSES), "decisions",
                     json_counts(by->allowed, REFEREED_COUNTS), "normals_right",
                     (json_int_t)counted->normals_right, "histograms", histograms, "faulty",
                     examples_json(sum->faulty, FAULTS), "worst_t", example_json(&sum->worst_t),
                     "worst_normal", example_json(&sum->worst_normal), "most", most, "widest",
                     examples_json(by->widest, FAULTS_WITH_MARGIN));
}

/* Before the histograms, whose largest sizes are theirs. */
static bool add_worst(tally *to, const json_t *from)
{
    const json_t *all = json_object_get(from, "histograms");
    double t, normal;
    return take_double(json_array_get(json_array_get(all, 0), 1), &t) &&
           take_double(json_array_get(json_array_get(all, 2), 1), &normal) &&
           add_example(&to->sum.worst_t, to->t_ulps.most, json_object_get(from, "worst_t"), t) &&
           add_example(&to->sum.worst_normal, to->normal.most,
                       json_object_get(from, "worst_normal"), normal);
}

static bool add_faulty(verdict *to, const json_t *all)
{
    bool added = json_array_size(all) == FAULTS;
    for (int i = 0; added && i < FAULTS; i++)
        added = add_example(&to->faulty[i], 0, json_array_get(all, (size_t)i), 0);
    return added;
}

static bool add_refereed(refereed *to, const json_t *from)
{
    const json_t *sizes = json_object_get(from, "most"), *all = json_object_get(from, "widest");
    double most;
    for (int i = 0; i < FAULTS_WITH_MARGIN; i++) {
        if (!take_double(json_array_get(sizes, (size_t)i), &most) ||
            !add_example(&to->widest[i], to->most[i], json_array_get(all, (size_t)i), most))
            return false;
        to->most[i] = most > to->most[i] ? most : to->most[i];
    }
    return add_counts(to->allowed, REFEREED_COUNTS, json_object_get(from, "decisions"));
}

const char *ledger_add_json(ledger *to, const json_t *from)
{
    tally *counted = &to->counted;
    const json_t *histograms = json_object_get(from, "histograms");
    bool added =
        add_counts(&counted->sum.cases, VERDICT_COUNTS, json_object_get(from, "counts")) &&
        add_counts(counted->sum.t_classes, SIZE_CLASSES, json_object_get(from, "t_classes")) &&
        add_faulty(&counted->sum, json_object_get(from, "faulty")) && add_worst(counted, from) &&
        add_refereed(&to->looked_at, from);
    for (int i = 0; added && i < HISTOGRAMS; i++)
        added = add_histogram(histogram_of(counted, i), json_array_get(histograms, (size_t)i));
    uint64_t right = 0;
    added = added && json_take_count(json_object_get(from, "normals_right"), &right);
    counted->normals_right += right;
    return added ? NULL : "expected what was counted in a row";
}
