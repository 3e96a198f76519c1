/* SPDX-License-Identifier: MIT */
/* Bytes as text (RFC 4648). */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* Three bytes in four digits, the last ones filled up. To be freed; NULL: no memory. */
static inline char *base64_of(const void *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const uint8_t *byte = bytes;
    char *text = malloc((size + 2) / 3 * 4 + 1), *at = text;
    for (size_t i = 0; text && i < size; i += 3) {
        uint32_t word = 0;
        for (size_t j = 0; j < 3; j++)
            word = word << 8 | (i + j < size ? byte[i + j] : 0);
        for (size_t j = 0; j < 4; j++)
            *at++ = i + j > size ? '=' : digits[word >> (18 - 6 * j) & 63];
    }
    if (text)
        *at = '\0';
    return text;
}
