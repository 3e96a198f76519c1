/* SPDX-License-Identifier: MIT */
/* The lines of docs/contract.md: what is printed is read as it was, what is read prints and is read
 * again, and what is refused leaves the outputs alone. */

#include "regimes.h"
#include "mutate_text.h"

#define WORD(name, NAME) #name " "

static const char words[] =
    SURE_EACH_SHAPE(WORD) "miss hit invalid surface base top wall o d t_min t_max point centre "
                          "normal apex radius none "
                          "line 0 -0 1 -1 0.1 inf -inf nan -nan nan(1) infinity 0x1p-1074 "
                          "-0x1.fffffffffffffp+1023 1e999 "
                          "1e-999 0x 0x1p 1e 0x1.8p+1 +1 123456789012345678901234567890e-20";
static const char *const further_lines[] = {"hit 4 surface 0 0 1", "invalid t_max", "miss\r\n",
                                            "\n"};

enum { FURTHER_LINES = sizeof further_lines / sizeof *further_lines };

static size_t mutate(uint8_t *data, size_t size, size_t max, unsigned seed)
{
    static char shape_lines[SURE_SHAPES][CASE_LINE_MAX];
    static const char *lines[SURE_SHAPES + FURTHER_LINES];
    static const text_words all = {words, lines, SURE_SHAPES + FURTHER_LINES, 600};
    for (int i = 0; !lines[SURE_SHAPES] && i < SURE_SHAPES; i++) {
        sure_case question = regime_case((sure_shape)i, REGIME_INTEGERS, 1, 0);
        case_print(&question, shape_lines[i]);
        lines[i] = shape_lines[i];
    }
    memcpy(lines + SURE_SHAPES, further_lines, sizeof further_lines);
    if (size == 0 || data[0] % 4 < 2)
        return fuzz_mutate_doubles(data, size, max, seed);
    return text_mutate(data, 1, size, max, seed, &all);
}

FUZZ_TARGET("case", mutate)

/* The same bits; what is not a number is told by its sign alone. */
static bool same(double x, double y)
{
    return isnan(x) ? isnan(y) && !signbit(x) == !signbit(y) : memcmp(&x, &y, sizeof x) == 0;
}

