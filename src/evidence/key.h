/* Words and swatches drawn into a picture. */
#ifndef EVIDENCE_KEY_H
#define EVIDENCE_KEY_H

#include "../image/picture.h"

typedef struct {
    uint8_t r, g, b;
} key_color;

/* A letter's dots: high, and wide with the gap behind it. */
#define KEY_HEIGHT 8
#define KEY_ADVANCE 6

/* What is beyond the picture's edge is left out, of both. */
void key_fill(picture *image, int x, int y, int width, int height, key_color color);

/* Digits, ".-_" and the small letters that the keys need; anything else is a blank. (x, y) is
 * the upper left corner, `scale` pixels a side make a dot. */
void key_text(picture *image, int x, int y, int scale, key_color color, const char *text);

int key_width(const char *text, int scale);

#endif
