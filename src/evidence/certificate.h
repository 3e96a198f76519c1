/* What a picture's pixels see, as text that can be checked: docs/tracer.md has the format. */
#ifndef EVIDENCE_CERTIFICATE_H
#define EVIDENCE_CERTIFICATE_H

#include "../tracer/render.h"
#include "../scene/rt.h"

typedef struct {
    char *scene;        /* its path as given, printable */
    uint64_t hash;      /* of its bytes */
    size_t objects;     /* that it has */
    rt_options options; /* as resolved; the size is the whole picture's */
    picture_part part;  /* width and height are set */
    sure_tier tier;     /* certain or exact */
    sure_statistics statistics;
    pixel_record *records; /* of the part, in reading order; without their times */
} certificate;

/* The file appears whole or not at all. On false one line was written to `messages`. */
bool certificate_write(const certificate *of, const char *path, FILE *messages);

/* Reads one (free it with certificate_free). On false one line was written to `messages`, which
 * names the line that is wrong, and nothing is left allocated. */
bool certificate_read(const char *path, FILE *messages, certificate *read);

void certificate_free(certificate *of);

/* FNV-1a, 64 bits, of a scene's bytes: it tells scenes that were mistaken for one another, not
 * those that were made alike. False after a line to `messages`, as for a pipe, which can't be read
 * twice. */
bool certificate_hash(const char *scene, FILE *messages, uint64_t *hash);

#endif
