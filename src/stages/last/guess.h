/* SPDX-License-Identifier: MIT */
/* Where a number of an answer is, nearly, and how nearly. Where that leaves more than one double a
 * good guess still spares rounding.c most of its questions. */
#pragma once

#include "line.h"
#include "wide.h"

/* alpha + beta t*, t* a root: off by a small share of it, also where nearly nothing is left. */
wide guess_linear(exact_context *, const line_coefficients *, end_kind at, exact alpha, exact beta);
