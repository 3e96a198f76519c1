/* SPDX-License-Identifier: MIT */
/* Whole numbers in limbs of the type NUMBER (number.h), the least limb first; NUMBER_pair is an
 * unsigned type of twice its bits. limbs_mul and so on take what GMP's mpn_mul takes and do the
 * same. Sizes are at least 1. */
#include "../number.h"

#include <stdbool.h>
#include <string.h>

#define limb NUMBER
#define limb_pair NUMBER_JOIN(NUMBER, pair)
#define LIMB_WIDTH (8 * (int)sizeof(limb))

/* x * y + r + carry: with B = 2^LIMB_WIDTH at most (B - 1)^2 + 2 (B - 1) = B^2 - 1. */
static inline limb_pair OVER(limbs_product)(limb x, limb y, limb r, limb carry)
{
    return (limb_pair)((limb_pair)x * y + r + carry);
}

/* r += x * y, of n limbs; returns the carry. n may be 0. */
static inline limb OVER(limbs_addmul)(limb *r, const limb *x, int n, limb y)
{
    limb carry = 0;
    for (int i = 0; i < n; i++) {
        limb_pair product = OVER(limbs_product)(x[i], y, r[i], carry);
        r[i] = (limb)product;
        carry = (limb)(product >> LIMB_WIDTH);
    }
    return carry;
}

/* r = x * y, row by row as on paper; r has nx + ny limbs. */
static inline void OVER(limbs_mul)(limb *r, const limb *x, int nx, const limb *y, int ny)
{
    memset(r, 0, (size_t)nx * sizeof *r);
    for (int i = 0; i < ny; i++)
        r[nx + i] = OVER(limbs_addmul)(r + i, x, nx, y[i]);
}

/* r = x * x, of 2 n limbs: the products of different limbs, doubled, and the squares. */
static inline void OVER(limbs_sqr)(limb *r, const limb *x, int n)
{
    memset(r, 0, 2 * (size_t)n * sizeof *r);
    for (int i = 0; i < n; i++)
        r[n + i] = OVER(limbs_addmul)(r + 2 * i + 1, x + i + 1, n - i - 1, x[i]);
    limb out = 0, carry = 0; /* of doubling; of adding */
    for (int i = 0; i < n; i++) {
        limb low = r[2 * i], high = r[2 * i + 1];
        limb_pair even = OVER(limbs_product)(x[i], x[i], (limb)(low << 1 | out), carry);
        limb doubled = (limb)(high << 1 | low >> (LIMB_WIDTH - 1));
        limb_pair odd = OVER(limbs_product)(doubled, 1, (limb)(even >> LIMB_WIDTH), 0);
        r[2 * i] = (limb)even;
        r[2 * i + 1] = (limb)odd;
        out = (limb)(high >> (LIMB_WIDTH - 1));
        carry = (limb)(odd >> LIMB_WIDTH);
    }
}

/* Sign of x - y, both of n limbs. */
static inline int OVER(limbs_cmp)(const limb *x, const limb *y, int n)
{
    while (n-- > 0)
        if (x[n] != y[n])
            return x[n] > y[n] ? 1 : -1;
    return 0;
}

/* r = x * 2^count, 0 < count < LIMB_WIDTH; returns what is shifted out. r may be x. */
static inline limb OVER(limbs_lshift)(limb *r, const limb *x, int n, unsigned count)
{
    limb out = 0;
    for (int i = 0; i < n; i++) {
        limb here = x[i];
        r[i] = (limb)(here << count | out);
        out = (limb)(here >> (LIMB_WIDTH - (int)count));
    }
    return out;
}

/* A limb q of the quotient of u[0] ... u[nd] by d, or one more than that: from the three leading
 * limbs of u and two of d. The latter are v1, whose first bit is 1, and v2. Where d has one limb,
 * v2 is 0, and q is right. */
static inline limb OVER(limbs_digit)(const limb *u, int nd, limb v1, limb v2)
{
    limb_pair leading = (limb_pair)((limb_pair)u[nd] << LIMB_WIDTH | u[nd - 1]);
    limb_pair q = (limb_pair)(leading / v1), rest = (limb_pair)(leading - q * v1);
    limb third = nd > 1 ? u[nd - 2] : 0;
    while (q >> LIMB_WIDTH != 0 || (limb_pair)(q * v2) > (limb_pair)(rest << LIMB_WIDTH | third)) {
        q--;
        rest = (limb_pair)(rest + v1);
        if (rest >> LIMB_WIDTH != 0)
            break;
    }
    return (limb)q;
}

/* u -= d * q, u of nd + 1 limbs. Returns whether less was there than was taken. */
static inline bool OVER(limbs_submul)(limb *u, const limb *d, int nd, limb q)
{
    limb carry = 0;
    for (int i = 0; i < nd; i++) {
        limb_pair product = OVER(limbs_product)(d[i], q, 0, carry);
        limb taken = (limb)product;
        carry = (limb)((limb)(product >> LIMB_WIDTH) + (u[i] < taken));
        u[i] = (limb)(u[i] - taken);
    }
    bool less = u[nd] < carry;
    u[nd] = (limb)(u[nd] - carry);
    return less;
}

/* u += d, u of nd + 1 limbs; the carry out of them is dropped. */
static inline void OVER(limbs_add_back)(limb *u, const limb *d, int nd)
{
    limb carry = 0;
    for (int i = 0; i < nd; i++) {
        limb_pair sum = OVER(limbs_product)(d[i], 1, u[i], carry);
        u[i] = (limb)sum;
        carry = (limb)(sum >> LIMB_WIDTH);
    }
    u[nd] = (limb)(u[nd] + carry);
}

/* q = n / d and the rest, which is r[0] ... r[nd - 1]: D. E. Knuth, The Art of Computer
 * Programming, vol. 2, 3rd edition, 4.3.1, algorithm D, whose guess of a digit is at most one too
 * great. Beyond what GMP asks the first bit of d's last limb is 1, and r has room for nn + 1 limbs.
 * nn >= nd; q has nn - nd + 1 limbs. */
static inline void OVER(limbs_tdiv_qr)(limb *q, limb *r, int none, const limb *n, int nn,
                                       const limb *d, int nd)
{
    (void)none;
    memcpy(r, n, (size_t)nn * sizeof *r);
    r[nn] = 0;
    for (int i = nn - nd; i >= 0; i--) {
        limb digit = OVER(limbs_digit)(r + i, nd, d[nd - 1], nd > 1 ? d[nd - 2] : 0);
        if (OVER(limbs_submul)(r + i, d, nd, digit)) {
            digit--;
            OVER(limbs_add_back)(r + i, d, nd);
        }
        q[i] = digit;
    }
}

#undef limb
#undef limb_pair
#undef LIMB_WIDTH
#undef NUMBER
