/* SPDX-License-Identifier: MIT */
/* The functions of limbs_tmpl.h, over NUMBERs as limbs, against GMP's integers. */

/* No factor of exact.h is longer, in limbs of 32 bits: of degree 32 (EXACT_DEGREE_LIMBS). */
enum { OVER(most) = 32 * 70 };

/* Of 0, 1, the greatest, one bit, and random limbs: of one kind or mixed. */
static void OVER(draw)(uint64_t stream, uint64_t i, NUMBER *x, int size)
{
    int kind = (int)(suite_bits(stream, i) % 6);
    for (int at = 0; at < size; at++) {
        uint64_t bits = suite_bits(stream + 1 + (uint64_t)at, i);
        const NUMBER limbs[5] = {0, 1, (NUMBER) ~(NUMBER)0,
                                 (NUMBER)((NUMBER)1 << (bits >> 8) % (8 * sizeof(NUMBER))),
                                 (NUMBER)(bits >> 16)};
        x[at] = limbs[kind < 5 ? (uint64_t)kind : bits % 5];
    }
}

/* Short ones are common, the longest there, too. */
static int OVER(draw_size)(uint64_t stream, uint64_t i)
{
    uint64_t bits = suite_bits(stream, i), kind = bits % 100;
    uint64_t limit = kind < 60 ? 4 : kind < 99 ? 40 : (uint64_t)OVER(most);
    return 1 + (int)((bits >> 8) % limit);
}

static void OVER(set)(mpz_t value, const NUMBER *x, int size)
{
    mpz_import(value, (size_t)size, -1, sizeof *x, 0, 0, x);
}

static void OVER(expect)(const char *what, uint64_t i, const NUMBER *x, int size, mpz_t wanted)
{
    INTEGERS(got);
    OVER(set)(got, x, size);
    if (mpz_cmp(got, wanted) != 0) {
        gmp_fprintf(stderr, "%Zx, expected\n%Zx\n", got, wanted);
        ck_abort_msg("%s of draw %lu in limbs of %zu bytes", what, (unsigned long)i, sizeof *x);
    }
}

static void OVER(check_products)(void)
{
    static NUMBER x[OVER(most)], y[OVER(most)], r[2 * OVER(most)];
    INTEGERS(p, q, wanted);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int nx = OVER(draw_size)(1, i), ny = OVER(draw_size)(2, i);
        if (nx < ny)
            nx = ny;
        OVER(draw)(10000, i, x, nx);
        OVER(draw)(20000, i, y, ny);
        OVER(set)(p, x, nx);
        OVER(set)(q, y, ny);
        mpz_mul(wanted, p, q);
        OVER(limbs_mul)(r, x, nx, y, ny);
        OVER(expect)("product", i, r, nx + ny, wanted);
        mpz_mul(wanted, p, p);
        OVER(limbs_sqr)(r, x, nx);
        OVER(expect)("square", i, r, 2 * nx, wanted);
        unsigned count = 1 + (unsigned)(suite_bits(3, i) % (8 * sizeof(NUMBER) - 1));
        mpz_mul_2exp(wanted, p, count);
        memcpy(r, x, (size_t)nx * sizeof *r);
        r[nx] = OVER(limbs_lshift)(r, r, nx, count);
        OVER(expect)("shift", i, r, nx + 1, wanted);
        ck_assert_int_eq(OVER(limbs_cmp)(x, y, ny),
                         (OVER(set)(p, x, ny), mpz_cmp(p, q) > 0) - (mpz_cmp(p, q) < 0));
        if (i % 2 != 0)
            memcpy(y, x, (size_t)ny * sizeof *y);
        y[i % (uint64_t)ny] ^= (NUMBER)(i % 4 < 2);
        OVER(set)(q, y, ny);
        ck_assert_int_eq(OVER(limbs_cmp)(x, y, ny), (mpz_cmp(p, q) > 0) - (mpz_cmp(p, q) < 0));
    }
}

/* Of what is drawn, and where the quotient is about to change. */
static void OVER(check_quotients)(void)
{
    static NUMBER n[2 * OVER(most)], d[OVER(most)], q[2 * OVER(most)], r[2 * OVER(most) + 1];
    INTEGERS(top, bottom, quotient, rest);
    for (uint64_t i = 0; i < DRAWS; i++) {
        int nd = OVER(draw_size)(4, i), nq = OVER(draw_size)(5, i), nn = nd + nq - 1;
        OVER(draw)(30000, i, d, nd);
        d[nd - 1] |= (NUMBER)((NUMBER)1 << (8 * sizeof(NUMBER) - 1));
        OVER(draw)(40000, i, n, nn);
        OVER(set)(bottom, d, nd);
        OVER(set)(top, n, nn);
        if (i % 3 != 0) { /* a multiple of d, or one less */
            mpz_tdiv_q(top, top, bottom);
            mpz_mul(top, top, bottom);
            if (i % 3 == 2 && mpz_sgn(top) != 0)
                mpz_sub_ui(top, top, 1);
            memset(n, 0, (size_t)nn * sizeof *n);
            mpz_export(n, NULL, -1, sizeof *n, 0, 0, top);
        }
        mpz_tdiv_qr(quotient, rest, top, bottom);
        OVER(limbs_tdiv_qr)(q, r, 0, n, nn, d, nd);
        OVER(expect)("quotient", i, q, nq, quotient);
        OVER(expect)("rest", i, r, nd, rest);
    }
}

#undef NUMBER
