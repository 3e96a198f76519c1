/* SPDX-License-Identifier: MIT */
/* What a script may call. Numbers are doubles and whole numbers of 32 bits, an address is one of
 * these; text ends with a 0. */
#pragma once

#define WASM_EXPORT(name) __attribute__((export_name(#name))) name
