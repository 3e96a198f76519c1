/* SPDX-License-Identifier: MIT */
/* The picture's writers: what is written is read back by others, to the byte, and what can't be
 * written leaves nothing behind and what was there untouched. tests/image/test_picture.c has the
 * places where no picture can be. */
#define _XOPEN_SOURCE 700 /* mkdtemp, open_memstream */

#include "fuzz.h"

#include "picture.h"

#include <dirent.h>
#include <limits.h>
#include <sys/resource.h>
#include <unistd.h>

#include <png.h>

/* libpng is not compiled for the sanitizer, which does not see what it writes: so it is told, and
 * does not look at what libpng hands to zlib and to the C library. */
#if defined __has_feature
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#define BY_LIBPNG(place, size) __msan_unpoison(place, size)
#define LIBPNG_BEGINS() __msan_scoped_disable_interceptor_checks()
#define LIBPNG_ENDS() __msan_scoped_enable_interceptor_checks()
#endif
#endif
#ifndef BY_LIBPNG
#define BY_LIBPNG(place, size) ((void)(place), (void)(size))
#define LIBPNG_BEGINS() ((void)0)
#define LIBPNG_ENDS() ((void)0)
#endif

FUZZ_TARGET("picture", NULL)

/* A folder of its own, removed at the end; between two executions it is empty. */
static char folder[64];

enum { PATH = 128, LARGEST = 3 * 16 * 16 * 200 };

static void remove_folder(void)
{
    rmdir(folder);
}

static void make_folder(void)
{
    static const char *const homes[] = {"/dev/shm", "/tmp", "."};
    for (size_t i = 0; i < sizeof homes / sizeof *homes && folder[0] == '\0'; i++) {
        snprintf(folder, sizeof folder, "%s/fuzz_picture.XXXXXX", homes[i]);
        if (!mkdtemp(folder))
            folder[0] = '\0';
    }
    if (folder[0] == '\0' || atexit(remove_folder) != 0)
        abort();
}

/* How many are in the folder. */
static int entries(bool removed)
{
    DIR *all = opendir(folder);
    int count = -2; /* . and .. */
    if (!all)
        abort();
    for (const struct dirent *entry; (entry = readdir(all)); count++) {
        if (removed)
            unlinkat(dirfd(all), entry->d_name, 0);
    }
    closedir(all);
    return count;
}

typedef struct {
    char path[PATH];
    bool png;
    picture image;
    char *said;
    size_t said_size;
} trial;

static void expect_of(const trial *t, bool holds, const char *law)
{
    char what[200];
    if (holds)
        return;
    snprintf(what, sizeof what, "%s: %dx%d: %s", t->png ? "PNG" : "PPM", t->image.width,
             t->image.height, law);
    entries(true);
    remove_folder();
    fuzz_find(what, t->said);
}

static FILE *listen(trial *t)
{
    free(t->said);
    t->said = NULL;
    FILE *messages = open_memstream(&t->said, &t->said_size);
    if (!messages)
        abort();
    return messages;
}

static bool write_picture(trial *t)
{
    FILE *messages = listen(t);
    LIBPNG_BEGINS();
    bool written = picture_write(&t->image, t->path, messages);
    LIBPNG_ENDS();
    fclose(messages);
    expect_of(t, (t->said_size == 0) == written, "a failure without a word, or a word too much");
    return written;
}

/* Files. */

static uint8_t *contents(const trial *t, size_t *size)
{
    static uint8_t room[2 * LARGEST];
    FILE *file = fopen(t->path, "rb");
    expect_of(t, file != NULL, "there is no file");
    *size = fread(room, 1, sizeof room, file);
    fclose(file);
    expect_of(t, *size < sizeof room, "the file is too large");
    return room;
}

static void put(const trial *t, const void *bytes, size_t size)
{
    FILE *file = fopen(t->path, "wb");
    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
        abort();
}

static size_t pixel_bytes(const picture *image)
{
    return 3 * (size_t)image->width * (size_t)image->height;
}

/* P6, one line each of numbers, and the pixels: nothing else. */
static void check_ppm(const trial *t)
{
    size_t size;
    char head[64];
    const uint8_t *found = contents(t, &size);
    size_t length =
        (size_t)snprintf(head, sizeof head, "P6\n%d %d\n255\n", t->image.width, t->image.height);
    expect_of(t,
              size == length + pixel_bytes(&t->image) && memcmp(found, head, length) == 0 &&
                  memcmp(found + length, t->image.rgb, size - length) == 0,
              "not the picture's bytes");
}

