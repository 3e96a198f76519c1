/* The pictures of the report: extreme scenes by every tier, and where they differ from exact. */
#ifndef CLI_REPORT_PICTURES_H
#define CLI_REPORT_PICTURES_H

#include "../judge/report/report.h"

#include <stdbool.h>

#define REPORT_SCENES 2

/* Draws them, once in a program; to be freed with report_pictures_free, whatever is returned. False
 * after a line to standard error. Without PNG in this build there are none: *count is 0. */
bool report_pictures_draw(report_scene scenes[REPORT_SCENES], int *count);
void report_pictures_free(int count);

#endif
