/* SPDX-License-Identifier: MIT */
/* Pictures in files: what is written, what is read, and what becomes of the file that was there.
 * test_cli.py has the places where a picture may be. */
#define _XOPEN_SOURCE 700

#include "../../src/image/picture.h"
#include "../../src/support/atomic_file.h"
#include "../support/files.h"

#include <limits.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

static void assert_silent(FILE *messages)
{
    fclose(messages);
    ck_assert_str_eq(heard, "");
}

/* Every byte value occurs, and no two neighbours are alike. */
static picture colorful(int width, int height)
{
    picture image;
    ck_assert(picture_new(width, height, &image));
    for (size_t i = 0; i < 3 * (size_t)width * (size_t)height; i++)
        image.rgb[i] = (uint8_t)(97 * i + i / 256);
    return image;
}

static void write_well(const picture *image, const char *path)
{
    FILE *messages = listen();
    ck_assert_msg(picture_write(image, path, messages), "%s", path);
    assert_silent(messages);
}

static void assert_reads(const char *path, const picture *image)
{
    FILE *messages = listen();
    FREED_BY(picture_free) picture back;
    ck_assert(picture_read(path, messages, &back));
    assert_silent(messages);
    ck_assert_int_eq(back.width, image->width);
    ck_assert_int_eq(back.height, image->height);
    ck_assert_mem_eq(back.rgb, image->rgb, 3 * (size_t)image->width * (size_t)image->height);
}

TEST(any_value_is_seen)
{
    FREED_BY(picture_free) picture image;
    ck_assert(picture_new(5, 3, &image));
    for (int i = 0; i < 3 * 5 * 3; i++) {
        ck_assert(picture_is_black(&image));
        image.rgb[i] = 1;
        ck_assert(!picture_is_black(&image));
        image.rgb[i] = 0;
    }
}

TEST(a_new_picture_is_black)
{
    FREED_BY(picture_free) picture image;
    ck_assert(picture_new(5, 3, &image));
    ck_assert_int_eq(image.width, 5);
    ck_assert_int_eq(image.height, 3);
    for (int i = 0; i < 45; i++)
        ck_assert_uint_eq(image.rgb[i], 0);
}

TEST(impossible_sizes_are_refused)
{
    static const int sizes[][2] = {{0, 1}, {1, 0}, {-1, -1}, {INT_MIN, 1}, {INT_MAX, INT_MAX}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        picture image = {.width = 7, .height = 7};
        ck_assert(!picture_new(sizes[i][0], sizes[i][1], &image));
        ck_assert_int_eq(image.width, 7);
    }
}

TEST(ppm_bytes)
{
    uint8_t rgb[] = {0, 10, 255, 13, 32, 128, 1, 2, 3, 35, 80, 54};
    const picture image = {.width = 2, .height = 2, .rgb = rgb};
    write_well(&image, "a.ppm");
    assert_holds("a.ppm", "P6\n2 2\n255\n\x00\x0a\xff\x0d\x20\x80\x01\x02\x03\x23\x50\x36", 23);
}

static const int round_trips[][2] = {{1, 1}, {1, 300}, {300, 1}, {257, 3}, {64, 64}};
enum { TRIPS = sizeof round_trips / sizeof *round_trips };

LOOP_TEST(round_trip, TRIPS)
{
    FREED_BY(picture_free) picture image = colorful(round_trips[_i][0], round_trips[_i][1]);
    write_well(&image, "a.ppm");
    assert_reads("a.ppm", &image);
    write_well(&image, "a.png");
    assert_reads("a.png", &image);
}

/* In any case. */
TEST(the_name_tells_the_kind)
{
    static const char *const names[] = {"a.PNG", "a.pNg", "a.PPM", "a.pPm"};
    FREED_BY(picture_free) picture image = colorful(3, 2);
    for (int i = 0; i < 4; i++) {
        size_t size;
        ck_assert(picture_has_name(names[i]));
        write_well(&image, names[i]);
        uint8_t *bytes = get(names[i], &size);
        ck_assert_mem_eq(bytes, i < 2 ? "\x89P" : "P6", 2);
        free(bytes);
    }
}

/* Size, 8 bits of RGB, the data and the end: nothing that tells when or by whom. */
TEST(png_holds_nothing_but_the_picture)
{
    FREED_BY(picture_free) picture image = colorful(64, 48);
    write_well(&image, "a.png");
    size_t size, at = 8;
    uint8_t *bytes = get("a.png", &size);
    ck_assert_mem_eq(bytes, "\x89PNG\r\n\x1a\n", 8);
    ck_assert_mem_eq(bytes + 16, "\0\0\0\x40\0\0\0\x30\x08\x02\0\0\0", 13);
    char chunks[64] = "";
    while (at < size) {
        strncat(chunks, (const char *)bytes + at + 4, 4);
        at += 12 + ((size_t)bytes[at] << 24 | (size_t)bytes[at + 1] << 16 |
                    (size_t)bytes[at + 2] << 8 | bytes[at + 3]);
    }
    ck_assert_str_eq(chunks, "IHDRIDATIEND");
    write_well(&image, "b.png");
    assert_holds("b.png", bytes, size);
    free(bytes);
}

