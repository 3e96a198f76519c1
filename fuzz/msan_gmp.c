/* SPDX-License-Identifier: MIT */
/* MemorySanitizer's build: GMP is not compiled for it, so what GMP writes has to be marked; and
 * what stat does, which clang 14 doesn't know by its name for large files. The
 * linker puts these in front (--wrap). */
#include <gmp.h>
#include <sanitizer/msan_interface.h>
#include <sys/stat.h>

#define WRITES(place, count) __msan_unpoison(place, (size_t)(count) * sizeof(mp_limb_t))
#define DECLARE(type, name, parameters)                                                            \
    type __real_##name parameters;                                                                 \
    type __wrap_##name parameters

DECLARE(mp_limb_t, __gmpn_mul,
        (mp_limb_t *, const mp_limb_t *, mp_size_t, const mp_limb_t *, mp_size_t));
DECLARE(void, __gmpn_sqr, (mp_limb_t *, const mp_limb_t *, mp_size_t));
DECLARE(mp_limb_t, __gmpn_lshift, (mp_limb_t *, const mp_limb_t *, mp_size_t, unsigned));
DECLARE(void, __gmpn_tdiv_qr,
        (mp_limb_t *, mp_limb_t *, mp_size_t, const mp_limb_t *, mp_size_t, const mp_limb_t *,
         mp_size_t));

mp_limb_t __wrap___gmpn_mul(mp_limb_t *product, const mp_limb_t *x, mp_size_t nx,
                            const mp_limb_t *y, mp_size_t ny)
{
    mp_limb_t high = __real___gmpn_mul(product, x, nx, y, ny);
    WRITES(product, nx + ny);
    return high;
}

void __wrap___gmpn_sqr(mp_limb_t *square, const mp_limb_t *x, mp_size_t n)
{
    __real___gmpn_sqr(square, x, n);
    WRITES(square, 2 * n);
}

mp_limb_t __wrap___gmpn_lshift(mp_limb_t *shifted, const mp_limb_t *x, mp_size_t n, unsigned count)
{
    mp_limb_t out = __real___gmpn_lshift(shifted, x, n, count);
    WRITES(shifted, n);
    return out;
}

void __wrap___gmpn_tdiv_qr(mp_limb_t *quotient, mp_limb_t *rest, mp_size_t unused,
                           const mp_limb_t *x, mp_size_t nx, const mp_limb_t *y, mp_size_t ny)
{
    __real___gmpn_tdiv_qr(quotient, rest, unused, x, nx, y, ny);
    WRITES(quotient, nx - ny + 1);
    WRITES(rest, ny);
}

DECLARE(int, stat64, (const char *, struct stat *));
DECLARE(int, lstat64, (const char *, struct stat *));

int __wrap_stat64(const char *path, struct stat *about)
{
    int failed = __real_stat64(path, about);
    if (!failed)
        __msan_unpoison(about, sizeof *about);
    return failed;
}

int __wrap_lstat64(const char *path, struct stat *about)
{
    int failed = __real_lstat64(path, about);
    if (!failed)
        __msan_unpoison(about, sizeof *about);
    return failed;
}
