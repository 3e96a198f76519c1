/* SPDX-License-Identifier: MIT */
/* Which version of the library this header is of, and which one is loaded. */
#pragma once

#include <surehit/linkage.h>

SURE_C_BEGIN

#define SUREHIT_VERSION_MAJOR 0
#define SUREHIT_VERSION_MINOR 2
#define SUREHIT_VERSION_PATCH 0

/* To be compared, in the preprocessor, too: SUREHIT_VERSION >= SUREHIT_VERSION_OF(0, 2, 0). */
#define SUREHIT_VERSION_OF(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))
#define SUREHIT_VERSION                                                                            \
    SUREHIT_VERSION_OF(SUREHIT_VERSION_MAJOR, SUREHIT_VERSION_MINOR, SUREHIT_VERSION_PATCH)

#define SUREHIT_VERSION_TEXT "0.2.0"

/* SUREHIT_VERSION of the library that is loaded. A program may run with any library of the same
 * soname that is not older than the header it was compiled with (docs/building.md). */
int sure_version(void);

SURE_C_END
