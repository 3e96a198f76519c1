/* SPDX-License-Identifier: MIT */
#include "suite.h"

#include <Random123/philox.h>
#include <stdarg.h>

static int suite_run(Suite *suite)
{
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner), run = srunner_ntests_run(runner);
    srunner_free(runner);
    if (run == 0)
        fprintf(stderr, "no test was run\n");
    return failed == 0 && run > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

enum { TESTS_MOST = 100 };

static suite_test added[TESTS_MOST];
static int added_count;

void suite_add(suite_test test)
{
    if (added_count == TESTS_MOST)
        abort();
    added[added_count++] = test;
}

static void add_case(Suite *suite, const char *name, const suite_test *of, int begin, int end,
                     SFun set_up, SFun tear_down)
{
    TCase *tests = tcase_create(name);
    tcase_set_timeout(tests, 0); /* what hangs is ended by meson */
    tcase_add_checked_fixture(tests, set_up, tear_down);
    tcase_add_loop_test_raise_signal(tests, of->test, of->signal, begin, end);
    suite_add_tcase(suite, tests);
}

int suite_main(const char *title, SFun set_up, SFun tear_down)
{
#define NAME(shape, SHAPE) #shape,
    static const char *const shapes[] = {SURE_EACH_SHAPE(NAME)};
    Suite *suite = suite_create(title);
    setvbuf(stdout, NULL, _IOLBF, 0); /* a failure is told, too, where a later crash ends it */
    const char *fork = getenv("CK_FORK");
    const bool one_process = fork && strcmp(fork, "no") == 0; /* which a signal would end */
    for (const suite_test *of = added; of < added + added_count; of++) {
        if (of->signal != 0 && one_process)
            continue;
        if (!of->of_shapes)
            add_case(suite, of->test->name, of, 0, of->count, set_up, tear_down);
        for (int i = 0; i < of->count && of->of_shapes; i++)
            add_case(suite, shapes[i], of, i, i + 1, set_up, tear_down);
    }
    return suite_run(suite);
}

double suite_rounded(int tier, double x)
{
    return tier == SURE_TIER_FLOAT32 ? (double)(float)x : x;
}

uint64_t suite_setting(const char *name, uint64_t otherwise)
{
    const char *text = getenv(name);
    char *end = "";
    uint64_t value = text ? strtoull(text, &end, 10) : otherwise;
    ck_assert_msg(*end == '\0' && value > 0, "%s=%s is no number", name, text);
    return value;
}

void free_text(char **text)
{
    free(*text);
}

const char *suite_file(const char *format, ...)
{
    static char path[4096];
    const char *folder = getenv("SUREHIT_TESTS");
    int used = snprintf(path, sizeof path / 2, "%s/", folder ? folder : SUREHIT_TESTS);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(path + used, sizeof path - (size_t)used, format, arguments);
    va_end(arguments);
    return path;
}

void suite_double_same(const char *file, int line, double value, double expected)
{
    if (!(value == expected))
        ck_abort_msg("%s:%d: %a (%.17g), expected %a (%.17g)", file, line, value, value, expected,
                     expected);
}

void suite_vector_same(const char *file, int line, sure_vec3 value, sure_vec3 expected)
{
    if (!(value.x == expected.x && value.y == expected.y && value.z == expected.z))
        ck_abort_msg("%s:%d: (%a, %a, %a), expected (%a, %a, %a)", file, line, value.x, value.y,
                     value.z, expected.x, expected.y, expected.z);
}

uint64_t suite_bits(uint64_t stream, uint64_t index)
{
    philox2x64_ctr_t counter = {{index, stream}};
    philox2x64_key_t key = {{UINT64_C(0x7375726568697421)}};
    return philox2x64(counter, key).v[0];
}

int suite_integer(uint64_t stream, uint64_t index, int limit)
{
    return (int)(suite_bits(stream, index) % (uint64_t)(2 * limit + 1)) - limit;
}

double suite_double(uint64_t stream, uint64_t index, int spread)
{
    uint64_t bits = suite_bits(stream, index);
    double fraction = ldexp((double)(int64_t)(bits & ~UINT64_C(0x7ff)), -63);
    return ldexp(fraction, (int)((bits & 0x7ff) % (uint64_t)(2 * spread + 1)) - spread);
}

sure_vec3 suite_integers(uint64_t stream, uint64_t index, int limit)
{
    return (sure_vec3){suite_integer(stream, index, limit), suite_integer(stream + 1, index, limit),
                       suite_integer(stream + 2, index, limit)};
}

sure_vec3 suite_doubles(uint64_t stream, uint64_t index, int spread)
{
    return (sure_vec3){suite_double(stream, index, spread), suite_double(stream + 1, index, spread),
                       suite_double(stream + 2, index, spread)};
}

float suite_single(uint64_t stream, uint64_t index, int spread)
{
    return (float)suite_double(stream, index, spread);
}
