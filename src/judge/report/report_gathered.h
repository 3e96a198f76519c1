/* What the processes that share the report's work write into a pipe, whole at a time. */
#ifndef JUDGE_REPORT_GATHERED_H
#define JUDGE_REPORT_GATHERED_H

#include "report_parts.h"

typedef enum { FOUND_ROW, FOUND_TIME, FOUND_END } found_kind;

typedef struct {
    found_kind kind;
    int candidate, shape, which;
    bool in_float, with_normals;
    union {
        report_row row;
        double nanoseconds;
        char trouble[REPORT_MESSAGE]; /* FOUND_END: why the job is not done; empty: it is */
    } is;
} finding;

/* What a pipe takes whole, whoever else writes. */
#define PIPE_WHOLE 512
_Static_assert(sizeof(finding) <= PIPE_WHOLE, "written whole");

/* Ends the process when nobody reads. */
void report_put(int results, const finding *one);

/* Takes everyone's times for a shape, in all regimes that it was asked. */
void report_take_times(const report_plan *plan, const report_candidate *list, int count,
                       sure_shape shape, int results);

#endif
