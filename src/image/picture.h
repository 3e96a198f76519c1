/* SPDX-License-Identifier: MIT */
/* A picture of 8-bit RGB, rows from the top, and the files it is written to and read from. */
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct {
    int width, height;
    uint8_t *rgb; /* 3 * width * height bytes */
    bool golden;  /* made by `surehit regress --accept`: a PNG says so */
} picture;

/* Linear light as a picture has it: clamped to 0..1, times 255, rounded to nearest. Not a number
 * becomes black. */
static inline uint8_t picture_level(double linear)
{
    if (!(linear > 0))
        return 0;
    double level = linear < 1 ? 255 * linear : 255;
    int whole = (int)level;
    return (uint8_t)(whole + (level - whole >= 0.5)); /* as lround, which is no call here */
}

/* Allocates a black picture; false when there is no memory. */
bool picture_new(int width, int height, picture *out);
void picture_free(picture *image);

bool picture_is_black(const picture *image);

/* Writes P6 PPM or PNG, by the ending of `path`; PPM to standard output, which is "-" or
 * "/dev/stdout", and to a pipe of another name. The file appears whole or not at all: it is
 * written beside its place under a temporary name, then renamed. On false one line was written to
 * `messages`. */
bool picture_write(const picture *image, const char *path, FILE *messages);

/* Writes PNG to a stream, for which `name` stands in messages. False after a line to `messages`. */
bool picture_write_png(const picture *image, FILE *stream, const char *name, FILE *messages);

/* Is it standard output? */
bool picture_is_stdout(const char *path);

/* Has the path an ending by which a picture can be written there? One line to `messages` if not. */
bool picture_has_name(const char *path);
bool picture_path_ok(const char *path, FILE *messages);

/* May what is no picture, but `what`, be written there? NULL: it is not written. Likewise. */
bool picture_is_other(const char *path, const char *what, FILE *messages);

/* Reads a P6 PPM of 255 levels, or a PNG of up to 8 bits a channel and without transparency: by
 * what the file holds, whatever its name. Values are taken as they stand, without gamma or profile.
 * On false one line was written to `messages`, and nothing is left allocated. */
bool picture_read(const char *path, FILE *messages, picture *out);

/* For it: a PNG behind its first byte. NULL and the picture, or what is wrong, until it is asked
 * again; then nothing is left allocated. */
const char *picture_read_png(FILE *stream, picture *out);

#define PICTURE_NEITHER "neither a PNG nor a P6 PPM"
#define PICTURE_TOO_SHORT "ends before the picture does"
#define PICTURE_TOO_LONG "bytes after the end of the picture"
#define PICTURE_TOO_LARGE "no memory for a picture of this size"