static bool same_vector(sure_vec3 a, sure_vec3 b)
{
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/* Questions. */

static bool same_case(const sure_case *a, const sure_case *b)
{
    double x[CASE_NUMBERS_MAX] = {0}, y[CASE_NUMBERS_MAX] = {0};
    bool alike = a->object.shape == b->object.shape;
    case_to_numbers(a, x);
    case_to_numbers(b, y);
    for (int i = 0; i < case_numbers(a->object.shape); i++)
        alike = alike && same(x[i], y[i]);
    return alike;
}

static bool same_answer(const case_answer *a, const case_answer *b)
{
    if (a->status != b->status)
        return false;
    if (a->status == SURE_INVALID)
        return a->field == b->field;
    return a->status == SURE_MISS ||
           (same(a->t, b->t) && a->part == b->part && same_vector(a->normal, b->normal));
}

/* What a line holds. */
typedef union {
    sure_case question;
    case_answer answer;
} content;

static bool read_content(bool is_question, const char *line, content *c)
{
    return is_question ? case_read(line, &c->question) : case_answer_read(line, &c->answer);
}

static void print_content(bool is_question, const content *c, char line[CASE_LINE_MAX])
{
    if (is_question)
        case_print(&c->question, line);
    else
        case_answer_print(&c->answer, line);
}

static void check_print(bool is_question, const content *c)
{
    char line[CASE_LINE_MAX], again[CASE_LINE_MAX];
    content read;
    print_content(is_question, c, line);
    fuzz_ask("%s", line);
    expect(strlen(line) < CASE_LINE_MAX - 1, "what fills its line");
    expect(read_content(is_question, line, &read), "what is printed is refused");
    expect(is_question ? same_case(&c->question, &read.question)
                       : same_answer(&c->answer, &read.answer),
           "what is printed is read as another");
    print_content(is_question, &read, again);
    expect(strcmp(line, again) == 0, "what is read prints otherwise");
}

/* The format in other words: fields with one blank between them, the last ended by the line. */

static bool next_field(char **rest, char **field)
{
    *field = *rest;
    if (!*rest)
        return false;
    *rest = strchr(*rest, ' ');
    if (*rest)
        *(*rest)++ = '\0';
    return true;
}

static bool is_number(const char *field)
{
    char *end;
    if (*field == '\0' || strspn(field, "+-.0123456789abcdefinptxyABCDEFINPTXY()_") == 0)
        return false;
    (void)strtod(field, &end);
    return *end == '\0';
}

static bool numbers_follow(char **rest, int count)
{
    char *field;
    for (int i = 0; i < count; i++) {
        if (!next_field(rest, &field) || !is_number(field))
            return false;
    }
    return true;
}

static void cut_end(char *line)
{
    size_t length = strlen(line);
    if (length > 0 && line[length - 1] == '\n')
        line[--length] = '\0';
    else
        return;
    if (length > 0 && line[length - 1] == '\r')
        line[--length] = '\0';
}

static bool is_case(char *line)
{
    char *rest = line, *name;
    sure_shape shape;
    char *remark = strstr(line, " #");
    if (remark)
        *remark = '\0';
    else
        cut_end(line);
    return next_field(&rest, &name) && sure_shape_from_name(name, &shape) &&
           numbers_follow(&rest, case_numbers(shape)) && !rest;
}

static bool is_named(const char *word, const char *(*name_of)(int), int first)
{
    const char *name;
    for (int i = first; (name = name_of(i)) != NULL; i++) {
        if (strcmp(word, name) == 0)
            return true;
    }
    return false;
}

static const char *part_name(int i)
{
    return sure_part_name((sure_part)i);
}

static const char *field_name(int i)
{
    return sure_field_name((sure_field)i);
}

static bool is_answer(char *line)
{
    char *rest = line, *word, *name;
    cut_end(line);
    if (!next_field(&rest, &word))
        return false;
    if (strcmp(word, "miss") == 0)
        return !rest;
    if (strcmp(word, "invalid") == 0)
        return next_field(&rest, &name) && is_named(name, field_name, SURE_FIELD_NONE + 1) && !rest;
    return strcmp(word, "hit") == 0 && numbers_follow(&rest, 1) && next_field(&rest, &name) &&
           is_named(name, part_name, 0) && numbers_follow(&rest, 3) && !rest;
}

static void check_line(bool is_question, const char *line, bool right)
{
    content c, before;
    memset(&before, 0x5a, sizeof before);
    memcpy(&c, &before, sizeof c);
    fuzz_ask("%s", line);
    bool read = read_content(is_question, line, &c);
    expect(read == right, read ? "a wrong line is read" : "a right line is refused");
    if (read)
        check_print(is_question, &c);
    else
        expect(memcmp(&c, &before, sizeof before) == 0, "a refused line is written");
}

/* Decoding: numbers, or a line of its own length. */

static bool compare_numbers(fuzz_bytes *bytes)
{
    sure_shape shape = (sure_shape)(fuzz_byte(bytes) % SURE_SHAPES);
    double numbers[CASE_NUMBERS_MAX] = {0}, back[CASE_NUMBERS_MAX];
    for (int i = 0; i < case_numbers(shape); i++)
        numbers[i] = fuzz_double(bytes);
    content made = {.question = case_from_numbers(shape, numbers)};
    case_to_numbers(&made.question, back);
    expect(memcmp(numbers, back, sizeof(double) * (size_t)case_numbers(shape)) == 0,
           "numbers made a case are others");
    check_print(true, &made);
    return true;
}

static bool compare_answer(fuzz_bytes *bytes)
{
    case_answer answer = {.status = (sure_status)(fuzz_byte(bytes) % 3)};
    uint8_t member = fuzz_byte(bytes);
    if (answer.status == SURE_INVALID)
        answer.field = (sure_field)(SURE_FIELD_O + member % (SURE_FIELD_RADIUS - SURE_FIELD_O + 1));
    if (answer.status == SURE_HIT) {
        answer.part = (sure_part)(member % (SURE_PART_WALL + 1));
        answer.t = fuzz_double(bytes);
        answer.normal = fuzz_vector(bytes, fuzz_double);
    }
    check_print(false, &(content){.answer = answer});
    return true;
}

static bool compare_line(fuzz_bytes *bytes, bool is_question)
{
    char *line = malloc(bytes->left + 1), *copy = malloc(bytes->left + 1);
    if (!line || !copy)
        abort();
    if (bytes->left > 0)
        memcpy(line, bytes->at, bytes->left);
    line[bytes->left] = '\0'; /* or where a byte is 0 */
    strcpy(copy, line);
    check_line(is_question, line, is_question ? is_case(copy) : is_answer(copy));
    free(line);
    free(copy);
    return true;
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    switch (fuzz_byte(&bytes) % 4) {
    case 0: return compare_numbers(&bytes);
    case 1: return compare_answer(&bytes);
    case 2: return compare_line(&bytes, true);
    default: return compare_line(&bytes, false);
    }
}
