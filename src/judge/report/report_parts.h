/* The parts of the page, each a file. */
#ifndef JUDGE_REPORT_PARTS_H
#define JUDGE_REPORT_PARTS_H

#include "report.h"

/* The cases of a shape that belong together: typical ones, or those of all other regimes, where
 * each regime has the same weight whatever its number of cases. */
typedef enum { REPORT_TYPICAL, REPORT_HARD } report_part;

typedef struct {
    int regimes;           /* 0: not asked */
    uint64_t valid, wrong; /* cases */
    uint64_t breaches, unasked;
    double share;       /* of wrong decisions: the regimes' mean */
    double upper;       /* the end of its 95 % interval, where none is wrong */
    double nanoseconds; /* the regimes' median; 0: not known */
    double slowest;     /* of the regimes */
    uint64_t t_count, t_right;
    uint64_t t_classes[SIZE_CLASSES];
} report_sum;

report_sum report_sum_of(const report_candidate *who, int shape, report_part part);
bool report_answers(const report_candidate *who, int shape);

/* Is it `exact`, held against itself? */
bool report_is_measure(const report_candidate *who);

/* A text in HTML, and numbers as people write them. Large enough for any number: */
#define REPORT_NUMBER 32
void report_text(FILE *out, const char *text);
void report_time(double nanoseconds, char text[REPORT_NUMBER]);           /* "57 ns", "1.4 µs" */
void report_per_million(const report_sum *sum, char text[REPORT_NUMBER]); /* "none in 40,000" */
void report_count(uint64_t number, char text[REPORT_NUMBER]);             /* "40,000" */
void report_ulps(double ulps, char text[REPORT_NUMBER]);                  /* "12", "3.4e6" */
void report_percent(double share, char text[REPORT_NUMBER]);              /* "0", "0.35", "44" */

/* The class of a cell with that share of wrong answers: its colour. */
const char *report_heat(double share);

/* The beginning of a paragraph: what the classes' colours stand for. */
void report_print_key(FILE *out);

void report_print_style(FILE *out);
void report_print_plane(FILE *out, const report_candidate *list, int count, int shape,
                        report_part part);
void report_print_heat(FILE *out, const report_plan *plan, const report_candidate *list, int count,
                       int shape);
void report_print_histograms(FILE *out, const report_candidate *list, int count, int shape);
void report_print_scene(FILE *out, const report_scene *scene);
void report_print_trade(FILE *out, const report_trade *trade);

#endif