/* A file size limit fails a write as a full disk does: at the first bytes, and at a later block. */
static const struct {
    const char *path;
    rlim_t limit;
} full_disks[] = {
    {"a.ppm", 0},
    {"a.ppm", 20000},
    {"a.png", 0},
    {"a.png", 20000},
};

LOOP_TEST(a_full_disk_leaves_what_was_there, (int)(sizeof full_disks / sizeof *full_disks))
{
    const char *path = full_disks[_i].path;
    FREED_BY(picture_free) picture image = colorful(128, 128);
    uint32_t noise = 1; /* so that a PNG is as large */
    for (size_t j = 0; j < 3 * 128 * 128; j++) {
        noise = noise * 1664525 + 1013904223;
        image.rgb[j] = (uint8_t)(noise >> 24);
    }
    put(path, "old", 3);
    struct rlimit limit, before;
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &before), 0);
    limit = before;
    limit.rlim_cur = full_disks[_i].limit;
    FILE *messages = listen();
    int limited = setrlimit(RLIMIT_FSIZE, &limit); /* of Check's own files, too */
    bool written = picture_write(&image, path, messages);
    int freed = setrlimit(RLIMIT_FSIZE, &before);
    ck_assert(limited == 0 && freed == 0 && !written);
    assert_said(messages, path, "too large");
    assert_holds(path, "old", 3);
    ck_assert_int_eq(each_entry(NULL), 1);
    write_well(&image, path); /* and the next attempt is free to succeed */
}

/* An error that only ferror knows of, because the caller looked away, is found at the end. */
TEST(a_lost_write_is_found_at_the_end)
{
    FILE *messages = listen();
    atomic_file file;
    ck_assert(atomic_file_open("a", messages, &file));
    ck_assert_int_eq(getc(file.stream), EOF); /* a write-only stream: sets its error flag */
    ck_assert(!atomic_file_finish(&file, messages));
    assert_said(messages, "a", "cannot be written");
    ck_assert_int_eq(each_entry(NULL), 0);
}

static const int deadly[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM};
#define DEADLY (int)(sizeof deadly / sizeof *deadly)

LOOP_TEST(a_deadly_signal_leaves_no_temporary_file, DEADLY)
{
    put("a", "old", 3);
    pid_t child = fork();
    if (child == 0) {
        signal(deadly[_i], SIG_DFL);                 /* Check has set its own handlers */
        setrlimit(RLIMIT_CORE, &(struct rlimit){0}); /* which SIGQUIT leaves */
        atomic_file file;
        if (atomic_file_open("a", stderr, &file) && fputs("new", file.stream) >= 0 &&
            fflush(file.stream) == 0 && each_entry(NULL) == 2)
            raise(deadly[_i]);
        _exit(1);
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFSIGNALED(status));
    ck_assert_int_eq(WTERMSIG(status), deadly[_i]);
    ck_assert_int_eq(each_entry(NULL), 1);
    assert_holds("a", "old", 3);
}

static struct sigaction meaning_of(int signal_number)
{
    struct sigaction action;
    ck_assert_int_eq(sigaction(signal_number, NULL, &action), 0);
    return action;
}

LOOP_TEST(signals_that_somebody_handles_are_left_alone, DEADLY)
{
    struct sigaction ignoring = {.sa_handler = SIG_IGN}, dying = {.sa_handler = SIG_DFL};
    sigaction(deadly[_i], &ignoring, NULL);
    sigaction(SIGXFSZ, &dying, NULL);
    FILE *messages = listen();
    atomic_file file;
    ck_assert(atomic_file_open("a", messages, &file));
    raise(deadly[_i]);
    fputs("new", file.stream);
    ck_assert(atomic_file_finish(&file, messages));
    assert_silent(messages);
    assert_holds("a", "new", 3);
    ck_assert(meaning_of(deadly[_i]).sa_handler == SIG_IGN);
    ck_assert(meaning_of(SIGXFSZ).sa_handler == SIG_DFL);
    sigaction(deadly[_i], &dying, NULL);
    ck_assert(atomic_file_open("a", stderr, &file));
    atomic_file_discard(&file);
    ck_assert(meaning_of(deadly[_i]).sa_handler == SIG_DFL);
    assert_holds("a", "new", 3);
    ck_assert_int_eq(each_entry(NULL), 1);
}

static void read_badly(const char *path, const char *word)
{
    picture image = {.width = 7, .height = 7};
    FILE *messages = listen();
    ck_assert_msg(!picture_read(path, messages, &image), "%s", path);
    assert_said(messages, path, word);
    ck_assert(image.width == 7 && image.height == 7 && !image.rgb);
}

/* test_regress.py has all that is no PPM. */
TEST(what_is_refused_leaves_nothing)
{
    put("a.ppm", "P6\n1 1\n255\nab", 13);
    read_badly("a.ppm", "ends before");
    ck_assert_int_eq(mkdir("folder", 0777), 0);
    read_badly("folder", "directory");
    read_badly("missing.ppm", "No such file");
}

SUITE_IN("picture", enter_folder, leave_folder)
