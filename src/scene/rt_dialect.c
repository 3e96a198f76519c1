/* SPDX-License-Identifier: MIT */
/* Dialect 42 (docs/scene_format.md): what programs that read such scenes write into them. Its words
 * and lines for shapes are in their rows; here is how a line is told from another, and what stands
 * between and behind the fields that are known. */
#include "rt_reader.h"

#include <stdarg.h>

bool rt_may(rt_reader *r, const char *place, const char *warning, const char *error, ...)
{
    va_list arguments;
    rt_place at = rt_place_of(&r->notes, place);
    va_start(arguments, error);
    if (!r->lenient)
        rt_complain_by(&r->notes, RT_ERROR_BUT_IN_42, at, error, arguments);
    else if (warning)
        rt_complain(&r->notes, RT_LIBERTY, at, "%s", warning);
    va_end(arguments);
    return r->lenient;
}

/* Lines by what they look like. */

/* Numbers with commas between them start here, or should. */
static bool is_vector(const rt_reader *r, const char *at)
{
    rt_word run = rt_run_at(r, at);
    return run.start < run.end && (rt_starts_number(*at) || *at == ',') &&
           memchr(run.start, ',', (size_t)(run.end - run.start));
}

static bool is_number(const rt_reader *r, const char *at)
{
    return at < r->end && rt_starts_number(*at) && !is_vector(r, at);
}

/* Behind the field that stands at r->at: a vector goes on behind a comma and blanks. */
static void pass_field(rt_reader *r)
{
    do {
        rt_skip_blanks(r);
        r->at = rt_run_at(r, r->at).end;
    } while (r->at[-1] == ',' && rt_more_fields(r));
}

/* Are there as many numbers and vectors, in their order, and a colour or a word behind them? */
static bool fits(rt_reader *r, const rt_field *fields)
{
    const char *start = r->at;
    bool all = true;
    for (; all && fields->name; fields++) {
        all = rt_more_fields(r) &&
              (fields->kind == RT_NUMBER ? is_number(r, r->at) : is_vector(r, r->at));
        if (all)
            pass_field(r);
    }
    all = all && rt_more_fields(r);
    r->at = start;
    return all;
}

static bool has_word(const char *const *words, rt_word w)
{
    while (*words && !rt_is_word_in_any_case(w, *words))
        words++;
    return *words;
}

const rt_form *rt_form_of(rt_reader *r, rt_word identifier, sure_shape shape)
{
    const rt_shape *row = rt_shapes[shape];
    for (const rt_form *form = row->forms; form->words[0]; form++) {
        if (!has_word(form->words, identifier))
            continue;
        if (has_word(row->words, identifier) && fits(r, row->fields))
            return NULL;
        if (fits(r, form->fields))
            return form;
    }
    return NULL;
}

bool rt_form_word(rt_word w, sure_shape *shape)
{
    for (int i = 0; i < SURE_SHAPES; i++) {
        for (const rt_form *form = rt_shapes[i]->forms; form->words[0]; form++) {
            *shape = (sure_shape)i;
            if (has_word(form->words, w))
                return true;
        }
    }
    return false;
}

/* Between and behind fields. */

void rt_leave_out(rt_reader *r, const char *warning)
{
    if (r->last_left_out != r->notes.line_number)
        rt_complain(&r->notes, RT_LIBERTY, rt_place_of(&r->notes, r->at), "%s", warning);
    r->last_left_out = r->notes.line_number;
    r->at = rt_run_at(r, r->at).end;
}

void rt_leave_out_name(rt_reader *r)
{
    rt_skip_blanks(r);
    rt_word run = rt_run_at(r, r->at);
    bool has_comma = memchr(run.start, ',', (size_t)(run.end - run.start));
    if (run.start < run.end && !has_comma && !rt_starts_number(*run.start))
        rt_leave_out(r, "a name before the position is left out");
}

bool rt_read_color(rt_reader *r, const rt_field *f, void *of)
{
    bool is_missing = !rt_more_fields(r), passed = false;
    if (!r->lenient || is_missing) {
        r->helps = !is_missing && !is_vector(r, r->at);
        bool read = rt_read_field(r, f, of);
        r->helps = false;
        return read;
    }
    const char *start = r->at;
    while (rt_more_fields(r) && !is_vector(r, r->at)) {
        r->at = rt_run_at(r, r->at).end;
        passed = true;
    }
    if (rt_more_fields(r)) {
        if (passed)
            rt_complain(&r->notes, RT_LIBERTY, rt_place_of(&r->notes, start),
                        "what stands before the colour is left out");
        return rt_read_field(r, f, of);
    }
    r->at = rt_run_at(r, start).end;
    rt_complain(&r->notes, RT_LIBERTY, rt_place_of(&r->notes, start),
                "no colour but a name or number: of an object grey, of light white is taken");
    return true;
}

size_t rt_errors(const rt_reader *r)
{
    return r->notes.counts[RT_ERROR] + r->notes.counts[RT_ERROR_BUT_IN_42];
}

bool rt_try_field(rt_reader *r, const rt_field *f, void *of)
{
    rt_reader before = *r;
    size_t errors = rt_errors(r);
    if (rt_read_field(r, f, of) && rt_errors(r) == errors)
        return true;
    *r = before;
    return false;
}
