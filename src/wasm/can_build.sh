#!/bin/sh
# SPDX-License-Identifier: MIT
# can_build.sh CLANG: does it link for wasm32-wasi, and are the headers there?
set -e
[ -d /usr/include/Random123 ]
[ -e /usr/include/jansson.h ]
echo 'int answer(void) { return 0; }' |
    "$1" --target=wasm32-wasi -mexec-model=reactor -x c - -o /dev/null
