/* Pictures from files. The kind is told by the first bytes, without going back, so that a pipe can
 * be read as well. */
#include "picture.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <string.h>

#ifdef SUREHIT_PNG
#include <png.h>
#endif

#define NEITHER "neither a PNG nor a P6 PPM"
#define TOO_SHORT "ends before the picture does"
#define TOO_LONG "bytes after the end of the picture"
#define TOO_LARGE "no memory for a picture of this size"

/* Each reader returns NULL and the picture, or what is wrong (perhaps in `room`); then nothing is
 * left allocated. */
#define ROOM 128

/* The first character behind blanks and comments, which begin with # and end with the line. */
static int skip_blanks(FILE *stream)
{
    bool comment = false;
    for (;;) {
        int c = getc(stream);
        if (c == '#')
            comment = true;
        else if (c == '\n' || c == '\r')
            comment = false;
        else if (c == EOF || (!comment && !isspace(c)))
            return c;
    }
}

/* A whole number after blanks, with the one blank that ends it; -1 for anything else. */
static int read_number(FILE *stream)
{
    int c = skip_blanks(stream), number = 0;
    if (!isdigit(c))
        return -1;
    for (; isdigit(c); c = getc(stream)) {
        int digit = c - '0';
        if (number > (INT_MAX - digit) / 10)
            return -1;
        number = 10 * number + digit;
    }
    return isspace(c) ? number : -1;
}

/* Behind "P6". */
static const char *read_ppm(FILE *stream, picture *out)
{
    bool blank = isspace(getc(stream));
    int width = blank ? read_number(stream) : -1, height = blank ? read_number(stream) : -1;
    if (width < 1 || height < 1 || read_number(stream) != 255)
        return "not a P6 PPM of 255 levels";
    picture image;
    if (!picture_new(width, height, &image))
        return TOO_LARGE;
    size_t size = 3 * (size_t)width * (size_t)height;
    bool whole = fread(image.rgb, 1, size, stream) == size;
    if (whole && getc(stream) == EOF && !ferror(stream)) {
        *out = image;
        return NULL;
    }
    picture_free(&image);
    return whole ? TOO_LONG : TOO_SHORT;
}

#ifdef SUREHIT_PNG
#define SIGNATURE 8

typedef struct {
    char *reason; /* for a jump; of ROOM bytes */
    picture image;
} png_reading;

static void png_failed(png_structp png, png_const_charp reason)
{
    png_reading *to = png_get_error_ptr(png);
    snprintf(to->reason, ROOM, "not a whole PNG: %s", reason);
    png_longjmp(png, 1);
}

static void png_warned(png_structp png, png_const_charp reason)
{
    (void)png;
    (void)reason;
}

/* Leaves by a jump when libpng finds something wrong. Fewer bits and a palette are only a smaller
 * way to write the same picture. */
static const char *png_get(png_structp png, png_infop info, FILE *stream, picture *image)
{
    png_init_io(png, stream);
    png_set_sig_bytes(png, SIGNATURE);
    png_set_user_limits(png, INT_MAX, INT_MAX);
    png_read_info(png, info);
    if (png_get_bit_depth(png, info) > 8)
        return "16 bits a channel; expected 8";
    if (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA ||
        png_get_valid(png, info, PNG_INFO_tRNS))
        return "has transparency; expected an opaque picture";
    png_set_palette_to_rgb(png);
    png_set_expand_gray_1_2_4_to_8(png);
    png_set_gray_to_rgb(png);
    int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    int width = (int)png_get_image_width(png, info), height = (int)png_get_image_height(png, info);
    if (!picture_new(width, height, image))
        return TOO_LARGE;
    for (int pass = 0; pass < passes; pass++) {
        for (size_t row = 0; row < (size_t)height; row++)
            png_read_row(png, image->rgb + row * 3 * (size_t)width, NULL);
    }
    png_read_end(png, NULL);
    return getc(stream) == EOF ? NULL : TOO_LONG;
}

static const char *png_get_or_reason(png_structp png, png_infop info, FILE *stream, png_reading *to)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return feof(stream) ? TOO_SHORT : to->reason;
    return png_get(png, info, stream, &to->image);
}

/* Behind the first byte. */
static const char *read_png(FILE *stream, char room[ROOM], picture *out)
{
    png_reading to = {.reason = room};
    uint8_t start[SIGNATURE] = {0x89};
    size_t got = fread(start + 1, 1, SIGNATURE - 1, stream);
    if (got < SIGNATURE - 1 || png_sig_cmp(start, 0, SIGNATURE) != 0)
        return NEITHER;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &to, png_failed, png_warned);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    const char *wrong = info ? png_get_or_reason(png, info, stream, &to) : "libpng does not start";
    png_destroy_read_struct(&png, &info, NULL);
    if (wrong)
        picture_free(&to.image);
    else
        *out = to.image;
    return wrong;
}
#else
static const char *read_png(FILE *stream, char room[ROOM], picture *out)
{
    (void)stream;
    (void)room;
    (void)out;
    return "this build reads no PNG";
}
#endif

static const char *read_either(FILE *stream, char room[ROOM], picture *out)
{
    int first = getc(stream);
    if (first == 0x89)
        return read_png(stream, room, out);
    return first == 'P' && getc(stream) == '6' ? read_ppm(stream, out) : NEITHER;
}

bool picture_read(const char *path, FILE *messages, picture *out)
{
    char room[ROOM];
    FILE *stream = fopen(path, "rb");
    const char *wrong = stream ? read_either(stream, room, out) : strerror(errno);
    if (stream && wrong && ferror(stream))
        wrong = strerror(errno);
    if (wrong)
        fprintf(messages, "%s: error: %s\n", path, wrong);
    if (stream)
        fclose(stream);
    return !wrong;
}
