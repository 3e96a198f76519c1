/* SPDX-License-Identifier: MIT */
/* What there is to tell, name by name, for scripts: numbers and words. A name such as
 * `t_ulps/median` is that of a member of a member. */
#pragma once

void facts_clear(void);
void facts_number(const char *name, double is);
void facts_words(const char *name, const char *words); /* which are copied */

/* The same, `member` of `of`. */
void facts_member(const char *of, const char *member, double is);
