/* SPDX-License-Identifier: MIT */
#include "rt_reader.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Words: what stands between blanks, commas, comments and line ends. */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

bool rt_starts_number(char c)
{
    return is_digit(c) || strchr("+-.", c);
}

/* The end of the line, or a comment, which is as good. */
static bool ends_line(const rt_reader *r, const char *at)
{
    return at == r->end || *at == '#' || (*at == '/' && at + 1 < r->end && at[1] == '/');
}

static bool ends_word(const rt_reader *r, const char *at)
{
    return ends_line(r, at) || rt_is_blank(*at) || *at == ',';
}

bool rt_more_fields(rt_reader *r)
{
    rt_skip_blanks(r);
    return !ends_line(r, r->at);
}

rt_word rt_word_at(const rt_reader *r, const char *start)
{
    rt_word w = {start, start};
    while (!ends_word(r, w.end))
        w.end++;
    return w;
}

rt_word rt_run_at(const rt_reader *r, const char *start)
{
    rt_word w = {start, start};
    while (!ends_line(r, w.end) && !rt_is_blank(*w.end))
        w.end++;
    return w;
}

/* Numbers: what one division can't round is left to strtod. */

/* Most numbers in scenes have so few digits that digits and power of ten are exact doubles; then
 * one division rounds correctly. False where this is not so, or not a number at all. */
static bool short_decimal(const rt_reader *r, const char *at, const char **behind, double *value)
{
    static const double tens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                  1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
    bool negative = at < r->end && *at == '-';
    if (at < r->end && (*at == '-' || *at == '+'))
        at++;
    uint64_t digits = 0;
    const char *start = at, *point = NULL;
    for (; at < r->end && (is_digit(*at) || (*at == '.' && !point)); at++) {
        if (*at == '.')
            point = at;
        else
            digits = 10 * digits + (uint64_t)(*at - '0');
    }
    ptrdiff_t decimals = point ? at - point - 1 : 0, count = at - start - (point != NULL);
    if (count == 0 || count > 19 || digits > UINT64_C(1) << 53 || !ends_word(r, at))
        return false;
    double magnitude = (double)digits / tens[decimals];
    *value = negative ? -magnitude : magnitude;
    *behind = at;
    return true;
}

/* Decimal or hexadecimal, correctly rounded; NaN for what is no number, as strtod's words for
 * infinity and NaN. The text need not end in NUL, strtod's does. */
static double convert(const rt_reader *r, rt_word w)
{
    char text[RT_LONGEST_LINE + 1], *end;
    size_t length = (size_t)(w.end - w.start);
    memcpy(text, w.start, length);
    text[length] = '\0';
    double value = strtod_l(text, &end, r->c_locale);
    bool plain = strspn(text, "+-.0123456789abcdefABCDEFxXpP") == length;
    return plain && *end == '\0' ? value : NAN;
}

/* Takes the word at r->at; false, after an error, where there is none: the line ends or there is a
 * comma. */
static bool take_word(rt_reader *r, const rt_field *f, rt_word *w)
{
    *w = rt_word_at(r, r->at);
    r->at = w->end;
    if (w->start < w->end)
        return true;
    rt_fault(r, r->at, "%s; expected the %s, %s",
             ends_line(r, r->at)   ? "the line ends here"
             : rt_is_blank(*r->at) ? "a blank"
                                   : "a comma without a number before it",
             f->name, f->expected);
    return false;
}

static bool out_of_range(const rt_field *f, double value)
{
    return value < f->low || value > f->high || (f->open && (value == f->low || value == f->high));
}

/* Is it 0 by rounding only? */
static bool underflows(rt_word w, double value)
{
    if (value != 0)
        return false;
    while (w.start < w.end && strchr("+-.0xX", *w.start))
        w.start++;
    return w.start < w.end && (*w.start | 32) != 'e' && (*w.start | 32) != 'p';
}

/* In dialect 42 what is just not inside. */
static bool may_be_inside(rt_reader *r, const rt_field *f, const char *start, double *value)
{
    rt_word w = rt_word_at(r, start);
    bool is_end = *value == f->low || *value == f->high;
    if (f->inside == 0 || !is_end || underflows(w, *value))
        return false;
    *value += *value == f->low ? f->inside : -f->inside;
    rt_may(r, start, "a field of view of 0 or 180 degrees is taken for 1 or 179",
           "%s %s is out of range; expected %s", f->name, rt_quote(w).text, f->expected);
    return true;
}

static void check_range(rt_reader *r, const rt_field *f, const char *start, double *number)
{
    double value = *number;
    if (!out_of_range(f, value) || may_be_inside(r, f, start, number))
        return;
    rt_word w = rt_word_at(r, start);
    rt_fault(r, start, "%s %s %s; expected %s", f->name, rt_quote(w).text,
             underflows(w, value) ? "rounds to 0" : "is out of range", f->expected);
}

/* A field of whole numbers takes digits with an optional sign only. */
static bool is_whole(const rt_field *f)
{
    return f->kind == RT_WHOLE || f->kind == RT_COLOR;
}

static bool has_digits_only(rt_word w)
{
    w.start += *w.start == '+' || *w.start == '-';
    const char *at = w.start;
    while (at < w.end && is_digit(*at))
        at++;
    return at > w.start && at == w.end;
}

