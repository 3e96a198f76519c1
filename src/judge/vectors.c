#include "vectors.h"

#include <inttypes.h>
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

/* Writing. `at` is where the line goes on; what is returned, where it goes on then. */

static uint64_t bits_of(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

static char *put_text(char *at, const char *text)
{
    size_t length = strlen(text);
    memcpy(at, text, length + 1);
    return at + length;
}

static char *put_bits(char *at, double number)
{
    return at + sprintf(at, "\"%016" PRIx64 "\"", bits_of(number));
}

/* The digits of a fraction of 52 bits behind its point, without zeros at the end. */
static char *put_fraction(char *at, uint64_t fraction)
{
    if (fraction == 0)
        return at;
    int digits = 13;
    while ((fraction & 15) == 0) {
        fraction >>= 4;
        digits--;
    }
    return at + sprintf(at, ".%0*" PRIx64, digits, fraction);
}

/* What C leaves open in %a is settled: one digit before the point, 0 for a subnormal. */
static char *put_hex(char *at, double number)
{
    uint64_t bits = bits_of(number), fraction = bits & ((UINT64_C(1) << 52) - 1);
    int exponent = (int)(bits >> 52 & 2047);
    if (exponent == 2047 && fraction != 0)
        return put_text(at, "\"nan\"");
    at = put_text(at, bits >> 63 ? "\"-" : "\"");
    if (exponent == 2047)
        return put_text(at, "inf\"");
    at = put_text(at, exponent == 0 ? "0x0" : "0x1");
    at = put_fraction(at, fraction);
    int power = exponent == 0 ? fraction == 0 ? 0 : -1022 : exponent - 1023;
    return at + sprintf(at, "p%+d\"", power);
}

/* ,"key":[..] and ,"key_bits":[..] */
static char *put_numbers(char *at, const char *key, const double *numbers, int count)
{
    at += sprintf(at, ",\"%s\":[", key);
    for (int i = 0; i < count; i++)
        at = put_hex(put_text(at, i > 0 ? "," : ""), numbers[i]);
    at += sprintf(at, "],\"%s_bits\":[", key);
    for (int i = 0; i < count; i++)
        at = put_bits(put_text(at, i > 0 ? "," : ""), numbers[i]);
    return put_text(at, "]");
}

static char *put_answer(char *at, const case_answer *answer)
{
    at += sprintf(at, ",\"answer\":\"%s\"", sure_status_name(answer->status));
    if (answer->status == SURE_INVALID)
        at += sprintf(at, ",\"field\":\"%s\"", sure_field_name(answer->field));
    if (answer->status != SURE_HIT)
        return at;
    const double normal[] = {answer->normal.x, answer->normal.y, answer->normal.z};
    at += sprintf(at, ",\"part\":\"%s\",\"t\":", sure_part_name(answer->part));
    at = put_hex(at, answer->t);
    at = put_bits(put_text(at, ",\"t_bits\":"), answer->t);
    return put_numbers(at, "normal", normal, 3);
}

void vectors_print_head(sure_shape shape, char line[VECTORS_LINE_MAX])
{
    char *at = line + sprintf(line, "{\"surehit_vectors\":%d,\"shape\":\"%s\",\"case\":[",
                              VECTORS_VERSION, sure_shape_name(shape));
    for (int i = 0; i < case_numbers(shape); i++)
        at += sprintf(at, "%s\"%s\"", i > 0 ? "," : "", names[shape][i]);
    put_text(at, "]}");
}

void vectors_print(const frozen_case *frozen, char line[VECTORS_LINE_MAX])
{
    double numbers[CASE_NUMBERS_MAX];
    case_to_numbers(&frozen->question, numbers);
    char *at = line + sprintf(line, "{\"from\":\"%s\",\"number\":%" PRIu64, frozen->source,
                              frozen->number);
    at = put_numbers(at, "case", numbers, case_numbers(frozen->question.object.shape));
    put_text(put_answer(at, &frozen->answer), "}");
}

/* Reading. The bits are taken, and then the line has to be the one that is printed of them. */

static bool is_printed(const char *line, const char *printed)
{
    size_t length = strlen(printed);
    return strncmp(line, printed, length) == 0 &&
           (strcmp(line + length, "") == 0 || strcmp(line + length, "\n") == 0);
}

/* Behind the first `key` in the line; NULL for none. */
static const char *find(const char *line, const char *key)
{
    const char *at = strstr(line, key);
    return at ? at + strlen(key) : NULL;
}

/* `count` times "16 digits", with one character between. */
static bool take_bits(const char *at, double *numbers, int count)
{
    for (int i = 0; at && i < count; i++) {
        uint64_t bits;
        int read = 0;
        if (sscanf(at, "\"%16" SCNx64 "\"%n", &bits, &read) != 1 || read == 0)
            return false;
        memcpy(&numbers[i], &bits, sizeof bits);
        at += read;
        at += *at != '\0';
    }
    return at != NULL;
}

/* The member of [0, count) whose name the line has behind the key; -1 for none. */
static int take_name(const char *line, const char *key, const char *name_of(int), int count)
{
    const char *at = find(line, key);
    for (int i = 0; at && i < count; i++) {
        size_t length = strlen(name_of(i));
        if (strncmp(at, name_of(i), length) == 0 && at[length] == '"')
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

static bool take_hit(const char *line, case_answer *answer)
{
    double normal[3];
    int part = take_name(line, ",\"part\":\"", part_name, SURE_PART_WALL + 1);
    answer->part = (sure_part)part;
    if (part < 0 || !take_bits(find(line, ",\"t_bits\":"), &answer->t, 1) ||
        !take_bits(find(line, ",\"normal_bits\":["), normal, 3))
        return false;
    answer->normal = (sure_vec3){normal[0], normal[1], normal[2]};
    return true;
}

static bool take_answer(const char *line, case_answer *answer)
{
    int field;
    switch (take_name(line, ",\"answer\":\"", status_name, SURE_INVALID + 1)) {
    case SURE_MISS: answer->status = SURE_MISS; return true;
    case SURE_HIT: answer->status = SURE_HIT; return take_hit(line, answer);
    case SURE_INVALID:
        field = take_name(line, ",\"field\":\"", field_name, SURE_FIELD_RADIUS + 1);
        answer->status = SURE_INVALID;
        answer->field = (sure_field)field;
        return field >= 0;
    default: return false;
    }
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
    double numbers[CASE_NUMBERS_MAX];
    frozen_case read = {.number = 0};
    if (sscanf(line, "{\"from\":\"%63[^\"]\",\"number\":%" SCNu64, read.source, &read.number) !=
            2 ||
        !take_bits(find(line, ",\"case_bits\":["), numbers, case_numbers(shape)) ||
        !take_answer(line, &read.answer))
        return false;
    read.question = case_from_numbers(shape, numbers);
    vectors_print(&read, printed);
    if (!is_printed(line, printed))
        return false;
    *frozen = read;
    return true;
}
