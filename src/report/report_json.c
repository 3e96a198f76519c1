#include "report.h"

#include "../support/json_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Made of page.html (meson.build). */
extern const char report_page[];

#define PLACE "@REPORT@" /* in the page: there the document goes */

const char *report_trouble(const report_candidate *who)
{
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        if (who->shapes[shape].trouble[0] != '\0')
            return who->shapes[shape].trouble;
    }
    return NULL;
}

/* null where it is not known, or infinite. */
static json_t *number(bool known, double x)
{
    return known && isfinite(x) ? json_real(x) : json_null();
}

static json_t *t_of(const verdict *sum)
{
    const error_summary *t = &sum->t_ulps;
    bool some = t->count > 0;
    return json_pack("{s:I, s:I, s:o, s:o, s:o, s:o}", "hits", (json_int_t)t->count,
                     "correctly_rounded", (json_int_t)t->right, "median", number(some, t->median),
                     "99", number(some, t->q99), "most", number(some, t->most), "by_powers_of_two",
                     json_counts(sum->t_classes, SIZE_CLASSES));
}

static json_t *row_of(const report_row *row, sure_shape shape, regime which)
{
    const verdict *sum = &row->sum;
    return json_pack("{s:s, s:s, s:I, s:I, s:I, s:I, s:I, s:o, s:o}", "shape",
                     sure_shape_name(shape), "regime", regime_name(which), "cases",
                     (json_int_t)report_row_cases(row), "valid", (json_int_t)sum->valid, "wrong",
                     (json_int_t)sum->wrong, "breaches", (json_int_t)verdict_breaches(sum),
                     "unasked", (json_int_t)sum->unasked, "nanoseconds",
                     number(row->nanoseconds > 0, row->nanoseconds), "t_ulps", t_of(sum));
}

/* In the order of shapes and regimes; those that were asked. */
static json_t *rows_of(const report_candidate *who)
{
    json_t *list = json_array();
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        for (int which = 0; which < REGIMES; which++) {
            const report_row *row = &who->shapes[shape].rows[which];
            if (report_row_cases(row) > 0)
                json_array_append_new(list, row_of(row, (sure_shape)shape, (regime)which));
        }
    }
    return list;
}

static json_t *candidate_of(const report_candidate *who)
{
    static const char *const truths[] = {"exact", "reference", "like"};
    bool in_float = false, with_normals = false;
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        in_float |= who->shapes[shape].in_float;
        with_normals |= who->shapes[shape].with_normals;
    }
    return json_pack("{s:s, s:s?, s:s?, s:s, s:b, s:b, s:s?, s:o}", "name", who->name, "library",
                     who->library, "tier", who->library ? NULL : sure_tier_name(who->tier), "truth",
                     truths[who->truth], "in_float", in_float, "with_normals", with_normals,
                     "trouble", report_trouble(who), "rows", rows_of(who));
}

static json_t *shape_names(void)
{
    json_t *list = json_array();
    for (int shape = 0; shape < SURE_SHAPES; shape++)
        json_array_append_new(list, json_string(sure_shape_name((sure_shape)shape)));
    return list;
}

static json_t *regimes_of(const report_plan *plan)
{
    json_t *list = json_array();
    for (int which = 0; which < REGIMES; which++)
        json_array_append_new(list,
                              json_pack("{s:s, s:I}", "name", regime_name((regime)which), "cases",
                                        (json_int_t)report_cases(plan, (regime)which)));
    return list;
}

json_t *report_json(const report_plan *plan, const report_candidate *list, int count)
{
    json_t *candidates = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(candidates, candidate_of(&list[i]));
    if (json_array_size(candidates) != (size_t)count) { /* or a name is no UTF-8 */
        json_decref(candidates);
        return NULL;
    }
    char seed[24]; /* a number of JSON may lose digits */
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)plan->seed);
    return json_pack("{s:i, s:s, s:I, s:i, s:o, s:o, s:o}", "surehit_report", 1, "seed", seed,
                     "count", (json_int_t)plan->count, "reference_cases", REPORT_REFERENCE_CASES,
                     "shapes", shape_names(), "regimes", regimes_of(plan), "candidates",
                     candidates);
}

/* A < that is escaped, since one in a string could end the page's script. */
bool report_print_page(FILE *out, const json_t *report)
{
    const char *place = strstr(report_page, PLACE);
    char *text = json_dumps(report, JSON_COMPACT | JSON_MEASURED);
    if (!text)
        return false;
    fwrite(report_page, 1, (size_t)(place - report_page), out);
    for (const char *at = text; *at != '\0'; at++) {
        if (*at == '<')
            fputs("\\u003c", out);
        else
            fputc(*at, out);
    }
    fputs(place + strlen(PLACE), out);
    free(text);
    return true;
}
