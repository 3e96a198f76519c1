/* SPDX-License-Identifier: MIT */
/* Files of hard cases, tests/cases/<shape>.cases. A line is
 *
 *     <case> -> <answer> ; <tiers, or -> @<stage> ; <where the case came from>
 *
 * with case and answer as in docs/contract.md. The tiers are those of the plain ones that answer
 * exactly so; that certain and exact are right is not noted. The stage is the one that decides for
 * certain. Empty lines and lines from # on are passed over. */
#pragma once

#include "case.h"

typedef struct {
    sure_case question;
    case_answer answer;
    bool right[SURE_TIERS]; /* the tiers that must give the answer, bit for bit */
    sure_stage stage;
    char text[1024];
} hard_case;

/* Calls use() for every case of the shape's file and returns their number; a line that cannot be
 * read, or a file that cannot be opened, fails the running test. */
int case_file_each(sure_shape shape, void (*use)(const hard_case *));

/* Do both answers say the same, numbers by value? */
bool case_answers_same(const case_answer *a, const case_answer *b);