/* By the library's own reader, which refuses a byte less and a byte more. */
static void check_ppm_reader(trial *t, int more)
{
    picture back = {0};
    size_t size;
    uint8_t *found = contents(t, &size);
    found[size] = 0;
    if (more != 0)
        put(t, found, size + (size_t)more);
    FILE *messages = listen(t);
    bool read = picture_read(t->path, messages, &back);
    fclose(messages);
    expect_of(t, read == (more == 0), more == 0 ? "it can't be read" : "another length is read");
    expect_of(t, (t->said_size == 0) == read, "a reader that says nothing, or too much");
    expect_of(t,
              !read || (back.width == t->image.width && back.height == t->image.height &&
                        memcmp(back.rgb, t->image.rgb, pixel_bytes(&back)) == 0),
              "another picture is read");
    expect_of(t, read || !back.rgb, "a picture that is refused is written");
    if (read)
        picture_free(&back);
}

static void check_png(const trial *t)
{
    size_t size;
    const uint8_t *found = contents(t, &size);
    png_image back = {.version = PNG_IMAGE_VERSION};
    LIBPNG_BEGINS();
    int begun = png_image_begin_read_from_memory(&back, found, size);
    BY_LIBPNG(&back, sizeof back);
    expect_of(t, begun, "libpng can't read it");
    expect_of(t,
              back.format == PNG_FORMAT_RGB && back.warning_or_error == 0 &&
                  (int)back.width == t->image.width && (int)back.height == t->image.height,
              "libpng reads another format or size");
    static uint8_t rgb[LARGEST];
    int finished = png_image_finish_read(&back, NULL, rgb, 0, NULL);
    LIBPNG_ENDS();
    expect_of(t, finished, "libpng can't read its pixels");
    BY_LIBPNG(rgb, sizeof rgb);
    expect_of(t, memcmp(rgb, t->image.rgb, pixel_bytes(&t->image)) == 0,
              "libpng reads other pixels");
}

static void write_anew(trial *t, uint8_t how)
{
    expect_of(t, write_picture(t), "a picture can't be written");
    (t->png ? check_png : check_ppm)(t);
    if (!t->png)
        check_ppm_reader(t, how % 4 == 1 ? 1 : how % 4 == 2 ? -1 : 0);
    expect_of(t, entries(false) == 1, "something else is left");
}

/* A limit that the file reaches, or not, or just so; over what was there, or nothing. */
static void write_within(trial *t, bool exists, size_t limit)
{
    static const char old[] = "what was there";
    struct rlimit before, least;
    size_t size = 0;
    if (exists)
        put(t, old, sizeof old);
    if (getrlimit(RLIMIT_FSIZE, &before) != 0)
        abort();
    least = before;
    least.rlim_cur = limit;
    setrlimit(RLIMIT_FSIZE, &least);
    bool written = write_picture(t);
    setrlimit(RLIMIT_FSIZE, &before);
    expect_of(t, entries(false) == (written || exists), "a part of the picture is left");
    const uint8_t *found = written || exists ? contents(t, &size) : NULL;
    if (written)
        (t->png ? check_png : check_ppm)(t);
    else if (exists)
        expect_of(t, size == sizeof old && memcmp(found, old, size) == 0,
                  "the old file is changed");
    expect_of(t, !written || size <= limit, "more is written than may be");
}

/* Small, or wide or high; in each row the bytes that are left, again and again, plus a step, so
 * that a few bytes give any size something to hold. */
static bool read_picture(fuzz_bytes *bytes, picture *image)
{
    uint8_t how = fuzz_byte(bytes), step = fuzz_byte(bytes);
    int width = 1 + fuzz_byte(bytes) % 16, height = 1 + fuzz_byte(bytes) % 16;
    if (how % 16 == 2)
        width *= 200;
    if (!picture_new(how & 1 ? height : width, how & 1 ? width : height, image))
        return false;
    size_t row_size = 3 * (size_t)image->width;
    for (size_t i = 0; bytes->left > 0 && i < pixel_bytes(image); i += bytes->left) {
        size_t rest = pixel_bytes(image) - i;
        memcpy(image->rgb + i, bytes->at, bytes->left < rest ? bytes->left : rest);
    }
    for (int row = 0; row < image->height; row++)
        image->rgb[(size_t)row * row_size] = (uint8_t)(row * step);
    return true;
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t how = fuzz_byte(&bytes);
    trial t = {.png = how & 8};
    if (folder[0] == '\0')
        make_folder();
    if (!read_picture(&bytes, &t.image))
        return false;
    snprintf(t.path, sizeof t.path, "%s/a.%s", folder, t.png ? "png" : "PPM");
    if (how % 8 == 2)
        write_within(&t, fuzz_byte(&bytes) & 1, fuzz_byte(&bytes));
    else if (how % 8 == 3)
        write_within(&t, false, (size_t)fuzz_byte(&bytes) * 64);
    else
        write_anew(&t, fuzz_byte(&bytes));
    unlink(t.path);
    picture_free(&t.image);
    free(t.said);
    return true;
}
