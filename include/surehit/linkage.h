/* SPDX-License-Identifier: MIT */
/* What stands around declarations, so that C++ calls their functions as C does; and what makes
 * several of one. */
#pragma once

#ifdef __cplusplus
#define SURE_C_BEGIN extern "C" {
#define SURE_C_END }
#else
#define SURE_C_BEGIN
#define SURE_C_END
#endif

/* A function once for each tier of those whose formula is the notes', with their laws and bound:
 * sure_reflect_float32, sure_reflect_textbook; and with a form that holds over the whole range of
 * doubles, sure_reflect_stable. float32 takes the floats that its arguments round to, and what is
 * asked on entry is asked of these: 1e300 is not finite there, 1e-60 is zero. */
#define SURE_PLAIN(type, function, ...)                                                            \
    type function##_float32(__VA_ARGS__);                                                          \
    type function##_textbook(__VA_ARGS__)
#define SURE_TIERED(type, function, ...)                                                           \
    SURE_PLAIN(type, function, __VA_ARGS__);                                                       \
    type function##_stable(__VA_ARGS__)
