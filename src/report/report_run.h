/* A whole report: who is asked, the judging, the pictures, and the files. */
#ifndef REPORT_RUN_H
#define REPORT_RUN_H

#include "report.h"
#include "report_trade.h"

typedef struct {
    const char *page, *json, *scenes; /* the last two may be NULL */
    bool quiet;
    report_plan plan;
    report_candidate list[REPORT_CANDIDATES]; /* of which `count` are asked */
    int count;
    const char *version, *flags; /* of the program, and what it was compiled with */
    char *const *words;          /* of the command line, behind the command; NULL ends them */
    trade trade;
} report_run;

/* One more to be asked; there has to be room. False when there is no memory. */
void report_add_tier(report_run *run, sure_tier tier);
bool report_add_library(report_run *run, const char *path);

/* Every tier, and the peers that were built with surehit. */
bool report_choose_all(report_run *run);

typedef enum {
    REPORTED,
    REPORT_TROUBLE,  /* the output could not be written, or a candidate could not be asked */
    REPORT_NO_SCENES /* a scene can't be read */
} report_outcome;

/* Unless all is well, one line was written to standard error. */
report_outcome report_make(report_run *run);

#endif
