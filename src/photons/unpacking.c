/* SPDX-License-Identifier: MIT */
#include "unpacking.h"

#include <errno.h>
#include <stdio.h>
#include <unistd.h>

bool unpacking_begin(int file, unpacking *of)
{
    of->stream = (z_stream){.next_in = Z_NULL};
    of->file = file;
    of->error = 0;
    of->state = inflateInit2(&of->stream, 16 + MAX_WBITS); /* 16: with the head of gzip */
    return of->state == Z_OK;
}

void unpacking_end(unpacking *of)
{
    inflateEnd(&of->stream);
}

static bool fill(unpacking *of)
{
    ssize_t got = read(of->file, of->packed, sizeof of->packed);
    if (got < 0)
        of->error = errno;
    of->stream.next_in = of->packed;
    of->stream.avail_in = got > 0 ? (uInt)got : 0;
    return got > 0;
}

size_t unpacking_get(unpacking *of, void *to, size_t size)
{
    of->stream.next_out = to;
    of->stream.avail_out = (uInt)size;
    while (of->stream.avail_out > 0 && of->state == Z_OK) {
        if (of->stream.avail_in == 0 && !fill(of))
            break;
        of->state = inflate(&of->stream, Z_NO_FLUSH);
    }
    return size - of->stream.avail_out;
}

int unpacking_next(unpacking *of)
{
    uint8_t next;
    return unpacking_get(of, &next, 1) == 1 ? next : EOF;
}

bool unpacking_follows(unpacking *of)
{
    return unpacking_next(of) != EOF ||
           (of->state == Z_STREAM_END && (of->stream.avail_in > 0 || fill(of)));
}
