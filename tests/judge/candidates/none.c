/* SPDX-License-Identifier: MIT */
/* A shared library that is no candidate. */
int nothing(void);

int nothing(void)
{
    return 0;
}
