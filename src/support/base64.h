/* SPDX-License-Identifier: MIT */
/* Bytes as text (RFC 4648), and back. */
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define BASE64_DIGITS "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"

/* Three bytes in four digits, the last ones filled up. To be freed; NULL: no memory. */
static inline char *base64_of(const void *bytes, size_t size)
{
    static const char digits[] = BASE64_DIGITS;
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

/* To be freed; NULL: no memory, or no such text (NULL is none). */
static inline uint8_t *base64_bytes(const char *text, size_t *size)
{
    size_t length = text ? strlen(text) : 1, digits = text ? strcspn(text, "=") : 0;
    uint8_t *bytes = length % 4 == 0 && length - digits <= 2 ? malloc(length / 4 * 3 + 1) : NULL;
    uint32_t word = 0;
    *size = 0;
    for (size_t i = 0; bytes && i < digits; i++) {
        const char *digit = strchr(BASE64_DIGITS, text[i]);
        if (!digit) {
            free(bytes);
            return NULL;
        }
        word = word << 6 | (uint32_t)(digit - BASE64_DIGITS);
        if (i % 4 > 0)
            bytes[(*size)++] = (uint8_t)(word >> (6 - 2 * (i % 4)));
    }
    return bytes;
}
