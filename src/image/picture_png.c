/* SPDX-License-Identifier: MIT */
/* Pictures as PNG, by libpng. */
#include "../support/complain.h"
#include "picture.h"

#include <errno.h>
#include <limits.h>
#include <png.h>
#include <string.h>

#define SIGNATURE 8

/* For a jump out of libpng. */
typedef struct {
    FILE *stream;
    const char *beginning; /* of what is said then: ... */
} png_file;

static char reason[128]; /* ... this */

static void png_failed(png_structp png, png_const_charp why)
{
    int error = errno;
    const png_file *file = png_get_error_ptr(png);
    snprintf(reason, sizeof reason, "%s%s", file->beginning,
             ferror(file->stream) ? strerror(error) : why);
    png_longjmp(png, 1);
}

static void png_warned(png_structp png, png_const_charp why)
{
    (void)png;
    (void)why;
}

/* These leave by a jump when something fails, or return what is wrong, or NULL. */
typedef const char *png_work(png_structp png, png_infop info, FILE *stream, picture *image);

/* What a golden picture says of itself. */
#define GOLDEN_KEY "Source"
#define GOLDEN_TEXT "surehit regress --accept"

static void put_golden(png_structp png, png_infop info)
{
    char key[] = GOLDEN_KEY, text[] = GOLDEN_TEXT;
    png_text says = {.compression = PNG_TEXT_COMPRESSION_NONE, .key = key, .text = text};
    png_set_text(png, info, &says, 1);
}

static bool is_golden(png_structp png, png_infop info)
{
    png_textp says;
    int count = 0;
    bool golden = false;
    png_get_text(png, info, &says, &count);
    for (int i = 0; i < count; i++)
        golden = golden ||
                 (strcmp(says[i].key, GOLDEN_KEY) == 0 && strcmp(says[i].text, GOLDEN_TEXT) == 0);
    return golden;
}

/* No time and no other text: the same picture is the same file. */
static const char *png_put(png_structp png, png_infop info, FILE *stream, picture *image)
{
    (void)stream;
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (image->golden)
        put_golden(png, info);
    png_write_info(png, info);
    for (size_t row = 0; row < (size_t)image->height; row++)
        png_write_row(png, image->rgb + row * 3 * (size_t)image->width);
    png_write_end(png, info);
    return NULL;
}

/* From indices, which stand at the beginning of each row. Returns what is wrong, or NULL. */
static const char *colour(png_structp png, png_infop info, picture *image)
{
    png_colorp palette = NULL;
    int count = 0;
    png_get_PLTE(png, info, &palette, &count);
    for (size_t row = 0; row < (size_t)image->height; row++) {
        uint8_t *rgb = image->rgb + row * 3 * (size_t)image->width;
        for (size_t i = (size_t)image->width; i-- > 0;) {
            if (rgb[i] >= count)
                return "has a pixel whose colour is not in its palette";
            const png_color *of = &palette[rgb[i]];
            memcpy(rgb + 3 * i, (uint8_t[]){of->red, of->green, of->blue}, 3);
        }
    }
    return NULL;
}

/* libpng takes a colour that its palette lacks for black: indices stay what they are. */
static void ask_for_bytes(png_structp png, bool indices)
{
    if (indices) {
        png_set_packing(png);
    } else {
        png_set_expand_gray_1_2_4_to_8(png);
        png_set_gray_to_rgb(png);
    }
}

/* Fewer bits and a palette are only a smaller way to write the same picture. */
static const char *png_get(png_structp png, png_infop info, FILE *stream, picture *image)
{
    png_set_sig_bytes(png, SIGNATURE);
    png_read_info(png, info);
    if (png_get_bit_depth(png, info) > 8)
        return "16 bits a channel; expected 8";
    if (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA ||
        png_get_valid(png, info, PNG_INFO_tRNS))
        return "has transparency; expected an opaque picture";
    const bool indices = png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE;
    ask_for_bytes(png, indices);
    int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    int width = (int)png_get_image_width(png, info), height = (int)png_get_image_height(png, info);
    if (!picture_new(width, height, image))
        return PICTURE_TOO_LARGE;
    for (int pass = 0; pass < passes; pass++) {
        for (size_t row = 0; row < (size_t)height; row++)
            png_read_row(png, image->rgb + row * 3 * (size_t)width, NULL);
    }
    image->golden = is_golden(png, info);
    png_read_end(png, NULL);
    const char *wrong = indices ? colour(png, info, image) : NULL;
    return wrong || getc(stream) == EOF ? wrong : PICTURE_TOO_LONG;
}

static const char *work_or_reason(png_work *work, png_structp png, png_infop info,
                                  const png_file *file, picture *image)
{
    if (!info)
        return "libpng does not start";
    if (setjmp(png_jmpbuf(png)) != 0)
        return reason;
    png_init_io(png, file->stream);
    png_set_user_limits(png, INT_MAX, INT_MAX);
    return work(png, info, file->stream, image);
}

bool picture_write_png(const picture *image, FILE *stream, const char *name, FILE *messages)
{
    png_file file = {stream, ""};
    picture written = *image;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &file, png_failed, png_warned);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    const char *wrong = work_or_reason(png_put, png, info, &file, &written);
    png_destroy_write_struct(&png, &info);
    return !wrong || complain(messages, name, "cannot be written: %s", wrong);
}

const char *picture_read_png(FILE *stream, picture *out)
{
    png_file file = {stream, "not a whole PNG: "};
    picture read = {.rgb = NULL};
    uint8_t start[SIGNATURE] = {0x89};
    size_t got = fread(start + 1, 1, SIGNATURE - 1, stream);
    if (got < SIGNATURE - 1 || png_sig_cmp(start, 0, SIGNATURE) != 0)
        return PICTURE_NEITHER;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &file, png_failed, png_warned);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    const char *wrong = work_or_reason(png_get, png, info, &file, &read);
    png_destroy_read_struct(&png, &info, NULL);
    if (!wrong)
        *out = read;
    else
        picture_free(&read);
    return wrong == reason && feof(stream) ? PICTURE_TOO_SHORT : wrong;
}
