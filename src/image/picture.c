#define _POSIX_C_SOURCE 200809L /* strcasecmp */

#include "picture.h"
#include "../support/atomic_file.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#ifdef SUREHIT_PNG
#include <png.h>
#endif

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
    fprintf(messages, "%s: error: cannot be written: %s\n", file->path, strerror(errno));
    return false;
}

#ifdef SUREHIT_PNG
typedef struct {
    FILE *stream;
    const char *name;
    FILE *messages;
} png_place;

static void png_failed(png_structp png, png_const_charp reason)
{
    int error = errno;
    const png_place *place = png_get_error_ptr(png);
    fprintf(place->messages, "%s: error: cannot be written: %s\n", place->name,
            ferror(place->stream) ? strerror(error) : reason);
    png_longjmp(png, 1);
}

static void png_warned(png_structp png, png_const_charp reason)
{
    (void)png;
    (void)reason;
}

/* Leaves by a jump when something fails. No time and no text: the same picture is the same file. */
static void png_put(png_structp png, png_infop info, const picture *image, FILE *stream)
{
    png_init_io(png, stream);
    png_set_user_limits(png, INT_MAX, INT_MAX);
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (size_t row = 0; row < (size_t)image->height; row++)
        png_write_row(png, image->rgb + row * 3 * (size_t)image->width);
    png_write_end(png, info);
}

static bool png_put_or_return(png_structp png, png_infop info, const picture *image, FILE *stream)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_put(png, info, image, stream);
    return true;
}

bool picture_write_png(const picture *image, FILE *stream, const char *name, FILE *messages)
{
    png_place place = {stream, name, messages};
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &place, png_failed, png_warned);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    bool written = false;
    if (info)
        written = png_put_or_return(png, info, image, stream);
    else
        fprintf(messages, "%s: error: cannot be written: libpng does not start\n", name);
    png_destroy_write_struct(&png, &info);
    return written;
}

static bool write_png(const picture *image, atomic_file *file, FILE *messages)
{
    return picture_write_png(image, file->stream, file->path, messages);
}
#else
bool picture_write_png(const picture *image, FILE *stream, const char *name, FILE *messages)
{
    (void)image;
    (void)stream;
    fprintf(messages, "%s: error: this build writes no PNG\n", name);
    return false;
}

#define write_png NULL
#endif

typedef bool picture_writer(const picture *image, atomic_file *file, FILE *messages);

static const struct {
    const char *ending;
    picture_writer *write; /* NULL: not in this build */
} formats[] = {{".ppm", write_ppm}, {".png", write_png}};

static bool ends_with(const char *path, const char *ending)
{
    size_t length = strlen(path), size = strlen(ending);
    return length >= size && strcasecmp(path + length - size, ending) == 0;
}

/* NULL after a line to `messages`. */
static picture_writer *writer_for(const char *path, FILE *messages)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (!ends_with(path, formats[i].ending))
            continue;
        if (!formats[i].write)
            fprintf(messages, "%s: error: this build writes no PNG; expected a name in .ppm\n",
                    path);
        return formats[i].write;
    }
    fprintf(messages, "%s: error: unknown kind of picture; expected a name in .ppm or .png\n",
            path);
    return NULL;
}

bool picture_path_ok(const char *path, FILE *messages)
{
    return writer_for(path, messages) != NULL;
}

bool picture_write(const picture *image, const char *path, FILE *messages)
{
    picture_writer *write = writer_for(path, messages);
    atomic_file file;
    if (!write || !atomic_file_open(path, messages, &file))
        return false;
    if (write(image, &file, messages))
        return atomic_file_finish(&file, messages);
    atomic_file_discard(&file);
    return false;
}
