/* What was found of a folder of scenes, as one page to look at. It holds its pictures, loads
 * nothing and runs no script. */
#ifndef REGRESS_REGRESS_PAGE_H
#define REGRESS_REGRESS_PAGE_H

#include "regress.h"

/* What is not the same gets a part of its own, what is the same stands in one line. */
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

/* The file appears whole or not at all. On false one line was written to `messages`. */
bool regress_page_write(regress_page *page, const char *folder, const render_settings *settings,
                        const int counts[REGRESS_VERDICTS], const char *path, FILE *messages);

#endif
