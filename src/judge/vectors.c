#include "vectors.h"

#include <inttypes.h>
#include <jansson.h>
#include <stdio.h>
#include <string.h>

#define RAY_NAMES "ox", "oy", "oz", "dx", "dy", "dz", "t_min", "t_max"

static const char *const names[SURE_SHAPES][CASE_NUMBERS_MAX] = {
    [SURE_SHAPE_PLANE] = {RAY_NAMES, "px", "py", "pz", "nx", "ny", "nz"},
    [SURE_SHAPE_DISC] = {RAY_NAMES, "cx", "cy", "cz", "nx", "ny", "nz", "r"},
    [SURE_SHAPE_SPHERE] = {RAY_NAMES, "cx", "cy", "cz", "r"},
    [SURE_SHAPE_CYLINDER] = {RAY_NAMES, "bx", "by", "bz", "tx", "ty", "tz", "r"},
    [SURE_SHAPE_CONE] = {RAY_NAMES, "bx", "by", "bz", "ax", "ay", "az", "r"},
};

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

void vectors_print_head(sure_shape shape, char line[VECTORS_LINE_MAX])
{
    json_t *numbers = json_array();
    for (int i = 0; i < case_numbers(shape); i++)
        json_array_append_new(numbers, json_string(names[shape][i]));
    print(json_pack("{s:i, s:s, s:o}", "surehit_vectors", VECTORS_VERSION, "shape",
                    sure_shape_name(shape), "case", numbers),
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

/* Reading. The bits are taken, and then the line has to be the one that is printed of them. */

static bool is_printed(const char *line, const char *printed)
{
    size_t length = strlen(printed);
    return strncmp(line, printed, length) == 0 &&
           (strcmp(line + length, "") == 0 || strcmp(line + length, "\n") == 0);
}

static bool take_bits(const json_t *text, double *number)
{
    const char *digits = json_string_value(text);
    uint64_t bits;
    if (!digits || sscanf(digits, "%16" SCNx64, &bits) != 1)
        return false;
    memcpy(number, &bits, sizeof bits);
    return true;
}

static bool take_array(const json_t *array, double *numbers, size_t count)
{
    bool taken = json_array_size(array) == count;
    for (size_t i = 0; taken && i < count; i++)
        taken = take_bits(json_array_get(array, i), &numbers[i]);
    return taken;
}

/* The member of [0, count) that has the name; -1 for none. */
static int take_name(const json_t *text, const char *name_of(int), int count)
{
    const char *name = json_string_value(text);
    for (int i = 0; name && i < count; i++) {
        if (strcmp(name, name_of(i)) == 0)
            return i;
    }
    return -1;
}

static const char *status_name(int status)
{
    return sure_status_name((sure_status)status);
}

static const char *part_name(int part)
{
    return sure_part_name((sure_part)part);
}

static const char *field_name(int field)
{
    return sure_field_name((sure_field)field);
}

static bool take_hit(const json_t *object, case_answer *answer)
{
    double normal[3];
    int part = take_name(json_object_get(object, "part"), part_name, SURE_PART_WALL + 1);
    answer->part = (sure_part)part;
    if (part < 0 || !take_bits(json_object_get(object, "t_bits"), &answer->t) ||
        !take_array(json_object_get(object, "normal_bits"), normal, 3))
        return false;
    answer->normal = (sure_vec3){normal[0], normal[1], normal[2]};
    return true;
}

static bool take_answer(const json_t *object, case_answer *answer)
{
    int status = take_name(json_object_get(object, "answer"), status_name, SURE_INVALID + 1);
    answer->status = (sure_status)status;
    if (status != SURE_INVALID)
        return status == SURE_MISS || (status == SURE_HIT && take_hit(object, answer));
    int field = take_name(json_object_get(object, "field"), field_name, SURE_FIELD_RADIUS + 1);
    answer->field = (sure_field)field;
    return field >= 0;
}

static bool take_case(const json_t *object, sure_shape shape, frozen_case *read)
{
    double numbers[CASE_NUMBERS_MAX];
    const char *source = json_string_value(json_object_get(object, "from"));
    if (!source || strlen(source) >= sizeof read->source ||
        !take_array(json_object_get(object, "case_bits"), numbers, (size_t)case_numbers(shape)))
        return false;
    strcpy(read->source, source);
    read->number = (uint64_t)json_integer_value(json_object_get(object, "number"));
    read->question = case_from_numbers(shape, numbers);
    return take_answer(object, &read->answer);
}

bool vectors_read_head(const char *line, sure_shape *shape)
{
    char printed[VECTORS_LINE_MAX];
    for (int i = 0; i < SURE_SHAPES; i++) {
        vectors_print_head((sure_shape)i, printed);
        if (is_printed(line, printed)) {
            *shape = (sure_shape)i;
            return true;
        }
    }
    return false;
}

bool vectors_read(sure_shape shape, const char *line, frozen_case *frozen)
{
    char printed[VECTORS_LINE_MAX];
    frozen_case read = {.number = 0};
    json_t *object = json_loads(line, 0, NULL);
    bool taken = take_case(object, shape, &read);
    json_decref(object);
    if (!taken)
        return false;
    vectors_print(&read, printed);
    if (!is_printed(line, printed))
        return false;
    *frozen = read;
    return true;
}
