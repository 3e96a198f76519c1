/* SPDX-License-Identifier: MIT */
/* The tiers: the speed-for-accuracy ladder of docs/contract.md, least promise first. */
#pragma once

#include <surehit/answer.h>

SURE_C_BEGIN

typedef enum {
    SURE_TIER_FLOAT32,  /* single precision, inputs rounded to float: promises nothing */
    SURE_TIER_TEXTBOOK, /* the notes' formulas in double, corrected: promises nothing */
    SURE_TIER_STABLE,   /* of a shape: the first stage of certain, or a guess */
    SURE_TIER_CERTAIN,  /* every decision right, t within t_error */
    SURE_TIER_EXACT     /* every decision right, t and normal correctly rounded */
} sure_tier;

#define SURE_TIERS 5

/* "float32", "textbook", "stable", "certain", "exact"; NULL for a number that is no tier. */
const char *sure_tier_name(sure_tier tier);

/* Finds the tier of that name: 1 and *tier written, or 0 and *tier untouched. */
int sure_tier_from_name(const char *name, sure_tier *tier);

SURE_C_END