/* Reads the number at r->at. False, after an error, when the rest of the line makes no sense. */
static bool read_number(rt_reader *r, const rt_field *f, double *value)
{
    const bool whole = is_whole(f);
    rt_word w = {r->at, r->at};
    bool known = short_decimal(r, r->at, &w.end, value);
    if (known && !whole) {
        r->at = w.end;
        return true;
    }
    if (!take_word(r, f, &w))
        return false;
    bool digits = !whole || has_digits_only(w);
    if (!known)
        *value = convert(r, w);
    bool decimal = !digits && f->kind == RT_COLOR && isfinite(*value);
    if (!digits && !(decimal && r->lenient))
        *value = NAN;
    r->decimals |= decimal;
    r->underflow |= underflows(w, *value);
    if (isnan(*value))
        rt_complain(&r->notes, decimal || r->helps ? RT_ERROR_BUT_IN_42 : RT_ERROR,
                    rt_place_of(&r->notes, w.start), "%s is not a %snumber; expected the %s, %s",
                    rt_quote(w).text, whole ? "whole " : "", f->name, f->expected);
    if (whole) {
        *value += 0; /* -0 becomes 0 */
        check_range(r, f, w.start, value);
    } else if (isinf(*value)) {
        rt_fault(r, w.start, "%s is beyond the largest double, 1.8e308; expected the %s, %s",
                 rt_quote(w).text, f->name, f->expected);
        *value = NAN;
    }
    return true;
}

/* Fields: numbers with their range, and three of them. */

static bool read_value(rt_reader *r, const rt_field *f, void *value)
{
    double number;
    const char *start = r->at;
    if (!read_number(r, f, &number))
        return false;
    if (r->at < r->end && *r->at == ',') {
        rt_fault(r, r->at, "a comma after the %s; expected a blank", f->name);
        return false;
    }
    if (is_whole(f)) {
        *(int *)value = isnan(number) || out_of_range(f, number) ? 0 : (int)number;
    } else {
        check_range(r, f, start, &number);
        *(double *)value = number;
    }
    return true;
}

/* Of 1 or of 255: what has decimals and nothing above 1 is of 1. */
static void scale_color(rt_reader *r, const char *start, sure_vec3 *color)
{
    bool of_1 = r->decimals && color->x <= 1 && color->y <= 1 && color->z <= 1;
    double most = of_1 ? 1 : 255;
    if (r->decimals && r->lenient)
        rt_may(r, start,
               of_1 ? "a colour with decimals up to 1 is taken as parts of 1"
                    : "a colour with decimals is taken as parts of 255",
               "%s", "");
    *color = (sure_vec3){color->x / most, color->y / most, color->z / most};
}

/* Three numbers with a comma between them, and perhaps blanks behind the comma. */
static bool read_triple(rt_reader *r, const rt_field *f, sure_vec3 *triple)
{
    const char *start = r->at;
    r->decimals = r->underflow = false;
    for (int i = 0; i < 3; i++) {
        double *part = (double *)(void *)triple + i;
        if (!read_number(r, f, part))
            return false;
        if (i == 2)
            break;
        bool comma = r->at < r->end && *r->at == ',';
        r->at += comma;
        rt_skip_blanks(r);
        if (comma)
            continue;
        if (r->at < r->end && *r->at == ',')
            rt_fault(r, r->at, "a blank before a comma; expected it right behind the number");
        else if (!isnan(*part)) /* which is told already */
            rt_fault(r, start, "%s of %s; expected three parts, %s", f->name,
                     i == 0 ? "one part" : "two parts", f->expected);
        return false;
    }
    if (r->at < r->end && *r->at == ',') {
        rt_fault(r, r->at, "a comma after three parts; expected the %s, %s", f->name, f->expected);
        return false;
    }
    if (f->kind == RT_COLOR)
        scale_color(r, start, triple);
    if (f->kind == RT_DIRECTION && triple->x == 0 && triple->y == 0 && triple->z == 0 &&
        rt_may(r, start,
               f->usual.y == 1 ? "a normal or axis of zeros is taken for 0,1,0"
                               : "a direction of zeros is taken for 0,0,1",
               "%s %s zero; expected %s", f->name, r->underflow ? "rounds to" : "is", f->expected))
        *triple = f->usual;
    return true;
}

bool rt_read_field(rt_reader *r, const rt_field *f, void *of)
{
    void *value = (char *)of + f->at;
    return f->kind == RT_NUMBER || f->kind == RT_WHOLE ? read_value(r, f, value)
                                                       : read_triple(r, f, value);
}

bool rt_read_fields(rt_reader *r, const rt_field *fields, void *of)
{
    for (; fields->name; fields++) {
        rt_skip_blanks(r);
        if (!rt_read_field(r, fields, of))
            return false;
    }
    return true;
}

void rt_expect_end(rt_reader *r)
{
    while (r->lenient && rt_more_fields(r))
        rt_leave_out(r, "what stands behind the last field that is known is left out");
    if (rt_more_fields(r))
        rt_may(r, r->at, NULL, "%s after the last field; expected the end of the line",
               rt_quote(rt_run_at(r, r->at)).text);
    else if (r->end - r->at >= 2 && r->at[0] == '#' && r->at[1] == '!')
        rt_fault(r, r->at, "an option behind fields; expected '#!' on a line of its own");
}
