/* SPDX-License-Identifier: MIT */
#include "vectors.h"

#include "referee/entry.h"
#include "referee/margin.h"

#include "../numbers/digits/hex_float.h"
#include "../cases/lines.h"
#include "../support/atomic_file.h"
#include "../support/complain.h"
#include "../support/fnv.h"
#include "../support/folder.h"
#include "../support/json_file.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME "surehit vectors"
#define SOURCE_MOST 63

frozen_case vectors_case_of(const char *source, uint64_t number, const sure_case *question)
{
    return (frozen_case){source, number, *question, case_answer_of(question, SURE_TIER_EXACT)};
}

/* Numbers. */

static json_t *bits_json(double number)
{
    return json_bits(bits_of(number));
}

/* A NaN has no sign here. */
static json_t *hex_json(double number)
{
    return json_string(isnan(number) ? "nan" : HEX(number));
}

static json_t *array_of(const double *numbers, int count, json_t *one(double))
{
    json_t *array = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(array, one(numbers[i]));
    return array;
}

/* JSON. */

static void add_names(json_t *names, const char *vector)
{
    for (const char *axis = "xyz"; *axis != '\0'; axis++)
        json_array_append_new(names, json_sprintf("%c%c", *vector, *axis));
}

/* A field is called by its first letter. */
static json_t *names_of(sure_shape shape)
{
    const sure_shape_info *info = sure_shape_info_of(shape);
    json_t *names = json_array();
    add_names(names, "o");
    add_names(names, "d");
    json_array_append_new(names, json_string("t_min"));
    json_array_append_new(names, json_string("t_max"));
    for (int i = 0; i < info->field_count; i++) {
        const char *name = sure_field_name(info->fields[i].name);
        if (info->fields[i].kind == SURE_KIND_RADIUS)
            json_array_append_new(names, json_stringn(name, 1));
        else
            add_names(names, name);
    }
    return names;
}

static void set_hit(json_t *object, const case_answer *answer)
{
    const double normal[] = {answer->normal.x, answer->normal.y, answer->normal.z};
    json_object_update_new(object, json_pack("{s:s, s:o, s:o, s:o, s:o}", "part",
                                             sure_part_name(answer->part), "t", hex_json(answer->t),
                                             "t_bits", bits_json(answer->t), "normal",
                                             array_of(normal, 3, hex_json), "normal_bits",
                                             array_of(normal, 3, bits_json)));
}

/* What else is right. */

/* The first of these sizes of the object by which its faces may move so that the fault is none, as
 * FAULTS that t is of another end; or 0. */
static double tolerance_of(const sure_case *question, fault which, sure_part named)
{
    static const double sizes[] = {1e-12, 1e-9, 1e-6, 1e-3};
    const reply given = {.status = SURE_HIT, .part = (int)named};
    double unit = margin_length(question, MARGIN_SIZE, PRECISION_DOUBLE);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        double by = sizes[i] * unit;
        if (which == FAULTS ? margin_of_end(question, by)
                            : !margin_beyond_length(question, which, &given, by))
            return sizes[i];
    }
    return 0;
}

/* Where it is less than what allows all. Returns the least so far. */
static double add_margin(json_t *margins, const char *name, double size, double least)
{
    if (size == 0 || (least > 0 && size >= least))
        return least;
    json_object_set_new(margins, name, json_real(size));
    return size;
}

static json_t *margins_of_hit(const sure_case *question, sure_part right)
{
    const sure_shape_info *info = sure_shape_info_of(question->object.shape);
    json_t *margins = json_object();
    double least = add_margin(margins, "miss", tolerance_of(question, FAULT_FALSE_MISS, right), 0);
    least = add_margin(margins, "t", tolerance_of(question, FAULTS, right), least);
    for (int i = 0; i < info->part_count; i++) {
        sure_part other = info->parts[i];
        if (other != right)
            add_margin(margins, sure_part_name(other),
                       tolerance_of(question, FAULT_WRONG_PART, other), least);
    }
    return margins;
}

static json_t *margins_of_miss(const sure_case *question)
{
    json_t *margins = json_object();
    add_margin(margins, "hit", tolerance_of(question, FAULT_FALSE_HIT, SURE_PART_SURFACE), 0);
    return margins;
}

static void set_allowed(json_t *object, const sure_case *question, const case_answer *answer)
{
    json_t *margins = answer->status == SURE_HIT ? margins_of_hit(question, answer->part)
                                                 : margins_of_miss(question);
    event which = event_of(question, answer, FAULTS, NULL);
    if (which != EVENT_CLEAR)
        json_object_set_new(object, "event", json_string(event_name(which)));
    if (json_object_size(margins) > 0)
        json_object_set(object, "margin", margins);
    json_decref(margins);
}

