#include "vectors.h"

#include <inttypes.h>
#include <jansson.h>
#include <stdio.h>
#include <string.h>

frozen_case vectors_case_of(const char *source, uint64_t number, const sure_case *question)
{
    frozen_case frozen = {.number = number, .question = *question};
    snprintf(frozen.source, sizeof frozen.source, "%s", source);
    frozen.answer = case_answer_of(question, SURE_TIER_EXACT);
    return frozen;
}

frozen_case vectors_case(sure_shape shape, regime which, uint64_t number)
{
    sure_case question = regime_case(shape, which, VECTORS_VERSION, number);
    return vectors_case_of(regime_name(which), number, &question);
}

/* Numbers. */

static uint64_t bits_of(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

static json_t *bits_json(double number)
{
    return json_sprintf("%016" PRIx64, bits_of(number));
}

/* As %a, of which C leaves something open that is settled here: one digit before the point, 0 for a
 * subnormal, and no zeros at the end. */
static json_t *hex_json(double number)
{
    uint64_t bits = bits_of(number), fraction = bits & ((UINT64_C(1) << 52) - 1);
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

/* Writing. */

/* Takes `object` over. */
static void print(json_t *object, char line[VECTORS_LINE_MAX])
{
    size_t length = json_dumpb(object, line, VECTORS_LINE_MAX - 1, JSON_COMPACT);
    line[length < VECTORS_LINE_MAX ? length : 0] = '\0';
    json_decref(object);
}

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

void vectors_print_head(sure_shape shape, char line[VECTORS_LINE_MAX])
{
    print(json_pack("{s:i, s:s, s:o}", "surehit_vectors", VECTORS_VERSION, "shape",
                    sure_shape_name(shape), "case", names_of(shape)),
          line);
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

void vectors_print(const frozen_case *frozen, char line[VECTORS_LINE_MAX])
{
    const case_answer *answer = &frozen->answer;
    int count = case_numbers(frozen->question.object.shape);
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(&frozen->question, numbers);
    json_t *object = json_pack(
        "{s:s, s:I, s:o, s:o, s:s}", "from", frozen->source, "number", (json_int_t)frozen->number,
        "case", array_of(numbers, count, hex_json), "case_bits",
        array_of(numbers, count, bits_json), "answer", sure_status_name(answer->status));
    if (answer->status == SURE_INVALID)
        json_object_set_new(object, "field", json_string(sure_field_name(answer->field)));
    if (answer->status == SURE_HIT)
        set_hit(object, answer);
    print(object, line);
}
