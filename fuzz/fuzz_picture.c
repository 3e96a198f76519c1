/* The picture's writers: what is written is read back by others, to the byte, and what can't be
 * written leaves nothing behind and what was there untouched. */
#define _XOPEN_SOURCE 700 /* mkdtemp, open_memstream */

#include "fuzz.h"

#include "picture.h"

#include <dirent.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef SUREHIT_PNG
#include <png.h>
#endif

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

const char fuzz_name[] = "picture";
size_t (*const fuzz_mutator)(uint8_t *, size_t, size_t, unsigned) = NULL;

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

/* Calls `visit` for all in the folder and counts it. */
static int each_entry(int (*visit)(const char *path))
{
    DIR *all = opendir(folder);
    int count = 0;
    if (!all)
        abort();
    for (const struct dirent *entry; (entry = readdir(all));) {
        char path[sizeof folder + sizeof entry->d_name];
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        count++;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (visit)
            visit(path);
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

static void find(const trial *t, const char *law)
{
    char what[200];
    snprintf(what, sizeof what, "%s: %dx%d: %s", t->png ? "PNG" : "PPM", t->image.width,
             t->image.height, law);
    each_entry(remove);
    remove_folder();
    fuzz_find(what, t->said);
}

static void expect(bool holds, const trial *t, const char *law)
{
    if (!holds)
        find(t, law);
}

static bool write_picture(trial *t)
{
    free(t->said);
    t->said = NULL;
    FILE *messages = open_memstream(&t->said, &t->said_size);
    if (!messages)
        abort();
    LIBPNG_BEGINS();
    bool written = picture_write(&t->image, t->path, messages);
    LIBPNG_ENDS();
    fclose(messages);
    return written;
}

static void write_well(trial *t)
{
    expect(write_picture(t), t, "a picture can't be written");
    expect(t->said_size == 0, t, "something is said about a picture that is written");
}

/* One line that names the file. */
static void write_badly(trial *t)
{
    size_t length = strlen(t->path);
    expect(!write_picture(t), t, "what can't be written is written");
    expect(strncmp(t->said, t->path, length) == 0 &&
               strncmp(t->said + length, ": error: ", 9) == 0 && t->said_size > length + 12 &&
               strchr(t->said, '\n') == t->said + t->said_size - 1,
           t, "a complaint that is not one line about the file");
}

/* Files. */

static uint8_t *contents(const trial *t, const char *path, size_t *size)
{
    static uint8_t room[2 * LARGEST];
    FILE *file = fopen(path, "rb");
    expect(file != NULL, t, "there is no file");
    *size = fread(room, 1, sizeof room, file);
    fclose(file);
    expect(*size < sizeof room, t, "the file is too large");
    return room;
}

static void put(const trial *t, const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
        find(t, "the test itself can't write a file");
}

static const char old[] = "what was there";

static void check_old(const trial *t, const char *path)
{
    size_t size;
    const uint8_t *found = contents(t, path, &size);
    expect(size == sizeof old && memcmp(found, old, size) == 0, t, "the old file is changed");
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
    const uint8_t *found = contents(t, t->path, &size);
    size_t length =
        (size_t)snprintf(head, sizeof head, "P6\n%d %d\n255\n", t->image.width, t->image.height);
    expect(size == length + pixel_bytes(&t->image) && memcmp(found, head, length) == 0 &&
               memcmp(found + length, t->image.rgb, size - length) == 0,
           t, "not the picture's bytes");
}

/* By the library's own reader, which refuses a byte less and a byte more. */
static void check_ppm_reader(trial *t, int more)
{
    picture back = {0};
    size_t size;
    uint8_t *found = contents(t, t->path, &size);
    found[size] = 0;
    if (more != 0)
        put(t, t->path, found, size + (size_t)more);
    free(t->said);
    t->said = NULL;
    FILE *messages = open_memstream(&t->said, &t->said_size);
    if (!messages)
        abort();
    bool read = picture_read(t->path, messages, &back);
    fclose(messages);
    expect(read == (more == 0), t, more == 0 ? "it can't be read" : "another length is read");
    expect((t->said_size == 0) == read, t, "a reader that says nothing, or too much");
    expect(!read || (back.width == t->image.width && back.height == t->image.height &&
                     memcmp(back.rgb, t->image.rgb, pixel_bytes(&back)) == 0),
           t, "another picture is read");
    expect(read || !back.rgb, t, "a picture that is refused is written");
    if (read)
        picture_free(&back);
}

#ifdef SUREHIT_PNG
static void check_png(const trial *t)
{
    size_t size;
    const uint8_t *found = contents(t, t->path, &size);
    png_image back = {.version = PNG_IMAGE_VERSION};
    LIBPNG_BEGINS();
    int begun = png_image_begin_read_from_memory(&back, found, size);
    BY_LIBPNG(&back, sizeof back);
    expect(begun, t, "libpng can't read it");
    expect(back.format == PNG_FORMAT_RGB && back.warning_or_error == 0 &&
               (int)back.width == t->image.width && (int)back.height == t->image.height,
           t, "libpng reads another format or size");
    static uint8_t rgb[LARGEST];
    int finished = png_image_finish_read(&back, NULL, rgb, 0, NULL);
    LIBPNG_ENDS();
    expect(finished, t, "libpng can't read its pixels");
    BY_LIBPNG(rgb, sizeof rgb);
    expect(memcmp(rgb, t->image.rgb, pixel_bytes(&t->image)) == 0, t, "libpng reads other pixels");
}
#endif

static void check_file(const trial *t)
{
#ifdef SUREHIT_PNG
    if (t->png) {
        check_png(t);
        return;
    }
#endif
    check_ppm(t);
}

/* What may be in the way. */

static void write_anew(trial *t, uint8_t how)
{
    write_well(t);
    check_file(t);
    if (!t->png)
        check_ppm_reader(t, how % 4 == 1 ? 1 : how % 4 == 2 ? -1 : 0);
    expect(each_entry(NULL) == 1, t, "something else is left");
}

static void write_over(trial *t)
{
    put(t, t->path, old, sizeof old);
    write_well(t);
    check_file(t);
    expect(each_entry(NULL) == 1, t, "something else is left");
}

static void write_through_link(trial *t)
{
    char target[PATH];
    snprintf(target, sizeof target, "%s/old", folder);
    put(t, target, old, sizeof old);
    if (symlink("old", t->path) != 0)
        abort();
    write_well(t);
    check_file(t);
    struct stat about;
    expect(lstat(t->path, &about) == 0 && S_ISLNK(about.st_mode), t, "the link is replaced");
    expect(each_entry(NULL) == 2, t, "something else is left");
}

/* A limit that the file reaches, or not, or just so. */
static void write_within(trial *t, uint8_t how, size_t limit)
{
    bool exists = how & 1;
    struct rlimit before, least;
    if (exists)
        put(t, t->path, old, sizeof old);
    if (getrlimit(RLIMIT_FSIZE, &before) != 0)
        abort();
    least = before;
    least.rlim_cur = limit;
    setrlimit(RLIMIT_FSIZE, &least);
    bool written = write_picture(t);
    setrlimit(RLIMIT_FSIZE, &before);
    if (written) {
        check_file(t);
    } else {
        expect(t->said_size > 0, t, "a failure without a word");
        if (exists)
            check_old(t, t->path);
    }
    expect(each_entry(NULL) == (written || exists), t, "a part of the picture is left");
    size_t size = 0;
    if (written)
        contents(t, t->path, &size);
    expect(size <= limit, t, "more is written than may be");
}

static void write_where_it_cannot_be(trial *t, uint8_t how)
{
    static const char *const places[] = {"%s/missing/a.%s", "%s/a.%s/", "%s/a.%s.txt", "%s/%s"};
    enum { PLACES = sizeof places / sizeof *places };
    const char *ending = t->png ? "png" : "ppm";
    if (how % (PLACES + 1) < PLACES) {
        snprintf(t->path, sizeof t->path, places[how % (PLACES + 1)], folder, ending);
        write_badly(t);
        expect(each_entry(NULL) == 0, t, "something is left");
        return;
    }
    if (mkdir(t->path, 0777) != 0) /* a folder of that name */
        abort();
    write_badly(t);
    expect(rmdir(t->path) == 0, t, "the folder is not as it was");
}

/* A device is never replaced; one that is full is not written to either. */
static void write_to_device(trial *t)
{
    struct stat about;
    if (symlink("/dev/full", t->path) != 0)
        abort();
    write_badly(t);
    expect(stat(t->path, &about) == 0 && S_ISCHR(about.st_mode), t, "the device is replaced");
    expect(each_entry(NULL) == 1, t, "something is left");
}

static void compare(trial *t, fuzz_bytes *bytes, uint8_t how)
{
    switch (how % 8) {
    case 0: write_over(t); break;
    case 1: write_through_link(t); break;
    case 2: write_within(t, fuzz_byte(bytes), fuzz_byte(bytes)); break;
    case 3: write_within(t, 0, (size_t)fuzz_byte(bytes) * 64); break;
    case 4: write_where_it_cannot_be(t, fuzz_byte(bytes)); break;
    case 5: write_to_device(t); break;
    default: write_anew(t, fuzz_byte(bytes));
    }
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

/* What the trials have named; that there is nothing else they have seen to. */
static void clean_up(const trial *t)
{
    char target[PATH];
    snprintf(target, sizeof target, "%s/old", folder);
    unlink(t->path);
    unlink(target);
}

bool fuzz_target(const uint8_t *data, size_t size)
{
    fuzz_bytes bytes = {data, size, false};
    uint8_t how = fuzz_byte(&bytes);
    trial t = {.png = false};
#ifdef SUREHIT_PNG
    t.png = how & 8;
#endif
    if (folder[0] == '\0')
        make_folder();
    if (!read_picture(&bytes, &t.image))
        return false;
    snprintf(t.path, sizeof t.path, "%s/a.%s", folder, t.png ? "png" : "PPM");
    compare(&t, &bytes, how);
    clean_up(&t);
    picture_free(&t.image);
    free(t.said);
    return true;
}