json_t *vectors_json(const frozen_case *frozen)
{
    const case_answer *answer = &frozen->answer;
    int count = case_numbers(frozen->question.object.shape);
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(&frozen->question, numbers);
    json_t *object =
        json_pack("{s:s%, s:I, s:o, s:o, s:s}", "from", frozen->source,
                  strnlen(frozen->source, SOURCE_MOST), "number", (json_int_t)frozen->number,
                  "case", array_of(numbers, count, hex_json), "case_bits",
                  array_of(numbers, count, bits_json), "answer", sure_status_name(answer->status));
    if (answer->status == SURE_INVALID)
        json_object_set_new(object, "field", json_string(sure_field_name(answer->field)));
    if (answer->status == SURE_HIT)
        set_hit(object, answer);
    if (answer->status != SURE_INVALID)
        set_allowed(object, &frozen->question, answer);
    return object;
}

/* Writing. */

typedef struct {
    const vectors_plan *plan;
    sure_shape shape;
    entry by;
    FILE *out;
    int lines;
} writing;

/* Takes `object` over. */
static void write_line(FILE *out, json_t *object)
{
    json_dumpf(object, out, JSON_COMPACT | VECTORS_PRECISION);
    fputc('\n', out);
    json_decref(object);
}

static void write_case(writing *to, const char *source, uint64_t number, const sure_case *question)
{
    sure_case made;
    if (!entry_case(&to->by, question, to->by.in_float ? PRECISION_FLOAT : PRECISION_DOUBLE, &made))
        return;
    frozen_case frozen = vectors_case_of(source, number, &made);
    write_line(to->out, vectors_json(&frozen));
    to->lines++;
}

static void write_regime(writing *to, regime which)
{
    for (uint64_t i = 0; i < to->plan->count; i++) {
        sure_case question = regime_case(to->shape, which, VECTORS_SEED, i);
        write_case(to, regime_name(which), i, &question);
        progress_step(to->plan->bar, 1);
    }
}

/* Only what a JSON string may hold as it is. */
static const char *source_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    for (const char *at = name; *at != '\0'; at++) {
        if (*at < ' ' || *at > '~' || *at == '"' || *at == '\\')
            return "cases";
    }
    return name;
}

/* What is before " -> ". Is there a case in it? */
static bool cut_case(char *line)
{
    char *answer = strstr(line, " -> ");
    if (answer)
        *answer = '\0';
    return line[0] != '#' && line[0] != '\0';
}

/* The file's cases of that shape. */
static bool write_file(writing *to, FILE *in, const char *path)
{
    case_lines lines = {.in = in};
    while (case_lines_next(&lines)) {
        sure_case question;
        if (lines.whole && !cut_case(lines.text))
            continue;
        if (!lines.whole || !case_read(lines.text, &question))
            return complain(stderr, NAME, "%s: line %ju is no case", path, lines.number);
        if (question.object.shape == to->shape)
            write_case(to, source_of(path), lines.number, &question);
    }
    const char *wrong = case_lines_fault(&lines);
    return !wrong || complain(stderr, NAME, "%s: cannot be read after line %ju: %s", path,
                              lines.number, wrong);
}

static bool write_cases(writing *to)
{
    const vectors_plan *plan = to->plan;
    bool done = true;
    for (int which = 0; which < REGIMES; which++) {
        if (regime_rows_have(&plan->rows, (int)to->shape, which))
            write_regime(to, (regime)which);
    }
    for (int i = 0; done && i < plan->file_count; i++) {
        FILE *in = fopen(plan->files[i], "r");
        done = in ? write_file(to, in, plan->files[i])
                  : complain(stderr, NAME, "%s: %s", plan->files[i], strerror(errno));
        if (in)
            fclose(in);
    }
    return done;
}

/* The head says what its lines are. */
static void write_head(FILE *out, const writing *of, const char *text, size_t length)
{
    write_line(out,
               json_pack("{s:i, s:s, s:s, s:s, s:o, s:i, s:o}", "surehit_vectors", VECTORS_VERSION,
                         "set", VECTORS_SET, "shape", sure_shape_name(of->shape), "entry",
                         of->plan->entry, "case", names_of(of->shape), "lines", of->lines, "digest",
                         json_bits(fnv_add(FNV_START, text, length))));
}

/* 0, or as vectors_write. */
static int write_path(const char *path, const writing *of, const char *text, size_t length)
{
    atomic_file file;
    if (!atomic_file_open(path, stderr, &file))
        return 1;
    write_head(file.stream, of, text, length);
    fwrite(text, 1, length, file.stream);
    return atomic_file_finish(&file, stderr) ? 0 : 1;
}

int vectors_write(const vectors_plan *plan, sure_shape shape)
{
    const char *name = sure_shape_name(shape);
    char *path = folder_path(plan->folder, name, strlen(name), ".jsonl"), *text = NULL;
    size_t size = 0;
    writing to = {.plan = plan, .shape = shape, .out = open_memstream(&text, &size)};
    (void)entry_read(plan->entry, &to.by);
    bool done = path && to.out && write_cases(&to);
    bool kept = to.out && fclose(to.out) == 0 && path;
    int status = !kept ? 1 : done ? write_path(path, &to, text, size) : 2;
    if (!kept)
        complain(stderr, NAME, "no memory");
    free(text);
    free(path);
    return status;
}
