/* What each tier gives and takes over a folder of scenes, for the report. */
#ifndef CLI_REPORT_TRADE_H
#define CLI_REPORT_TRADE_H

#include "../judge/report/report.h"
#include "../tracer/render_file.h"

#include <stdbool.h>

typedef struct {
    report_trade table;
    placed_scene *placed; /* one a row */
} trade;

/* Reads all scenes (*.rt) of the folder, in the order of their names. To be freed with
 * report_trade_free, whatever is returned; false after a line to standard error that names the file
 * or the folder. */
bool report_trade_read(const char *folder, trade *of);

/* Draws them, counts and times: fills in the table. `shown`: with a bar, where it takes long. False
 * after a line to standard error. */
bool report_trade_draw(trade *of, bool shown);

void report_trade_free(trade *of);

#endif
