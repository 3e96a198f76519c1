/* A whole file in memory. */
#ifndef SCENE_RT_FILE_H
#define SCENE_RT_FILE_H

#include <stddef.h>

/* All bytes up to the end of the file or pipe, whatever its size was said to be; to be freed. NULL,
 * and `why` says what is wrong and what was expected. */
char *rt_read_file(const char *path, size_t *size, char why[200]);

#endif
