/* How the frozen vectors' numbers are printed (docs/vectors.md). The bytes themselves are
 * test_vectors.py's; what tiers promise in regimes is told by <shape> laws. */
#include "suite.h"
#include "vectors.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Every number is printed as it is: each exponent, whole and odd fractions, both signs. */
TEST(test_numbers)
{
    for (int power = 0; power < 2048; power++) {
        for (int i = 0; i < 4; i++) {
            uint64_t fraction = suite_bits(1, (uint64_t)(4 * power + i)) >> 12 >> (17 * i % 52);
            uint64_t bits = (uint64_t)i % 2 << 63 | (uint64_t)power << 52 | fraction;
            double numbers[CASE_NUMBERS_MAX] = {0};
            memcpy(&numbers[i], &bits, sizeof bits);
            sure_case question = case_from_numbers(SURE_SHAPE_SPHERE, numbers);
            frozen_case frozen = vectors_case_of("test", 7, &question);
            json_t *object = vectors_json(&frozen);
            FREED_BY(free_text) char *line = json_dumps(object, JSON_COMPACT);
            char number[64], digits[64];
            snprintf(number, sizeof number, isnan(numbers[i]) ? "\"nan\"" : "\"%a\"", numbers[i]);
            snprintf(digits, sizeof digits, "\"%016" PRIx64 "\"", bits);
            ck_assert_msg(strstr(line, number) && strstr(line, digits), "%s or %s not in %s",
                          number, digits, line);
            json_decref(object);
        }
    }
}

SUITE("vectors")
