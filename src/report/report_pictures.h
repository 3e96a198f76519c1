/* The pictures of the report: two hard scenes by every tier. */
#ifndef REPORT_PICTURES_H
#define REPORT_PICTURES_H

#include <jansson.h>

/* For each scene its name, its file, its size, and for each tier the picture's RGB bytes in base64.
 * NULL after a line to standard error. */
json_t *report_pictures_draw(void);

#endif
