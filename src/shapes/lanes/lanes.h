/* SPDX-License-Identifier: MIT */
/* As many doubles side by side as one instruction computes. Behind this header `double` stands for
 * them, so that the headers of the first stages, which are included next, compute several queries
 * at once: each by the very operations that a query alone takes, and so to the same bits. What has
 * branches in them is left out where LANES is defined.
 *
 * bool is what a comparison gives, all ones or zero; uint64_t the bits. Included before: whatever
 * is to keep its doubles. */
#pragma once

#include "../../numbers/bits.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

/* The build says how many: a compiler may be told of more. */
#if defined(LANES_WIDTH)
#define LANES LANES_WIDTH
#elif defined(__AVX512F__)
#define LANES 8
#elif defined(__AVX2__)
#define LANES 4
#else
#define LANES 2
#endif

#if LANES == 8
#define LANES_CALL(operation) _mm512_##operation##_pd
#define LANES_UNSIGNED /* compares bits in one operation */
#elif LANES == 4
#define LANES_CALL(operation) _mm256_##operation##_pd
#else
#define LANES_CALL(operation) _mm_##operation##_pd
#endif

enum { LANES_STRIDE = sizeof(double) };

typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));
typedef int64_t lanes_mask __attribute__((vector_size(LANES * sizeof(double))));
typedef uint64_t lanes_bits __attribute__((vector_size(LANES * sizeof(double))));

static inline lanes lanes_at(const void *first)
{
    lanes x;
    memcpy(&x, first, sizeof x);
    return x;
}

static inline void lanes_to(void *first, lanes x)
{
    memcpy(first, &x, sizeof x);
}

/* One number in all lanes. */
static inline lanes lanes_all_at(const void *number)
{
    double x;
    memcpy(&x, number, sizeof x);
    return x - (lanes){0};
}

static inline lanes lanes_all_of_float(const void *number)
{
    float x;
    memcpy(&x, number, sizeof x);
    return (double)x - (lanes){0};
}

/* Of a comparison, a bit a lane. */
static inline unsigned lanes_bit_each(lanes_mask x)
{
#if LANES == 8
    return _mm512_movepi64_mask((__m512i)x);
#elif LANES == 4
    return (unsigned)_mm256_movemask_pd((__m256d)x);
#else
    return (unsigned)((x[0] & 1) | (x[1] & 2));
#endif
}

/* LANES floats, and masks of them. */
typedef float lanes_floats __attribute__((vector_size(LANES * sizeof(float))));
typedef int32_t lanes_floats_mask __attribute__((vector_size(LANES * sizeof(float))));

static inline lanes_floats lanes_floats_at(const void *first)
{
    lanes_floats x;
    memcpy(&x, first, sizeof x);
    return x;
}

static inline void lanes_floats_to(void *first, lanes_floats x)
{
    memcpy(first, &x, sizeof x);
}

#if LANES == 8 /* GCC 12 makes a long way of these three */
static inline lanes lanes_of_floats(lanes_floats x)
{
    return _mm512_cvtps_pd((__m256)x);
}

static inline lanes_mask lanes_wide(lanes_floats_mask x)
{
    return (lanes_mask)_mm512_cvtepi32_epi64((__m256i)x);
}

static inline lanes_floats_mask lanes_narrow(lanes_mask x)
{
    return (lanes_floats_mask)_mm512_cvtepi64_epi32((__m512i)x);
}
#elif LANES == 4
static inline lanes lanes_of_floats(lanes_floats x)
{
    return _mm256_cvtps_pd((__m128)x);
}

static inline lanes_mask lanes_wide(lanes_floats_mask x)
{
    return (lanes_mask)_mm256_cvtepi32_epi64((__m128i)x);
}

static inline lanes_floats_mask lanes_narrow(lanes_mask x)
{
    __m128 low = _mm256_castps256_ps128((__m256)x), high = _mm256_extractf128_ps((__m256)x, 1);
    return (lanes_floats_mask)_mm_shuffle_ps(low, high, 0x88);
}
#else
static inline lanes lanes_of_floats(lanes_floats x)
{
    return __builtin_convertvector(x, lanes);
}

static inline lanes_mask lanes_wide(lanes_floats_mask x)
{
    return __builtin_convertvector(x, lanes_mask);
}

static inline lanes_floats_mask lanes_narrow(lanes_mask x)
{
    return __builtin_convertvector(x, lanes_floats_mask);
}
#endif

static inline lanes_floats lanes_floats_of(lanes x)
{
    return __builtin_convertvector(x, lanes_floats);
}

static inline lanes_mask lanes_same_floats(lanes_floats x, lanes_floats y)
{
    return lanes_wide(x == y);
}

static inline lanes_floats lanes_floats_where(lanes_mask condition, lanes_floats x, lanes_floats y)
{
    lanes_floats_mask mask = lanes_narrow(condition);
    return (lanes_floats)(((lanes_floats_mask)x & mask) | ((lanes_floats_mask)y & ~mask));
}

/* LANES bytes, in one number: those of small numbers, or of what a comparison gives. */
#if LANES == 8 /* GCC 12 makes a long way of it, and of 4 */
typedef uint64_t lanes_bytes;

