/* SPDX-License-Identifier: MIT */
#include "case_file.h"

#include "suite.h"
#include "text_rows.h"

bool case_answers_same(const case_answer *a, const case_answer *b)
{
    return a->status == b->status && a->field == b->field && a->part == b->part && a->t == b->t &&
           a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z;
}

static void read_tiers(char *words, const char *stage, hard_case *read)
{
    while (read->stage < SURE_STAGES && strcmp(stage, sure_stage_name(read->stage)) != 0)
        read->stage++;
    ck_assert_msg(read->stage < SURE_STAGES, "no stage: %s", read->text);
    for (char *name = strtok(words, " "); name; name = strtok(NULL, " ")) {
        sure_tier tier;
        if (strcmp(name, "-") == 0)
            continue;
        ck_assert_msg(sure_tier_from_name(name, &tier), "no tier: %s", read->text);
        read->right[tier] = true;
    }
}

static void read_case(char *line, hard_case *read)
{
    strcpy(read->text, line);
    char *answer = row_cut(line, " -> "), *tiers = row_cut(answer, " ; ");
    const char *origin = row_cut(tiers, " ; "), *stage = row_cut(tiers, " @");
    ck_assert_msg(case_read(line, &read->question) && case_answer_read(answer, &read->answer) &&
                      *origin != '\n',
                  "not a hard case: %s", read->text);
    read_tiers(tiers, stage, read);
}

int case_file_each(sure_shape shape, void (*use)(const hard_case *))
{
    char line[1024], path[64];
    int cases = 0;
    snprintf(path, sizeof path, "cases/%s.cases", sure_shape_name(shape));
    FILE *file = rows_open(path);
    for (; rows_line(file, line, sizeof line); cases++) {
        hard_case read = {.stage = 0};
        read_case(line, &read);
        use(&read);
    }
    fclose(file);
    return cases;
}
