/* SPDX-License-Identifier: MIT */
#include "picture.h"
#include "../support/atomic_file.h"
#include "../support/complain.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

bool picture_new(int width, int height, picture *out)
{
    if (width < 1 || height < 1 || (size_t)height > PTRDIFF_MAX / 3 / (size_t)width)
        return false;
    uint8_t *rgb = calloc((size_t)height, 3 * (size_t)width);
    if (rgb)
        *out = (picture){width, height, rgb, false};
    return rgb != NULL;
}

void picture_free(picture *image)
{
    free(image->rgb);
    image->rgb = NULL;
}

bool picture_is_black(const picture *image)
{
    const size_t size = 3 * (size_t)image->width * (size_t)image->height;
    size_t i = 0;
    while (i < size && image->rgb[i] == 0)
        i++;
    return i == size;
}

static bool write_ppm(const picture *image, FILE *stream, const char *name, FILE *messages)
{
    size_t size = 3 * (size_t)image->width * (size_t)image->height;
    if (fprintf(stream, "P6\n%d %d\n255\n", image->width, image->height) >= 0 &&
        fwrite(image->rgb, 1, size, stream) == size && fflush(stream) == 0)
        return true;
    return complain(messages, name, "cannot be written: %s", strerror(errno));
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

bool picture_is_stdout(const char *path)
{
    return strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0;
}

static bool is_pipe(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISFIFO(about.st_mode);
}

bool picture_path_ok(const char *path, FILE *messages)
{
    return picture_has_name(path) || picture_is_stdout(path) || is_pipe(path) ||
           complain(messages, path, "unknown kind of picture; expected a name in .ppm or .png");
}

bool picture_is_other(const char *path, const char *what, FILE *messages)
{
    if (path && strcmp(path, "-") == 0)
        return complain(messages, path, "a %s is written to a file that has a name", what);
    return !path || !picture_has_name(path) ||
           complain(messages, path, "a %s may not have a picture's name", what);
}

bool picture_write(const picture *image, const char *path, FILE *messages)
{
    atomic_file file;
    if (picture_is_stdout(path))
        return write_ppm(image, stdout, path, messages);
    if (!picture_path_ok(path, messages) || !atomic_file_open(path, messages, &file))
        return false;
    if (ends_with(path, ".png") ? picture_write_png(image, file.stream, path, messages)
                                : write_ppm(image, file.stream, path, messages))
        return atomic_file_finish(&file, messages);
    atomic_file_discard(&file);
    return false;
}

/* Reading: the kind is told by the first bytes, without going back, so that a pipe can be read as
 * well. */

/* A whole number after blanks and comments, which begin with # and end with the line,
 * with the one blank that ends it; -1 for anything else. */
static int read_number(FILE *stream)
{
    char mark[2], digits[11] = "";
    while (fscanf(stream, " %1[#]", mark) == 1)
        (void)!fscanf(stream, "%*[^\n\r]");
    bool read = fscanf(stream, "%10[0-9]", digits) == 1 && isspace(getc(stream));
    unsigned long number = strtoul(digits, NULL, 10);
    return read && number <= INT_MAX ? (int)number : -1;
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
