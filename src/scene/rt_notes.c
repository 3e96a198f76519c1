/* SPDX-License-Identifier: MIT */
#include "rt_notes.h"

#include "shapes/rt_shape.h"

#include "../support/printable.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* " (or cn, con, cone)" */
static char *put_further(char *out, const char *const *words)
{
    const char *before = " (or ";
    for (; *words; words++, before = ", ")
        out += sprintf(out, "%s%s", before, *words);
    return out + sprintf(out, "%s", *before == ',' ? ")" : "");
}

rt_quotation rt_identifiers(void)
{
    rt_quotation q;
    char *out = q.text + sprintf(q.text, "one of A, C, L, R, falloff");
    for (int shape = 0; shape < SURE_SHAPES; shape++) {
        const char *const *words = rt_shapes[shape]->words;
        if (words[0])
            out = put_further(out + sprintf(out, ", %s", words[0]), words + 1);
    }
    return q;
}

rt_quotation rt_quote(rt_word word)
{
    rt_quotation q;
    size_t length = (size_t)(word.end - word.start);
    size_t shown = length < RT_QUOTED_BYTES ? length : RT_QUOTED_BYTES;
    char *out = q.text;
    *out++ = '\'';
    for (size_t i = 0; i < shown; i++)
        out = printable_byte(out, (unsigned char)word.start[i], 0x7f);
    strcpy(out, shown < length ? "...'" : "'");
    return q;
}

char *rt_printable_name(const char *name)
{
    size_t size = 4 * strlen(name) + PRINTABLE_MOST + 1;
    char *copy = malloc(size);
    if (copy)
        printable_write(copy, size, name);
    return copy;
}

rt_place rt_place_of(const rt_notes *notes, const char *at)
{
    return (rt_place){notes->line_number, (size_t)(at - notes->line_start) + 1};
}

static rt_note *same_liberty(rt_notes *notes, const char *text)
{
    for (size_t i = 0; i < notes->note_count; i++) {
        rt_note *n = &notes->notes[i];
        if (n->verdict == RT_LIBERTY && strcmp(n->text, text) == 0)
            return n;
    }
    return NULL;
}

/* At least the first RT_ERRORS_SHOWN of each verdict are kept, so those of all errors are among
 * them whatever the pending ones turn out to be. */
void rt_complain_by(rt_notes *notes, rt_verdict verdict, rt_place at, const char *format,
                    va_list arguments)
{
    rt_note n = {.at = at, .verdict = verdict};
    bool is_liberty = verdict == RT_LIBERTY;
    if (!is_liberty && notes->counts[verdict]++ >= RT_ERRORS_SHOWN)
        return;
    vsnprintf(n.text, sizeof n.text, format, arguments);
    rt_note *same = is_liberty ? same_liberty(notes, n.text) : NULL;
    if (same)
        same->again++;
    else if (!is_liberty || notes->counts[verdict]++ < RT_ERRORS_SHOWN)
        notes->notes[notes->note_count++] = n;
}

void rt_complain(rt_notes *notes, rt_verdict verdict, rt_place at, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    rt_complain_by(notes, verdict, at, format, arguments);
    va_end(arguments);
}

static void print(const rt_notes *notes, const rt_note *n, bool is_error)
{
    fprintf(notes->messages, "%s:%zu:%zu: %s: ", notes->name, n->at.line, n->at.column,
            is_error ? "error" : "warning");
    if (n->verdict == RT_UNKNOWN_SURFACE && is_error)
        fprintf(notes->messages,
                "unknown surface %s; expected %s, or the option skip-unknown or dialect 42\n",
                n->text, rt_identifiers().text);
    else if (n->verdict == RT_UNKNOWN_SURFACE)
        fprintf(notes->messages, "unknown surface %s is left out\n", n->text);
    else if (n->verdict == RT_ERROR_BUT_IN_42)
        fprintf(notes->messages, "%s, or the option dialect 42\n", n->text);
    else if (n->verdict == RT_BRIGHT_LIGHT && !is_error)
        fprintf(notes->messages, "%s; 1 is taken\n", n->text);
    else if (n->again > 0)
        fprintf(notes->messages, "%s (%zu times)\n", n->text, n->again + 1);
    else
        fprintf(notes->messages, "%s\n", n->text);
}

/* How many are not shown, of those that are shown up to a number only. */
static void print_more(const rt_notes *notes, rt_verdict verdict, const char *one, const char *many)
{
    size_t count = notes->counts[verdict];
    if (count > RT_ERRORS_SHOWN)
        fprintf(notes->messages, "%s: warning: %zu more %s left out\n", notes->name,
                count - RT_ERRORS_SHOWN, count - RT_ERRORS_SHOWN == 1 ? one : many);
}

/* Is it one more bright light that is dimmed? */
static bool is_repeated(const rt_notes *notes, size_t i, const rt_verdict *is)
{
    bool found = false;
    for (size_t j = 0; j < i && is[RT_BRIGHT_LIGHT] == RT_WARNING; j++)
        found = found || notes->notes[j].verdict == RT_BRIGHT_LIGHT;
    return found && notes->notes[i].verdict == RT_BRIGHT_LIGHT;
}

size_t rt_report(const rt_notes *notes, const rt_options *options)
{
    /* What each verdict is now: itself where it is nothing. */
    const rt_verdict is[RT_VERDICTS] = {
        [RT_ERROR] = RT_ERROR,
        [RT_WARNING] = RT_WARNING,
        [RT_BRIGHT_LIGHT] = options->falloff != SURE_FALLOFF_NONE ? RT_BRIGHT_LIGHT
                            : options->dialect == RT_42           ? RT_WARNING
                                                                  : RT_ERROR,
        [RT_UNKNOWN_SURFACE] = options->skip_unknown ? RT_WARNING : RT_ERROR,
        [RT_ERROR_BUT_IN_42] = RT_ERROR,
        [RT_LIBERTY] = RT_WARNING,
    };
    size_t errors = 0, shown = 0;
    for (int v = 0; v < RT_VERDICTS; v++)
        errors += is[v] == RT_ERROR ? notes->counts[v] : 0;
    for (size_t i = 0; i < notes->note_count; i++) {
        const rt_note *n = &notes->notes[i];
        if (is_repeated(notes, i, is))
            continue;
        if (is[n->verdict] == RT_WARNING ||
            (is[n->verdict] == RT_ERROR && shown++ < RT_ERRORS_SHOWN))
            print(notes, n, is[n->verdict] == RT_ERROR);
    }
    if (options->skip_unknown)
        print_more(notes, RT_UNKNOWN_SURFACE, "unknown surface is", "unknown surfaces are");
    print_more(notes, RT_LIBERTY, "unknown kind is", "unknown kinds are");
    if (errors > RT_ERRORS_SHOWN)
        fprintf(notes->messages, "%s: %zu more error%s\n", notes->name, errors - RT_ERRORS_SHOWN,
                errors - RT_ERRORS_SHOWN == 1 ? "" : "s");
    return errors;
}
