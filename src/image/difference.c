/* SPDX-License-Identifier: MIT */
#include "difference.h"

#include <inttypes.h>
#include <stdlib.h>

/* The largest of a pixel's channels. */
static int apart(const uint8_t *a, const uint8_t *b)
{
    int most = 0;
    for (int c = 0; c < 3; c++) {
        int distance = abs(a[c] - b[c]);
        most = distance > most ? distance : most;
    }
    return most;
}

difference difference_of(const picture *a, const picture *b)
{
    difference found = {.sizes = {{a->width, a->height}, {b->width, b->height}},
                        .same_size = a->width == b->width && a->height == b->height};
    pixel_box *box = &found.box;
    int right = 0; /* end of the box */
    for (int y = 0; found.same_size && y < a->height; y++) {
        for (int x = 0; x < a->width; x++) {
            size_t at = 3 * ((size_t)y * (size_t)a->width + (size_t)x);
            int distance = apart(a->rgb + at, b->rgb + at);
            if (distance == 0)
                continue;
            if (found.pixels++ == 0)
                *box = (pixel_box){.left = x, .top = y};
            found.largest = distance > found.largest ? distance : found.largest;
            right = x < right ? right : x + 1;
            box->left = x < box->left ? x : box->left;
            box->height = y + 1 - box->top;
        }
    }
    box->width = right - box->left;
    return found;
}

bool difference_is_none(const difference *of)
{
    return of->same_size && of->pixels == 0;
}

void difference_print(FILE *out, const difference *of)
{
    const int *a = of->sizes[0], *b = of->sizes[1];
    const pixel_box *box = &of->box;
    if (!of->same_size)
        fprintf(out, "sizes %dx%d and %dx%d", a[0], a[1], b[0], b[1]);
    else
        fprintf(out, "%" PRId64 " of %" PRId64 " pixels, by at most %d, box x=%d y=%d w=%d h=%d",
                of->pixels, (int64_t)a[0] * a[1], of->largest, box->left, box->top, box->width,
                box->height);
}

json_t *difference_json(const difference *of)
{
    const int *a = of->sizes[0], *b = of->sizes[1];
    const pixel_box *box = &of->box;
    json_t *object = json_pack("{s:b, s:[[i,i],[i,i]]}", "same", difference_is_none(of), "sizes",
                               a[0], a[1], b[0], b[1]);
    if (of->same_size)
        json_object_update_new(object, json_pack("{s:I, s:i}", "pixels", (json_int_t)of->pixels,
                                                 "largest", of->largest));
    if (of->pixels > 0)
        json_object_set_new(object, "box",
                            json_pack("{s:i, s:i, s:i, s:i}", "x", box->left, "y", box->top, "w",
                                      box->width, "h", box->height));
    return object;
}

/* A difference of 1 is as far from grey as one of 255, and no grey is lighter than 51. */
static void show(const uint8_t *a, const uint8_t *b, uint8_t *shown)
{
    int distance = apart(a, b);
    if (distance == 0) {
        shown[0] = shown[1] = shown[2] = (uint8_t)((a[0] + a[1] + a[2]) / 15);
        return;
    }
    shown[0] = 255;
    shown[1] = (uint8_t)(90 + distance * 150 / 255);
    shown[2] = (uint8_t)(distance * 200 / 255);
}

bool difference_draw(const picture *a, const picture *b, picture *shown)
{
    if (!picture_new(a->width, a->height, shown))
        return false;
    for (size_t i = 0; i < 3 * (size_t)a->width * (size_t)a->height; i += 3)
        show(a->rgb + i, b->rgb + i, shown->rgb + i);
    return true;
}
