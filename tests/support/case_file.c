#include "case_file.h"

#include <check.h>
#include <stdio.h>
#include <string.h>

bool case_answers_same(const case_answer *a, const case_answer *b)
{
    return a->status == b->status && a->field == b->field && a->part == b->part && a->t == b->t &&
           a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z;
}

static bool read_stage(const char *name, sure_stage *stage)
{
    for (int i = 0; i < SURE_STAGES; i++) {
        if (strcmp(name, sure_stage_name((sure_stage)i)) == 0) {
            *stage = (sure_stage)i;
            return true;
        }
    }
    return false;
}

/* The stage's name, which is cut off; NULL for none. */
static const char *cut_stage(char *words)
{
    char *at = strstr(words, " @");
    if (!at)
        return NULL;
    *at = '\0';
    return at + 2;
}

static bool read_tiers(char *words, hard_case *read)
{
    const char *stage = cut_stage(words);
    if (!stage || !read_stage(stage, &read->stage))
        return false;
    for (char *name = strtok(words, " "); name; name = strtok(NULL, " ")) {
        sure_tier tier;
        if (strcmp(name, "-") == 0)
            continue;
        if (!sure_tier_from_name(name, &tier))
            return false;
        read->right[tier] = true;
    }
    return true;
}

static bool read_line(char *line, hard_case *read)
{
    char *answer = strstr(line, " -> ");
    char *tiers = answer ? strstr(answer, " ; ") : NULL;
    char *origin = tiers ? strstr(tiers + 3, " ; ") : NULL;
    if (!origin)
        return false;
    *answer = *tiers = *origin = '\0';
    return case_read(line, &read->question) && case_answer_read(answer + 4, &read->answer) &&
           read_tiers(tiers + 3, read) && origin[3] != '\n';
}

int case_file_each(const char *path, void (*use)(const hard_case *))
{
    FILE *file = fopen(path, "r");
    ck_assert_msg(file != NULL, "%s cannot be opened", path);
    char line[1024];
    int cases = 0;
    for (int number = 1; fgets(line, sizeof line, file); number++) {
        hard_case read = {.line = number};
        if (line[0] == '#' || line[0] == '\n')
            continue;
        strcpy(read.text, line);
        ck_assert_msg(read_line(line, &read), "%s:%d: not a hard case: %s", path, number,
                      read.text);
        use(&read);
        cases++;
    }
    fclose(file);
    return cases;
}
