/* SPDX-License-Identifier: MIT */
/* A scene held against its golden picture: the one that its user has looked at and found right. */
#pragma once

#include "../image/difference.h"
#include "../photons/render_file.h"

typedef enum {
    REGRESS_SAME,
    REGRESS_DIFFERS,
    REGRESS_NEW,        /* no golden picture yet */
    REGRESS_BAD_SCENE,  /* the scene can't be read */
    REGRESS_BAD_GOLDEN, /* the golden picture can't */
    REGRESS_STALE,      /* a golden picture without a scene */
    REGRESS_VERDICTS
} regress_verdict;

typedef struct {
    regress_verdict verdict;
    difference apart;    /* from the golden picture to what is drawn now; REGRESS_DIFFERS */
    picture golden, got; /* rgb is NULL where there is none */
    char *messages;      /* errors and warnings of the readers, a line each; "" for none */
} regression;

/* "differs: 12 of 57600 pixels, ...": what a line about it says behind the scene's name. */
void regress_print_verdict(FILE *out, const regression *found);

/* "3 scenes: 1 same, 1 different, 1 new; 1 stale golden picture". */
void regress_print_counts(FILE *out, const int counts[REGRESS_VERDICTS]);

/* A folder of scenes held against its golden pictures. */
typedef struct {
    const char *folder; /* of scenes, *.rt */
    const char *golden; /* the folder of golden pictures, *.png; NULL: FOLDER/golden */
    const char *page;   /* the path of a page that shows what differs, or NULL */
    bool accept;        /* what is drawn now becomes golden */
    bool quiet;         /* no word of what is the same */
    render_settings settings;
} regress_plan;

/* Tells of every scene on standard output, of trouble on standard error. Returns 0 where all are
 * the same, or accepted; 1 where something differs, is new or stale; 2 where something could not be
 * read or written. */
int regress_folder(const regress_plan *plan);

/* What was found of a folder of scenes, as one page to look at. It holds its pictures, loads
 * nothing and runs no script. What is not the same gets a part of its own, what is the same stands
 * in one line. */
typedef struct {
    FILE *parts, *same;
    char *parts_text, *same_text;
    size_t parts_size, same_size;
    bool failed; /* for want of memory */
} regress_page;

/* False when there is no memory; else close it with regress_page_close. */
bool regress_page_open(regress_page *page);
void regress_page_close(regress_page *page);

/* `remark` says what was done about it; NULL: nothing. */
void regress_page_add(regress_page *page, const char *name, const regression *found,
                      const char *remark);

/* The file appears whole or not at all. On false one line was written to standard error. */
bool regress_page_write(regress_page *page, const char *folder, const render_settings *settings,
                        const int counts[REGRESS_VERDICTS], const char *path);
