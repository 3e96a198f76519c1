#include "vectors.h"

#include "../numbers/bits.h"
#include "../support/atomic_file.h"
#include "../support/complain.h"
#include "../support/json_file.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#define NAME "surehit vectors"
#define PATH_MOST 4096
#define SOURCE_MOST 63

frozen_case vectors_case_of(const char *source, uint64_t number, const sure_case *question)
{
    return (frozen_case){source, number, *question, case_answer_of(question, SURE_TIER_EXACT)};
}

frozen_case vectors_case(sure_shape shape, regime which, uint64_t number)
{
    sure_case question = regime_case(shape, which, VECTORS_VERSION, number);
    return vectors_case_of(regime_name(which), number, &question);
}

/* Numbers. */

static json_t *bits_json(double number)
{
    return json_bits(bits_of(number));
}

/* As %a, of which C leaves something open that is settled here: one digit before the point, 0 for a
 * subnormal, and no zeros at the end. */
static json_t *hex_json(double number)
{
    uint64_t bits = bits_of(number), fraction = bits & BITS_FRACTION;
    int exponent = (int)(bits >> 52 & 2047), digits = 13;
    const char *sign = bits >> 63 ? "-" : "";
    if (exponent == 2047)
        return fraction != 0 ? json_string("nan") : json_sprintf("%sinf", sign);
    int power = exponent == 0 ? fraction == 0 ? 0 : -1022 : exponent - 1023;
    if (fraction == 0)
        return json_sprintf("%s0x%dp%+d", sign, exponent != 0, power);
    for (; (fraction & 15) == 0; fraction >>= 4)
        digits--;
    return json_sprintf("%s0x%d.%0*" PRIx64 "p%+d", sign, exponent != 0, digits, fraction, power);
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
    return object;
}

/* Writing. */

/* Takes `object` over. */
static void write_line(FILE *out, json_t *object)
{
    json_dumpf(object, out, JSON_COMPACT);
    fputc('\n', out);
    json_decref(object);
}

static void write_regimes(FILE *out, sure_shape shape)
{
    for (int which = 0; which < REGIMES; which++) {
        for (uint64_t i = 0; regime_applies(shape, (regime)which) && i < VECTORS_PER_REGIME; i++) {
            frozen_case frozen = vectors_case(shape, (regime)which, i);
            write_line(out, vectors_json(&frozen));
        }
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
    return line[0] != '#' && line[0] != '\n' && line[0] != '\0';
}

/* The file's cases of that shape; whole lines. */
static bool write_file(FILE *out, sure_shape shape, FILE *in, const char *path)
{
    char line[2 * CASE_LINE_MAX];
    for (int number = 1; fgets(line, sizeof line, in); number++) {
        sure_case question;
        bool whole = strchr(line, '\n') || feof(in);
        if (whole && !cut_case(line))
            continue;
        if (!whole || !case_read(line, &question))
            return complain(stderr, NAME, "%s: line %d is no case", path, number);
        if (question.object.shape != shape)
            continue;
        frozen_case frozen = vectors_case_of(source_of(path), (uint64_t)number, &question);
        write_line(out, vectors_json(&frozen));
    }
    return !ferror(in) || complain(stderr, NAME, "%s: cannot be read", path);
}

static bool write_all(FILE *out, sure_shape shape, const char *const *files, int count)
{
    bool done = true;
    write_line(out, json_pack("{s:i, s:s, s:o}", "surehit_vectors", VECTORS_VERSION, "shape",
                              sure_shape_name(shape), "case", names_of(shape)));
    write_regimes(out, shape);
    for (int i = 0; done && i < count; i++) {
        FILE *in = fopen(files[i], "r");
        done = in ? write_file(out, shape, in, files[i])
                  : complain(stderr, NAME, "%s: %s", files[i], strerror(errno));
        if (in)
            fclose(in);
    }
    return done;
}

int vectors_write(sure_shape shape, const char *const *files, int count, const char *folder)
{
    char path[PATH_MOST];
    atomic_file file;
    int length = snprintf(path, sizeof path, "%s/%s.jsonl", folder, sure_shape_name(shape));
    if (length >= PATH_MOST) {
        complain(stderr, NAME, "too long: '%s'", folder);
        return 2;
    }
    if (!atomic_file_open(path, stderr, &file))
        return 1;
    if (write_all(file.stream, shape, files, count))
        return atomic_file_finish(&file, stderr) ? 0 : 1;
    atomic_file_discard(&file);
    return 2;
}
