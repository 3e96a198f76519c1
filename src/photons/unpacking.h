/* SPDX-License-Identifier: MIT */
/* What was compressed as by gzip, from a file or pipe that holds nothing else. zlib's own readers
 * of files pass over what follows. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <zlib.h>

typedef struct {
    z_stream stream;
    int file;  /* open */
    int state; /* Z_OK: goes on; Z_STREAM_END; else what is damaged */
    int error; /* an errno: it can't be read */
    uint8_t packed[16384];
} unpacking;

/* False when there is no memory; else it is to be ended. */
bool unpacking_begin(int file, unpacking *of);
void unpacking_end(unpacking *of);

/* How many bytes it got: fewer where they end, are damaged or can't be read. */
size_t unpacking_get(unpacking *of, void *to, size_t size);

/* One of them, or EOF. */
int unpacking_next(unpacking *of);

/* Behind the last byte: is there another one, or does the file go on? */
bool unpacking_follows(unpacking *of);
