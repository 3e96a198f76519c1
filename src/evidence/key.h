/* Words and swatches drawn into a picture. */
#ifndef EVIDENCE_KEY_H
#define EVIDENCE_KEY_H

#include "../image/picture.h"

typedef struct {
    uint8_t r, g, b;
} legend_color;

/* A letter's dots: high, and wide with the gap behind it. */
#define LEGEND_HEIGHT 8
#define LEGEND_ADVANCE 6

/* What is beyond the picture's edge is left out, of both. */
void legend_fill(picture *image, int x, int y, int width, int height, legend_color color);

/* Digits, ".-_" and the small letters that the legends need; anything else is a blank. (x, y) is
 * the upper left corner, `scale` pixels a side make a dot. */
void legend_text(picture *image, int x, int y, int scale, legend_color color, const char *text);

int legend_width(const char *text, int scale);

#endif