static inline lanes_bytes lanes_bytes_of(lanes_bits x)
{
    return (lanes_bytes)_mm_cvtsi128_si64(_mm512_cvtepi64_epi8((__m512i)x));
}
#elif LANES == 4
typedef uint32_t lanes_bytes;

static inline lanes_bytes lanes_bytes_of(lanes_bits x)
{
    const __m256i least =
        _mm256_setr_epi8(0, 8, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, 0, 8,
                         -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1);
    __m256i apart = _mm256_shuffle_epi8((__m256i)x, least);
    return (lanes_bytes)_mm_cvtsi128_si32(
        _mm_or_si128(_mm256_castsi256_si128(apart), _mm256_extracti128_si256(apart, 1)));
}
#else
typedef uint16_t lanes_bytes;

static inline lanes_bytes lanes_bytes_of(lanes_bits x)
{
    typedef uint8_t vector __attribute__((vector_size(LANES)));
    vector bytes = __builtin_convertvector(x, vector);
    lanes_bytes all;
    memcpy(&all, &bytes, sizeof all);
    return all;
}
#endif

/* Of what a comparison gives. */
static inline lanes_bytes lanes_bytes_of_mask(lanes_mask x)
{
#if LANES == 4 /* bit i to byte i, and all of it */
    static const lanes_bytes bytes[] = {0,          0xff,       0xff00,     0xffff,
                                        0xff0000,   0xff00ff,   0xffff00,   0xffffff,
                                        0xff000000, 0xff0000ff, 0xff00ff00, 0xff00ffff,
                                        0xffff0000, 0xffff00ff, 0xffffff00, 0xffffffff};
    return bytes[lanes_bit_each(x)];
#else
    return lanes_bytes_of((lanes_bits)x);
#endif
}

/* The same byte LANES times. */
#define LANES_BYTES(byte) ((lanes_bytes)((lanes_bytes)-1 / 0xff * (byte)))

static inline lanes_bytes lanes_bytes_at(const uint8_t *first)
{
    lanes_bytes all;
    memcpy(&all, first, sizeof all);
    return all;
}

static inline void lanes_bytes_to(uint8_t *first, lanes_bytes all)
{
    memcpy(first, &all, sizeof all);
}

static inline lanes lanes_of_bits(lanes_bits x)
{
    return (lanes)x;
}

static inline lanes_bits lanes_bits_of(lanes x)
{
    return (lanes_bits)x;
}

/* mask: of each lane all or none. */
static inline lanes filter_either(lanes_bits mask, lanes x, lanes y)
{
#if LANES == 4 /* GCC 12 makes three operations of it */
    return _mm256_blendv_pd(y, x, (lanes)mask);
#else
    return (lanes)(((lanes_bits)x & mask) | ((lanes_bits)y & ~mask));
#endif
}

static inline lanes lanes_magnitude(lanes x)
{
    return (lanes)((lanes_bits)x & ~BITS_SIGN);
}

static inline lanes lanes_signed(lanes x, lanes sign)
{
    return (lanes)(((lanes_bits)x & ~BITS_SIGN) | ((lanes_bits)sign & BITS_SIGN));
}

#if defined(__SSE2__)
static inline lanes lanes_root(lanes x)
{
    return LANES_CALL(sqrt)(x);
}

/* x < y ? x : y, for NaNs too. */
static inline lanes filter_lesser(lanes x, lanes y)
{
    return LANES_CALL(min)(x, y);
}

static inline lanes filter_greater(lanes x, lanes y)
{
    return LANES_CALL(max)(x, y);
}
#elif defined(__wasm_simd128__)
static inline lanes lanes_root(lanes x)
{
    return (lanes)wasm_f64x2_sqrt((v128_t)x);
}

/* The parts of wasm_f64x2_pmin and pmax stand the other way round. */
static inline lanes filter_lesser(lanes x, lanes y)
{
    return (lanes)wasm_f64x2_pmin((v128_t)y, (v128_t)x);
}

static inline lanes filter_greater(lanes x, lanes y)
{
    return (lanes)wasm_f64x2_pmax((v128_t)y, (v128_t)x);
}
#else
static inline lanes lanes_root(lanes x)
{
    for (int i = 0; i < LANES; i++)
        x[i] = sqrt(x[i]);
    return x;
}

static inline lanes filter_lesser(lanes x, lanes y)
{
    lanes_bits less = (lanes_bits)(x < y);
    return (lanes)(((lanes_bits)x & less) | ((lanes_bits)y & ~less));
}

static inline lanes filter_greater(lanes x, lanes y)
{
    lanes_bits more = (lanes_bits)(x > y);
    return (lanes)(((lanes_bits)x & more) | ((lanes_bits)y & ~more));
}
#endif

#define bits_of(x) _Generic((x), lanes : lanes_bits_of, default : bits_of)(x)
#define double_of(x) _Generic((x), lanes_bits : lanes_of_bits, default : double_of)(x)
#undef fabs
#undef sqrt
#undef copysign
#undef bool
#undef true
#define fabs lanes_magnitude
#define sqrt lanes_root
#define copysign lanes_signed
#define double lanes
#define uint64_t lanes_bits
#define int64_t lanes_mask
#define bool lanes_mask
#define true (~(lanes_mask){0})
