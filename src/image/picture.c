#include "picture.h"
#include "../support/atomic_file.h"
#include "../support/complain.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

bool picture_new(int width, int height, picture *out)
{
    if (width < 1 || height < 1 || (size_t)height > PTRDIFF_MAX / 3 / (size_t)width)
        return false;
    uint8_t *rgb = calloc((size_t)height, 3 * (size_t)width);
    if (rgb)
        *out = (picture){width, height, rgb};
    return rgb != NULL;
}

void picture_free(picture *image)
{
    free(image->rgb);
    image->rgb = NULL;
}

static bool write_ppm(const picture *image, atomic_file *file, FILE *messages)
{
    size_t size = 3 * (size_t)image->width * (size_t)image->height;
    if (fprintf(file->stream, "P6\n%d %d\n255\n", image->width, image->height) >= 0 &&
        fwrite(image->rgb, 1, size, file->stream) == size)
        return true;
    return complain(messages, file->path, "cannot be written: %s", strerror(errno));
}

static bool ends_with(const char *path, const char *ending)
{
    size_t length = strlen(path), size = strlen(ending);
    return length >= size && strcasecmp(path + length - size, ending) == 0;
}

bool picture_has_name(const char *path)
{
    return ends_with(path, ".png") || ends_with(path, ".ppm");
}

bool picture_path_ok(const char *path, FILE *messages)
{
    return picture_has_name(path) ||
           complain(messages, path, "unknown kind of picture; expected a name in .ppm or .png");
}

bool picture_write(const picture *image, const char *path, FILE *messages)
{
    atomic_file file;
    if (!picture_path_ok(path, messages) || !atomic_file_open(path, messages, &file))
        return false;
    if (ends_with(path, ".png") ? picture_write_png(image, file.stream, path, messages)
                                : write_ppm(image, &file, messages))
        return atomic_file_finish(&file, messages);
    atomic_file_discard(&file);
    return false;
}

/* Reading: the kind is told by the first bytes, without going back, so that a pipe can be read as
 * well. */

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
        return PICTURE_TOO_LARGE;
    size_t size = 3 * (size_t)width * (size_t)height;
    bool whole = fread(image.rgb, 1, size, stream) == size;
    if (whole && getc(stream) == EOF && !ferror(stream)) {
        *out = image;
        return NULL;
    }
    picture_free(&image);
    return whole ? PICTURE_TOO_LONG : PICTURE_TOO_SHORT;
}

static const char *read_either(FILE *stream, picture *out)
{
    int first = getc(stream);
    if (first == 0x89)
        return picture_read_png(stream, out);
    return first == 'P' && getc(stream) == '6' ? read_ppm(stream, out) : PICTURE_NEITHER;
}

bool picture_read(const char *path, FILE *messages, picture *out)
{
    FILE *stream = fopen(path, "rb");
    const char *wrong = stream ? read_either(stream, out) : strerror(errno);
    if (stream && wrong && ferror(stream))
        wrong = strerror(errno);
    if (stream)
        fclose(stream);
    return !wrong || complain(messages, path, "%s", wrong);
}
