/* SPDX-License-Identifier: MIT */
/* AFL++, persistent mode. The process is replaced from time to time; all of them count in the same
 * file. The targets' mutators are not used: AFL++ has its own. */
#include "counts.h"
#include "fuzz.h"

#include <unistd.h>

enum { EXECUTIONS_A_PROCESS = 10000 };

__AFL_FUZZ_INIT();

int main(void)
{
    if (!fuzz_counts_open()) {
        fprintf(stderr, "FUZZ_COUNTS: can't be mapped\n");
        return EXIT_FAILURE;
    }
    __AFL_INIT();
    const unsigned char *data = __AFL_FUZZ_TESTCASE_BUF;
    while (__AFL_LOOP(EXECUTIONS_A_PROCESS)) {
        fuzz_count_execution();
        fuzz_count_compared(fuzz_target(data, (size_t)__AFL_FUZZ_TESTCASE_LEN));
    }
    return EXIT_SUCCESS;
}
