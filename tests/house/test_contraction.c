/* The stems' sources compiled for this very machine, FMA included where it has it: h^2 - a c must
 * still be the difference of two rounded products. */
#include "../support/suite.h"

TEST(test_two_products)
{
    volatile double h = 0x1.0000002p+0; /* h^2 needs 54 bits */
    volatile double c = h * h;
    double roots[2];
    ck_assert_int_eq(sure_quadratic_textbook(1, h, c, roots), SURE_ROOTS_TWO);
    ck_double_same(roots[0], roots[1]);
    volatile float single = 0x1.002p+0f;
    volatile float square = single * single;
    ck_assert_int_eq(sure_quadratic_float32(1, single, square, roots), SURE_ROOTS_TWO);
    ck_double_same(roots[0], roots[1]);
}

SUITE("contraction")
